// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_results_h
#define lamella_recover_results_h

#include <lamella/base/units.h>
#include <lamella/contact/contact.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/recover/failure_trial.h>
#include <lamella/recover/goal_result.h>
#include <lamella/solve/phase.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// One pair of a contact at the end of a load step: a gap row with its
  /// geometry.
  struct ContactRow
  {
    /// The places, the normal and the area of the pair.
    ContactInterface::Point point;
    /// g_init of Eq. 17 and g of Eq. 16, lengths, negative in penetration; of
    /// an average over an area (surface to surface) these averages.
    double initial_gap = 0., gap = 0.;
    /// lambda, positive in compression: over the area of the pair the mean
    /// pressure there.
    double force = 0.;
    /// What that is on the second side, friction with it.
    Wrench on_second = {};
    /// With friction: lambda_t on the second side; whether the pair slips; the
    /// length of its slip and what that has dissipated, so far.
    struct Friction
    {
      dealii::Tensor<1, 3> shear;
      bool                 slips      = false;
      double               length     = 0.;
      double               dissipated = 0.;
    };
    std::optional<Friction> friction = {};

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
    unsigned int step = 0;
    /// t: what multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    /// Displacements, contact forces and how they were found.
    State  state;
    Checks checks;
    /// SolvedStep::substeps and change.
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// How often Newton's method halved the step (SolvedStep::cuts).
    unsigned int halvings = 0;
    /// What the strategy had learnt when the step ended.
    StrategyMemory memory;

    /// Of each probe a row a ply that it touches, from the bottom.
    std::vector<std::vector<FieldRow>> probes;
    std::vector<std::vector<LineRow>>  lines;
    std::vector<std::vector<CutRow>>   cuts;
    /// Of each line.
    std::vector<InterfaceJump> jumps;
    /// Of each measure its value.
    std::vector<double> measures;
    Closures            closures;
    /// Of each contact its pairs, in the order of its rows.
    std::vector<std::vector<ContactRow>> contacts;
    /// Of each contact.
    std::vector<StatusChanges> changes;
    /// Of each ply of the swept bodies a row a criterion, in the order of
    /// bodies, plies and criteria; without any that the criterion has no point
    /// of (an interlaminar one of a single ply).
    std::vector<PlyReserve> plies;
    /// Of each ply of the swept bodies that are beams, by body, ply and s.
    std::vector<ReserveAlong> plies_along;

    /// What the user should know of this step, a sentence each.
    std::vector<std::string> warnings;

    /// Drops the state's vectors, the strategy's memory and all rows (those of
    /// the checks, too), which is nearly all of its memory. What stays: number,
    /// load factor, iterations, checks, jumps, measures, closures, changes,
    /// reserve
    /// factors of plies and warnings.
    void
    drop_fields();
  };

  /// What a body is to those who read results.
  struct BodyFacts
  {
    /// As the scene says them: `upper`, `LE-2`.
    std::string name, theory;
    /// Those that supports prescribe among them.
    unsigned int dofs = 0;
    /// What solving it took; nothing under the `full` strategy.
    std::optional<SolverStatistics> solver;
    /// Of each ply the name of its material.
    std::vector<std::string> materials = {};
  };

  /// What a contact is to those who read results.
  struct ContactFacts
  {
    /// Of the contact, and of the body or obstacle on its second side.
    std::string    name, second_name;
    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    /// Its gap rows, and the nodes of either side that face nothing of the
    /// other.
    unsigned int rows = 0, unpaired = 0, unpaired_second = 0;
    /// The range of g_init over its rows, a length.
    double initial_gap_min = 0., initial_gap_max = 0.;
    /// Coulomb's coefficient.
    double friction = 0.;
    /// What carries its rows; null if that is not known.
    std::shared_ptr<const CarryingSurface> surface = {};
  };

  /**
   * Everything that a run has found out, free of what it was found with: no
   * file, no reference to a scene, a body or a solver. Console, tables, JSON
   * and pictures are made from it.
   */
  struct Results
  {
    /// Of the scene; units are labels only, numbers are as the scene's.
    std::string title;
    Units       units;
    /// In the order of the scene, as are all names here.
    std::vector<BodyFacts>    bodies;
    std::vector<ContactFacts> contacts;
    std::vector<std::string>  supports, probes, lines, cuts, measures;
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
    /// Where the scene asks for such a search.
    std::optional<FirstFailure> first_failure;
    /// The numbers that it was made for, of the last step; none where no errors
    /// were estimated.
    std::vector<GoalResult> goals;
    /// Why there are none; empty if there are.
    std::string why_no_goals;
    /// Of the condensed stiffnesses, the largest of all bodies; a lower bound,
    /// 0 if unknown (only CHOLMOD knows one).
    double condition_estimate = 0.;

    /// Phase (phase_names(), `total`) -> wall seconds. `total` is more than
    /// their sum by what belongs to none.
    std::map<std::string, double> seconds;
    /// MPI processes of the run.
    unsigned int processes = 1;
    /// In bytes: of the process that took most, and of all.
    double peak_memory = 0., peak_memory_of_all = 0.;

    /// DoFs of all bodies.
    unsigned int
    n_dofs() const;

    /// Returns notes, the warnings of all steps, and endnotes: a sentence each,
    /// without a full stop. Warnings have their steps if there are several, or
    /// that of first failure. Warnings that differ by numbers only are merged,
    /// with the numbers of the largest load factor. So are those that differ by
    /// the name of a contact or body, with all names.
    std::vector<std::string>
    all_warnings() const;

    /// Of all steps the largest stiffening and the smallest buckling factor.
    BeyondLinear
    worst_beyond() const;

    /// The last step that was solved. Throws InputError if none was.
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
} // namespace lamella

#endif
