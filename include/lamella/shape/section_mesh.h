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
  /**
   * The plane that a ply's fibres lie in: that of y, along the beam, and t = y
   * x n, at right angles to the unit vector n of the section's plane. In a wall
   * n points from the inside to the outside, and angles that are positive from
   * +y towards t wind all round a tube or a box as one helix. With n = +z, the
   * plane of a laminate, t is +x.
   */
  struct PlyPlane
  {
    /// n = (n_x, n_z) where it is the same all over the ply; exact in walls
    /// along x or z, so that a cross-ply has exact zeros there, too.
    dealii::Tensor<1, 2> normal = dealii::Point<2>(0., 1.);
    /// n at a point (x, z) of the section. Empty where it is the same all over.
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> normal_at;
    /// The wall that the ply belongs to, as a user calls it: `left`, `web`;
    /// empty in what has no walls. Plies of one wall that have numbers next to
    /// each other touch.
    std::string wall;

    /// n at the point @p x of the section.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const
    {
      return normal_at ? normal_at(x) : normal;
    }
  };

  /// One homogeneous part of a section: a ply, a core, the whole section. In a
  /// layer-wise theory each ply keeps its own C, and cells never cross from one
  /// ply into another; an equivalent single layer takes the same plies. Of a
  /// section by Gmsh it is what one physical surface holds, wherever that lies.
  struct Ply
  {
    /// Name of the material, as in the scene.
    std::string material;
    /// Fibre angle in degrees in the ply's plane, 0 along +y, positive from +y
    /// towards t (ply_axes()). In a level ply a turn about z, from +y towards
    /// +x.
    double angle = 0.;
    /// The range of z that it lies in [length]. Plies of a laminate touch and
    /// ascend; those of a file may overlap in z.
    double bottom = 0., top = 0.;
    /// A copy: plies do not refer to the scene's materials.
    Material properties;
    /// Level unless it is set.
    PlyPlane plane = {};

    /// The ply's axes in the body frame at the point @p x of the section. Row k
    /// is e_k: 1 along the fibre, 2 across, 3 normal to the ply.
    Triad
    axes(const dealii::Point<2> &x) const
    {
      return ply_axes(angle, plane.at(x));
    }

    /// C in the axes t, y, n of the ply's plane, in the places of x, y, z: of a
    /// level ply in the body frame. C = T^T C' T of strain_rotation(), 6 x 6 in
    /// the order of Eq. 4 [force/length^2]. Inverts a 3 x 3 matrix at each
    /// call: keep it. In the body frame, at any point: PlyLaws.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), ply_axes(angle));
    }

    /// The strain per kelvin in the body frame at the point @p x of the
    /// section, alpha = sum_k alpha_k e_k e_k, in the order of Eq. 4 with
    /// engineering shear strains [1/K]. The material must have its Thermal
    /// expansion.
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
