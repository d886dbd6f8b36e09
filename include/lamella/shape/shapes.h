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
  /// What a section may be: `Shape` in its subsection, with pictures in
  /// doc/sections.md.
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

  /// What a homogeneous section, or a part of one, is made of.
  struct Fabric
  {
    /// Name of the material, as in the scene.
    std::string material;
    /// Fibre angle in degrees, 0 along +y, positive from +y towards +x. The
    /// same in all walls of a thin-walled section: about z, never along a web.
    double angle = 0.;
  };

  /// A ply of a wall.
  struct WallPly
  {
    /// Degrees in the wall's own plane (PlyPlane): 0 along +y.
    Fabric fabric;
    /// [length].
    double thickness = 0.;
  };

  /// Plies from the inside of a wall to its outside.
  using WallLayup = std::vector<WallPly>;

  /**
   * Half a disc, its flat side, the boundary `flat`, on z = 0 and its corners
   * at x = 0 and x = 2 radius; the other boundary is `arc`. The mesh is graded
   * towards the point P of the arc at the angle graded_towards: there the cells
   * are finest_cell wide (or less, where that is too coarse for the rings
   * around them), and grow from ring to ring.
   *
   * Half a butterfly of cells stands at P, rings around it, and a block between
   * the last ring and the flat side. Rings grow by about the factor exp(pi /
   * sectors), at which cells are as wide as deep, so the number of cells goes
   * with the logarithm of radius / finest_cell. It is meshed for P on top and
   * carried elsewhere by the conformal map of the half disc onto itself, under
   * which small cells keep their shape. Made for Hertzian contact (the
   * half-cylinders of the paper's section 4.1).
   */
  struct HalfDisc
  {
    /// [length].
    double radius = 0.;
    /// Of P, in degrees from +x towards +z, 30 to 150; 90 is the top.
    double graded_towards = 90.;
    /// [length]. Must be positive; the scene's default is an eighth of the
    /// radius.
    double finest_cell = 0.;
    /// Cells in each ring around P; a multiple of 4. Away from the top take 12
    /// or more: the far end of the arc has few cells then.
    unsigned int sectors = 8;
    /// Of the whole section.
    Fabric fabric;
  };

  /// A full ellipse in the box [0, width] x [0, height]; its boundary is `arc`.
  /// A circle where width and height agree. Its arc is followed by a manifold
  /// of polar coordinates that are scaled to the axes.
  struct Ellipse
  {
    /// Twice the semi-axes [length].
    double width = 0., height = 0.;
    /// 12 cells, each cut into four this often. So 12 4^n cells.
    unsigned int refinements = 1;
    Fabric       fabric;
  };

  /**
   * Webs (upright walls) and flanges (level ones) in the box [0, width] x
   * [0, height]. What lies on the sides of the box is called `left`, `right`,
   * `bottom`, `top`, and the rest of the boundary `inner`.
   *
   * The mesh is a grid of blocks, of which some are walls: a box has three by
   * three without the middle, a channel two by three, and so on. Cells are
   * rectangles; walls meet in corners of cells_per_wall by cells_per_wall
   * cells. The theory of shells or thin walls is not used: a wall is a piece of
   * the section like any other.
   *
   * With layups each wall has plies in its own plane (PlyPlane). Flanges run
   * through to the sides of the box, webs end at them. Normals point out of the
   * section: of left walls -x, of right ones +x, of bottom ones -z, of top ones
   * +z; that of a web with both faces free points to +x.
   */
  struct ThinWalled
  {
    /// box, double_t, t, channel or angle.
    ShapeKind form = ShapeKind::undefined;
    /// Outer extensions [length].
    double width = 0., height = 0.;
    /// Thicknesses from left to right and from bottom to top. As many as
    /// count_of_walls() says, each [length]; their sums must leave some of the
    /// width and of the height.
    std::vector<double> webs, flanges;
    /// Through the thickness of each wall, and along it between its corners.
    unsigned int cells_per_wall = 1, cells_along_wall = 4;
    Fabric       fabric;
    /// Of each wall, webs first, with plies that add up to its thickness; or
    /// none, and all walls are of the fabric.
    std::vector<WallLayup> layups = {};
    /// Through the thickness of each ply of a layup.
    unsigned int cells_per_ply = 1;
  };

  /**
   * A ring of plies in the box [0, width] x [0, height]: between an ellipse and
   * the curve at the distance of its thickness inside of it, so that wall and
   * plies are as thick all round. The boundaries are `inner` and `outer`. The
   * plies are parallel to the ellipse, their normals those of its nearest
   * points (EllipseFoot), and so another one at each point. Cells have curved
   * edges, their second direction is the normal's.
   */
  struct Tube
  {
    /// Of its outside [length].
    double width = 0., height = 0.;
    /// From the inside to the outside; their thicknesses add up to the wall's,
    /// which must be below the smallest radius of the ellipse's curvature,
    /// min(width, height)^2 / (2 max(width, height)).
    WallLayup layup;
    /// In each ring, a multiple of 4, equally wide in the ellipse's parameter,
    /// with vertices on its axes; and through each ply.
    unsigned int cells_around = 24, cells_per_ply = 1;
  };

  /// How many webs and flanges the thin-walled section @p form has. A box has
  /// two of each, a double-T one web and two flanges, a T one of each. @p form
  /// must be a thin-walled one; others throw std::out_of_range.
  std::pair<unsigned int, unsigned int>
  count_of_walls(const ShapeKind form);

  /// What the walls of @p form are called, webs first: `left`, `right`,
  /// `bottom`, `top`, or `web` or `flange` where there is one. In the order of
  /// ThinWalled::layups. As above.
  std::vector<std::string>
  names_of_walls(const ShapeKind form);

  /// The ply plane of a part of a section from a file.
  struct PartPlane
  {
    /// Of the normal, in degrees from +x towards +z.
    double direction = 90.;
    /// Or the physical lines, between blanks, whose nearest point has it, out
    /// of the section there, or into it.
    std::string curve    = {};
    bool        outwards = true;
  };

  /**
   * A mesh made by Gmsh; its x, y are the section's x, z, times scale. Its
   * physical surfaces are the parts, called as their material unless @p parts
   * tells it, its physical lines the boundaries, what is left of these `other`.
   * Coordinates are not shifted: (0, 0) of the mesh is that of the section.
   * Edges are straight.
   */
  struct SectionFile
  {
    /// As it is opened: the scene's folder is part of it.
    std::string path;
    /// Lengths of the scene over lengths of the mesh: 0.001 for a mesh in mm in
    /// a scene in m.
    double scale = 1.;
    /// Name of a physical surface -> what it is made of. Those that are not
    /// listed are of the material that has their name, at 0 degrees.
    std::map<std::string, Fabric> parts;
    /// The subsection that names it, for messages: `Section NAME`. Faults of
    /// the mesh are then faults of the entry `Section NAME/File`.
    std::string what;
    /// Name of a physical surface -> where the normal of its ply plane points.
    /// Those that are not listed are level.
    std::map<std::string, PartPlane> planes = {};
  };

  /// Of a whole section: a slip of a digit must not end in a machine out of
  /// memory.
  constexpr double most_section_cells = 50000.;

  /// A section as the scene describes it. Plain data, cheap to copy: no mesh is
  /// made, and no file read, before make_section_mesh().
  using SectionShape =
    std::variant<Laminate, HalfDisc, Ellipse, ThinWalled, Tube, SectionFile>;

  /// Never undefined for what the scene has read.
  ShapeKind
  kind_of(const SectionShape &shape);

  /// As a user writes its kind: `laminate`, `half disc`, ...
  inline std::string
  name_of(const SectionShape &shape)
  {
    return name_of(kind_of(shape));
  }

  /**
   * The mesh of @p shape. Edges on arcs carry a manifold, so that expansions of
   * higher degree follow the curve. Throws InputError, of the entries of
   * `Section NAME`, if @p shape is a file that does not hold a section. The
   * materials that @p shape names must be in @p materials (std::out_of_range
   * otherwise). Sections from files pass check_section_mesh(); those of
   * formulas need no check but check_proportions().
   */
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials);

  /// All cells of @p section divided in four, @p times times, at the middles of
  /// their edges, on arcs where their manifold has these. Plies and the names
  /// of sides are inherited. Throws InputError, of the entry `Cells divided` of
  /// the subsection @p what, if that makes more than most_section_cells.
  std::shared_ptr<const SectionMesh>
  divided(const SectionMesh &section,
          const unsigned int times,
          const std::string &what);

  /// Of one kind of shape; what make_section_mesh() calls. All but files have
  /// the lower left corner of their box at (0, 0). Boundary ids of this one: 0
  /// `arc`, 1 `flat`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const HalfDisc &disc, const Materials &materials);

  /// Boundary id 0 `arc`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials);

  /// Boundary ids 0 `inner`, 1 `outer`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Tube &tube, const Materials &materials);

  /// Boundary ids 0 to 4: `left`, `right`, `bottom`, `top`, `inner`. Only
  /// vertices of walls are made, not those of the whole grid.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials);

  /// Reads the file now. Vertices stay where they are but for the scale; a
  /// message names the line of the fault where it has one.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials);
} // namespace lamella

#endif
