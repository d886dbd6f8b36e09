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
  /// A contact constraint at the end of a load step: gap, force and geometry.
  struct ContactRow
  {
    /// Position, normal and area of the contact point.
    ContactInterface::Point point;
    /// Initial gap in the undeformed bodies and gap at the end of the step
    /// [length]; averages for mortar constraints.
    double initial_gap = 0., gap = 0.;
    /// Contact force lambda; divided by the point's area, the mean pressure.
    double force = 0.;
    /// Force and moment on the second side, friction included.
    Wrench on_second = {};
    /// Friction: shear force on the second side, slip length, dissipation.
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

  /// Numbers of contact points that closed and opened in a load step.
  struct StatusChanges
  {
    unsigned int closed = 0, opened = 0;
  };

  /// Results of one load step; lists have the order of the names in Results.
  struct StepResults
  {
    /// Number of the load step, from 1.
    unsigned int step = 0;
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    /// Displacements and contact forces, with data on the iterations.
    State  state;
    Checks checks;
    /// Number of substeps, and change by the last doubling
    /// (SolvedStep::change).
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// Number of bisections of the load step (SolvedStep::cuts).
    unsigned int halvings = 0;
    /// Data of the contact strategy at the end of the step, for a restart.
    StrategyHistory memory;

    /// Rows of each probe (one per ply, from the bottom), line and cut.
    std::vector<std::vector<FieldRow>> probes;
    std::vector<std::vector<LineRow>>  lines;
    std::vector<std::vector<CutRow>>   cuts;
    /// Interface jumps of each line.
    std::vector<InterfaceJump> jumps;
    /// Value of each measure.
    std::vector<double> measures;
    EquilibriumDefects  defects;
    /// Contact points of each contact, in the order of its constraints.
    std::vector<std::vector<ContactRow>> contacts;
    /// Numbers of opened and closed contact points of each contact.
    std::vector<StatusChanges> changes;
    /// Reserve factors of each ply of the evaluated bodies, by body, ply and
    /// criterion, without criteria that apply to no point.
    std::vector<PlyReserve> plies;
    /// Reserve factors along the axes of beams, by body, ply and s.
    std::vector<ReserveAlong> plies_along;

    /// Warnings about this step, one sentence each.
    std::vector<std::string> warnings;

    /// Releases vectors of the state, data of the strategy and all rows, which
    /// are nearly all of the memory, but not checks, jumps, measures, defects,
    /// changes, reserve factors of plies and warnings.
    void
    drop_fields();
  };

  /// Model data of a body in the results.
  struct BodySummary
  {
    /// Name and theory as in the scene, for example `upper`, `LE-2`.
    std::string name, theory;
    /// Number of DoFs, including prescribed DoFs.
    unsigned int dofs = 0;
    /// Statistics of the linear solver; empty for the `full` strategy.
    std::optional<SolverStatistics> solver;
    /// Name of the material of each ply.
    std::vector<std::string> materials = {};
  };

  /// Data of a contact in the results.
  struct ContactSummary
  {
    /// Names of the contact and of its second body or obstacle.
    std::string    name, second_name;
    Discretization discretization = Discretization::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    /// Number of contact constraints, and of unpaired nodes on either side.
    unsigned int rows = 0, unpaired = 0, unpaired_second = 0;
    /// Smallest and largest initial gap [length].
    double initial_gap_min = 0., initial_gap_max = 0.;
    /// Friction coefficient of Coulomb's law.
    double friction = 0.;
    /// Slave surface; null if unknown.
    std::shared_ptr<const SlaveSurface> surface = {};
  };

  /// Results of a run, without references to a scene, body or solver.
  struct Results
  {
    /// Title of the scene; units are labels, and numbers are as in the scene.
    std::string title;
    Units       units;
    /// Bodies, contacts and names, in the order of the scene.
    std::vector<BodySummary>    bodies;
    std::vector<ContactSummary> contacts;
    std::vector<std::string>    supports, probes, lines, cuts, measures;
    /// Resultant of each load at load factor 1.
    std::vector<LoadResultant> loads;
    /// Diagonal of the bounding box of all bodies [length].
    double size = 0.;

    /// Solved load steps, in order.
    std::vector<StepResults> steps;
    /// Number of load steps in the scene, and true if all were solved.
    unsigned int load_steps = 0;
    bool         converged  = false;
    /// Notes about the scene, printed before and after the warnings of steps.
    std::vector<std::string> notes, endnotes;
    /// First failure; empty if the scene does not request the search.
    std::optional<FirstFailure> first_failure;
    /// Goals of the last step; empty if no errors were estimated.
    std::vector<GoalResult> goals;
    /// Reason why there are no goals; empty if there are goals.
    std::string no_goals_reason;
    /// Lower bound of the largest condition number of stiffnesses, or 0.
    double condition_estimate = 0.;

    /// Wall-clock seconds by phase (phase_names()), and `total`.
    std::map<std::string, double> seconds;
    /// Number of MPI processes of the run.
    unsigned int processes = 1;
    /// Peak memory in bytes: of the largest process, and of all processes.
    double peak_memory = 0., peak_memory_of_all = 0.;

    /// Returns the number of DoFs of all bodies.
    unsigned int
    n_dofs() const;

    /// Returns notes, the warnings of all steps, and endnotes. If there are
    /// several steps, warnings contain the step or `first failure`. Warnings
    /// that differ by numbers only are merged, with the numbers of the largest
    /// load factor; warnings that differ by a name are merged with all names.
    std::vector<std::string>
    all_warnings() const;

    /// Returns the largest stiffening and smallest buckling factor of all
    /// steps.
    NonlinearityEstimate
    worst_nonlinearity() const;

    /// Returns the last solved step. Throws InputError if there is none.
    const StepResults &
    last() const;

    /// Returns the row of the probe @p name in the last step for @p ply (from
    /// 1), or the first row if 0. Throws InputError if there is none.
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
