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
  struct StiffnessBlock
  {
    std::vector<DofIndex> rows, columns;
    bool                  columns_ascend = false;
    /// Row by row; empty where only the pattern is asked for.
    std::vector<double> values;
  };

  /// A term k r^T r of the stiffness: a spring k to the ground in what the row
  /// r measures.
  using SpringTerm = std::pair<Row, double>;

  /// What the stiffness of a body is assembled from.
  struct StiffnessTerms
  {
    DofIndex n_dofs = 0;
    /// The DoFs whose rows this process keeps; contiguous.
    dealii::IndexSet owned;
    /// Calls its second argument with block after block of the unconstrained
    /// stiffness, with values if the first is true: all of them together, or
    /// this process's share where several assemble.
    std::function<void(const bool,
                       const std::function<void(const StiffnessBlock &)> &)>
                            for_each_block;
    std::vector<SpringTerm> springs;
  };

  /**
   * The stiffness of a body, condensed by the homogeneous part of its
   * constraints: constrained DoFs keep a positive diagonal and nothing else.
   */
  class StiffnessMatrix
  {
  public:
    virtual ~StiffnessMatrix() = default;

    /// Calls @p use with row, column and value of the entries of those rows
    /// that this process keeps.
    virtual void
    for_each_entry(
      const std::function<void(DofIndex, DofIndex, double)> &use) const = 0;

    /// The whole diagonal, on every process.
    virtual Vector
    diagonal() const = 0;

    /// Makes the matrix ready to be solved with. Throws NumericsError if it is
    /// not positive definite; @p what names it then. @p monitor is told how
    /// large a factor becomes, if there is one.
    virtual std::unique_ptr<LinearSolver>
    factorise(const std::string   &what,
              const FactorMonitor &monitor = {}) const = 0;
  };

  /// In deal.II's SparseMatrix, for one process; factorised by CHOLMOD.
  std::unique_ptr<StiffnessMatrix>
  assemble_serial(const StiffnessTerms &terms, const Constraints &constraints);

  /**
   * In Trilinos' sparse matrix, the rows terms.owned on each process; blocks
   * may add to the rows of other processes. With @p kind = mumps it is
   * factorised, with cg solved by conjugate gradients, preconditioned by
   * smoothed aggregation (ML) that keeps the @p near_null_space: displacements
   * that cost hardly any energy, the rigid motions.
   */
  std::unique_ptr<StiffnessMatrix>
  assemble_distributed(const StiffnessTerms      &terms,
                       const Constraints         &constraints,
                       const SolverKind           kind,
                       const std::vector<Vector> &near_null_space = {});
} // namespace lamella

#endif
