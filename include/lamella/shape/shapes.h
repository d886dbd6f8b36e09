// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shapes_h
#define lamella_shape_shapes_h

#include <lamella/base/names.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace lamella
{
  /// A rectangular laminated section with plies from z = 0 upwards.
  struct Laminate
  {
    double width = 0.; ///< Width along x [length].
    /// Fiber angles of the plies in degrees, bottom to top (see Ply::angle).
    std::vector<double> angles;
    /// Thicknesses of the plies, bottom to top [length], positive.
    std::vector<double> thicknesses;
    /// Names of the materials of the plies, bottom to top.
    std::vector<std::string> materials;
    /// Number of cells through the thickness of each ply, bottom to top; a
    /// single number applies to all plies.
    std::vector<unsigned int> cells_per_ply{1};
    /// Number of equal cells in each interval of the width, from x = 0.
    std::vector<unsigned int> cells_across{1};
    /// Positions x of the boundaries between the intervals of cells_across,
    /// ascending [length].
    std::vector<double> across_breaks{};

    /// Returns the sum of the ply thicknesses [length].
    double
    height() const;

    /// Returns the plies, bottom to top, with material data from @p library.
    /// Throws std::out_of_range if @p library has no material of this name.
    std::vector<Ply>
    plies(const Materials &library) const;
  };

  /// Returns the structured mesh of @p laminate, with the plies' data from
  /// @p materials. Boundary ids 0 to 3 are `left` (x = 0), `right`, `bottom` (z
  /// = 0) and `top`. The material id of a cell is the index of its ply.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials);

  /// The stiffness matrices A, B, D of classical lamination theory, N = A e + B
  /// k, M = B e + D k in the order {yy, xx, xy} with y along the beam (Jones,
  /// Mechanics of Composite Materials, 2nd ed., Eqs. 4.22 to 4.24):
  ///   A = sum_k Q_k (z_k - z_k-1)
  ///   B = 1/2 sum_k Q_k (z_k^2 - z_k-1^2)
  ///   D = 1/3 sum_k Q_k (z_k^3 - z_k-1^3)
  /// Q_k is the plane-stress stiffness of ply k in the body's axes; its faces
  /// are at the distances z_k-1 and z_k from the mid-plane. e and k are strains
  /// and curvatures of the mid-plane, N and M forces and moments per width.
  /// Units are force/length for A, force for B, force times length for D.
  struct LaminateStiffness
  {
    dealii::Tensor<2, 3> A, ///< Extensional stiffness [force / length].
      B,                    ///< Coupling stiffness [force].
      D;                    ///< Bending stiffness [force length].
    /// Axial stiffness EA = b / a_11 [force] of a strip of width b that is free
    /// to contract and twist. a_11 = e_yy / N_yy and d_11 = k_yy / M_yy are
    /// compliances, entries of the inverse of the 6 x 6 matrix [A, B; B, D].
    double EA = 0.;
    double EI = 0.; ///< Bending stiffness EI = b / d_11 [force length^2].
    /// Bending stiffness of a strip that contracts freely but does not twist.
    double EI_untwisted = 0.;
    /// Shear stiffness, int C_yz,yz dA without shear correction factor [force].
    double GA = 0.;
  };

  /// Computes the stiffnesses of a laminate of @p width; plies bottom to top.
  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width);

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

  /// Names of the shapes in parameter files.
  template <>
  struct Names<ShapeKind>
  {
    /// Value and name of each shape except `undefined`.
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

  /// Material and fiber angle of a homogeneous section or of one ply.
  struct OrientedMaterial
  {
    std::string material; ///< Name of the material in the scene.
    /// Fiber angle in degrees: 0 along the beam axis +y, positive towards +x.
    double angle = 0.;
  };

  /// A ply of a wall of a thin-walled section or tube.
  struct WallPly
  {
    /// Material, and fiber angle in degrees in the plane of the wall, 0 along
    /// +y.
    OrientedMaterial oriented_material;
    double           thickness = 0.; ///< Thickness [length].
  };

  /// Plies of a wall of a thin-walled section or tube, from inside to outside.
  using WallLayup = std::vector<WallPly>;

  /// A half disc for Hertzian contact of cylinders, with the flat boundary
  /// `flat` on z = 0 from x = 0 to x = 2 radius and the round boundary `arc`.
  ///
  /// The mesh is graded towards the point P of the arc at the angle
  /// graded_towards, where cells have about the width finest_cell. The mesh
  /// consists of half a butterfly mesh at P, concentric rings, and a block at
  /// the flat side. Ring radii grow by about exp(pi / sectors), so that cells
  /// are nearly square. If P is not the top of the arc, a conformal map of the
  /// half disc moves the finest cells from the top to P.
  struct HalfDisc
  {
    double radius = 0.; ///< Radius [length].
    /// Angle of P, the point of finest mesh, in degrees from +x to +z, 30 to
    /// 150.
    double graded_towards = 90.;
    /// Width of the finest cells [length]; in a scene by default radius / 8.
    double finest_cell = 0.;
    /// Number of cells in each ring around the point of finest mesh: a multiple
    /// of 4, and at least 12 if graded_towards is not 90.
    unsigned int     sectors = 8;
    OrientedMaterial oriented_material; ///< Material and fiber angle.
  };

  /// A solid ellipse in [0, width] x [0, height] with the boundary `arc`.
  struct Ellipse
  {
    double width = 0., ///< Length of the axis along x [length].
      height     = 0.; ///< Length of the axis along z [length].
    /// Number n of global refinements; the mesh has 12 4^n cells.
    unsigned int     refinements = 1;
    OrientedMaterial oriented_material; ///< Material and fiber angle.
  };

  /// A section of vertical webs and horizontal flanges in the rectangle [0,
  /// width] x [0, height]. Boundaries on the sides of this rectangle are
  /// `left`, `right`, `bottom` and `top`, all others `inner`. Walls are meshed
  /// as solids, without a thin-wall theory.
  ///
  /// The mesh consists of rectangular blocks, e.g. for a box 3 x 3 without the
  /// middle one. The corner block of a web and a flange has cells_per_wall^2
  /// cells.
  ///
  /// The plies of a wall are parallel to the wall (see PlyPlane). Flanges
  /// extend over the whole width, webs end at flanges. Normals point outwards:
  /// -x in left, +x in right, -z in bottom and +z in top walls. A web with two
  /// free faces has the normal +x.
  struct ThinWalled
  {
    /// Shape: box, double_t, t, channel or angle.
    ShapeKind form  = ShapeKind::undefined;
    double    width = 0., ///< Outer dimension along x [length].
      height        = 0.; ///< Outer dimension along z [length].
    /// Thicknesses of the webs from left to right, as many as wall_counts()
    /// [length]. Their sum must be less than the width.
    std::vector<double> webs;
    /// Thicknesses of the flanges from bottom to top, as many as wall_counts()
    /// [length]. Their sum must be less than the height.
    std::vector<double> flanges;
    unsigned int cells_per_wall = 1, ///< Number of cells through each wall.
      cells_along_wall          = 4; ///< Cells along each wall between corners.
    /// Material and fiber angle of all walls without layup.
    OrientedMaterial oriented_material;
    /// Layup of each wall, webs first; empty if all walls are of one material.
    /// The ply thicknesses of a wall must add up to its thickness.
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
    double width = 0., ///< Outer dimension along x [length].
      height     = 0.; ///< Outer dimension along z [length].
    /// Plies from inside to outside. The sum of their thicknesses must be less
    /// than min(width, height)^2 / (2 max(width, height)).
    WallLayup layup;
    /// Number of cells around the tube, a multiple of 4.
    unsigned int cells_around  = 24;
    unsigned int cells_per_ply = 1; ///< Number of cells through each ply.
  };

  /// Returns the number of webs and the number of flanges of the thin-walled
  /// shape @p form. Throws std::out_of_range if @p form is not thin-walled.
  std::pair<unsigned int, unsigned int>
  wall_counts(const ShapeKind form);

  /// Returns the names of the walls of the thin-walled shape @p form, webs
  /// first: `left`, `right`, `bottom`, `top`, `web`, `flange`. Throws
  /// std::out_of_range if @p form is not thin-walled.
  std::vector<std::string>
  wall_names(const ShapeKind form);

  /// The plane of the plies in one physical surface of a Gmsh file.
  struct PartPlane
  {
    /// Direction of a constant ply normal in degrees from +x towards +z.
    double direction = 90.;
    /// Names of physical lines, separated by blanks. If set, the normal at a
    /// point is that of the nearest point on these lines; if empty, see
    /// `direction`.
    std::string curve = {};
    /// True if normals of `curve` point out of the section, false if into it.
    bool outwards = true;
  };

  /// A section meshed by Gmsh with straight edges. The coordinates x, y of the
  /// file times `scale` are x, z of the section. Each physical surface has one
  /// material, given in `parts` or by the name of the surface. Physical lines
  /// are boundaries; the remaining boundary is `other`.
  struct SectionFile
  {
    std::string path; ///< Path of the mesh file.
    /// Factor from the file's to the scene's lengths, e.g. 0.001 for mm to m.
    double scale = 1.;
    /// Material and fiber angle of each physical surface, by its name. The
    /// default is the material with the name of the surface, at 0 degrees.
    std::map<std::string, OrientedMaterial> parts;
    std::string what; ///< Name of the subsection in messages, `Section NAME`.
    /// Plane of the plies by name of the physical surface; normal +z by
    /// default.
    std::map<std::string, PartPlane> planes = {};
  };

  /// Largest number of cells of a section, to detect typing errors.
  constexpr double max_section_cells = 50000.;

  /// Parameters of a section of any shape, for make_section_mesh().
  using SectionShape =
    std::variant<Laminate, HalfDisc, Ellipse, ThinWalled, Tube, SectionFile>;

  /// Returns the name of the shape in parameter files, e.g. `half disc`.
  inline std::string
  name_of(const SectionShape &shape)
  {
    // In the order of SectionShape.
    constexpr std::array<ShapeKind, 6> kinds{{ShapeKind::laminate,
                                              ShapeKind::half_disc,
                                              ShapeKind::ellipse,
                                              ShapeKind::undefined,
                                              ShapeKind::tube,
                                              ShapeKind::file}};
    const auto                        *walls = std::get_if<ThinWalled>(&shape);
    return name_of(walls != nullptr ? walls->form : kinds[shape.index()]);
  }

  /// Returns the mesh of @p shape, with manifolds on arcs. Throws
  /// std::out_of_range for unknown materials, InputError for a bad Gmsh file.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials);

  /// Returns the mesh @p section with each cell divided into four, repeated
  /// @p times times. Throws InputError for the entry `Cells divided` in the
  /// subsection @p what if the result has more than max_section_cells cells.
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

  /// Returns the scaled mesh of a Gmsh file. Throws InputError if invalid.
  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials);
} // namespace lamella

#endif
