// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_problem_h
#define lamella_solve_contact_problem_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/interface_law.h>
#include <lamella/solve/structure.h>

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace lamella
{
  /// History of contact with friction at a material point of a slave surface.
  /// It stays with the point when surfaces are paired anew.
  struct FrictionHistory
  {
    /// Undeformed position of the point in scene axes, known if it is dropped.
    dealii::Point<3> position;
    /// True if the point had a constraint, but has none in the present pairing.
    bool is_dropped = false;
    /// Normal force at the start of the load step.
    double force = 0.;
    /// Shear force along both tangents at the start of the load step.
    dealii::Tensor<1, 2> shear;
    /// Gap plus compliance times normal force at the start of the load step.
    double gap = 0.;
    /// Slip length in the load step up to the last pairing in which the point
    /// had a constraint [length].
    double slid = 0.;
    /// Slip length, summed over all load steps.
    double length = 0.;
    /// Energy dissipated in all load steps: per step, friction coefficient
    /// times slip length times mean normal force.
    double dissipated = 0.;
  };

  /// Friction variables of an equilibrium state: constraint forces with one
  /// entry per gap constraint, vectors in scene axes, and the history of the
  /// material points. Empty without friction and before the first load step.
  /// Coulomb's law in a load step, with displacements u, slip s, initial slip
  /// s_0, normal force lambda_n, shear force lambda_t, friction coefficient mu:
  ///   v = s(u) + a lambda_t - s_0,   |lambda_t| <= mu lambda_n,
  ///   v = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v / |v| where v is not zero.
  /// The compliance a of a penalty (law_compliance()) also acts tangentially.
  struct FrictionState
  {
    /// Shear force of each constraint on the second contact side [force].
    std::vector<dealii::Tensor<1, 3>> shear;
    /// Unit vector along the shear force of slipping constraints; else zero.
    std::vector<dealii::Tensor<1, 3>> direction;
    /// Slip of each constraint, active or not, at the start of the load step,
    /// including the elastic slip of a penalty [length].
    std::vector<dealii::Tensor<1, 3>> before;
    /// History of each material point that has or had a constraint, by
    /// GapConstraints::material_point().
    std::map<std::pair<unsigned int, unsigned int>, FrictionHistory> history;
    /// Error of the energy balance of friction [energy], summed over all
    /// constraints and load steps. With mean forces of the step, each step adds
    ///   - (mean contact force) . (change of gap and slip) - dissipated energy.
    double path_gap = 0.;

    /// Returns true without friction, and before the first load step.
    bool
    empty() const
    {
      return shear.empty();
    }

    /// Returns the energy dissipated by friction, summed over all points.
    double
    all_dissipated() const;
    /// Returns the friction variables of the unloaded scene: initial gaps of
    /// the constraints @p rows; zero forces, slips and energies.
    static FrictionState
    unloaded(const GapConstraints &rows);
  };

  /// Last sentence of error messages if a friction solution is not found.
  constexpr const char *friction_remedy =
    ". Try more Substeps, a smaller step in Load factors, or a softer penalty.";

  /// Returns the components of @p vector (scene axes) along the two tangents of
  /// the contact constraint @p row; zero if it has no friction.
  dealii::Tensor<1, 2>
  along_tangents(const GapConstraint &row, const dealii::Tensor<1, 3> &vector);
  /// Returns the scene vector with the @p components along the tangents of the
  /// contact constraint @p row.
  dealii::Tensor<1, 3>
  in_scene(const GapConstraint &row, const dealii::Tensor<1, 2> &components);

  /// Returns the slip (relative tangential displacement) of the constraint @p
  /// row at @p u and @p factor, along its two tangents [length].
  dealii::Tensor<1, 2>
  slip_of(const GapConstraint &row,
          const BlockVector   &u,
          const LoadFactor    &factor);

  /// Adds the nodal forces of the contact constraint @p row, for its @p normal
  /// force and @p shear force (scene axes), to the load vector @p f.
  void
  add_force(const GapConstraint        &row,
            const double                normal,
            const dealii::Tensor<1, 3> &shear,
            BlockVector                &f);

  /// A contact problem in increments about a state whose displacements u and
  /// contact forces lambda_state are in equilibrium,
  ///   K u = t f + B^T lambda_state,
  /// with stiffness K, loads t f and constraint rows B. Vectors have one entry
  /// per contact constraint (GapConstraints).
  struct ContactProblem
  {
    std::vector<double> gap, ///< Gap of each constraint in the state [length].
      force; ///< Contact force lambda_state of each constraint [force].
    /// Estimate of each contact force, or zero. Better estimates reduce the
    /// penetration due to the numerical compliance (NumericalCompliance).
    std::vector<double> estimate;
    /// Indices of the constraints in the initial active set, ascending.
    std::vector<unsigned int> start;
    /// Slip of each constraint in the load step along its tangents [length];
    /// empty without friction.
    std::vector<dealii::Tensor<1, 2>> slip = {};
    /// Shear force of each constraint in the state [force].
    std::vector<dealii::Tensor<1, 2>> shear = {};
    /// Forces (n, t_1, t_2) at which the friction iteration starts.
    std::vector<dealii::Tensor<1, 3>> first_forces = {};
    /// Unbalanced forces of the state, in all DoFs; empty for none.
    BlockVector residual = BlockVector();
    /// Tolerance [length]: gaps from -closed to 0 are rounding errors of zero.
    double closed = 0.;

    /// Returns the contact force (n, t_1, t_2) of each constraint in the state.
    std::vector<dealii::Tensor<1, 3>>
    forces() const;
  };

  /// Methods of solve_interface(), by increasing cost.
  enum class InterfaceMethod
  {
    newton,         ///< Newton's method from the last forces.
    interior_point, ///< Interior point method, then Newton's method.
    compliance      ///< Newton's method with decreasing compliance.
  };

  /// Number of solutions of the contact laws by each InterfaceMethod; a contact
  /// problem has one for each of its working sets.
  using MethodCounts = std::array<unsigned int, 3>;

  /// Solution of a ContactProblem.
  struct ContactSolution
  {
    /// Increment of the displacements with respect to the state of the problem.
    BlockVector du;
    /// Contact force of each constraint, the state included; zero if inactive.
    std::vector<double> force;
    /// Indices of the active constraints, ascending.
    std::vector<unsigned int> active;
    /// Shear force of each constraint; empty without friction.
    std::vector<dealii::Tensor<1, 2>> shear = {};
    /// Unit direction of the shear force where a point slips, else zero.
    std::vector<dealii::Tensor<1, 2>> direction = {};
    /// Methods that solved the contact laws.
    MethodCounts solved_by{};
    /// True if the friction solution is unstable
    /// (InterfaceSolution::stability): no load path leads to it, and it must be
    /// rejected.
    bool is_unstable = false;

    /// Stores the contact force @p lambda = (n, t_1, t_2) of the constraint @p
    /// r in the state @p state, and adds it to the active ones if it is closed.
    /// Constraints that are not @p bilateral have no negative force.
    void
    store(const unsigned int          r,
          const bool                  bilateral,
          const PointState            state,
          const dealii::Tensor<1, 3> &lambda);
  };

  /// Active constraints of a linear system with contact. The increment of each
  /// listed gap or slip is prescribed, and its force lambda is unknown. In a
  /// slipping constraint, normal and shear force together are the nodal forces
  /// lambda (B_n^T + sum_a c_a B_t,a^T), with the rows B_n of the gap and B_t,a
  /// of the slips, and c = mu e with friction coefficient mu and shear
  /// direction e.
  struct ActiveConstraints
  {
    ActiveConstraints() = default;
    /// Lists the constraints with the indices @p active, without friction.
    ActiveConstraints(std::vector<unsigned int> active)
      : numbers(std::move(active))
    {}

    /// Indices of the closed gaps, ascending, then of the sticking slips.
    std::vector<unsigned int> numbers;
    /// Indices of slipping gaps, with the vectors c = mu e.
    std::vector<std::pair<unsigned int, dealii::Tensor<1, 2>>> sliding = {};
  };

  /// Result of one round of the active-set search, for reports.
  struct Round
  {
    std::size_t active = 0; ///< Number of active constraints.
    /// Indices of constraints that violate the contact law: penetrating ones,
    /// for the `full` strategy also tensile ones.
    std::vector<unsigned int> changed;
    double violation = 0.; ///< Largest violation of the contact law [length].
    /// True if the entry `Maximum iterations` counts the round; false for steps
    /// of the interior point method, which has a limit of its own.
    bool counts = true;
  };

  /// Data of a contact strategy that a restarted run needs in addition to the
  /// last state for bitwise equal results.
  struct StrategyHistory
  {
    /// Penalty factor of NumericalCompliance: a power of ten from 1 to 1000.
    double stiffening = 1.;
    /// Indices of constraints: for CondensedStrategy, Compliance::row_groups();
    /// for FullStrategy one list, the constraints in the matrix pattern.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Callback for each round of the active-set search, which may throw.
  using Monitor = std::function<void(const Round &)>;

  /// The numerical compliance d >= a [length / force] of a constraint with
  /// law_compliance() a, the proximal term of the method of multipliers:
  ///   lambda = max(0, ((d - a) lambda_bar - g) / d).
  /// The force lambda is a function of the gap g even for a = 0, and satisfies
  /// the contact law if its estimate lambda_bar equals lambda.
  class NumericalCompliance
  {
  public:
    /// Returns the difference d - a for constraint @p row with the penalty eps:
    /// zero for the method `penalty`, otherwise 1/eps divided by `stiffening`.
    /// The condensed strategy reduces it further for `exact` and `tied`.
    double
    proximal(const GapConstraint &row) const;

    /// Returns the compliance d of entry @p number in a list of all gaps, then
    /// all slips, of @p rows.
    double
    operator()(const GapConstraints &rows, const unsigned int number) const;

    /// Multiplies the penalty by ten, so that the estimates converge faster.
    /// Returns false, without effect, if `stiffening` is already 1000.
    bool
    increase_penalty();

    /// Factor of all penalties; no effect for the method `penalty`.
    double stiffening = 1.;
  };
} // namespace lamella

#endif
