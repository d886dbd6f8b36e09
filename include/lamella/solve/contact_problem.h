// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_problem_h
#define lamella_solve_contact_problem_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/friction_state.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// Returns the compliance a [length / force] of the contact law
  ///   g + a lambda >= 0,  lambda >= 0,  (g + a lambda) lambda = 0
  /// of the constraint @p row with gap g and force lambda, positive in
  /// compression. For `penalty` with the parameter eps, a = 1/eps, so lambda =
  /// eps max(0, -g). Otherwise a = 0: Kuhn-Tucker conditions.
  double
  law_compliance(const GapConstraint &row);

  /// A contact problem in increments about a state whose displacements u and
  /// contact forces lambda_state are in equilibrium,
  ///   K u = t f + B^T lambda_state,
  /// such as the linear solution without contact or a refined state. Vectors
  /// have one entry per contact constraint (GapConstraints).
  struct ContactProblem
  {
    /// Gap g_state [length] and force lambda_state of each constraint.
    std::vector<double> gap, force;
    /// Estimates lambda_bar of the forces, or zero. Better estimates reduce the
    /// penetration due to the numerical compliance d (NumericalCompliance).
    std::vector<double> estimate;
    /// Constraints expected to be active, ascending: the start of the search.
    std::vector<unsigned int> start;
    /// Slip in the load step, s(u) - s_0, and shear force of the state, along
    /// the tangents; initial forces of the iteration. Empty without friction.
    std::vector<dealii::Tensor<1, 2>> slip = {}, shear = {};
    std::vector<dealii::Tensor<1, 3>> first_forces = {};
    /// Gaps above -closed [length] are within rounding of zero.
    double closed = 0.;
  };

  /// Solution of a ContactProblem.
  struct ContactSolution
  {
    /// K^-1 B^T (lambda - lambda_state), the increment of the displacements.
    BlockVector du;
    /// Total force lambda of each constraint; zero where it is inactive.
    std::vector<double> force;
    /// Numbers of the active constraints, ascending.
    std::vector<unsigned int> active;
    /// Shear force of each constraint, and its unit direction where it slips.
    std::vector<dealii::Tensor<1, 2>> shear = {}, direction = {};
    /// True if the friction solution is unstable (CoulombSolution::stability):
    /// no load path leads to it, and it must be rejected.
    bool is_unstable = false;
  };

  /// Active constraints of a linear system with contact. The increment of each
  /// listed gap or slip is prescribed, and its force lambda is unknown. In a
  /// slipping constraint, normal and shear force act together along B_n^T +
  /// sum_a c_a B_t,a^T, with the rows B_n of the gap and B_t,a of the slips, c
  /// = mu e, friction coefficient mu and shear direction e.
  struct ActiveConstraints
  {
    ActiveConstraints() = default;
    /// Lists the @p active gaps, without friction.
    ActiveConstraints(std::vector<unsigned int> active)
      : numbers(std::move(active))
    {}

    /// Numbers of the closed gaps, ascending, then of the sticking slips.
    std::vector<unsigned int> numbers;
    /// Slipping constraints: numbers of their gaps, with the factors c.
    std::vector<std::pair<unsigned int, dealii::Tensor<1, 2>>> sliding = {};
  };

  /// Result of one round of the active-set search, for reports.
  struct Round
  {
    /// Number of active constraints.
    std::size_t active = 0;
    /// Constraints that violate the contact law (penetrating; with `full` also
    /// tensile), and the largest violation [length].
    std::vector<unsigned int> changed;
    double                    violation = 0.;
  };

  /// Data of a contact strategy that a restarted run needs in addition to the
  /// last state, for bitwise equal results.
  struct StrategyHistory
  {
    /// Penalty factor of NumericalCompliance: a power of ten from 1 to 1000.
    double stiffening = 1.;
    /// CondensedStrategy: Compliance::row_groups(). FullStrategy: one list, the
    /// constraints in the matrix pattern.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Callback for each round of the search; an exception ends the search.
  using Monitor = std::function<void(const Round &)>;

  /// The numerical compliance d >= a [length / force] of a constraint, the
  /// proximal term of the method of multipliers:
  ///   lambda = max(0, ((d - a) lambda_bar - g) / d).
  /// The force is a function of the gap g even for a = 0, and satisfies the
  /// contact law if the estimate lambda_bar equals lambda.
  class NumericalCompliance
  {
  public:
    /// Returns d of @p row: 1/eps for `penalty`, otherwise 1 / (eps s) with the
    /// penalty eps of the constraint and the factor s `stiffening` (less for
    /// `exact` in the condensed strategy).
    double
    operator()(const GapConstraint &row) const;

    /// Multiplies the penalty by ten, so that the estimates converge faster.
    /// Returns false, without effect, if the factor is 1000.
    bool
    increase_penalty();

    /// Current factor s of the penalty; no effect for `penalty`.
    double stiffening = 1.;
  };
} // namespace lamella

#endif
