// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/solve/mass_matrix.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace lamella
{
  MassMatrix::MassMatrix(const Structure &structure, const BlockVector &u)
    : patterns(structure.bodies().size())
    , matrices(structure.bodies().size())
  {
    for (unsigned int b = 0; b < matrices.size(); ++b)
      {
        const Body                    &body = *structure.bodies()[b];
        dealii::DynamicSparsityPattern pattern(body.n_dofs());
        body.for_each_mass_block(u.block(b),
                                 false,
                                 [&](const StiffnessBlock &block) {
                                   for (const DofIndex row : block.rows)
                                     pattern.add_entries(row,
                                                         block.columns.begin(),
                                                         block.columns.end(),
                                                         block.columns_ascend);
                                 });
        patterns[b].copy_from(pattern);
        matrices[b].reinit(patterns[b]);
        body.for_each_mass_block(
          u.block(b), true, [&](const StiffnessBlock &block) {
            for (unsigned int i = 0; i < block.rows.size(); ++i)
              matrices[b].add(block.rows[i],
                              block.columns.size(),
                              block.columns.data(),
                              &block.values[i * block.columns.size()],
                              true,
                              block.columns_ascend);
          });
      }
  }



  BlockVector
  MassMatrix::operator()(const BlockVector &v) const
  {
    BlockVector result(v);
    for (unsigned int b = 0; b < matrices.size(); ++b)
      {
        matrices[b].vmult(result.block(b), v.block(b));
        sum_over_processes(result.block(b));
      }
    return result;
  }



  std::vector<double>
  MassMatrix::energies(const BlockVector &v) const
  {
    const BlockVector   momentum = (*this)(v);
    std::vector<double> energies;
    for (unsigned int b = 0; b < matrices.size(); ++b)
      energies.push_back(0.5 * (momentum.block(b) * v.block(b)));
    return energies;
  }
} // namespace lamella
