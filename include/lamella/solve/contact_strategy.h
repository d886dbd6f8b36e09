// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_strategy_h
#define lamella_solve_contact_strategy_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/structure.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * How the linear system of one Newton iteration is solved. With B_A the
   * active gap rows, all of it in total form,
   *   K du - B_A^T dlambda     = r_u     (equilibrium, on unconstrained DoFs)
   *   B_A du + dlambda / eps   = r_lambda (the law lambda = -eps g),
   * which is the paper's Eq. 22 when dlambda is eliminated.
   */
  class ContactStrategy
  {
  public:
    virtual ~ContactStrategy() = default;

    /// @p active: numbers of the active rows; @p r_lambda and @p dlambda have
    /// an entry for each of them. @p r_u need not be condensed; null means
    /// zero. du vanishes in what supports prescribe.
    virtual void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               *r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda) = 0;

    /// The largest estimate of a condition number met so far, 0 if unknown.
    virtual double
    condition_estimate() const = 0;
  };
} // namespace lamella

#endif
