// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_results_h
#define lamella_solve_results_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/solve/checks.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// The fields at a point of a body, on one side of its ply interfaces: a row
  /// of the tables of probes, lines and cuts.
  struct FieldRow
  {
    std::string body;
    /// From 0 at the bottom.
    unsigned int     ply = 0;
    dealii::Point<3> position;
    FieldSample      sample;
  };

  /// A row of a line, with the arc length from its start.
  struct LineRow
  {
    double   s = 0.;
    FieldRow fields;
  };

  /// A row of a cut: point (i, j) of the grid on the cell @p cell of the
  /// section.
  struct CutRow
  {
    unsigned int cell = 0, i = 0, j = 0;
    FieldRow     fields;
  };

  /// What a line meets at the ply interfaces that it crosses.
  struct InterfaceJump
  {
    /// 0: it crosses none.
    unsigned int interfaces = 0;
    /// The largest jump of the traction sigma . d, d the line's direction,
    /// over the largest traction on the line. Equilibrium makes it zero where
    /// the line is normal to the plies; what is left is the section's mesh.
    double relative = 0.;
  };

  /// One pair of a contact at the end of a load step.
  struct ContactRow
  {
    /// The places, the normal and the area of the pair.
    ContactInterface::Point point;
    double                  initial_gap = 0., gap = 0.;
    /// Positive in compression.
    double force = 0.;

    bool
    touches() const
    {
      return force > 0.;
    }
  };

  /// How many pairs of a contact began and ceased to touch in a load step, the
  /// first against no contact.
  struct StatusChanges
  {
    unsigned int closed = 0, opened = 0;
  };

  /**
   * What one load step came to. Vectors over probes, lines, cuts and contacts
   * are in the order of the names in Results; resultants are in `checks`.
   */
  struct StepResults
  {
    /// From 1.
    unsigned int step        = 0;
    double       load_factor = 0.;
    State        state;
    Checks       checks;
    /// What the strategy had learnt when the step ended.
    StrategyMemory memory;

    /// Of each probe a row a ply that it touches.
    std::vector<std::vector<FieldRow>>   probes;
    std::vector<std::vector<LineRow>>    lines;
    std::vector<std::vector<CutRow>>     cuts;
    std::vector<InterfaceJump>           jumps;
    std::vector<std::vector<ContactRow>> contacts;
    std::vector<StatusChanges>           changes;

    /// What the user should know of this step, a sentence each.
    std::vector<std::string> warnings;

    /// Drops the state's vectors and all rows, which is nearly all of its
    /// memory.
    void
    drop_fields();
  };

  /// What a body is to those who read results.
  struct BodyFacts
  {
    std::string  name, theory;
    unsigned int dofs = 0;
    /// What solving it took; nothing under the `full` strategy.
    std::optional<SolverStatistics> solver;
  };

  /// What a contact is to those who read results.
  struct ContactFacts
  {
    std::string    name, second_name;
    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    unsigned int   rows = 0, unpaired = 0, unpaired_second = 0;
    double         initial_gap_min = 0., initial_gap_max = 0.;
  };

  /**
   * Everything that a run has found out, free of what it was found with: no
   * file, no reference to a scene, a body or a solver. Console, tables, JSON
   * and pictures are made from it.
   */
  struct Results
  {
    std::string               title;
    Units                     units;
    std::vector<BodyFacts>    bodies;
    std::vector<ContactFacts> contacts;
    std::vector<std::string>  supports, probes, lines, cuts;
    /// Of each load, at load factor 1.
    std::vector<LoadResultant> loads;
    /// The diagonal of the box around all bodies.
    double size = 0.;

    /// Those that were solved, in the order of their load factors.
    std::vector<StepResults> steps;
    /// How many the scene asks for, and whether all of them were solved.
    unsigned int load_steps = 0;
    bool         converged  = false;
    /// What the user should know of the scene as a whole, said before and
    /// after what the steps say.
    std::vector<std::string> notes, endnotes;
    double                   condition_estimate = 0.;

    /// Phase (phase_names(), `total`) -> wall seconds.
    std::map<std::string, double> seconds;
    unsigned int                  processes = 1;
    /// In bytes: of the process that took most, and of all.
    double peak_memory = 0., peak_memory_of_all = 0.;

    /// DoFs of all bodies.
    unsigned int
    n_dofs() const;

    /// Of the scene and of all steps, these named where there are several.
    std::vector<std::string>
    all_warnings() const;

    /// Throws InputError if no step was solved.
    const StepResults &
    last() const;

    /// The row of the probe @p name in the last step: that of @p ply (from 1 at
    /// the bottom), or of 0 the first. Throws InputError for a name or a ply
    /// that is not there.
    const FieldRow &
    probe(const std::string &name, const unsigned int ply = 0) const;

    /// The force of the support or the contact @p name in the last step, with
    /// its moment. Throws InputError for a name that is not there.
    const Resultant &
    support(const std::string &name) const;
    const KuhnTucker &
    contact(const std::string &name) const;
  };

  /// The phases of a run, in the order of its work.
  const std::vector<std::string> &
  phase_names();
} // namespace lamella

#endif
