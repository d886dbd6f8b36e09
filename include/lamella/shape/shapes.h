// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shapes_h
#define lamella_shape_shapes_h

#include <lamella/shape/laminate.h>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace lamella
{
  /// What a homogeneous section, or a part of one, is made of.
  struct Fabric
  {
    /// Name of the material, as in the scene.
    std::string material;
    /// Fibre angle in degrees, 0 along +y, positive from +y towards +x.
    double angle = 0.;
  };

  /**
   * Half a disc, its flat side, the boundary `flat`, on z = 0 and its corners
   * at x = 0 and x = 2 radius; the other boundary is `arc`. The mesh is graded
   * towards the point P of the arc at the angle graded_towards: there the cells
   * are finest_cell wide (or less, where that is too coarse for the rings
   * around them), and grow from ring to ring.
   */
  struct HalfDisc
  {
    double radius = 0.;
    /// Of P, in degrees from +x towards +z, 30 to 150; 90 is the top.
    double graded_towards = 90.;
    double finest_cell    = 0.;
    /// Cells in each ring around P; a multiple of 4.
    unsigned int sectors = 8;
    Fabric       fabric;
  };

  /// A full ellipse in the box [0, width] x [0, height]; its boundary is `arc`.
  struct Ellipse
  {
    double width = 0., height = 0.;
    /// 12 cells, each cut into four this often.
    unsigned int refinements = 1;
    Fabric       fabric;
  };

  /**
   * Webs (upright walls) and flanges (level ones) in the box [0, width] x
   * [0, height]. What lies on the sides of the box is called `left`, `right`,
   * `bottom`, `top`, and the rest of the boundary `inner`.
   */
  struct ThinWalled
  {
    /// box, double-T, T (flange on top), channel (web on the left) or angle
    /// (legs left and bottom).
    std::string form;
    double      width = 0., height = 0.;
    /// Thicknesses from left to right and from bottom to top.
    std::vector<double> webs, flanges;
    unsigned int        cells_per_wall = 1, cells_along_wall = 4;
    Fabric              fabric;
  };

  /// How many webs and flanges the thin-walled section @p form has.
  std::pair<unsigned int, unsigned int>
  count_of_walls(const std::string &form);

  /**
   * A mesh made by Gmsh; its x, y are the section's x, z, times scale. Its
   * physical surfaces are the parts, called as their material unless @p parts
   * tells it, its physical lines the boundaries, what is left of these `other`.
   */
  struct SectionFile
  {
    std::string path;
    double      scale = 1.;
    /// Name of a physical surface -> what it is made of.
    std::map<std::string, Fabric> parts;
    /// What messages begin with: `Section NAME`.
    std::string what;
  };

  /// A section as the scene describes it.
  using SectionShape =
    std::variant<Laminate, HalfDisc, Ellipse, ThinWalled, SectionFile>;

  /// As a user writes it: `laminate`, `half disc`, ...
  std::string
  name_of(const SectionShape &shape);

  /**
   * The mesh of @p shape. Edges on arcs carry a manifold, so that expansions of
   * higher degree follow the curve. Throws InputError if @p shape is a file
   * that does not hold a section.
   */
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials);

  /// Of one kind of shape; what the function above calls.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const HalfDisc &disc, const Materials &materials);

  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials);

  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials);

  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials);
} // namespace lamella

#endif
