// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shapes_h
#define lamella_shape_shapes_h

#include <lamella/base/names.h>
#include <lamella/shape/laminate.h>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace lamella
{
  /// Shape of a section, the entry `Shape` (doc/reference/sections.md).
  enum class ShapeKind
  {
    undefined,
    laminate,
    half_disc,
    ellipse,
    box,
    double_t,
    t,       ///< the flange on top
    channel, ///< the web on the left
    angle,   ///< the legs left and bottom
    tube,
    file ///< a mesh by Gmsh
  };

  template <>
  struct Names<ShapeKind>
  {
    static constexpr NameOf<ShapeKind> all[] = {
      {ShapeKind::laminate, "laminate"},
      {ShapeKind::half_disc, "half disc"},
      {ShapeKind::ellipse, "ellipse"},
      {ShapeKind::box, "box"},
      {ShapeKind::double_t, "double-T"},
      {ShapeKind::t, "T"},
      {ShapeKind::channel, "channel"},
      {ShapeKind::angle, "angle"},
      {ShapeKind::tube, "tube"},
      {ShapeKind::file, "file"}};
  };

  /// Material and angle of a homogeneous section or part.
  struct OrientedMaterial
  {
    /// Name of the material in the scene.
    std::string material;
    /// Fiber angle about z in degrees, 0 along +y, positive towards +x, also in
    /// walls.
    double angle = 0.;
  };

  /// A ply of a wall.
  struct WallPly
  {
    /// Material with the angle in the wall's plane (PlyPlane) in degrees.
    OrientedMaterial oriented_material;
    /// Thickness [length].
    double thickness = 0.;
  };

  /// Plies from the inside of a wall to its outside.
  using WallLayup = std::vector<WallPly>;

  /**
   * A half disc with the flat side `flat` on z = 0, corners at x = 0 and x = 2
   * radius, and the other boundary `arc`. Made for Hertzian contact (the
   * half-cylinders of the paper's section 4.1).
   *
   * The mesh is graded towards the point P of the arc at graded_towards, with
   * cells of about the width finest_cell. It consists of half a butterfly at P,
   * rings, and a block at the flat side. Rings grow by about exp(pi / sectors),
   * so that cells are as wide as deep. A conformal map of the half disc moves P
   * from the top, preserving the shape of small cells.
   */
  struct HalfDisc
  {
    /// Radius [length].
    double radius = 0.;
    /// Angle of P in degrees from +x towards +z, 30 to 150; 90 is the top.
    double graded_towards = 90.;
    /// Width of the finest cells [length], positive; by default an eighth of
    /// the radius in a scene.
    double finest_cell = 0.;
    /// Number of cells in each ring around P, a multiple of 4; at least 12 if P
    /// is not on top.
    unsigned int sectors = 8;
    /// Fabric of the whole section.
    OrientedMaterial oriented_material;
  };

  /// A full ellipse in the box [0, width] x [0, height], with the boundary
  /// `arc`.
  struct Ellipse
  {
    /// Axes, twice the semi-axes [length].
    double width = 0., height = 0.;
    /// Number n of refinements: 12 4^n cells.
    unsigned int     refinements = 1;
    OrientedMaterial oriented_material;
  };

  /**
   * Webs (upright) and flanges (level) in the box [0, width] x [0, height].
   * Boundaries on the sides of the box are `left`, `right`, `bottom`, `top`,
   * the rest `inner`. No shell or thin-wall theory is used.
   *
   * The mesh is a grid of blocks, some of which are walls: a box has three by
   * three without the middle, a channel two by three. Cells are rectangles;
   * corners of walls have cells_per_wall by cells_per_wall cells.
   *
   * Walls with layups have plies in their own planes (PlyPlane). Flanges extend
   * to the sides of the box, webs end at flanges. Normals point outwards: -x of
   * left walls, +x of right ones, -z of bottom ones, +z of top ones; +x of a
   * web with two free faces.
   */
  struct ThinWalled
  {
    /// Form: box, double_t, t, channel or angle.
    ShapeKind form = ShapeKind::undefined;
    /// Outer dimensions [length].
    double width = 0., height = 0.;
    /// Thicknesses [length] from left to right and from bottom to top,
    /// wall_counts() each. Their sums must be below the width and the height.
    std::vector<double> webs, flanges;
    /// Number of cells through each wall, and along it between corners.
    unsigned int     cells_per_wall = 1, cells_along_wall = 4;
    OrientedMaterial oriented_material;
    /// Layup of each wall, webs first, which adds up to its thickness; or none.
    std::vector<WallLayup> layups = {};
    /// Number of cells through each ply of a layup.
    unsigned int cells_per_ply = 1;
  };

  /// A ring of plies between an ellipse in the box [0, width] x [0, height] and
  /// the inner curve parallel to it. Boundaries are `inner` and `outer`. Plies
  /// have constant thickness and the normals of EllipseProjection. Cells have
  /// curved edges; their second direction is the normal's.
  struct Tube
  {
    /// Outer dimensions [length].
    double width = 0., height = 0.;
    /// Plies from inside to outside. Their total thickness must be below
    /// min(width, height)^2 / (2 max(width, height)).
    WallLayup layup;
    /// Number of cells in each ring, a multiple of 4, equal in the ellipse's
    /// parameter, and through each ply.
    unsigned int cells_around = 24, cells_per_ply = 1;
  };

  /// Returns the numbers of webs and flanges of the thin-walled @p form. Throws
  /// std::out_of_range for other shapes.
  std::pair<unsigned int, unsigned int>
  wall_counts(const ShapeKind form);

  /// Returns the names of the walls of @p form in the order of
  /// ThinWalled::layups: `left`, `right`, `bottom`, `top`, `web`, `flange`.
  /// Throws as wall_counts() does.
  std::vector<std::string>
  wall_names(const ShapeKind form);

  /// The ply plane of a part of a section from a file.
  struct PartPlane
  {
    /// Direction of the normal in degrees from +x towards +z.
    double direction = 90.;
    /// Names of physical lines, separated by blanks, that give the normal at
    /// their nearest point, pointing out of the section or into it.
    std::string curve    = {};
    bool        outwards = true;
  };

  /// A mesh by Gmsh, whose x, y times scale are the section's x, z, with
  /// straight edges. Physical surfaces are parts, of the material of their name
  /// or in @p parts; physical lines are boundaries; the other boundary is
  /// `other`.
  struct SectionFile
  {
    /// Path including the scene's folder.
    std::string path;
    /// Scale from lengths of the mesh to the scene: 0.001 for mm to m.
    double scale = 1.;
    /// Fabric by name of a physical surface, by default its name at 0 degrees.
    std::map<std::string, OrientedMaterial> parts;
    /// Subsection for messages, `Section NAME`.
    std::string what;
    /// Ply plane by name of a physical surface. Others are level.
    std::map<std::string, PartPlane> planes = {};
  };

  /// Largest number of cells of a section, against typing errors.
  constexpr double max_section_cells = 50000.;

  /// A section as described in the scene; make_section_mesh() makes the mesh.
  using SectionShape =
    std::variant<Laminate, HalfDisc, Ellipse, ThinWalled, Tube, SectionFile>;

  /// Returns the kind of @p shape, never undefined for a scene's shapes.
  ShapeKind
  kind_of(const SectionShape &shape);

  /// Returns the name of its kind in a scene: `half disc`.
  inline std::string
  name_of(const SectionShape &shape)
  {
    return name_of(kind_of(shape));
  }

  /// Returns the mesh of @p shape, with manifolds on arcs. Materials must be in
  /// @p materials (std::out_of_range otherwise). Throws InputError, of the
  /// entries of `Section NAME`, if a file has no valid section.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials);

  /// Returns @p section with all cells divided into four, @p times times. Plies
  /// and side names are inherited. Throws InputError, of the entry `Cells
  /// divided` of the subsection @p what, if more than max_section_cells result.
  std::shared_ptr<const SectionMesh>
  divided(const SectionMesh &section,
          const unsigned int times,
          const std::string &what);

  /// Returns the mesh of a half disc, boundary ids 0 `arc`, 1 `flat`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const HalfDisc &disc, const Materials &materials);

  /// Returns the mesh of an ellipse, boundary id 0 `arc`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials);

  /// Returns the mesh of a tube, boundary ids 0 `inner`, 1 `outer`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Tube &tube, const Materials &materials);

  /// Returns the mesh of walls, boundary ids 0 to 4: `left`, `right`, `bottom`,
  /// `top`, `inner`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials);

  /// Reads the file and returns its mesh, scaled. Messages name its lines.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials);
} // namespace lamella

#endif
