// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `shape`: the geometry of sections. It has laminates, thin walls,
// ellipses, half discs and Gmsh files as meshes of quadrilaterals with plies
// and named sides, their areas and moments, and the checks of meshes.
// Displacement fields are in the room `section`.

#ifndef lamella_shape_section_mesh_h
#define lamella_shape_section_mesh_h

#include <lamella/material/material.h>

#include <deal.II/base/point.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Plane of a ply's fibers, spanned by y (along the beam) and t = y x n with
  /// its unit normal n in the section's plane. Normals of walls point outwards,
  /// so angles from +y towards t form one helix around a tube or a box. A
  /// laminate has n = +z and t = +x.
  struct PlyPlane
  {
    /// Constant normal n = (n_x, n_z); components of level plies are exact.
    dealii::Tensor<1, 2> normal = dealii::Point<2>(0., 1.);
    /// Normal at a point (x, z) of the section; empty if constant.
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> normal_at;
    /// Name of the ply's wall, as `left`; empty without walls. Successive plies
    /// of a wall are adjacent.
    std::string wall;

    /// Returns n at the point @p x of the section.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const
    {
      return normal_at ? normal_at(x) : normal;
    }
  };

  /// A homogeneous part of a section: a ply, a core, the whole section, a
  /// physical surface of a Gmsh file. Cells never cross plies. Layer-wise
  /// theories and equivalent single layers use the same plies.
  struct Ply
  {
    /// Name of the material in the scene.
    std::string material;
    /// Fiber angle in the ply's plane in degrees, 0 along +y, positive towards
    /// t (ply_axes()); +x in a level ply.
    double angle = 0.;
    /// Range of z [length]. Plies of a laminate ascend; others may overlap.
    double bottom = 0., top = 0.;
    /// Copy of the material.
    Material properties;
    /// Plane of the ply; level by default.
    PlyPlane plane = {};

    /// Returns the ply's axes in the body frame at the point @p x of the
    /// section. Row k is e_k: 1 along the fiber, 2 across, 3 normal.
    Triad
    axes(const dealii::Point<2> &x) const
    {
      return ply_axes(angle, plane.at(x));
    }

    /// Returns C in the axes t, y, n of the ply's plane, the body frame for a
    /// level ply: C = T^T C' T with strain_rotation(), 6 x 6 in the order of
    /// Eq. 4 [force/length^2]. PlyLaws have the body frame at any point.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), ply_axes(angle));
    }

    /// Returns the thermal expansion in the body frame at the point @p x of the
    /// section, alpha = sum_k alpha_k e_k e_k, with engineering shear strains
    /// [1/K]. The material must have one.
    Voigt
    expansion(const dealii::Point<2> &x) const
    {
      Voigt alpha;
      for (unsigned int k = 0; k < 3; ++k)
        alpha[k] = properties.expansion.value()[k];
      return strain_rotation(transpose(axes(x))) * alpha;
    }
  };

  /// Geometry of a section: quadrilaterals in its plane (coordinates x, z of
  /// the body's axes, in the scene's unit of length; lower left corner at the
  /// origin, except from files). Material ids number @p plies, boundary ids are
  /// named in @p boundaries. Cell numbers are shared by expansions, integration
  /// and extrusion; the mesh is never refined. Edges on arcs have a manifold,
  /// all others are straight.
  struct SectionMesh
  {
    /// Mesh; the material id of an active cell is the index of its ply.
    dealii::Triangulation<2> mesh;
    /// Plies, of a laminate from bottom to top; one if homogeneous.
    std::vector<Ply> plies;
    /// Boundary id -> name in the scene.
    std::map<dealii::types::boundary_id, std::string> boundaries;
  };

  /// Section meshes by the name of the section.
  using SectionMeshes =
    std::map<std::string, std::shared_ptr<const SectionMesh>>;
} // namespace lamella

#endif
