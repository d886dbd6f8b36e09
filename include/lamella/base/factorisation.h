// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_factorisation_h
#define lamella_base_factorisation_h

#include <lamella/base/half_solved_rows.h>
#include <lamella/base/linear_algebra.h>

#include <memory>
#include <string>

namespace lamella
{
  /**
   * The factorisation A = P^T L L^T P of a symmetric positive definite matrix.
   *
   * Its two halves are public because the compliance of rows B needs one only:
   * B A^-1 B^T = Y^T Y with Y = L^-1 P B^T.
   */
  class Factorisation
  {
  public:
    virtual ~Factorisation() = default;

    /// x = A^-1 x.
    virtual void
    solve(Vector &x) const = 0;

    /// For rows to be half solved, y = L^-1 P b; the object refers to this
    /// one.
    virtual HalfSolvedRows
    half_solved_rows() const = 0;

    /// x = P^T L^-T x: A^-1 b, if x is b half solved.
    virtual void
    backward(Vector &x) const = 0;

    /**
     * A lower estimate of the condition number of A, the square of the ratio of
     * the largest to the smallest diagonal entry of L. Cheap and rough: it
     * tells decades.
     */
    virtual double
    condition_estimate() const = 0;

    /// Non-zero entries of L.
    virtual std::size_t
    n_nonzero() const = 0;
  };

  /**
   * Factorises @p matrix, of which only the upper triangle is read, with
   * CHOLMOD's supernodal Cholesky factorisation (LL^T, AMD or METIS ordering,
   * serial).
   *
   * Throws NumericsError if a pivot is not positive; @p what then names the
   * matrix in the message.
   */
  std::unique_ptr<Factorisation>
  factorise(const Matrix &matrix, const std::string &what);
} // namespace lamella

#endif
