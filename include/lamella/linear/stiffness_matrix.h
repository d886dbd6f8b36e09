// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_stiffness_matrix_h
#define lamella_linear_stiffness_matrix_h

#include <lamella/linear/linear_solver.h>

#include <deal.II/base/index_set.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Stiffness entries between all @p rows and all @p columns, to be added. A
  /// beam block is a row of the Kronecker products of axis and section
  /// matrices, sums of the fundamental nuclei (Eq. 12). Other bodies may use
  /// element matrices.
  struct StiffnessBlock
  {
    /// DoFs of the body before constraints. Values of common DoFs are summed.
    std::vector<DofIndex> rows, columns;
    /// True if @p columns is sorted, which saves a search.
    bool columns_ascend = false;
    /// Values row by row, (i, j) at [i * columns.size() + j], force/length;
    /// empty if only the pattern is requested.
    std::vector<double> values;

    /// Adds the block times @p w to @p f.
    void
    add_product(const Vector &w, Vector &f) const
    {
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < columns.size(); ++j)
          f[rows[i]] += values[i * columns.size() + j] * w[columns[j]];
    }
  };

  /// A stiffness term k r^T r: a spring to the ground along r, with k in
  /// force/length if r is a length.
  using SpringTerm = std::pair<LinearFunctional, double>;

  /// Terms of the stiffness of a bodybefore condensation, the sum of all blocks
  /// and springs k r^T r.
  struct StiffnessTerms
  {
    /// Number of rows of the whole matrix, constrained ones included.
    DofIndex n_dofs = 0;
    /// DoFs whose rows this process owns; contiguous.
    dealii::IndexSet owned;
    /// Calls its second argument with each block of the unconstrained
    /// stiffness, with values if the first is true: all blocks, or this
    /// process's share in a distributed assembly. Called several times.
    std::function<void(const bool,
                       const std::function<void(const StiffnessBlock &)> &)>
      for_each_block;
    /// Springs of the body, the same list on every process.
    std::vector<SpringTerm> springs;
  };

  /// The stiffness of a body, condensed by the homogeneous part of its
  /// constraints,
  ///   A = G^T K G, u = G v + u_p,
  /// with the stiffness K of the terms and the unconstrained DoFs v. All DoFs
  /// keep their numbers; rows and columns of constrained DoFs are empty except
  /// for a positive diagonal.
  class StiffnessMatrix
  {
  public:
    virtual ~StiffnessMatrix() = default;

    /// Calls @p use with row, column and value of the entries in the rows owned
    /// by this process: both triangles, zeros of the pattern included.
    virtual void
    for_each_entry(
      const std::function<void(DofIndex, DofIndex, double)> &use) const = 0;

    /// Returns the whole diagonal. Collective where processes share the matrix.
    virtual Vector
    diagonal() const = 0;

    /// Returns a solver, which does not refer to this object. Throws
    /// NumericsError, naming the matrix @p what, if it is not positive
    /// definite; CHOLMOD throws NotPositiveDefinite with the DoF. @p monitor
    /// receives the size of a factor. Collective where processes share the
    /// matrix.
    virtual std::unique_ptr<LinearSolver>
    factorize(const std::string   &what,
              const FactorMonitor &monitor = {}) const = 0;

    /// Frees the entries if factorize() has copied them before it calls its
    /// monitor, which may call this to make room for the factor.
    virtual void
    release()
    {}
  };

  /// Assembles a deal.II SparseMatrix on one process, to be factorized by
  /// CHOLMOD. @p constraints must be closed.
  std::unique_ptr<StiffnessMatrix>
  assemble_serial(const StiffnessTerms &terms, const Constraints &constraints);

  /// Assembles a Trilinos sparse matrix with the rows terms.owned on each
  /// process; blocks may add to rows of other processes. @p kind = mumps
  /// factorizes it; cg uses conjugate gradients, preconditioned by smoothed
  /// aggregation (ML) that preserves the @p near_null_space, such as rigid
  /// motions. @p constraints must be closed and the same on all processes.
  /// Collective.
  std::unique_ptr<StiffnessMatrix>
  assemble_distributed(const StiffnessTerms      &terms,
                       const Constraints         &constraints,
                       const SolverKind           kind,
                       const std::vector<Vector> &near_null_space = {});
} // namespace lamella

#endif
