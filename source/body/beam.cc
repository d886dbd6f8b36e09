// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<std::vector<unsigned int>>
    all_fields(const Section &section, const Axis &axis)
    {
      std::vector<unsigned int> fields(section.n_fields());
      std::iota(fields.begin(), fields.end(), 0);
      return std::vector<std::vector<unsigned int>>(axis.n_nodes(), fields);
    }



    /// Weights of the deflections and slopes at the ends in those at @p t in
    /// [0, 1] of an element of length @p L (constrain_to_kirchhoff()).
    std::array<std::array<double, 4>, 2>
    hermite_weights(const double t, const double L, const double h)
    {
      const double H2 = t * t * (3. - 2. * t), H2_t = 6. * t * (1. - t);
      const double H1   = t * (1. - t) * (1. - t);
      const double H3   = -t * t * (1. - t);
      const double H1_t = (1. - t) * (1. - 3. * t), H3_t = t * (3. * t - 2.);
      return {{{{1. - H2, H2, -L / h * H1, -L / h * H3}},
               {{h / L * H2_t, -h / L * H2_t, H1_t, H3_t}}}};
    }
  } // namespace



  Beam::Beam(const std::string                    &name,
             const std::shared_ptr<const Section> &section,
             const std::shared_ptr<const Axis>    &axis,
             const Placement                      &placement)
    : Beam(name, section, axis, placement, all_fields(*section, *axis))
  {}



  Beam::Beam(const std::string                            &name,
             std::shared_ptr<const Section>                section,
             std::shared_ptr<const Axis>                   axis,
             const Placement                              &placement,
             const std::vector<std::vector<unsigned int>> &fields_of_node)
    : Beam(name,
           std::make_shared<SectionSpace>(std::move(section)),
           std::move(axis),
           placement,
           fields_of_node,
           "")
  {}



  Beam::Beam(const std::string                            &name,
             std::shared_ptr<const SectionSpace>           section_space,
             std::shared_ptr<const Axis>                   axis,
             const Placement                              &placement,
             const std::vector<std::vector<unsigned int>> &fields_of_node,
             const std::string                            &theory)
    : Body(name, placement)
    , space(std::move(section_space))
    , beam_section(space->shared_section())
    , beam_axis(std::move(axis))
    , dof_map(fields_of_node, space->n_fields())
    , label(theory)
  {
    if (n_processes() > beam_axis->n_nodes())
      throw InputError(
        "Body " + name,
        "",
        "body.too-many-processes: the body has " +
          std::to_string(beam_axis->n_nodes()) +
          " nodes along its axis, which is less than one for each of the " +
          std::to_string(n_processes()) + " processes",
        "Start fewer processes (mpirun -np), or use more Axis elements.");
    if (beam_section->theory().keeps_sections_normal())
      constrain_to_kirchhoff();
    kirchhoff.close();
  }



  void
  Beam::constrain_to_kirchhoff()
  {
    Assert(beam_axis->degree() == 3, ExcMessage("EBBT needs B4 elements."));
    const double h = beam_section->element().reference_length();
    for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
      {
        const double begin              = beam_axis->cell_begin(cell),
                     L                  = beam_axis->cell_end(cell) - begin;
        std::vector<unsigned int> nodes = beam_axis->nodes_of_cell(cell);
        std::sort(nodes.begin(), nodes.end());
        for (const auto &plane : RigidField::bending)
          for (const unsigned int inside : {nodes[1], nodes[2]})
            {
              const auto weights =
                hermite_weights((beam_axis->nodes()[inside] - begin) / L, L, h);
              for (unsigned int k = 0; k < 2; ++k)
                {
                  const DofIndex dof = dof_map.first(inside) + plane[k];
                  kirchhoff.add_line(dof);
                  for (unsigned int e = 0; e < 4; ++e)
                    kirchhoff.add_entry(
                      dof,
                      dof_map.first(nodes[e % 2 == 0 ? 0 : 3]) + plane[e / 2],
                      weights[k][e]);
                }
            }
      }
  }



  std::string
  Beam::theory() const
  {
    const std::string on_axis = ", " + std::to_string(beam_axis->n_cells()) +
                                " B" + std::to_string(beam_axis->degree() + 1);
    if (!label.empty())
      return label + on_axis;
    const Theory      &theory   = beam_section->theory();
    const unsigned int complete = (theory.order + 1) * (theory.order + 2) / 2;
    const unsigned int n        = beam_section->element().n_functions();
    const std::string  left_out =
      theory.is_taylor() && n < complete ?
         " (" + std::to_string(complete - n) + " of " +
          std::to_string(complete) +
          " polynomials depend on the others on this section)" :
         "";
    return theory.name() + left_out + on_axis;
  }



  IndexSet
  Beam::owned_dofs() const
  {
    const auto [begin, end] = beam_axis->own_nodes();
    IndexSet owned(n_dofs());
    if (begin < end)
      owned.add_range(dof_map.first(begin),
                      dof_map.first(end - 1) + dof_map.fields(end - 1).size());
    return owned;
  }



  DofInfo
  Beam::dof(const DofIndex dof) const
  {
    const double       y     = beam_axis->nodes()[dof_map.node_of(dof)];
    const Point<2>     c     = beam_section->element().center();
    const unsigned int field = dof_map.field_of(dof);
    return {placement.to_scene({c[0], y, c[1]}),
            space->sizes()[field],
            space->level(field)};
  }



  Point<3>
  Beam::center() const
  {
    const Point<2> c = beam_section->element().center();
    return placement.to_scene({c[0], 0.5 * beam_axis->length(), c[1]});
  }



  double
  Beam::size() const
  {
    return std::max(0.5 * beam_axis->length(),
                    beam_section->element().reference_length());
  }



  BoundingBox<3>
  Beam::bounding_box() const
  {
    std::vector<Point<3>> corners;
    for (const Point<2> &v :
         beam_section->element().section_mesh().mesh.get_vertices())
      for (const double y : {0., beam_axis->length()})
        corners.push_back(placement.to_scene({v[0], y, v[1]}));
    return BoundingBox<3>(corners);
  }



  std::vector<Vector>
  Beam::rigid_motions(const Vector &) const
  {
    const double        h      = beam_section->element().reference_length();
    const double        middle = 0.5 * beam_axis->length();
    std::vector<Vector> motions(6, Vector(n_dofs()));
    for (unsigned int m = 0; m < 6; ++m)
      {
        Tensor<1, 3> direction;
        direction[m % 3]            = 1.;
        const Tensor<1, 3> v        = placement.vector_to_body(direction);
        const bool         rotation = m >= 3;
        for (unsigned int node = 0; node < dof_map.n_nodes(); ++node)
          {
            const auto set = [&](const unsigned int alpha, const double value) {
              if (alpha < beam_section->n_fields() &&
                  dof_map.place(node, alpha) >= 0)
                motions[m][dof_map.first(node) + dof_map.place(node, alpha)] =
                  value;
            };
            // v x (0, y - middle, 0) moves the axis; the rest turns sections.
            const double arm = beam_axis->nodes()[node] - middle;
            set(RigidField::translation_x, rotation ? -v[2] * arm : v[0]);
            set(RigidField::translation_y, rotation ? 0. : v[1]);
            set(RigidField::translation_z, rotation ? v[0] * arm : v[2]);
            set(RigidField::slope_x, rotation ? h * v[2] : 0.);
            set(RigidField::slope_z, rotation ? -h * v[0] : 0.);
            set(RigidField::rotation_y, rotation ? h * v[1] : 0.);
          }
      }
    return motions;
  }



  std::vector<RigidMotion>
  Beam::omitted_rigid_motions() const
  {
    if (beam_section->theory().can_twist())
      return {};
    // The turn about the axis.
    const Tensor<1, 3> axis = placement.axes[1];
    return {{{0., 0., 0., axis[0], axis[1], axis[2]}}};
  }



  SectionForces
  Beam::section_forces(const SectionOperator &section_operator,
                       const FieldParts      &q) const
  {
    return section_operator.forces(q);
  }



  void
  Beam::add_internal_forces(const Vector &u, Vector &f) const
  {
    along_axis().add_forces(
      [&](const unsigned int cell, const SectionOperator &section_operator) {
        return section_forces(section_operator,
                              along_axis().on_element(cell,
                                                      section_operator.fields(),
                                                      u));
      },
      f);
  }



  Deformation
  Beam::deformation(const Vector &u) const
  {
    Deformation result;
    along_axis().for_each_element(
      [&](const unsigned int cell, const SectionOperator &section_operator) {
        const FieldParts q =
          along_axis().on_element(cell, section_operator.fields(), u);
        result.energy +=
          along_axis().energy(cell, section_forces(section_operator, q));
        result.max_rotation =
          std::max(result.max_rotation, section_operator.largest_rotation(q));
      });
    result.energy = Utilities::MPI::sum(result.energy, communicator());
    result.max_rotation =
      Utilities::MPI::max(result.max_rotation, communicator());
    return result;
  }



  std::vector<const Beam *>
  beams_of(const Bodies &bodies)
  {
    std::vector<const Beam *> beams;
    for (const std::unique_ptr<Body> &body : bodies)
      beams.push_back(dynamic_cast<const Beam *>(body.get()));
    return beams;
  }
} // namespace lamella
