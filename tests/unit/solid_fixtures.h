// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_solid_fixtures_h
#define lamella_tests_unit_solid_fixtures_h

#include "fixtures.h"

#include <lamella/body/solid.h>

#include <deal.II/grid/grid_tools.h>

namespace lamella
{
  /// @p elements of equal length; @p degree is for the beam beside the solid.
  inline AxisMesh
  axis_mesh(const double       length,
            const unsigned int elements,
            const unsigned int degree = 2)
  {
    AxisMesh mesh;
    mesh.length   = length;
    mesh.elements = {elements};
    mesh.degree   = degree;
    return mesh;
  }

  /// @p mesh with its inner vertices moved.
  inline std::shared_ptr<const SectionMesh>
  distorted(const std::shared_ptr<const SectionMesh> &mesh)
  {
    auto result = std::make_shared<SectionMesh>();
    result->mesh.copy_triangulation(mesh->mesh);
    result->plies      = mesh->plies;
    result->boundaries = mesh->boundaries;
    dealii::GridTools::distort_random(0.25, result->mesh, true, 7);
    return result;
  }
  inline const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  inline const Placement tilted =
    Placement::from_directions({0.2, -0.1, 0.4},
                               dealii::Point<3>(1., 2., 0.5),
                               dealii::Point<3>(-0.3, 0.2, 1.));

  /// A ball that divides the hexahedra around a corner: hanging nodes on the
  /// surface and inside.
  inline const SolidRefinement around_a_corner{0, {{{0.7, 0., 0.5}, 0.3, 1}}};

  inline std::shared_ptr<const SectionMesh>
  one_material(const unsigned int cells = 3)
  {
    return make_section_mesh(rectangle(0.7, 0.5, {20.}, cells, cells),
                             {{"material", orthotropic}});
  }
} // namespace lamella

#endif
