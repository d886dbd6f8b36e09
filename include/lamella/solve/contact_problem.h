// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_problem_h
#define lamella_solve_contact_problem_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// a of the contact law g + a lambda >= 0, lambda >= 0, one of them zero:
  /// 1/eps for `penalty`, zero for the others.
  double
  law_softness(const GapRow &row);

  /// Contact about a state whose displacements and forces are in equilibrium.
  struct ContactProblem
  {
    /// Of each row at that state.
    std::vector<double> gap, force;
    /// What is known of the forces that are sought, lambda_bar.
    std::vector<double> estimate;
    /// Numbers of the rows that are likely to be active.
    std::vector<unsigned int> start;
    /// A gap that is less negative is rounding.
    double closed = 0.;
  };

  struct ContactSolution
  {
    /// To be added to the state's displacements.
    BlockVector du;
    /// Of each row.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
  };

  /// What there is to tell of one round of the search for the active rows.
  struct Round
  {
    std::size_t active = 0;
    /// Rows whose state was wrong, and by how much the worst of them missed the
    /// law, a length.
    std::vector<unsigned int> changed;
    double                    violation = 0.;
  };

  /// What a solver has learnt in the load steps so far. Another one of the
  /// same scene that recalls it gives the same numbers to the last bit.
  struct StrategyMemory
  {
    /// Of NumericalSoftness.
    double stiffening = 1.;
    /// The rows whose compliance is known, as they became known together.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Is told of each round; what it throws ends the search.
  using Monitor = std::function<void(const Round &)>;

  /// The softness d that the arithmetic of a row is done with.
  class NumericalSoftness
  {
  public:
    /// 1 / (penalty times the stiffening so far), or exactly the law's.
    double
    operator()(const GapRow &row) const;

    /// Raises the penalty of rows whose estimate is improved; false once it is
    /// 1000 times what it was.
    bool
    stiffen();

    /// How much it was raised so far.
    double stiffening = 1.;
  };
} // namespace lamella

#endif
