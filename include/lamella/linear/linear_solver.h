// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `linear`: matrices and their solvers. It owns the assembled
// stiffness, the factorisations of CHOLMOD and MUMPS and one by dense blocks,
// conjugate gradients, and the products B K^-1 B^T of rows that contact asks
// for, half solved. All of them are asked through LinearSolver. It takes blocks
// and rows as they come and never knows what a beam, a support or a contact is.

#ifndef lamella_linear_linear_solver_h
#define lamella_linear_linear_solver_h

#include <lamella/base/names.h>
#include <lamella/base/row.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// What solves with the stiffness of a body. All of them take the matrix for
  /// symmetric positive definite. What is offered for a body depends on it:
  /// Body::solver_kind() decides and refuses.
  enum class SolverKind
  {
    automatic, ///< what suits the body and the number of processes
    cholmod,   ///< Cholesky factorisation on one process
    mumps,     ///< Cholesky factorisation shared by all processes
    cg,        ///< conjugate gradients with algebraic multigrid
    blocks     ///< Cholesky factorisation by dense blocks (factorise_blocks());
               ///< never asked for, what `automatic` is for bodies with them
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

  /// What a factor will take, known from the matrix's pattern alone. The result
  /// of the symbolic analysis (ordering, elimination tree), which costs little
  /// beside the factorisation itself.
  struct FactorSize
  {
    /// Of all processes together. Numbers stored for the factor, 8 bytes each.
    double non_zeros = 0.;
    /// Of this process, with the workspace that it takes to get there.
    double bytes = 0.;
  };

  /// Is told of a factor before memory is spent on it; what it throws prevents
  /// that. Called on all processes or on none. The memory budget is such a
  /// monitor: it compares with what the machine has left and throws InputError.
  using FactorMonitor = std::function<void(const FactorSize &)>;

  /// What a factor with @p n columns and @p non_zeros takes at least, in
  /// multiplications: z^2 / n, the sum of the squares of its columns where
  /// these are alike.
  inline double
  operations_of_factor(const double non_zeros, const double n)
  {
    return non_zeros * non_zeros / n;
  }

  /// Callbacks of the construction of a solver. Each may be empty. Each is
  /// called once, in the order of declaration. `blocks` is assembled inside its
  /// factor, whose size it reports first.
  struct SolverMonitor
  {
    /// The matrix is assembled; called on all processes.
    std::function<void()> assembled;
    /// The factor is analysed and not yet computed; never called for `cg`.
    FactorMonitor sized;
  };

  /// What solving took so far.
  struct SolverStatistics
  {
    /// Never `automatic` in what a solver returns.
    SolverKind kind = SolverKind::automatic;
    /// Of the factor; 0 if there is none.
    double non_zeros = 0.;
    /// Right-hand sides, the iterations of all of them and of the slowest; no
    /// iterations if there is a factor.
    unsigned int solutions = 0, iterations = 0, most_iterations = 0;
  };

  /// For users: "MUMPS on 2 processes, factor of 2.3e6 non-zeros". For `cg` the
  /// numbers of solutions and iterations take the factor's place.
  std::string
  to_text(const SolverStatistics &statistics);

  /**
   * Rows b_k with what a solver has made of them, for the compliance B A^-1
   * B^T. The object refers to its solver. Where several processes share the
   * matrix, all of them call all functions with the same arguments and get the
   * same values.
   *
   * The compliance is the Schur complement of contact: with the contact forces
   * lambda and the initial gaps g_0,
   *
   *   A v = f + B^T lambda, B v + g_0 = 0
   *
   * is statically condensed to
   *
   *   (B A^-1 B^T) lambda = -(g_0 + B A^-1 f),
   *
   * a dense system as small as the contact. Entry (i, j) is the opening of row
   * i under a unit force in row j: length/force where rows are gaps.
   *
   * Only the linear parts of rows count, and DoFs that constraints eliminate
   * must not be named: rows come as Row::reduced() leaves them, without
   * constants. Rows are numbered in the order of their appending and never
   * removed.
   */
  class SolvedRows
  {
  public:
    virtual ~SolvedRows() = default;

    /// Solves for @p rows, all at once: the more, the faster a row. Earlier
    /// rows and their products stay as they are. An iteration that does not
    /// converge throws NumericsError.
    virtual void
    append(const std::vector<Row> &rows) = 0;

    /// The number m of all rows appended so far.
    virtual unsigned int
    size() const = 0;

    /// b_i A^-1 b_j of the rows i from @p first on with all j, at [j * (size()
    /// - first) + i - first]. An (m - first) x m matrix, column by column. With
    /// first the size() before the last append() it is what that call added;
    /// the transposed part follows by symmetry.
    virtual std::vector<double>
    products(const unsigned int first) const = 0;

    /// A^-1 B^T @p lambda, all rows. @p lambda has one number per row. The
    /// result is a whole vector of the body, in which constrained DoFs are
    /// still to be distributed.
    virtual Vector
    displacement(const std::vector<double> &lambda) const = 0;
  };



  /**
   * What applies the inverse of a symmetric positive definite matrix A, by a
   * factorisation or by iteration. Vectors are whole on every process; where
   * several share the matrix, all call all functions with the same arguments
   * and get the same values.
   *
   * A solver owns what it solves with: the matrix that it was made from may go
   * (`cg` shares in its ownership). It must outlive the SolvedRows that it
   * hands out. What the assembled matrix has lost by rounding, refinement
   * against the strain-first residual brings back (doc/stable-basis.md).
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// x = A^-1 x. NumericsError if an iteration does not converge. @p x holds
    /// the right-hand side on entry, whole on every process, and the solution
    /// at the end. Entries of constrained DoFs are to be zero.
    virtual void
    solve(Vector &x) const = 0;

    /// The same for several right-hand sides; faster together where the solver
    /// can.
    virtual void
    solve_all(std::vector<Vector> &x) const
    {
      for (Vector &one : x)
        solve(one);
    }

    /// For rows to be solved. An empty set; several may exist side by side.
    /// Refers to this solver.
    virtual std::unique_ptr<SolvedRows>
    solved_rows() const = 0;

    /// The largest entry of A's diagonal. In absolute value; force/length where
    /// DoFs are displacements.
    virtual double
    largest_diagonal() const = 0;

    /// A lower estimate of the condition number of A, or 0 if there is none.
    /// CHOLMOD's factor has one at no cost; MUMPS and conjugate gradients have
    /// none.
    virtual double
    condition_estimate() const = 0;

    /// What it is and what it took. Counts go on from one call to the next.
    virtual SolverStatistics
    statistics() const = 0;
  };
} // namespace lamella

#endif
