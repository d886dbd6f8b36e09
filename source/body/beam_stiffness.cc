// SPDX-License-Identifier: LGPL-2.1-or-later

// Stiffness of a beam, by rows of Kronecker products.

#include <lamella/body/beam.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/fields.h>
#include <lamella/linear/factorization.h>

#include <algorithm>
#include <array>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns for each function of @p space whether a node has it.
    std::vector<bool>
    carried_functions(const SectionSpace &space, const BeamDofMap &dofs)
    {
      std::vector<bool> carried(space.n_fields(), false);
      for (unsigned int node = 0; node < dofs.n_nodes(); ++node)
        for (const unsigned int alpha : dofs.fields(node))
          carried[alpha] = true;
      return carried;
    }



    /// The section's factor of the stiffness: a row for each field of any node.
    std::vector<FactorRow>
    section_rows(const SectionSpace &space,
                 const Axis         &axis,
                 const BeamDofMap   &dofs)
    {
      const std::vector<bool>   carried = carried_functions(space, dofs);
      std::vector<unsigned int> fields;
      for (unsigned int alpha = 0; alpha < carried.size(); ++alpha)
        if (carried[alpha])
          fields.push_back(alpha);
      return make_section_operator(space,
                                   std::move(fields),
                                   axis.has_assumed_shear())
        ->stiffness();
    }



    FactorRow
    axis_row(const Axis &axis, const unsigned int node)
    {
      return factor_row(
        [&axis](const unsigned int m) -> auto & {
          return m < 4 ? axis.A(m / 2, m % 2) : axis.A_shear();
        },
        node,
        [](const unsigned int) { return true; });
    }



    /// Makes @p block the row of K that is @p on_axis times @p on_section.
    void
    fill_row(const BeamDofMap &dofs,
             const FactorRow  &on_axis,
             const FactorRow  &on_section,
             const bool        with_values,
             StiffnessBlock   &block)
    {
      block.columns.clear();
      block.values.clear();
      for (unsigned int m = 0; m < on_axis.columns.size(); ++m)
        {
          const unsigned int           j = on_axis.columns[m];
          const std::array<double, 5> &A = on_axis.entries[m];
          for (unsigned int b = 0; b < on_section.columns.size(); ++b)
            {
              const int place = dofs.place(j, on_section.columns[b]);
              if (place < 0)
                continue;
              block.columns.push_back(dofs.first(j) + place);
              const std::array<double, 5> &S = on_section.entries[b];
              if (with_values)
                block.values.push_back(A[0] * S[0] + A[1] * S[1] + A[2] * S[2] +
                                       A[3] * S[3] + (A[4] - A[0]) * S[4]);
            }
        }
    }
  } // namespace



  double
  Beam::stiffness_entries() const
  {
    const Matrix      &S   = beam_section->S(0, 0);
    const unsigned int all = beam_section->n_fields();
    // Lists of fields of the section are as sparse as its matrices.
    using List = std::vector<unsigned int>;
    std::map<std::pair<const List *, const List *>, double> sparse;
    const auto entries_between = [&](const unsigned int i,
                                     const unsigned int j) {
      const List &rows = dof_map.fields(i);
      const auto [known, is_new] =
        sparse.try_emplace({&rows, &dof_map.fields(j)}, 0.);
      if (is_new)
        for (const unsigned int a : rows)
          for (auto entry = S.begin(a); entry != S.end(a); ++entry)
            known->second += dof_map.place(j, entry->column()) >= 0;
      return known->second;
    };
    double sum = 0.;
    for (const auto &entry : beam_axis->A(0, 0))
      {
        const List &row    = dof_map.fields(entry.row()),
                   &column = dof_map.fields(entry.column());
        sum +=
          row.back() < all && column.back() < all ?
            entries_between(entry.row(), entry.column()) :
            std::min(double(row.size()) * column.size(),
                     S.n_nonzero_elements() +
                       space->n_dense() * double(row.size() + column.size()));
      }
    return sum;
  }



  void
  Beam::for_each_stiffness_block(const Vector &,
                                 const Vector &,
                                 const bool           with_values,
                                 const BlockCallback &use) const
  {
    for_each_product_row(section_rows(*space, *beam_axis, dof_map),
                         with_values,
                         use);
  }



  void
  Beam::for_each_mass_block(const Vector &,
                            const bool           with_values,
                            const BlockCallback &use) const
  {
    for_each_product_row(space->mass_rows(densities(*this),
                                          carried_functions(*space, dof_map)),
                         with_values,
                         use);
  }



  void
  Beam::for_each_product_row(const std::vector<FactorRow> &on_section,
                             const bool                    with_values,
                             const BlockCallback          &use) const
  {
    // A block is a row of the Kronecker products.
    StiffnessBlock block;
    block.rows.resize(1);
    block.columns_ascend    = true;
    const auto [begin, end] = beam_axis->own_nodes();
    for (unsigned int i = begin; i < end; ++i)
      {
        const FactorRow                  on_axis = axis_row(*beam_axis, i);
        const std::vector<unsigned int> &fields  = dof_map.fields(i);
        for (unsigned int k = 0; k < fields.size(); ++k)
          {
            block.rows[0] = dof_map.first(i) + k;
            fill_row(
              dof_map, on_axis, on_section[fields[k]], with_values, block);
            use(block);
          }
      }
  }
} // namespace lamella
