// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_results_h
#define lamella_solve_results_h

#include <lamella/base/names.h>
#include <lamella/base/units.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/solve/checks.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// What a run spends its time on, in the order of its work.
  enum class Phase
  {
    setup,         ///< meshes, sections, bodies, supports, loads, probes
    assembly,      ///< stiffness matrices
    factorisation, ///< what makes them ready to be solved with
    solve,         ///< linear solution, refinement, checks
    contact,       ///< search and pairing, and the search for active rows
    beyond,        ///< what large deflections would change (BeyondLinear)
    output         ///< fields at probes, lines and cuts; files
  };

  template <>
  struct Names<Phase>
  {
    static constexpr NameOf<Phase> all[] = {{Phase::setup, "setup"},
                                            {Phase::assembly, "assembly"},
                                            {Phase::factorisation,
                                             "factorisation"},
                                            {Phase::solve, "solve"},
                                            {Phase::contact, "contact"},
                                            {Phase::beyond, "beyond"},
                                            {Phase::output, "output"}};
  };

  /// The names of all phases, in their order; a static that lives as long as
  /// the program.
  const std::vector<std::string> &
  phase_names();

  /// One less than 0: tables, which count plies from 1, have 0 there.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// The fields at a point of a body, on one side of its ply interfaces: a row
  /// of the tables of probes, lines and cuts.
  struct FieldRow
  {
    /// Its name.
    std::string body;
    /// From 0 at the bottom; tables count from 1. `several_plies` of a mean
    /// over a box that reaches into more than one.
    unsigned int ply = 0;
    /// Undeformed, in the scene; the middle of a box.
    dealii::Point<3> position;
    /// Displacement, strains and stresses, scene axes and ply axes.
    FieldSample sample;
  };

  /// A row of a line, with the arc length from its start.
  struct LineRow
  {
    /// A length; both sides of a ply interface have the same.
    double   s = 0.;
    FieldRow fields;
  };

  /// A row of a cut: point (i, j) of the grid on the cell number @p cell of the
  /// section, each from 0. Cells have grids of their own, so points on their
  /// common sides stand there once a cell.
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
    /// over the largest stress component on the line: what the jump is to the
    /// body. Equilibrium makes it zero where the line is normal to the plies;
    /// what is left is the section's mesh.
    double of_stress = 0.;
    /// The same over the largest traction on the line: what it is to the
    /// transverse stresses. 0 where these are rounding.
    double of_traction = 0.;
  };

  /// What the integration of equilibrium leaves in the columns of each probe,
  /// line and cut whose stresses come of it: the largest difference from the
  /// traction on the upper face over the largest transverse stress, before it
  /// is distributed (recover/interlaminar.h). None for all others.
  struct Closures
  {
    std::vector<std::optional<double>> probes, lines, cuts;
  };

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
    /// What that is on the second side.
    Wrench on_second = {};

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

  /// How near a ply of a body is to failure by one criterion, at the place that
  /// is nearest to it (doc/strength.md).
  struct PlyReserve
  {
    /// The body's number in the scene; the ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// As the scene writes it, and what fails.
    std::string criterion, mode;
    /// What loads may be multiplied with, stresses growing with them; none
    /// where no factor brings failure.
    std::optional<double> reserve;
    /// The criterion's value: 1 at failure.
    double index = 0.;
    /// Undeformed, in the scene.
    dealii::Point<3> position;
    /// From the axis 2 of the ply to the normal of the fracture plane, positive
    /// towards 3, in degrees, where the criterion has such a plane.
    std::optional<double> angle;
    /// |element's stress - recovered stress| / |recovered stress| there: what
    /// the mesh leaves open. Large where stress is singular.
    double doubt = 0.;
  };

  /// The nearest to failure that a ply comes at a station of a beam's axis, by
  /// any criterion and anywhere across the section.
  struct ReserveAlong
  {
    /// The body's number in the scene; the ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// The distance from the axis' start, and the place in the scene.
    double           s = 0.;
    dealii::Point<3> position;
    /// The largest 1/R of the elements' own stresses; 0 where no R is finite,
    /// none where all of the station is left out.
    std::optional<double> inverse_reserve;
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
    double load_factor = 0.;
    /// Displacements, contact forces and how they were found.
    State  state;
    Checks checks;
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

  /// A load factor that was looked at for the first failure.
  struct FailureTrial
  {
    double load_factor = 0.;
    /// The smallest of all plies; none where no factor brings failure.
    std::optional<double> reserve;
    Checks                checks;
    /// As in StepResults.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// What a search for the load at which the smallest reserve factor is 1 has
  /// found.
  struct FirstFailure
  {
    /// No ply fails at the first load factor, and one does at the second, if
    /// any was seen to fail.
    double safe = 0., failing = 0.;
    /// What fails, at `failing`; none if nothing was seen to fail.
    std::optional<PlyReserve> where;
    /// In the order in which they were looked at; neither load steps nor load
    /// factors without a state are among them.
    std::vector<FailureTrial> trials;
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
  };

  /// What an element along a beam does to the error of a goal.
  struct ElementError
  {
    /// Its number in the scene, and the element from the start of its axis
    /// [length].
    unsigned int body  = 0;
    double       begin = 0., end = 0.;
    /// In the unit of the goal, signed.
    double error = 0.;
    /// Of the nodes of the element, those that it shares among them.
    unsigned int dofs = 0;
  };

  /// The change of a goal from one model to a finer one, by where it comes
  /// from: elements, contact and remainder sum to it.
  struct LocalErrors
  {
    std::vector<ElementError> elements;
    /// What the gap rows of the finer model find between the surfaces of the
    /// coarser one, and its forces that they do not have.
    double contact = 0.;
    /// What neither says: zero to rounding where all displacements of the
    /// coarser model are among those of the finer one, under one law.
    double remainder = 0.;
  };

  /// A number that a run was made for, and what is held of its error. In the
  /// unit of the quantity.
  struct GoalResult
  {
    /// As the scene says it: `tip: uz`.
    std::string name;
    double      value = 0.;
    /// The estimated error, to be added to the value, and what bounds it.
    double estimate = 0., bar = 0.;
    /// Whether the bar can be held to; if not, why.
    bool        trusted = false;
    std::string why;
    /// What tolerances are shares of: |value|, or the largest of its kind in
    /// the scene where that is near zero.
    double scale = 0.;
    /// As a share of the scale, if one was asked for.
    std::optional<double> tolerance;
    /// What the estimate is the sum of, by the source of the error.
    std::vector<std::pair<std::string, double>> shares;
    /// The share of the axis, by elements; none where that is not known.
    std::optional<LocalErrors> local;

    /// Whether the bar can be held to and is within the tolerance.
    bool
    met() const
    {
      return trusted && tolerance && bar <= *tolerance * scale;
    }
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

    /// What the user should know: notes, the warnings of all steps (with their
    /// steps where the scene has several; what differs by its numbers only
    /// once, as of the largest load factor), endnotes. A sentence each, without
    /// a full stop.
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
