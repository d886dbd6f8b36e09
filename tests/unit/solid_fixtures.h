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
} // namespace lamella

#endif
