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

  /// Material and fiber angle of a homogeneous section or of one of its plies.
  struct OrientedMaterial
  {
    /// Name of the material in the scene.
    std::string material;
    /// Fiber angle about z in degrees, 0 along +y, positive towards +x.
    double angle = 0.;
  };

  /// A ply of a wall.
  struct WallPly
  {
    /// Material, and fiber angle in the wall's plane (PlyPlane) in degrees.
    OrientedMaterial oriented_material;
    /// Thickness [length].
    double thickness = 0.;
  };

  /// Plies of a wall from the inside to the outside.
  using WallLayup = std::vector<WallPly>;

  /// A half disc for Hertzian contact of cylinders (the paper's section 4.1),
  /// with the flat boundary `flat` on z = 0 from x = 0 to x = 2 radius and the
  /// round boundary `arc`.
  ///
  /// The mesh is graded towards the point P of the arc at the angle
  /// graded_towards, where cells have about the width finest_cell. The mesh
  /// consists of half a butterfly mesh at P, concentric rings, and a block at
  /// the flat side. Ring radii grow by about exp(pi / sectors), so that cells
  /// are nearly square. A conformal map of the half disc moves P from the top.
  struct HalfDisc
  {
    /// Radius [length].
    double radius = 0.;
    /// Angle of the point P in degrees from +x to +z, 30 to 150; 90 is the top.
    double graded_towards = 90.;
    /// Width of the finest cells [length]; in a scene by default radius / 8.
    double finest_cell = 0.;
    /// Number of cells in each ring around P, a multiple of 4, and at least 12
    /// if graded_towards is not 90.
    unsigned int sectors = 8;
    /// Material and fiber angle of the section.
    OrientedMaterial oriented_material;
  };

  /// A solid ellipse in [0, width] x [0, height] with the boundary `arc`.
  struct Ellipse
  {
    /// Lengths of the axes along x and z [length].
    double width = 0., height = 0.;
    /// Number n of global refinements; the mesh has 12 4^n cells.
    unsigned int     refinements = 1;
    OrientedMaterial oriented_material;
  };

  /// A section of vertical webs and horizontal flanges in the rectangle [0,
  /// width] x [0, height]. Boundaries on the sides of this rectangle are
  /// `left`, `right`, `bottom` and `top`, all others `inner`. Walls are meshed
  /// as solids, without a thin-wall theory.
  ///
  /// The mesh consists of rectangular blocks, e.g. eight of 3 x 3 for a box.
  /// The block of a web and a flange has cells_per_wall^2 cells.
  ///
  /// The plies of a wall are parallel to the wall (see PlyPlane). Flanges
  /// extend over the whole width, webs end at flanges. Normals point outwards:
  /// -x in left, +x in right, -z in bottom and +z in top walls. A web with two
  /// free faces has the normal +x.
  struct ThinWalled
  {
    /// Shape: box, double_t, t, channel or angle.
    ShapeKind form = ShapeKind::undefined;
    /// Outer dimensions [length].
    double width = 0., height = 0.;
    /// Thicknesses of the webs from left to right and of the flanges from
    /// bottom to top [length], as many as wall_counts(). Their sums must be
    /// less than the width and the height.
    std::vector<double> webs, flanges;
    /// Number of cells through each wall, and along each wall between corners.
    unsigned int     cells_per_wall = 1, cells_along_wall = 4;
    OrientedMaterial oriented_material;
    /// Layup of each wall, webs first; empty for walls of one material. The ply
    /// thicknesses of a wall must add up to its thickness.
    std::vector<WallLayup> layups = {};
    /// Number of cells through the thickness of each ply of a layup.
    unsigned int cells_per_ply = 1;
  };

  /// A laminated elliptical tube. The outer surface is the ellipse in the
  /// rectangle [0, width] x [0, height]; the inner surface and the interfaces
  /// of plies are curves parallel to this ellipse, with the normals of
  /// EllipseProjection. Boundaries are `inner` and `outer`. Cells have curved
  /// edges; their reference coordinate eta is along the normal.
  struct Tube
  {
    /// Outer dimensions [length].
    double width = 0., height = 0.;
    /// Plies from inside to outside. The total thickness must be less than
    /// min(width, height)^2 / (2 max(width, height)).
    WallLayup layup;
    /// Number of cells around the tube, a multiple of 4, at equal increments of
    /// the ellipse's parameter, and number of cells through each ply.
    unsigned int cells_around = 24, cells_per_ply = 1;
  };

  /// Returns the numbers of webs and flanges of the thin-walled @p form. Throws
  /// std::out_of_range if @p form is not thin-walled.
  std::pair<unsigned int, unsigned int>
  wall_counts(const ShapeKind form);

  /// Returns the names of the walls of @p form in the order of
  /// ThinWalled::layups: `left`, `right`, `bottom`, `top`, `web`, `flange`.
  /// Throws std::out_of_range if @p form is not thin-walled.
  std::vector<std::string>
  wall_names(const ShapeKind form);

  /// The ply plane of a physical surface of a Gmsh file.
  struct PartPlane
  {
    /// Direction of a constant normal in degrees from +x towards +z.
    double direction = 90.;
    /// Names of physical lines, separated by blanks. If set, the normal at a
    /// point is that of the nearest point on these lines, pointing out of the
    /// section, or into it if @p outwards is false.
    std::string curve    = {};
    bool        outwards = true;
  };

  /// A section meshed by Gmsh with straight edges. The coordinates x, y of the
  /// file times `scale` are x, z of the section. Each physical surface has one
  /// material, given in `parts` or by the name of the surface. Physical lines
  /// are boundaries; the remaining boundary is `other`.
  struct SectionFile
  {
    /// Path of the mesh file.
    std::string path;
    /// Factor from the file's to the scene's lengths, e.g. 0.001 for mm to m.
    double scale = 1.;
    /// Material and fiber angle by name of the physical surface. The default is
    /// the material with the name of the surface, at 0 degrees.
    std::map<std::string, OrientedMaterial> parts;
    /// Subsection for messages, `Section NAME`.
    std::string what;
    /// Ply plane by name of the physical surface; the default normal is +z.
    std::map<std::string, PartPlane> planes = {};
  };

  /// Largest number of cells of a section, to detect typing errors.
  constexpr double max_section_cells = 50000.;

  /// Shape of a section in a scene; make_section_mesh() creates its mesh.
  using SectionShape =
    std::variant<Laminate, HalfDisc, Ellipse, ThinWalled, Tube, SectionFile>;

  /// Returns the kind of the alternative stored in @p shape.
  ShapeKind
  kind_of(const SectionShape &shape);

  /// Returns the name of the kind of @p shape in a scene, e.g. `half disc`.
  inline std::string
  name_of(const SectionShape &shape)
  {
    return name_of(kind_of(shape));
  }

  /// Returns the mesh of @p shape, with manifolds on arcs. Throws
  /// std::out_of_range if a material is not in @p materials, and InputError if
  /// a mesh file has no valid section.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials);

  /// Returns the mesh @p section with each cell divided into four, @p times
  /// times. Throws InputError for the entry `Cells divided` in the subsection
  /// @p what if the result has more than max_section_cells cells.
  std::shared_ptr<const SectionMesh>
  divided(const SectionMesh &section,
          const unsigned int times,
          const std::string &what);

  /// Returns the mesh of a half disc with boundary ids 0 `arc`, 1 `flat`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const HalfDisc &disc, const Materials &materials);

  /// Returns the mesh of an ellipse with boundary id 0 for `arc`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials);

  /// Returns the mesh of a tube with boundary ids 0 `inner`, 1 `outer`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Tube &tube, const Materials &materials);

  /// Returns the mesh of a thin-walled section with boundary ids 0 to 4 for
  /// `left`, `right`, `bottom`, `top`, `inner`.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials);

  /// Reads the Gmsh file and returns its mesh, scaled. Throws InputError.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials);
} // namespace lamella

#endif
