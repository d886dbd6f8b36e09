// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/solve/full_strategy.h>

#include <deal.II/base/index_set.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

namespace lamella
{
  using namespace dealii;

  FullStrategy::FullStrategy(const Structure           &structure,
                             const std::vector<GapRow> &rows)
    : structure(structure)
    , rows(rows)
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        Constraints shifted;
        shifted.copy_from(structure.reduction(b).constraints());
        shifted.shift(structure.load().get_block_indices().block_start(b));
        constraints.merge(shifted);
      }
    constraints.close();
  }



  std::vector<Row::Entry>
  FullStrategy::global_row(const GapRow &row) const
  {
    std::vector<Row::Entry> entries;
    for (const BodyRow &part : row.parts)
      for (const auto &[dof, weight] : part.row.entries())
        entries.emplace_back(
          structure.load().get_block_indices().local_to_global(part.body, dof),
          weight);
    return entries;
  }



  void
  FullStrategy::factorise(const std::vector<unsigned int> &active)
  {
    const auto &blocks = structure.load().get_block_indices();

    // The pattern: the bodies' own, and the couplings of the active rows.
    DynamicSparsityPattern pattern(structure.n_dofs());
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const auto &entry : structure.bodies()[b]->stiffness())
        pattern.add(blocks.local_to_global(b, entry.row()),
                    blocks.local_to_global(b, entry.column()));
    std::vector<std::vector<DofIndex>> dofs;
    std::vector<FullMatrix<double>>    penalties;
    for (const unsigned int r : active)
      {
        const std::vector<Row::Entry> row = global_row(rows[r]);
        dofs.emplace_back();
        for (const Row::Entry &entry : row)
          dofs.back().push_back(entry.first);
        // k^p = eps n^T n (Eq. 23), with the row in place of n.
        penalties.emplace_back(row.size());
        for (unsigned int i = 0; i < row.size(); ++i)
          for (unsigned int j = 0; j < row.size(); ++j)
            penalties.back()(i, j) =
              rows[r].penalty * row[i].second * row[j].second;
        constraints.add_entries_local_to_global(dofs.back(), pattern, false);
      }

    solver.reset();
    matrix.reinit(pattern);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const auto &entry : structure.bodies()[b]->stiffness())
        matrix.add(blocks.local_to_global(b, entry.row()),
                   blocks.local_to_global(b, entry.column()),
                   entry.value());
    for (unsigned int k = 0; k < active.size(); ++k)
      constraints.distribute_local_to_global(penalties[k], dofs[k], matrix);
    matrix.compress(VectorOperation::add);

    solver = std::make_unique<TrilinosWrappers::SolverDirect>(
      control,
      TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Mumps"));
    solver->initialize(matrix);
    factorised_for = active;
  }



  void
  FullStrategy::solve(const std::vector<unsigned int> &active,
                      const BlockVector               *r_u,
                      const Vector                    &r_lambda,
                      BlockVector                     &du,
                      Vector                          &dlambda)
  {
    if (solver == nullptr || factorised_for != active)
      factorise(active);

    // (K + K^p) du = r_u + B^T eps r_lambda.
    du = r_u == nullptr ? structure.zero() : *r_u;
    for (unsigned int k = 0; k < active.size(); ++k)
      rows[active[k]].add_to(du, rows[active[k]].penalty * r_lambda[k]);
    structure.condense(du);

    TrilinosWrappers::MPI::Vector x, b;
    b.reinit(complete_index_set(structure.n_dofs()));
    x.reinit(b);
    for (unsigned int i = 0; i < b.size(); ++i)
      b[i] = du[i];
    b.compress(VectorOperation::insert);
    solver->solve(x, b);
    for (unsigned int i = 0; i < b.size(); ++i)
      du[i] = x[i];
    for (unsigned int body = 0; body < structure.bodies().size(); ++body)
      structure.reduction(body).constraints().distribute(du.block(body));

    dlambda.reinit(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const GapRow &row = rows[active[k]];
        dlambda[k]        = row.penalty * (r_lambda[k] - row.opening(du));
      }
  }
} // namespace lamella
