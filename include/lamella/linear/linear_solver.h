// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `linear`: matrices and their solvers. It owns the assembled
// stiffness, the factorisations of CHOLMOD and MUMPS, conjugate gradients, and
// the products B K^-1 B^T of rows that contact asks for, half solved. All of
// them are asked through LinearSolver. It takes blocks and rows as they come
// and never knows what a beam, a support or a contact is.

#ifndef lamella_linear_linear_solver_h
#define lamella_linear_linear_solver_h

#include <lamella/base/row.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// What solves with the stiffness of a body.
  enum class SolverKind
  {
    automatic, ///< what suits the body and the number of processes
    cholmod,   ///< Cholesky factorisation on one process
    mumps,     ///< Cholesky factorisation shared by all processes
    cg         ///< conjugate gradients with algebraic multigrid
  };

  /// As in a scene file: `auto`, `cholmod`, `mumps`, `cg`.
  std::string
  name_of(const SolverKind kind);

  /// What a factor will take, known from the matrix's pattern alone.
  struct FactorSize
  {
    /// Of all processes together.
    double non_zeros = 0.;
    /// Of this process, with the workspace that it takes to get there.
    double bytes = 0.;
  };

  /// Is told of a factor before memory is spent on it; what it throws prevents
  /// that. Called on all processes or on none.
  using FactorMonitor = std::function<void(const FactorSize &)>;

  /// Is told how far the making of a solver is.
  struct SolverMonitor
  {
    /// The matrix is assembled; called on all processes.
    std::function<void()> assembled;
    FactorMonitor         sized;
  };

  /// What solving took so far.
  struct SolverStatistics
  {
    SolverKind kind = SolverKind::automatic;
    /// Of the factor; 0 if there is none.
    double non_zeros = 0.;
    /// Right-hand sides, the iterations of all of them and of the slowest; no
    /// iterations if there is a factor.
    unsigned int solutions = 0, iterations = 0, most_iterations = 0;
  };

  /// For users: "MUMPS on 2 processes, factor of 2.3e6 non-zeros".
  std::string
  to_text(const SolverStatistics &statistics);

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

    /// The largest entry of A's diagonal.
    virtual double
    largest_diagonal() const = 0;

    /// A lower estimate of the condition number of A, or 0 if there is none.
    virtual double
    condition_estimate() const = 0;

    /// What it is and what it took.
    virtual SolverStatistics
    statistics() const = 0;
  };
} // namespace lamella

#endif
