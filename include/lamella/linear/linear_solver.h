// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_linear_solver_h
#define lamella_linear_linear_solver_h

// The room `linear`: the assembled stiffness matrix, its factorization by
// CHOLMOD or MUMPS, conjugate gradients, and the compliance B
// K^-1 B^T of constraints. It is independent of beams and contacts.

#include <lamella/base/linear_functional.h>
#include <lamella/base/names.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Kind of linear solver for the symmetric positive definite stiffness matrix
  /// of a body. solver_kind() checks whether the body supports it.
  enum class SolverKind
  {
    automatic, ///< choice by body and number of processes
    cholmod,   ///< Cholesky factorization on one process
    mumps,     ///< Cholesky factorization shared by all processes
    cg         ///< conjugate gradients with algebraic multigrid
  };

  /// Names of the linear solvers in parameter files.
  template <>
  struct Names<SolverKind>
  {
    /// Value and name of each linear solver that a user may choose.
    static constexpr NameOf<SolverKind> all[] = {
      {SolverKind::automatic, "auto"},
      {SolverKind::cholmod, "cholmod"},
      {SolverKind::mumps, "mumps"},
      {SolverKind::cg, "cg"}};
  };

  /// Memory requirement of a matrix factor, predicted by symbolic analysis.
  struct FactorSize
  {
    /// Number of nonzeros of the factor on all processes, 8 bytes each.
    double non_zeros = 0.;
    double bytes     = 0.; ///< Memory on this process, with workspace [bytes].
  };

  /// Callback before the memory of a factor is allocated. It is called on all
  /// processes, and may throw an exception to prevent the allocation.
  using FactorMonitor = std::function<void(const FactorSize &)>;

  /// Returns a lower bound, non_zeros^2 / n, of the number of multiplications
  /// for computing a factor with @p n columns and @p non_zeros nonzeros.
  inline double
  operations_of_factor(const double non_zeros, const double n)
  {
    return non_zeros * non_zeros / n;
  }

  /// Optional callbacks during the construction of a solver, each called once:
  /// first `assembled`, then `factor_sized`.
  struct SolverMonitor
  {
    std::function<void()> assembled; ///< Called collectively after assembly.
    /// Called between symbolic analysis and factorization; not for `cg`.
    FactorMonitor factor_sized;
  };

  /// Kind, memory and cumulative number of iterations of a linear solver.
  struct SolverStatistics
  {
    /// Kind of solver; never SolverKind::automatic if returned by a solver.
    SolverKind kind = SolverKind::automatic;
    /// Number of nonzeros of the factor; 0 for conjugate gradients.
    double       non_zeros = 0.;
    unsigned int solutions = 0, ///< Number of solved right-hand sides.
      iterations           = 0, ///< Iterations in total; 0 for direct solvers.
      max_iterations_per_solve = 0; ///< Most iterations for one solution.
  };

  /// Returns a text for the user: "MUMPS on 2 processes, factor of 2.3e6
  /// non-zeros"; for `cg` with the numbers of solutions and iterations instead.
  std::string
  to_text(const SolverStatistics &statistics);

  /// Constraints with matrix B (rows b_k), and their solutions A^-1 b_k or
  /// equivalent data, for the compliance B A^-1 B^T. The solver must outlive
  /// this object. If the matrix is distributed, all processes must call each
  /// function with the same arguments; the results are equal.
  ///
  /// The compliance is the Schur complement of contact: with the contact forces
  /// lambda, the initial gaps g_0 and the loads f,
  ///   A v = f + B^T lambda, B v + g_0 = 0
  /// is statically condensed to
  ///   (B A^-1 B^T) lambda = -(g_0 + B A^-1 f).
  /// Entry (i, j) is the change of gap i due to a unit contact force j
  /// [length/force]. Rows must be results of LinearFunctional::reduced(); their
  /// constant parts are ignored. Rows are numbered in the order of appending.
  class SolvedRows
  {
  public:
    virtual ~SolvedRows() = default;

    /// Appends the constraints @p rows and solves A x = b for all rows b
    /// together. Throws NumericsError if an iteration does not converge.
    virtual void
    append(const std::vector<LinearFunctional> &rows) = 0;

    /// Returns the number of appended constraints.
    virtual unsigned int
    size() const = 0;

    /// Returns the compliances b_i A^-1 b_j of constraints i >= @p first and
    /// all constraints j, at [j * (m - first) + i - first] with m = size().
    virtual std::vector<double>
    products(const unsigned int first) const = 0;

    /// Returns the displacements A^-1 B^T @p lambda of the body due to the
    /// forces @p lambda, one per constraint with matrix B. The caller must
    /// compute constrained DoFs by AffineConstraints::distribute().
    virtual Vector
    displacement(const std::vector<double> &lambda) const = 0;
  };



  /// A direct or iterative solver for a symmetric positive definite matrix A.
  /// Every process stores whole vectors. If the matrix is distributed, all
  /// processes must call each function with the same arguments.
  ///
  /// The solver owns its data and must outlive its SolvedRows. Rounding errors
  /// of the assembled matrix can be removed by iterative refinement with
  /// residuals computed from strains (doc/theory/stable-basis.md).
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Computes x = A^-1 x. @p x must be zero in constrained DoFs. Throws
    /// NumericsError if the iteration does not converge.
    virtual void
    solve(Vector &x) const = 0;

    /// Solves for all right-hand sides @p x, with some solvers simultaneously.
    /// This default implementation calls solve() for each of them.
    virtual void
    solve_all(std::vector<Vector> &x) const
    {
      for (Vector &one : x)
        solve(one);
    }

    /// Returns an object for compliances of constraints, initially without
    /// constraints. It keeps a reference to this solver.
    virtual std::unique_ptr<SolvedRows>
    solved_rows() const = 0;

    /// Returns the largest diagonal entry of A in absolute value.
    virtual double
    largest_diagonal() const = 0;

    /// Returns a lower bound of the condition number of A; 0 if unknown.
    virtual double
    condition_estimate() const
    {
      return 0.;
    }

    /// Returns the kind of solver, its memory and its cumulative iterations.
    virtual SolverStatistics
    statistics() const = 0;
  };

  /// Compliance B A^-1 B^T of constraints for solvers without a factor of the
  /// matrix A (MUMPS, conjugate gradients). m constraints take m solutions and
  /// 4 m^2 bytes. Each call of displacement() takes one more solution.
  class RowProducts : public SolvedRows
  {
  public:
    /// Function that returns the compliance b_j A^-1 b_i for all @p rows b_j
    /// and the rows b_i with i >= @p first, at [(i - first) * n_rows + j].
    using Solve = std::function<
      std::vector<double>(const std::vector<LinearFunctional> &rows,
                          const unsigned int                   first)>;

    /// Keeps a reference to @p solver, which has @p n_dofs unknowns.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    /// Appends the constraints @p added and computes their compliances.
    void
    append(const std::vector<LinearFunctional> &added) override;

    /// Returns the number of appended constraints.
    unsigned int
    size() const override
    {
      return rows.size();
    }

    std::vector<double>
    products(const unsigned int first) const override;

    /// Returns A^-1 B^T @p lambda by one solution with A.
    Vector
    displacement(const std::vector<double> &lambda) const override;

  private:
    const LinearSolver &solver; ///< Solver, which must outlive this object.
    DofIndex            n_dofs;
    Solve               solve;
    std::vector<LinearFunctional> rows; ///< Constraints in appended order.
    /// Compliances kept[i][j] = b_j A^-1 b_i of each constraint i with all
    /// constraints j that were appended before or together with i.
    std::vector<std::vector<double>> kept;
  };

  /// Returns a conjugate gradient solver for stiffness matrices of nodal
  /// displacements, preconditioned by the smoothed aggregation multigrid of
  /// Trilinos ML. Memory and work are proportional to the number of DoFs.
  /// Coarse levels preserve the vectors @p near_null_space (such as rigid-body
  /// motions), which must be zero in constrained DoFs. If there are six, they
  /// must be the rigid-body motions of nodes with three DoFs each.
  ///
  /// The iteration for A x = b ends if |b - A x| <= 1e-11 |b|. Throws
  /// NumericsError, with @p what as name of A, if this takes more than 2000
  /// iterations. The smoother is Chebyshev's; the coarsest level of at most 300
  /// unknowns is solved directly. Shares the ownership of @p matrix. There is
  /// no condition estimate. Collective, as are all functions of the solver.
  std::unique_ptr<LinearSolver>
  make_conjugate_gradients(std::shared_ptr<const SharedMatrix> matrix,
                           const std::vector<Vector>          &near_null_space,
                           const std::string                  &what);
} // namespace lamella

#endif
