// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `shape`: sections as geometry. It owns laminates, thin walls,
// ellipses, half discs and what Gmsh reads or draws, as meshes of
// quadrilaterals with plies and named sides, their areas and moments, and the
// checks that a mesh can be used. It never knows what displacement fields will
// live on it: expansions are the next room's.

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
  /// its unit normal n in the section's plane. In a wall n points outwards;
  /// angles positive from +y towards t form one helix around a tube or a box.
  /// In a laminate n = +z and t = +x.
  struct PlyPlane
  {
    /// Constant normal n = (n_x, n_z); exact along x or z, so that a cross-ply
    /// has exact zeros.
    dealii::Tensor<1, 2> normal = dealii::Point<2>(0., 1.);
    /// Normal at a point (x, z) of the section; empty if constant.
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> normal_at;
    /// Name of the ply's wall, `left`, `web`; empty without walls. Plies of a
    /// wall with successive numbers touch.
    std::string wall;

    /// Returns n at the point @p x of the section.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const
    {
      return normal_at ? normal_at(x) : normal;
    }
  };

  /// A homogeneous part of a section: a ply, a core, the whole section. Cells
  /// never cross plies. In layer-wise theories each ply has its own C; an
  /// equivalent single layer uses the same plies. In a Gmsh section, one
  /// physical surface.
  struct Ply
  {
    /// Name of the material in the scene.
    std::string material;
    /// Fiber angle in the ply's plane in degrees, 0 along +y, positive towards
    /// t (ply_axes()). In a level ply, a rotation about z from +y towards +x.
    double angle = 0.;
    /// Range of z [length]. Plies of a laminate touch and ascend; those of a
    /// file may overlap in z.
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

    /// Returns C in the axes t, y, n of the ply's plane, in place of x, y, z:
    /// for a level ply the body frame. C = T^T C' T with strain_rotation(), 6 x
    /// 6 in the order of Eq. 4 [force/length^2]. Inverts a 3 x 3 matrix at each
    /// call. See PlyLaws for the body frame at any point.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), ply_axes(angle));
    }

    /// Returns the thermal expansion in the body frame at the point @p x of the
    /// section, alpha = sum_k alpha_k e_k e_k, in the order of Eq. 4 with
    /// engineering shear strains [1/K]. The material must have one.
    Voigt
    expansion(const dealii::Point<2> &x) const
    {
      Voigt alpha;
      for (unsigned int k = 0; k < 3; ++k)
        alpha[k] = properties.expansion.value()[k];
      return strain_rotation(transpose(axes(x))) * alpha;
    }
  };

  /**
   * Geometry of a section: quadrilaterals in its plane (coordinates x, z of the
   * body's axes, in the scene's unit of length; lower left corner at the
   * origin, except from files). Material ids number @p plies, boundary ids are
   * named in @p boundaries.
   *
   * Cell numbers are shared by expansions (SectionGeometry), integration of
   * S_pq and extrusion to hexahedra. The mesh is therefore a shared pointer to
   * const and never refined. Edges on arcs have a manifold, all others are
   * straight.
   */
  struct SectionMesh
  {
    /// Mesh whose active cells are used. A cell's material id is the index of
    /// its ply.
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
