// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_problem_h
#define lamella_solve_contact_problem_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/friction_state.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The softness a of the contact law that the solution has to obey,
   *   g + a lambda >= 0,  lambda >= 0,  (g + a lambda) lambda = 0,
   * with the gap g and the force lambda (positive in compression) of a row: a
   * length over a force. It is 1/eps for `penalty`, which is Eq. 25 read as a
   * compliance: lambda = eps max(0, -g). It is zero for `augmented lagrangian`
   * and `exact`, where the law is that of Kuhn and Tucker (Eq. 18, in which
   * p_N is negative in compression).
   */
  double
  law_softness(const GapRow &row);

  /**
   * A contact problem in increments: what is to be found about a state whose
   * displacements u and contact forces lambda_state are in equilibrium,
   *   K u = t f + B^T lambda_state.
   * The linear solution without contact forces is such a state, and so is a
   * refined one. Vectors have an entry for each gap row of the scene, in the
   * numbering of GapRows.
   */
  struct ContactProblem
  {
    /// Of each row at that state: g_state, a length, negative where the bodies
    /// penetrate, and lambda_state, a force.
    std::vector<double> gap, force;
    /// What is known of the forces that are sought, lambda_bar: the multiplier
    /// estimate of the method of multipliers. Zero where nothing is known; a
    /// good one leaves less penetration to the softness d.
    std::vector<double> estimate;
    /// Numbers of the rows that are likely to be active, ascending. A poor
    /// guess costs rounds, not correctness.
    std::vector<unsigned int> start;
    /// With friction, else empty, of each row by components along its tangents:
    /// the slip in this step at that state, s(u) - s_0, and the shear force
    /// that the state has; the normal and shear forces to begin the search
    /// with.
    std::vector<dealii::Tensor<1, 2>> slip = {}, shear = {};
    std::vector<dealii::Tensor<1, 3>> first_forces = {};
    /// A gap that is less negative than this length is rounding and counts as
    /// closed.
    double closed = 0.;
  };

  /// The answer to a ContactProblem.
  struct ContactSolution
  {
    /// K^-1 B^T (lambda - lambda_state), to be added to the state's
    /// displacements; zero in what supports prescribe.
    BlockVector du;
    /// lambda of each row: the whole force, not its change; zero where the row
    /// is open.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
    /// With friction, of each row: the shear force, and its direction where the
    /// row slips, else zero.
    std::vector<dealii::Tensor<1, 2>> shear = {}, direction = {};
    /// With friction: whether no load path leads to this answer
    /// (CoulombSolution::stability); who ends with it has to fail.
    bool is_unstable = false;
  };

  /**
   * The equations of a linear system with contact, and the forces in them: of
   * each number, a gap or a slip (GapRows), that does not move the equation
   * that says so and its force lambda. Where a row slips its force is along
   *   B_n^T + sum_a c_a B_t,a^T,   c = mu e,
   * e the direction of its shear.
   */
  struct ClosedRows
  {
    ClosedRows() = default;
    /// Those without friction.
    ClosedRows(std::vector<unsigned int> active)
      : numbers(std::move(active))
    {}

    /// Gaps in ascending order first, then slips.
    std::vector<unsigned int> numbers;
    /// Rows that slip, numbers of gaps that are among these, with c.
    std::vector<std::pair<unsigned int, dealii::Tensor<1, 2>>> sliding = {};
  };

  /// What there is to tell of one round of the search for the active rows: a
  /// solution with some active set, and what was wrong with the set.
  struct Round
  {
    /// How many rows were active in it.
    std::size_t active = 0;
    /// Rows whose state was wrong (open ones that penetrate, under `full` also
    /// active ones that pull), and by how much the worst of them missed the
    /// law, a length. None: the set is right.
    std::vector<unsigned int> changed;
    double                    violation = 0.;
  };

  /// What a solver has learnt in the load steps so far. Another one of the
  /// same scene that recalls it gives the same numbers to the last bit: it is
  /// what a resumed run needs beside the last state.
  struct StrategyMemory
  {
    /// That of NumericalSoftness: a power of ten from 1 to 1000.
    double stiffening = 1.;
    /// Of the condensed strategy the rows whose compliance is known, as they
    /// became known together (Compliance::batches()); of `full` one list, the
    /// rows that the matrix has room for.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Is told of each round; what it throws ends the search. It is how a limit
  /// of iterations reaches into a strategy.
  using Monitor = std::function<void(const Round &)>;

  /**
   * The softness d >= a that the arithmetic of a row is done with, a length
   * over a force: the proximal term of the method of multipliers,
   *   lambda = max(0, ((d - a) lambda_bar - g) / d).
   * A law with a = 0 has no force as a function of the gap; this one has, and
   * with lambda_bar = lambda it is the law itself.
   */
  class NumericalSoftness
  {
  public:
    /// d of @p row: exactly the law's 1/eps for `penalty`, otherwise
    /// 1 / (eps s) with the row's penalty eps (force / length) and the
    /// stiffening s so far. (The condensed strategy takes less for `exact`.)
    double
    operator()(const GapRow &row) const;

    /// Raises the penalty of rows whose estimate is improved tenfold: a harder
    /// d converges in fewer rounds of estimates. Changes nothing and returns
    /// false once it is 1000 times what it was.
    bool
    stiffen();

    /// How much it was raised so far; of no effect on `penalty`.
    double stiffening = 1.;
  };
} // namespace lamella

#endif
