// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/linear/factorization.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/linear/stiffness_matrix.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A contribution to a row: columns and values (null for the pattern).
    using RowUse = std::function<void(const DofIndex               row,
                                      const std::vector<DofIndex> &columns,
                                      const double *const          values,
                                      const bool columns_ascend)>;



    /// The stiffness without its constrained DoFs, G^T K G, piece by piece.
    class CondensedTerms
    {
    public:
      /// All are referred to.
      CondensedTerms(const StiffnessTerms &terms,
                     const Constraints    &constraints)
        : terms(terms)
        , constraints(constraints)
        , constrained(terms.n_dofs)
      {
        for (const auto &line : constraints.get_lines())
          constrained[line.index] = true;
      }

      /// Calls @p use with own blocks and springs of the condensed matrix.
      void
      for_each_row(const bool with_values, const RowUse &use) const
      {
        terms.for_each_block(with_values, [&](const StiffnessBlock &block) {
          add_block(block, use);
        });
        for (const SpringTerm &spring : terms.springs)
          add_spring(spring, use);
      }

      bool
      is_constrained(const DofIndex dof) const
      {
        return constrained[dof];
      }

    private:
      void
      add_block(const StiffnessBlock &block, const RowUse &use) const
      {
        const bool columns_free =
          std::none_of(block.columns.begin(),
                       block.columns.end(),
                       [this](const DofIndex dof) { return constrained[dof]; });
        for (unsigned int i = 0; i < block.rows.size(); ++i)
          {
            const double *const values =
              block.values.empty() ?
                nullptr :
                block.values.data() + i * block.columns.size();
            if (columns_free && !constrained[block.rows[i]])
              use(block.rows[i], block.columns, values, block.columns_ascend);
            else
              add_condensed(block.rows[i], block.columns, values, use);
          }
      }

      void
      add_spring(const SpringTerm &spring, const RowUse &use) const
      {
        const LinearFunctional row = spring.first.reduced(constraints);
        std::vector<DofIndex>  columns;
        for (const LinearFunctional::Entry &entry : row.entries())
          columns.push_back(entry.first);
        // All processes know all springs.
        for (const auto &[dof, weight] : row.entries())
          if (terms.owned.is_element(dof))
            {
              std::vector<double> values;
              for (const LinearFunctional::Entry &entry : row.entries())
                values.push_back(spring.second * weight * entry.second);
              use(dof, columns, values.data(), true);
            }
      }

      /// One row of a block of which constrained DoFs are part.
      void
      add_condensed(const DofIndex               row,
                    const std::vector<DofIndex> &columns,
                    const double *const          values,
                    const RowUse                &use) const
      {
        LinearFunctional entries;
        for (unsigned int j = 0; j < columns.size(); ++j)
          entries.add(columns[j], values == nullptr ? 1. : values[j]);
        const LinearFunctional free = entries.reduced(constraints);
        std::vector<DofIndex>  free_columns;
        for (const LinearFunctional::Entry &entry : free.entries())
          free_columns.push_back(entry.first);
        LinearFunctional target;
        target.add(row, 1.);
        const LinearFunctional targets = target.reduced(constraints);
        for (const auto &[free_row, factor] : targets.entries())
          {
            std::vector<double> scaled;
            for (const LinearFunctional::Entry &entry : free.entries())
              scaled.push_back(factor * entry.second);
            use(free_row,
                free_columns,
                values == nullptr ? nullptr : scaled.data(),
                true);
          }
      }

      const StiffnessTerms &terms;
      const Constraints    &constraints;
      std::vector<bool>     constrained;
    };



    class DistributedStiffness : public StiffnessMatrix
    {
    public:
      DistributedStiffness(const StiffnessTerms      &terms,
                           const Constraints         &constraints,
                           const SolverKind           kind,
                           const std::vector<Vector> &near_null_space)
        : n_dofs(terms.n_dofs)
        , first(terms.owned.n_elements() == 0 ? 0 :
                                                terms.owned.nth_index_in_set(0))
        , end(first + terms.owned.n_elements())
        , kind(kind)
        , near_null_space(near_null_space)
      {
        const CondensedTerms condensed(terms, constraints);
        make_pattern(condensed);
        fill(condensed);
        for (Vector &v : this->near_null_space)
          constraints.set_zero(v);
      }

      void
      for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &use)
        const override
      {
        for_each_own_row(*matrix,
                         [&](const DofIndex               row,
                             const std::vector<DofIndex> &columns,
                             const double *const          values) {
                           for (unsigned int k = 0; k < columns.size(); ++k)
                             use(row, columns[k], values[k]);
                         });
      }

      Vector
      diagonal() const override
      {
        Vector result(n_dofs);
        for_each_entry(
          [&](const DofIndex row, const DofIndex column, const double value) {
            if (row == column)
              result[row] = value;
          });
        sum_over_processes(result);
        return result;
      }

      std::unique_ptr<LinearSolver>
      factorize(const std::string   &what,
                const FactorMonitor &monitor) const override
      {
        if (kind == SolverKind::cg)
          return make_conjugate_gradients(matrix, near_null_space, what);
        UpperTriangle entries;
        // Where the upper half leans to other processes it is a little more.
        const std::size_t half =
          matrix->trilinos_matrix().NumMyNonzeros() / 2 + end - first;
        entries.rows.reserve(half);
        entries.columns.reserve(half);
        entries.values.reserve(half);
        for_each_entry(
          [&](const DofIndex row, const DofIndex column, const double value) {
            entries.add(row, column, value);
          });
        return factorize_shared(n_dofs, std::move(entries), what, monitor);
      }

    private:
      /// The entries of an own row, with columns as Trilinos counts them here.
      struct OwnRow
      {
        int     size    = 0;
        double *values  = nullptr;
        int    *columns = nullptr;
      };

      OwnRow
      own_row(const DofIndex row) const
      {
        OwnRow    entries;
        const int error = matrix->trilinos_matrix().ExtractMyRowView(
          int(row - first), entries.size, entries.values, entries.columns);
        AssertThrow(error == 0, ExcInternalError());
        return entries;
      }

      void
      make_pattern(const CondensedTerms &terms)
      {
        IndexSet owned(n_dofs), written(n_dofs);
        owned.add_range(first, end);
        std::set<DofIndex> others;
        terms.for_each_row(false,
                           [&](const DofIndex row, const auto &, auto, auto) {
                             if (row < first || row >= end)
                               others.insert(row);
                           });
        written.add_range(first, end);
        written.add_indices(others.begin(), others.end());
        written.compress();

        DynamicSparsityPattern pattern(n_dofs, n_dofs, written);
        terms.for_each_row(
          false,
          [&](
            const DofIndex row, const auto &columns, auto, const bool ascend) {
            pattern.add_entries(row, columns.begin(), columns.end(), ascend);
          });
        for (DofIndex row = first; row < end; ++row)
          if (terms.is_constrained(row))
            pattern.add(row, row);
        matrix->reinit(owned, owned, pattern, communicator(), true);

        const auto &columns = matrix->trilinos_matrix().ColMap();
        for (int c = 0; c < columns.NumMyElements(); ++c)
          global_column.push_back(columns.GID64(c));
      }

      void
      fill(const CondensedTerms &terms)
      {
        // Trilinos would search for each column; here a row is laid out once.
        std::vector<int> place(n_dofs);
        terms.for_each_row(true,
                           [&](const DofIndex               row,
                               const std::vector<DofIndex> &columns,
                               const double *const          values,
                               const bool                   ascend) {
                             if (row < first || row >= end)
                               {
                                 matrix->add(row,
                                             columns.size(),
                                             columns.data(),
                                             values,
                                             false,
                                             ascend);
                                 return;
                               }
                             const OwnRow entries = own_row(row);
                             for (int k = 0; k < entries.size; ++k)
                               place[global_column[entries.columns[k]]] = k;
                             for (std::size_t j = 0; j < columns.size(); ++j)
                               entries.values[place[columns[j]]] += values[j];
                           });
        matrix->compress(VectorOperation::add);
        fill_constrained(terms);
      }

      /// Constrained DoFs get the diagonal that others have on average.
      void
      fill_constrained(const CondensedTerms &terms)
      {
        double sum = 0., n_free = 0.;
        for (DofIndex row = first; row < end; ++row)
          if (!terms.is_constrained(row))
            {
              sum += std::abs(matrix->diag_element(row));
              ++n_free;
            }
        sum    = Utilities::MPI::sum(sum, communicator());
        n_free = Utilities::MPI::sum(n_free, communicator());
        for (DofIndex row = first; row < end; ++row)
          if (terms.is_constrained(row))
            own_row(row).values[0] = n_free > 0. ? sum / n_free : 1.;
      }

      DofIndex n_dofs, first, end;
      /// Shared with a solver that iterates.
      std::shared_ptr<SharedMatrix> matrix = std::make_shared<SharedMatrix>();
      /// What the columns of own rows are in the whole matrix.
      std::vector<DofIndex> global_column;
      SolverKind            kind;
      std::vector<Vector>   near_null_space;
    };
  } // namespace



  std::unique_ptr<StiffnessMatrix>
  assemble_distributed(const StiffnessTerms      &terms,
                       const Constraints         &constraints,
                       const SolverKind           kind,
                       const std::vector<Vector> &near_null_space)
  {
    return std::make_unique<DistributedStiffness>(terms,
                                                  constraints,
                                                  kind,
                                                  near_null_space);
  }
} // namespace lamella
