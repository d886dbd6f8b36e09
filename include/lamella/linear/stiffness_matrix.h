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
  /// Entries that add to a stiffness, between all @p rows and all @p columns.
  /// Of a beam a block is one row of the Kronecker products of its axis and
  /// section matrices, sums of the fundamental nuclei (Eq. 12) over what
  /// couples with that DoF. Other bodies may hand over element matrices: what
  /// the blocks are does not matter, only their sum.
  struct StiffnessBlock
  {
    /// DoFs of the body, before any constraint is applied. They may be named by
    /// several blocks, whose values add up.
    std::vector<DofIndex> rows, columns;
    /// Whether @p columns is sorted, which spares a search.
    bool columns_ascend = false;
    /// Row by row; empty where only the pattern is asked for. Value (i, j) at
    /// [i * columns.size() + j]; force/length.
    std::vector<double> values;

    /// f += the block times @p w.
    void
    add_product(const Vector &w, Vector &f) const
    {
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < columns.size(); ++j)
          f[rows[i]] += values[i * columns.size() + j] * w[columns[j]];
    }
  };

  /// A term k r^T r of the stiffness: a spring k to the ground in what the row
  /// r measures. The second is k, force/length where r is a length. The
  /// constant part of r takes no part.
  using SpringTerm = std::pair<Row, double>;

  /// What the stiffness of a body is assembled from. The matrix is the sum of
  /// all blocks and of k r^T r over the springs, before it is condensed.
  struct StiffnessTerms
  {
    /// Rows of the whole matrix, constrained ones included.
    DofIndex n_dofs = 0;
    /// The DoFs whose rows this process keeps; contiguous.
    dealii::IndexSet owned;
    /// Calls its second argument with block after block of the unconstrained
    /// stiffness, with values if the first is true: all of them together, or
    /// this process's share where several assemble. The assembly calls it
    /// several times, for the pattern and for the values.
    std::function<void(const bool,
                       const std::function<void(const StiffnessBlock &)> &)>
      for_each_block;
    /// All springs of the body, the same list on every process.
    std::vector<SpringTerm> springs;
  };

  /**
   * The stiffness of a body, condensed by the homogeneous part of its
   * constraints: constrained DoFs keep a positive diagonal and nothing else.
   *
   *   A = G^T K G, u = G v + u_p,
   *
   * with the stiffness K of the terms and the unconstrained DoFs v. It keeps
   * the numbering of all DoFs, so that vectors need no second map: rows and
   * columns of constrained DoFs are empty but for the diagonal.
   */
  class StiffnessMatrix
  {
  public:
    virtual ~StiffnessMatrix() = default;

    /// Calls @p use with row, column and value of the entries of those rows
    /// that this process keeps. Both triangles, zeros of the pattern included.
    /// A serial matrix keeps all rows.
    virtual void
    for_each_entry(
      const std::function<void(DofIndex, DofIndex, double)> &use) const = 0;

    /// The whole diagonal, on every process. Collective where several processes
    /// share the matrix.
    virtual Vector
    diagonal() const = 0;

    /// Makes the matrix ready to be solved with. Throws NumericsError if it is
    /// not positive definite; @p what names it then. @p monitor is told how
    /// large a factor becomes, if there is one. @p what as in `body 'upper'`.
    /// Solving with the result needs this object no longer. CHOLMOD throws
    /// NotPositiveDefinite, which tells the DoF. Collective where several
    /// processes share the matrix.
    virtual std::unique_ptr<LinearSolver>
    factorise(const std::string   &what,
              const FactorMonitor &monitor = {}) const = 0;

    /// Frees the entries where factorise() has copied them by the time that it
    /// calls its monitor, which may call this: the factor then has their
    /// memory. Elsewhere nothing.
    virtual void
    release()
    {}
  };

  /// In deal.II's SparseMatrix, for one process; factorised by CHOLMOD.
  /// @p constraints must be closed; neither argument is referred to afterwards.
  std::unique_ptr<StiffnessMatrix>
  assemble_serial(const StiffnessTerms &terms, const Constraints &constraints);

  /**
   * In Trilinos' sparse matrix, the rows terms.owned on each process; blocks
   * may add to the rows of other processes. With @p kind = mumps it is
   * factorised, with cg solved by conjugate gradients, preconditioned by
   * smoothed aggregation (ML) that keeps the @p near_null_space: displacements
   * that cost hardly any energy, the rigid motions. Collective. @p constraints
   * must be closed and the same on all processes. Constrained DoFs get the mean
   * diagonal of the others. Vectors of the near-null space are whole; they are
   * copied, and set to zero in constrained DoFs.
   */
  std::unique_ptr<StiffnessMatrix>
  assemble_distributed(const StiffnessTerms      &terms,
                       const Constraints         &constraints,
                       const SolverKind           kind,
                       const std::vector<Vector> &near_null_space = {});
} // namespace lamella

#endif
