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
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// One homogeneous part of a section: a ply, a core, the whole section. In a
  /// layer-wise theory each ply keeps its own C, and cells never cross from one
  /// ply into another; an equivalent single layer takes the same plies. Of a
  /// section by Gmsh it is what one physical surface holds, wherever that lies.
  struct Ply
  {
    /// Name of the material, as in the scene.
    std::string material;
    /// Fibre angle in degrees, 0 along +y, positive from +y towards +x
    /// (ply_axes()): a turn about z.
    double angle = 0.;
    /// The range of z that it lies in [length]. Plies of a laminate touch and
    /// ascend; those of a file may overlap in z.
    double bottom = 0., top = 0.;
    /// A copy: plies do not refer to the scene's materials.
    Material properties;

    /// The ply's axes in the body frame. Row k is e_k: 1 along the fibre, 2
    /// across, 3 = z normal to the ply.
    Triad
    axes() const
    {
      return ply_axes(angle);
    }

    /// C in the body frame. C = T^T C' T of strain_rotation(), 6 x 6 in the
    /// order of Eq. 4 [force/length^2]. Inverts a 3 x 3 matrix at each call:
    /// keep it.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), axes());
    }

    /// The strain per kelvin in the body frame, alpha = sum_k alpha_k e_k e_k,
    /// in the order of Eq. 4 with engineering shear strains [1/K]. The material
    /// must have its Thermal expansion.
    Voigt
    expansion() const
    {
      Voigt alpha;
      for (unsigned int k = 0; k < 3; ++k)
        alpha[k] = properties.expansion.value()[k];
      return strain_rotation(transpose(axes())) * alpha;
    }
  };

  /**
   * A section's geometry: a mesh of quadrilaterals in its plane (first
   * coordinate x, second z; lower left corner at the origin, unless a file says
   * otherwise), whose material ids number @p plies and whose boundary ids are
   * named in @p boundaries.
   *
   * Cells are numbered and shared by all that is built on them: expansions
   * (SectionGeometry), integration of the S_pq, extrusion to hexahedra. Hence
   * it is made once, handed about as a shared pointer to const, and never
   * refined. Edges on arcs are curved by a manifold, all others are straight.
   * The coordinates are those of the body's axes in the section's plane, in the
   * scene's unit of length.
   */
  struct SectionMesh
  {
    /// Active cells only count; a cell's material id is the place of its ply
    /// below.
    dealii::Triangulation<2> mesh;
    /// Of a laminate from bottom to top; a homogeneous section has one.
    std::vector<Ply> plies;
    /// Boundary id -> the name that supports, loads and contacts say in the
    /// scene.
    std::map<dealii::types::boundary_id, std::string> boundaries;
  };

  /// Section meshes by the name of the section.
  using SectionMeshes =
    std::map<std::string, std::shared_ptr<const SectionMesh>>;
} // namespace lamella

#endif
