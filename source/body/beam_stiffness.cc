// SPDX-License-Identifier: LGPL-2.1-or-later

// Stiffness of a beam, by rows of Kronecker products, and what acts in its
// volume: heat and weight.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
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



  namespace
  {
    /// The work that the stress @p stress, times what it stands for, does at
    /// @p point on each of its fields: an entry of each FieldPart.
    std::vector<std::array<double, FieldPart::n>>
    work_of(const Voigt &stress, const SectionPoint &point)
    {
      std::vector<std::array<double, FieldPart::n>> work(point.fields->size());
      for (unsigned int a = 0; a < work.size(); ++a)
        {
          for (unsigned int c = 0; c < 6; ++c)
            work[a][is_transverse_shear(c) ? FieldPart::shear_value :
                                             FieldPart::value] +=
              point.in_plane[a][c] * stress[c];
          work[a][FieldPart::derivative] = point.along[a] * stress;
        }
      return work;
    }
  } // namespace



  void
  Beam::heat(const ScalarField &change)
  {
    if (beam_section->completes_by_modes())
      throw InputError("Body " + name() + "/Kinematics/Theory",
                       beam_section->theory().name(),
                       "body.temperature-of-theory: with Poisson correction "
                       "this theory omits thermal expansion of sections",
                       "For a body with a Temperature use TE-2, LE-N or SV-N, "
                       "or Poisson correction = false.");
    Body::heat(change);
  }



  ElasticLaw
  Beam::law_at(const unsigned int cell,
               const Point<2>    &at,
               const Point<3>    &x) const
  {
    if (!is_heated())
      return beam_section->law(cell, at);
    const Ply &ply = beam_section->plies()[beam_section->cell_ply(cell)];
    return ElasticLaw(beam_section->law(cell, at).stiffness(),
                      temperature(x) * ply.expansion(at));
  }



  void
  Beam::for_each_thermal_point(
    const std::function<
      void(const SectionPoint &, const Voigt &, const Voigt &)> &use) const
  {
    beam_section->for_each_point([&](const SectionPoint &point,
                                     const double        weight) {
      const Voigt alpha =
        beam_section->plies()[beam_section->cell_ply(point.cell)].expansion(
          point.position);
      const Voigt active =
        alpha -
        beam_section->completion_of_initial(point.cell, point.position, alpha);
      use(point,
          active,
          weight * (beam_section->law(point.cell, point.position).stiffness() *
                    active));
    });
  }



  std::vector<SectionForces>
  Beam::thermal_forces(const std::vector<std::vector<double>> &stations) const
  {
    std::vector<SectionForces> forces;
    for (const std::vector<double> &group : stations)
      forces.emplace_back(beam_section->n_fields(), group.size());
    for_each_thermal_point(
      [&](const SectionPoint &point, const Voigt &active, const Voigt &stress) {
        const auto unit = work_of(stress, point);
        for (unsigned int g = 0; g < stations.size(); ++g)
          for (unsigned int k = 0; k < stations[g].size(); ++k)
            {
              const double T = temperature_at(point, stations[g][k]);
              forces[g].energy[k] += 0.5 * T * T * (stress * active);
              for (unsigned int a = 0; a < unit.size(); ++a)
                for (unsigned int p = 0; p < FieldPart::n; ++p)
                  forces[g].work[p]((*point.fields)[a], k) += T * unit[a][p];
            }
      });
    return forces;
  }



  std::vector<SectionForces>
  Beam::thermal_forces() const
  {
    std::vector<std::vector<double>> stations;
    const auto [begin, end] = beam_axis->own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        stations.emplace_back();
        for (unsigned int k = 0; k < along_axis().n_stations(); ++k)
          stations.back().push_back(
            beam_axis
              ->integration_points()[cell * along_axis().n_stations() + k]
              .y);
      }
    return thermal_forces(stations);
  }



  double
  Beam::add_thermal_load(const Vector &u, Vector &f) const
  {
    if (!is_heated())
      return 0.;
    const std::vector<SectionForces> forces = thermal_forces();
    const unsigned int               begin  = beam_axis->own_cells().first;
    double                           energy = 0.;
    along_axis().add_forces(
      [&](const unsigned int cell, const SectionOperator &section_operator) {
        energy += along_axis().energy(cell, forces[cell - begin]);
        return on_list(*space, section_operator.fields(), forces[cell - begin]);
      },
      f);
    if (u.size() > 0)
      add_product_of_blocks(
        [&](const auto &use) { for_each_thermal_block(u, use); }, u, f);
    return Utilities::MPI::sum(energy, communicator());
  }



  Beam::SectionThermalLoad
  Beam::section_thermal_load(const double y) const
  {
    SectionThermalLoad heat{Vector(beam_section->n_fields()),
                            Vector(beam_section->n_fields())};
    if (!is_heated())
      return heat;
    const FieldParts work = thermal_forces({{y}})[0].work;
    for (unsigned int alpha = 0; alpha < heat.on_values.size(); ++alpha)
      {
        heat.on_values[alpha] = work[FieldPart::value](alpha, 0) +
                                work[FieldPart::shear_value](alpha, 0);
        heat.on_derivatives[alpha] = work[FieldPart::derivative](alpha, 0);
      }
    return heat;
  }



  // Inertial forces of the translations, the first rigid section functions.
  Vector
  Beam::section_weight(const Tensor<1, 3> &acceleration) const
  {
    const std::vector<Vector> inertia = section_inertia();
    const Tensor<1, 3>        g       = placement.vector_to_body(acceleration);
    Vector                    load(beam_section->n_fields());
    for (unsigned int c = 0; c < 3; ++c)
      load.add(g[c], inertia[c]);
    return load;
  }



  // Rigid section functions are the first of each cell.
  std::vector<Vector>
  Beam::section_inertia() const
  {
    const std::vector<double> rho = densities(*this);
    std::vector<Vector>       forces(RigidField::n_all,
                               Vector(beam_section->n_fields()));
    beam_section->for_each_point(
      [&](const SectionPoint &point, const double weight) {
        const double mass = weight * rho[beam_section->cell_ply(point.cell)];
        // EBBT and TBT have no rotation about the axis.
        const std::size_t n_rigid = std::min(forces.size(), point.value.size());
        for (unsigned int r = 0; r < n_rigid; ++r)
          for (unsigned int a = 0; a < point.fields->size(); ++a)
            forces[r][(*point.fields)[a]] +=
              mass * (point.value[r] * point.value[a]);
      });
    return forces;
  }
} // namespace lamella
