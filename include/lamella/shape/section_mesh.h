// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `shape`: sections as geometry. It owns laminates, thin walls,
// ellipses, half discs and what Gmsh reads or draws, as meshes of
// quadrilaterals with plies and named sides, their areas and moments, and the
// checks that a mesh can be used. It never knows what displacement fields will
// live on it: expansions are the next room's.

#ifndef lamella_shape_section_mesh_h
#define lamella_shape_section_mesh_h

#include <lamella/material/material.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// One homogeneous part of a section: a ply, a core, the whole section.
  struct Ply
  {
    /// Name of the material, as in the scene.
    std::string material;
    /// Fibre angle in degrees, 0 along +y, positive from +y towards +x.
    double angle = 0.;
    /// The range of z that it lies in.
    double   bottom = 0., top = 0.;
    Material properties;

    /// The ply's axes in the body frame.
    Triad
    axes() const
    {
      return ply_axes(angle);
    }

    /// C in the body frame.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), axes());
    }
  };

  /**
   * A section's geometry: a mesh of quadrilaterals in its plane (first
   * coordinate x, second z; lower left corner at the origin, unless a file says
   * otherwise), whose material ids number @p plies and whose boundary ids are
   * named in @p boundaries.
   */
  struct SectionMesh
  {
    dealii::Triangulation<2>                          mesh;
    std::vector<Ply>                                  plies;
    std::map<dealii::types::boundary_id, std::string> boundaries;
  };
} // namespace lamella

#endif
