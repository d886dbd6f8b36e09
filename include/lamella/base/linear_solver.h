// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_linear_solver_h
#define lamella_base_linear_solver_h

#include <lamella/base/row.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Rows b_k with what a solver has made of them, for the compliance
   * B A^-1 B^T. The object refers to its solver. Where several processes share
   * the matrix, all of them call all functions with the same arguments and get
   * the same values.
   */
  class SolvedRows
  {
  public:
    virtual ~SolvedRows() = default;

    /// Solves for @p rows, all at once: the more, the faster a row.
    virtual void
    append(const std::vector<Row> &rows) = 0;

    virtual unsigned int
    size() const = 0;

    /// b_i A^-1 b_j of the rows i from @p first on with all j, at
    /// [j * (size() - first) + i - first].
    virtual std::vector<double>
    products(const unsigned int first) const = 0;

    /// A^-1 B^T @p lambda, all rows.
    virtual Vector
    displacement(const std::vector<double> &lambda) const = 0;
  };



  /**
   * What applies the inverse of a symmetric positive definite matrix A, by a
   * factorisation or by iteration. Vectors are whole on every process; where
   * several share the matrix, all call all functions with the same arguments
   * and get the same values.
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// x = A^-1 x. NumericsError if an iteration does not converge.
    virtual void
    solve(Vector &x) const = 0;

    /// For rows to be solved.
    virtual std::unique_ptr<SolvedRows>
    solved_rows() const = 0;

    /// A lower estimate of the condition number of A, or 0 if there is none.
    virtual double
    condition_estimate() const = 0;

    /// What it is and what it took, for users: "CHOLMOD, 2.3e6 non-zeros".
    virtual std::string
    description() const = 0;
  };
} // namespace lamella

#endif
