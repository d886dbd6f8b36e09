// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_leaning_rows_h
#define lamella_solve_leaning_rows_h

#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/contact_solver.h>

#include <vector>

namespace lamella
{
  /**
   * The rows of a state that press bodies on obstacles, for bodies that nothing
   * else keeps from buckling (a column behind a stop, a sheet between a
   * pressure and a floor): the tangent K of such a body is not definite, while
   * with a spring rho in each of these rows, S = K + rho B^T B, it is.
   *
   * With the shift lambda' = lambda + rho g of their forces the increment x
   * from a state of the gaps g_0,
   *   K x = r + B^T (lambda - lambda_0),   lambda = -eps g,
   * is that of
   *   S x = r + B^T (lambda' - lambda'_0),   lambda' = -(eps - rho) g,
   * as long as the row bears a force: a contact problem of the same kind, whose
   * S has a Cholesky factor. Where a row opens x is off by the spring's force,
   * which the next iteration knows. rho is a share of the penalty eps: the
   * less, the less the rounding of gaps, rho times that, is in the forces. Rows
   * of a law without penalty keep theirs, a number of the method.
   *
   * That S is definite says that the state is stable as long as these rows bear
   * forces.
   */
  class LeaningRows
  {
  public:
    /// Of each body.
    using Springs = std::vector<std::vector<SpringTerm>>;

    /// Those of @p state with the rows of @p contacts, rho @p share of eps.
    /// @p n_bodies are those of the scene.
    LeaningRows(const std::vector<ContactInterface> &contacts,
                const State                         &state,
                const unsigned int                   n_bodies,
                const double                         share);

    bool
    none() const
    {
      return leaning.empty();
    }

    const Springs &
    springs() const
    {
      return of_bodies;
    }

    /// All rows of the contacts, leaning ones with what penalty is left.
    GapRows
    rows() const
    {
      return GapRows(softened);
    }

    /// lambda' of @p state displaced to @p u at @p factor in the place of its
    /// forces, and back; rows that would pull then are open.
    void
    take_springs_off(const BlockVector &u,
                     const LoadFactor  &factor,
                     State             &state) const;
    void
    put_springs_on(const BlockVector &u,
                   const LoadFactor  &factor,
                   State             &state) const;

  private:
    struct Leaning
    {
      unsigned int row;
      double       spring;
    };
    std::vector<Leaning>          leaning;
    Springs                       of_bodies;
    std::vector<ContactInterface> softened;
  };
} // namespace lamella

#endif
