// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `shape`: the geometry of sections. Laminates, thin walls,
// ellipses, half discs and Gmsh files become meshes of quadrilaterals with
// plies and named boundaries. Also areas, moments of area, and mesh checks.
// It does not know section functions.

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
  /// The plane that contains the fibers of a ply, spanned by y (along the beam)
  /// and t = y x n, where n is the unit normal of the ply and lies in the plane
  /// of the section. In walls, n points outwards, so a constant angle from +y
  /// towards t is a helix around a tube or box. In a laminate, n = +z, t = +x.
  struct PlyPlane
  {
    /// Unit normal (n_x, n_z) of the ply if it is constant.
    dealii::Tensor<1, 2> normal = dealii::Point<2>(0., 1.);
    /// Function that returns the normal at a point (x, z); empty if constant.
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> normal_at;
    /// Name of the wall of the ply, e.g. `left`; empty if the section has no
    /// walls. Successive plies of a wall are adjacent.
    std::string wall;

    /// Returns the unit normal of the ply at the point @p x of the section.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const
    {
      return normal_at ? normal_at(x) : normal;
    }
  };

  /// A region of a section with one material: a ply, a core, the whole section,
  /// or a physical surface of a Gmsh file. Each cell lies within one ply.
  struct Ply
  {
    std::string material; ///< Name of the material in the scene.
    /// Fiber angle in the plane of the ply in degrees: 0 along the beam axis +y
    /// and positive towards the tangent t of PlyPlane, +x in a laminate.
    double angle  = 0.;
    double bottom = 0.,  ///< Smallest z [length].
      top         = 0.;  ///< Largest z [length].
    Material properties; ///< Copy of the material data.
    PlyPlane plane = {}; ///< Plane of the ply, by default with the normal +z.

    /// Returns the ply axes in the body frame at the point @p x of the section:
    /// along the fiber, across the fiber and normal to the ply.
    Triad
    axes(const dealii::Point<2> &x) const
    {
      return ply_axes(angle, plane.at(x));
    }

    /// Returns the elasticity matrix in the axes (tangent, y, normal) of
    /// PlyPlane [force/length^2]. These are the body axes if the normal is +z;
    /// otherwise use PlyLaws for the body frame.
    ElasticTensor
    stiffness() const
    {
      return rotated(properties.elastic.stiffness(), ply_axes(angle));
    }

    /// Returns the thermal strain per kelvin in the body frame at the point
    /// @p x of the section [1/K]. The material must have expansion data.
    Voigt
    expansion(const dealii::Point<2> &x) const
    {
      Voigt alpha;
      for (unsigned int k = 0; k < 3; ++k)
        alpha[k] = properties.expansion.value()[k];
      return strain_rotation(transpose(axes(x))) * alpha;
    }
  };

  /// The geometry of a section: a mesh of quadrilaterals in its plane, in the
  /// coordinates x, z of the body. The lower left corner is the origin, except
  /// for meshes from files. The mesh is never refined: cross-section expansions
  /// and solid meshes refer to its cell indices. Edges are straight unless they
  /// lie on arcs.
  struct SectionMesh
  {
    /// Mesh; the material id of a cell is the index of its ply in @p plies.
    dealii::Triangulation<2> mesh;
    /// All plies; bottom to top in a laminate, a single one if homogeneous.
    std::vector<Ply> plies;
    /// Name of each boundary (e.g. `top`), by boundary id of the mesh.
    std::map<dealii::types::boundary_id, std::string> boundaries;
  };

  /// Section meshes of a scene, by the name of the section.
  using SectionMeshes =
    std::map<std::string, std::shared_ptr<const SectionMesh>>;

  /// Parameters for grading the mesh of a section towards singular corners.
  struct CornerRules
  {
    /// Grading factor: ratio of the distances of successive layers from the
    /// corner. 0.15 is optimal for p-extension (Szabo and Babuska, Finite
    /// Element Analysis, 1991, sec. 10.2).
    double ratio = 0.15;
    /// Interior angle in degrees above which a corner counts as re-entrant.
    /// Corners between the straight edges of a fillet have smaller angles.
    double min_reentrant_angle = 225.;
  };

  /// Returns the indices of the mesh vertices with singular stresses,
  /// ascending: re-entrant corners of the boundary, and points where the
  /// boundary meets the interface between plies of different material or angle.
  std::vector<unsigned int>
  singular_corners(const SectionMesh &section, const CornerRules &rules = {});

  /// Returns the mesh @p section with @p layers geometrically graded layers of
  /// cells around each of its singular_corners(). Each edge that ends at such a
  /// corner is split at distances r^k times its length from it, k = 1 to @p
  /// layers, r = CornerRules::ratio. Opposite edges of a cell are split alike.
  /// Edges must be straight. Throws InputError for the entry `Corner layers` in
  /// the subsection @p what if there are no singular corners or too many cells.
  std::shared_ptr<const SectionMesh>
  graded_to_corners(const SectionMesh &section,
                    const unsigned int layers,
                    const std::string &what,
                    const CornerRules &rules = {});
} // namespace lamella

#endif
