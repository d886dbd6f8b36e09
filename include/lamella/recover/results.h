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
  /// A pair of a contact at the end of a load step: a row with its geometry.
  struct ContactRow
  {
    /// Positions, normal and area of the pair.
    ContactInterface::Point point;
    /// g_init of Eq. 17 and g of Eq. 16 [length], or their means over the area.
    double initial_gap = 0., gap = 0.;
    /// lambda, positive in compression; over the pair's area the mean pressure.
    double force = 0.;
    /// Resultant on the second side, friction included.
    Wrench on_second = {};
    /// Friction: lambda_t on the second side, state, slip length, dissipation.
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

  /// Numbers of pairs that closed and opened in a step, at first from none.
  struct StatusChanges
  {
    unsigned int closed = 0, opened = 0;
  };

  /// Results of one load step, in the order of the names in Results.
  struct StepResults
  {
    /// Number of the step, from 1.
    unsigned int step = 0;
    /// t, the factor on loads and prescribed displacements.
    LoadFactor load_factor;
    /// Displacements, contact forces and their solution history.
    State  state;
    Checks checks;
    /// SolvedStep::substeps and change.
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// Number of times that Newton's method halved the step (SolvedStep::cuts).
    unsigned int halvings = 0;
    /// Memory of the strategy at the end of the step.
    StrategyHistory memory;

    /// Rows of each probe, one per ply that it touches, from the bottom.
    std::vector<std::vector<FieldRow>> probes;
    std::vector<std::vector<LineRow>>  lines;
    std::vector<std::vector<CutRow>>   cuts;
    /// Interface jumps of each line.
    std::vector<InterfaceJump> jumps;
    /// Value of each measure.
    std::vector<double> measures;
    EquilibriumDefects  defects;
    /// Pairs of each contact, in the order of its rows.
    std::vector<std::vector<ContactRow>> contacts;
    /// Status changes of each contact.
    std::vector<StatusChanges> changes;
    /// Rows of each ply of the swept bodies, by body, ply and criterion,
    /// without criteria that have no point.
    std::vector<PlyReserve> plies;
    /// Rows of each ply of the swept beams, by body, ply and s.
    std::vector<ReserveAlong> plies_along;

    /// Warnings about this step, a sentence each.
    std::vector<std::string> warnings;

    /// Drops the state's vectors, the strategy's memory and all rows, which are
    /// nearly all of its memory, but not checks, jumps, measures, closures,
    /// changes, reserve factors of plies and warnings.
    void
    drop_fields();
  };

  /// Facts about a body in the results.
  struct BodySummary
  {
    /// Name and theory as in the scene: `upper`, `LE-2`.
    std::string name, theory;
    /// Number of DoFs, including prescribed ones.
    unsigned int dofs = 0;
    /// Statistics of the solver; none under the `full` strategy.
    std::optional<SolverStatistics> solver;
    /// Name of each ply's material.
    std::vector<std::string> materials = {};
  };

  /// Facts about a contact in the results.
  struct ContactSummary
  {
    /// Names of the contact and of its second body or obstacle.
    std::string    name, second_name;
    Discretization discretization = Discretization::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    /// Numbers of gap rows, and of unpaired nodes on either side.
    unsigned int rows = 0, unpaired = 0, unpaired_second = 0;
    /// Range of g_init over the rows [length].
    double initial_gap_min = 0., initial_gap_max = 0.;
    /// Friction coefficient of Coulomb's law.
    double friction = 0.;
    /// Surface that carries the rows; null if unknown.
    std::shared_ptr<const SlaveSurface> surface = {};
  };

  /// Results of a run, without references to a scene, body or solver.
  struct Results
  {
    /// Title of the scene; units are labels, numbers are as in the scene.
    std::string title;
    Units       units;
    /// Bodies and names, in the order of the scene.
    std::vector<BodySummary>    bodies;
    std::vector<ContactSummary> contacts;
    std::vector<std::string>    supports, probes, lines, cuts, measures;
    /// Resultant of each load at load factor 1.
    std::vector<LoadResultant> loads;
    /// Diagonal of the bounding box of all bodies.
    double size = 0.;

    /// Solved steps, in the order of their load factors.
    std::vector<StepResults> steps;
    /// Number of steps in the scene, and whether all were solved.
    unsigned int load_steps = 0;
    bool         converged  = false;
    /// Notes about the scene, printed before and after those of the steps.
    std::vector<std::string> notes, endnotes;
    /// First failure, if the scene requests its search.
    std::optional<FirstFailure> first_failure;
    /// Goals of the last step; none if no errors were estimated.
    std::vector<GoalResult> goals;
    /// Reason why there are no goals; empty if there are.
    std::string no_goals_reason;
    /// Largest condition number of condensed stiffnesses; a lower bound, or 0.
    double condition_estimate = 0.;

    /// Wall seconds by phase (phase_names()), and `total`.
    std::map<std::string, double> seconds;
    /// Number of MPI processes of the run.
    unsigned int processes = 1;
    /// Peak memory in bytes: of the largest process, and of all.
    double peak_memory = 0., peak_memory_of_all = 0.;

    /// Returns the number of DoFs of all bodies.
    unsigned int
    n_dofs() const;

    /// Returns notes, the warnings of all steps, and endnotes. Warnings name
    /// their step if there are several, or first failure. Warnings that differ
    /// by numbers only are merged, with the numbers of the largest load factor;
    /// those that differ by a name are merged with all names.
    std::vector<std::string>
    all_warnings() const;

    /// Returns the largest stiffening, smallest buckling factor of all steps.
    NonlinearityEstimate
    worst_nonlinearity() const;

    /// Returns the last solved step. Throws InputError if there is none.
    const StepResults &
    last() const;

    /// Returns the row of the probe @p name in the last step: of @p ply (from
    /// 1), or the first if 0. Throws InputError if it does not exist.
    const FieldRow &
    probe(const std::string &name, const unsigned int ply = 0) const;

    /// Returns the resultant of the support or contact @p name in the last
    /// step. Throws InputError for an unknown name.
    const Resultant &
    support(const std::string &name) const;
    const KktResidual &
    contact(const std::string &name) const;
  };
} // namespace lamella

#endif
