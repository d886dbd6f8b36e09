// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/factorization.h>
#include <lamella/linear/stiffness_matrix.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<DofIndex>
    dofs_of(const LinearFunctional &row)
    {
      std::vector<DofIndex> dofs;
      for (const auto &[dof, weight] : row.entries())
        dofs.push_back(dof);
      return dofs;
    }



    FullMatrix<double>
    matrix_of(const SpringTerm &spring)
    {
      const auto        &r = spring.first.entries();
      FullMatrix<double> term(r.size());
      for (unsigned int i = 0; i < r.size(); ++i)
        for (unsigned int j = 0; j < r.size(); ++j)
          term(i, j) = spring.second * r[i].second * r[j].second;
      return term;
    }



    /// Returns the DoFs of each constraint and spring, with their number.
    std::vector<DofIndex>
    couplings_of(const StiffnessTerms &terms, const Constraints &constraints)
    {
      std::vector<DofIndex> couplings;
      for (const auto &line : constraints.get_lines())
        {
          couplings.push_back(line.index);
          couplings.push_back(line.entries.size());
          for (const auto &[dof, weight] : line.entries)
            couplings.push_back(dof);
        }
      for (const SpringTerm &spring : terms.springs)
        {
          const std::vector<DofIndex> dofs = dofs_of(spring.first);
          couplings.push_back(dofs.size());
          couplings.insert(couplings.end(), dofs.begin(), dofs.end());
        }
      return couplings;
    }



    /// The places of the stiffness, condensed.
    DynamicSparsityPattern
    pattern_of(const StiffnessTerms &terms, const Constraints &constraints)
    {
      DynamicSparsityPattern pattern(terms.n_dofs);
      terms.for_each_block(false, [&](const StiffnessBlock &block) {
        for (const DofIndex row : block.rows)
          pattern.add_entries(row,
                              block.columns.begin(),
                              block.columns.end(),
                              block.columns_ascend);
      });
      for (const SpringTerm &spring : terms.springs)
        {
          const std::vector<DofIndex> dofs = dofs_of(spring.first);
          for (const DofIndex row : dofs)
            pattern.add_entries(row, dofs.begin(), dofs.end());
        }
      constraints.condense(pattern);
      return pattern;
    }



    class SerialStiffness : public StiffnessMatrix
    {
    public:
      SerialStiffness(const StiffnessTerms &terms,
                      const Constraints    &constraints)
        : shared(terms.has_loads ? nullptr : terms.shared)
      {
        std::vector<DofIndex> couplings;
        if (shared != nullptr)
          couplings = couplings_of(terms, constraints);
        if (shared != nullptr && shared->pattern != nullptr &&
            shared->couplings == couplings)
          pattern = shared->pattern;
        else
          {
            auto made = std::make_shared<SparsityPattern>();
            // It takes as much memory as the matrix and goes before that is
            // made.
            made->copy_from(pattern_of(terms, constraints));
            pattern = std::move(made);
          }
        if (shared != nullptr)
          {
            shared->couplings = std::move(couplings);
            shared->pattern   = pattern;
          }
        matrix.reinit(*pattern);

        terms.for_each_block(true, [&](const StiffnessBlock &block) {
          const std::size_t n = block.columns.size();
          for (unsigned int i = 0; i < block.rows.size(); ++i)
            matrix.add(block.rows[i],
                       n,
                       block.columns.data(),
                       block.values.data() + i * n,
                       false,
                       block.columns_ascend);
        });
        constraints.condense(matrix);
        for (const SpringTerm &spring : terms.springs)
          constraints.distribute_local_to_global(matrix_of(spring),
                                                 dofs_of(spring.first),
                                                 matrix);
      }

      void
      for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &use)
        const override
      {
        for (DofIndex row = 0; row < matrix.m(); ++row)
          for (auto entry = matrix.begin(row); entry != matrix.end(row);
               ++entry)
            use(row, entry->column(), entry->value());
      }

      Vector
      diagonal() const override
      {
        Vector result(matrix.m());
        for (DofIndex i = 0; i < matrix.m(); ++i)
          result[i] = matrix.diag_element(i);
        return result;
      }

      std::unique_ptr<LinearSolver>
      factorize(const std::string   &what,
                const FactorMonitor &monitor) const override
      {
        return lamella::factorize(
          matrix, what, monitor, shared == nullptr ? nullptr : &shared->factor);
      }

      void
      release() override
      {
        matrix.clear();
        pattern.reset();
      }

    private:
      std::shared_ptr<MatrixPattern>         shared;
      std::shared_ptr<const SparsityPattern> pattern;
      Matrix                                 matrix;
    };
  } // namespace



  std::unique_ptr<StiffnessMatrix>
  assemble_serial(const StiffnessTerms &terms, const Constraints &constraints)
  {
    return std::make_unique<SerialStiffness>(terms, constraints);
  }
} // namespace lamella
