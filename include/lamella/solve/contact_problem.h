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
  /// of a constraint with gap g and force lambda, positive in compression.
  /// `penalty`: a = 1/eps, which is Eq. 25, lambda = eps max(0, -g). `augmented
  /// lagrangian` and `exact`: a = 0, the Kuhn-Tucker conditions of Eq. 18.
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
    /// Estimates lambda_bar of the multipliers (method of multipliers), or
    /// zero. A good one leaves less penetration due to the compliance d.
    std::vector<double> estimate;
    /// Ascending constraints expected to be active, which affect rounds only.
    std::vector<unsigned int> start;
    /// Slip of the step, s(u) - s_0, and shear force of the state, along the
    /// tangents; forces to start from. Empty without friction.
    std::vector<dealii::Tensor<1, 2>> slip = {}, shear = {};
    std::vector<dealii::Tensor<1, 3>> first_forces = {};
    /// Gaps above -closed [length] are rounding and count as closed.
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
    /// True if no load path leads to this solution with friction, which must
    /// then be rejected (CoulombSolution::stability).
    bool is_unstable = false;
  };

  /// The constraint equations of a linear system with contact: each gap or slip
  /// listed by number has an equation for its zero velocity and a force lambda.
  /// In a slipping one the force acts along B_n^T + sum_a c_a B_t,a^T, c = mu
  /// e, e the direction of its shear force.
  struct ActiveConstraints
  {
    ActiveConstraints() = default;
    /// Creates the equations of the @p active gaps, without friction.
    ActiveConstraints(std::vector<unsigned int> active)
      : numbers(std::move(active))
    {}

    /// Numbers of the closed gaps in ascending order, then of the slips.
    std::vector<unsigned int> numbers;
    /// Slipping constraints: numbers of their gaps among `numbers`, with c.
    std::vector<std::pair<unsigned int, dealii::Tensor<1, 2>>> sliding = {};
  };

  /// Outcome of one round of the active-set search with one active set.
  struct Round
  {
    /// Number of active constraints.
    std::size_t active = 0;
    /// Constraints that violate the law (penetrating; with `full` also
    /// tensile), and the largest violation [length].
    std::vector<unsigned int> changed;
    double                    violation = 0.;
  };

  /// Data of a strategy that a resumed run needs beside the last state, for
  /// bitwise equal results.
  struct StrategyHistory
  {
    /// Factor of NumericalCompliance: a power of ten from 1 to 1000.
    double stiffening = 1.;
    /// `condensed`: the rows of the compliance (Compliance::row_groups()).
    /// `full`: one list, the rows in the matrix pattern.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Callback for each round; its exceptions end the search.
  using Monitor = std::function<void(const Round &)>;

  /// The numerical compliance d >= a of a constraint (length over force), the
  /// proximal term of the method of multipliers:
  ///   lambda = max(0, ((d - a) lambda_bar - g) / d),
  /// a function of the gap even for a = 0, the law for lambda_bar = lambda.
  class NumericalCompliance
  {
  public:
    /// Returns d of @p row: 1/eps for `penalty`, otherwise 1 / (eps s) with the
    /// row's penalty eps and the factor s (less for `exact` if condensed).
    double
    operator()(const GapConstraint &row) const;

    /// Raises the penalty tenfold, so that the estimates converge faster.
    /// Returns false, without effect, at a factor of 1000.
    bool
    increase_penalty();

    /// Current factor s of the penalty; no effect on `penalty`.
    double stiffening = 1.;
  };
} // namespace lamella

#endif
