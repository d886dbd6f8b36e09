// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `linear`: matrices and their solvers. It has the assembled
// stiffness, the factorizations by CHOLMOD, MUMPS and dense blocks, conjugate
// gradients, and the products B K^-1 B^T of contact constraints, behind
// LinearSolver. It is independent of beams, supports and contacts.

#ifndef lamella_linear_linear_solver_h
#define lamella_linear_linear_solver_h

#include <lamella/base/linear_functional.h>
#include <lamella/base/names.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Solver for the stiffness of a body, assumed symmetric positive definite.
  /// Body::solver_kind() determines which ones a body supports.
  enum class SolverKind
  {
    automatic, ///< choice by body and number of processes
    cholmod,   ///< Cholesky factorization on one process
    mumps,     ///< Cholesky factorization shared by all processes
    cg,        ///< conjugate gradients with algebraic multigrid
    blocks     ///< Cholesky factorization by dense blocks (factorize_blocks());
               ///< chosen by `automatic` only, for bodies with such blocks
  };

  template <>
  struct Names<SolverKind>
  {
    static constexpr NameOf<SolverKind> all[] = {
      {SolverKind::automatic, "auto"},
      {SolverKind::cholmod, "cholmod"},
      {SolverKind::mumps, "mumps"},
      {SolverKind::cg, "cg"}};
  };

  /// Size of a factor from the symbolic analysis of the matrix pattern.
  struct FactorSize
  {
    /// Numbers stored for the factor by all processes, 8 bytes each.
    double non_zeros = 0.;
    /// Bytes of this process, including the workspace of the factorization.
    double bytes = 0.;
  };

  /// Callback before the memory of a factor is allocated, on all processes or
  /// on none. An exception prevents the allocation.
  using FactorMonitor = std::function<void(const FactorSize &)>;

  /// Returns a lower bound of the multiplications for a factor with @p n
  /// columns and @p non_zeros: z^2 / n.
  inline double
  operations_of_factor(const double non_zeros, const double n)
  {
    return non_zeros * non_zeros / n;
  }

  /// Callbacks of the construction of a solver, each optional and called once,
  /// in the order of declaration. `blocks` reports the size first.
  struct SolverMonitor
  {
    /// Called on all processes when the matrix is assembled.
    std::function<void()> assembled;
    /// Called between analysis and factorization; never for `cg`.
    FactorMonitor factor_sized;
  };

  /// Effort of a solver so far.
  struct SolverStatistics
  {
    /// Kind of solver, never `automatic` in a result.
    SolverKind kind = SolverKind::automatic;
    /// Nonzeros of the factor; 0 if there is none.
    double non_zeros = 0.;
    /// Number of right-hand sides, of their total iterations and those of the
    /// slowest; no iterations with a factor.
    unsigned int solutions = 0, iterations = 0, max_iterations_per_solve = 0;
  };

  /// Returns a text for the user: "MUMPS on 2 processes, factor of 2.3e6
  /// non-zeros"; for `cg` with the numbers of solutions and iterations instead.
  std::string
  to_text(const SolverStatistics &statistics);

  /**
   * Solved rows b_k for the compliance B A^-1 B^T. Refers to its solver.
   * Collective where processes share the matrix, with the same arguments and
   * results on all.
   *
   * The compliance is the Schur complement of contact: with the contact forces
   * lambda and the initial gaps g_0,
   *   A v = f + B^T lambda, B v + g_0 = 0
   * is statically condensed to
   *   (B A^-1 B^T) lambda = -(g_0 + B A^-1 f).
   * Entry (i, j) is the gap of row i due to a unit force in row j: length/force
   * where rows are gaps. Rows must come from LinearFunctional::reduced(),
   * without constants. They are numbered in the order of appending.
   */
  class SolvedRows
  {
  public:
    virtual ~SolvedRows() = default;

    /// Solves for @p rows together, which is faster per row. Throws
    /// NumericsError if an iteration does not converge.
    virtual void
    append(const std::vector<LinearFunctional> &rows) = 0;

    /// Returns the number m of all rows appended so far.
    virtual unsigned int
    size() const = 0;

    /// Returns b_i A^-1 b_j of the rows i from @p first on with all j, at [j *
    /// (size() - first) + i - first]: an (m - first) x m matrix.
    virtual std::vector<double>
    products(const unsigned int first) const = 0;

    /// Returns A^-1 B^T @p lambda, one entry per row: a whole vector of the
    /// body, in which constrained DoFs are still to be distributed.
    virtual Vector
    displacement(const std::vector<double> &lambda) const = 0;
  };



  /**
   * The inverse of a symmetric positive definite matrix A, by factorization or
   * iteration. Vectors are whole on every process. Collective where processes
   * share the matrix, with the same arguments and results on all.
   *
   * Owns its data and must outlive its SolvedRows. Refinement against the
   * residual from strains removes the rounding errors of the assembled matrix
   * (doc/theory/stable-basis.md).
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Computes x = A^-1 x; @p x is zero in constrained DoFs. Throws
    /// NumericsError if an iteration does not converge.
    virtual void
    solve(Vector &x) const = 0;

    /// Solves for several right-hand sides; faster together with some solvers.
    virtual void
    solve_all(std::vector<Vector> &x) const
    {
      for (Vector &one : x)
        solve(one);
    }

    /// Returns an empty set of solved rows that refers to this solver.
    virtual std::unique_ptr<SolvedRows>
    solved_rows() const = 0;

    /// Returns the largest diagonal entry of A in absolute value.
    virtual double
    largest_diagonal() const = 0;

    /// Returns a lower bound of the condition number of A, or 0 if unknown
    /// (MUMPS, conjugate gradients).
    virtual double
    condition_estimate() const = 0;

    /// Returns the kind of solver and its cumulative effort.
    virtual SolverStatistics
    statistics() const = 0;
  };
} // namespace lamella

#endif
