// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_stiffness_matrix_h
#define lamella_linear_stiffness_matrix_h

#include <lamella/base/linear_algebra.h>
#include <lamella/linear/linear_solver.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// A dense block of stiffness contributions for all pairs of rows and
  /// columns. For a beam, a block is the stiffness of one axis node with all
  /// its neighbors: a block row of the sum of Kronecker products of axis and
  /// section matrices (the assembled fundamental nuclei, Eq. 12 of Nagaraj et
  /// al. 2020). For other bodies, a block is an element stiffness.
  struct StiffnessBlock
  {
    /// DoFs of the matrix rows, including constrained DoFs.
    std::vector<DofIndex> rows,
      columns; ///< DoFs of the matrix columns, including constrained DoFs.
    /// True if @p columns is sorted (saves a search), false if unknown.
    bool columns_ascend = false;
    /// Entries by rows, (i, j) at [i * columns.size() + j], in force/length;
    /// empty if only the sparsity pattern is needed.
    std::vector<double> values;

    /// Adds the product of the block and displacements @p w to forces @p f.
    void
    add_product(const Vector &w, Vector &f) const
    {
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < columns.size(); ++j)
          f[rows[i]] += values[i * columns.size() + j] * w[columns[j]];
    }
  };

  /// A callback with a block of a stiffness.
  using BlockCallback = std::function<void(const StiffnessBlock &)>;

  /// A stiffness term k r^T r: row vector r and spring constant k of a spring
  /// to the ground along r, with k in force/length if r is dimensionless.
  using SpringTerm = std::pair<LinearFunctional, double>;

  class SymbolicFactor;

  /// Sparsity pattern and symbolic factor of a stiffness matrix, which the
  /// matrices of a body at several displacements have in common. Each matrix
  /// uses them if its couplings are equal, and stores its own otherwise.
  struct MatrixPattern
  {
    /// DoFs of constraints and springs, with the number of each: the part of
    /// the pattern that may change between matrices of one body. Matrices with
    /// blocks of loads (StiffnessTerms::has_loads) share nothing.
    std::vector<DofIndex> couplings;
    /// Sparsity pattern of the condensed matrix; null before the first one.
    std::shared_ptr<const dealii::SparsityPattern> pattern;
    /// Result of CHOLMOD's analysis, for the entries that were not zero.
    std::shared_ptr<const SymbolicFactor> factor;
  };

  /// The stiffness of a body before condensation: sum of blocks and springs.
  struct StiffnessTerms
  {
    DofIndex n_dofs = 0;    ///< Number of DoFs, including constrained ones.
    dealii::IndexSet owned; ///< DoFs whose matrix rows this process owns.
    /// Function that calls its second argument for each block of the
    /// unconstrained stiffness. If the first argument is false, the blocks have
    /// no values. In a distributed assembly, each process has different blocks.
    std::function<void(const bool, const BlockCallback &)> for_each_block;
    std::vector<SpringTerm> springs; ///< Springs, equal on all processes.
    /// True if blocks of loads may couple DoFs that share no element.
    bool has_loads = false;
    /// Pattern to use again for equal couplings; may be null.
    std::shared_ptr<MatrixPattern> shared = {};
  };

  /// The assembled stiffness matrix of a body, condensed by the homogeneous
  /// part of its constraints u = G v + u_p,
  ///   A = G^T K G,
  /// with the stiffness K of the StiffnessTerms and the unconstrained DoFs v. A
  /// has the DoF numbers of K; rows and columns of constrained DoFs are zero
  /// except for a positive diagonal entry.
  class StiffnessMatrix
  {
  public:
    virtual ~StiffnessMatrix() = default;

    /// Calls @p use(row, column, value) for all entries of the rows owned by
    /// this process, in both triangles, including zeros of the pattern.
    virtual void
    for_each_entry(
      const std::function<void(DofIndex, DofIndex, double)> &use) const = 0;

    /// Returns the whole diagonal of the matrix, on every process. If the
    /// matrix is distributed, all processes must call this function.
    virtual Vector
    diagonal() const = 0;

    /// Returns a solver, which does not refer to this object. Throws
    /// NotPositiveDefinite, with @p what as name of the matrix, if it is not
    /// positive definite (multigrid: NumericsError). @p monitor is called with
    /// the size of the factor. Collective if distributed.
    virtual std::unique_ptr<LinearSolver>
    factorize(const std::string   &what,
              const FactorMonitor &monitor = {}) const = 0;

    /// Frees the matrix entries if factorize() has copied them. May be called
    /// by the monitor of factorize(), to provide memory for the factor.
    virtual void
    release()
    {}
  };

  /// Assembles the stiffness matrix on one process, as a deal.II SparseMatrix,
  /// to be factorized by CHOLMOD. @p constraints must be closed.
  std::unique_ptr<StiffnessMatrix>
  assemble_serial(const StiffnessTerms &terms, const Constraints &constraints);

  /// Assembles the stiffness matrix as a distributed Trilinos matrix. Each
  /// process owns the rows terms.owned; its blocks may contribute to rows of
  /// other processes. @p kind is the solver, mumps or cg (see
  /// make_conjugate_gradients(), also for @p near_null_space). @p constraints
  /// must be closed and equal on all processes. Collective.
  std::unique_ptr<StiffnessMatrix>
  assemble_distributed(const StiffnessTerms      &terms,
                       const Constraints         &constraints,
                       const SolverKind           kind,
                       const std::vector<Vector> &near_null_space = {});

  /// Calls @p use(row, columns, values) for each row of @p matrix that this
  /// process owns, with the row index, a vector of column indices and a pointer
  /// to the entries in these columns, valid during the call. Indices are
  /// global; columns are not sorted. The matrix must be compressed.
  template <typename Use>
  void
  for_each_own_row(const SharedMatrix &matrix, const Use &use)
  {
    const Epetra_CrsMatrix &entries = matrix.trilinos_matrix();
    std::vector<DofIndex>   columns;
    for (int local = 0; local < entries.NumMyRows(); ++local)
      {
        int       n      = 0;
        double   *values = nullptr;
        int      *places = nullptr;
        const int error  = entries.ExtractMyRowView(local, n, values, places);
        AssertThrow(error == 0, dealii::ExcInternalError());
        columns.resize(n);
        for (int k = 0; k < n; ++k)
          columns[k] = entries.GCID64(places[k]);
        use(DofIndex(entries.GRID64(local)), columns, values);
      }
  }
} // namespace lamella

#endif
