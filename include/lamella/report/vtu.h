// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_vtu_h
#define lamella_report_vtu_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/recover/results.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/solve/structure.h>

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lamella
{
  /// A data array of a VTU file for points or cells.
  struct VtuArray
  {
    std::string  name;             ///< Name of the array in ParaView.
    unsigned int n_components = 1; ///< Number of values per point or cell.
    /// Values of the first point or cell, then of the second, ...
    std::variant<std::vector<float>,
                 std::vector<double>,
                 std::vector<std::int32_t>,
                 std::vector<std::uint8_t>>
      values;
  };

  /// An unstructured grid with point data and cell data, as stored by VTK.
  struct VtuGrid
  {
    static constexpr std::uint8_t vertex        = 1; ///< VTK_VERTEX.
    static constexpr std::uint8_t quadrilateral = 9; ///< VTK_QUAD.
    /// VTK_LAGRANGE_HEXAHEDRON.
    static constexpr std::uint8_t lagrange_hexahedron = 72;
    /// Name of the cell data array with degrees of Lagrange hexahedra.
    static constexpr const char *degrees_name = "HigherOrderDegrees";

    VtuArray points{"points", 3, {}}; ///< Positions of the points.
    /// Indices of the points of the first cell, then of the second, ...
    std::vector<std::int32_t> connectivity;
    std::vector<std::int32_t> offsets;   ///< End of each cell in connectivity.
    std::vector<std::uint8_t> types;     ///< VTK type of each cell.
    std::vector<VtuArray>     at_points; ///< Point data.
    std::vector<VtuArray>     of_cells;  ///< Cell data.
    /// Time and load step that ParaView shows; empty for none.
    std::optional<std::pair<double, unsigned int>> time;

    /// Adds a cell of VTK type @p type with the point indices @p corners.
    template <typename Numbers>
    void
    add_cell(const std::uint8_t type, const Numbers &corners)
    {
      connectivity.insert(connectivity.end(), corners.begin(), corners.end());
      offsets.push_back(connectivity.size());
      types.push_back(type);
    }
  };

  /// Writes @p grid as a VTU file, version 2.2 (node order of Lagrange
  /// hexahedra as in VTK 9): raw appended arrays, compressed by zlib.
  void
  write_vtu_file(std::ostream &out, const VtuGrid &grid);

  /// Writes a PVTU file that combines the VTU files named @p parts, whose
  /// arrays have the names and types of those of @p grid.
  void
  write_pvtu_file(std::ostream                   &out,
                  const VtuGrid                  &grid,
                  const std::vector<std::string> &parts);

  /// Returns the index, in VTK's order, of node (@p i, @p j, @p k) of a
  /// Lagrange hexahedron with degrees @p n, where i is 0 to n[0], and j, k
  /// likewise. Nodes of corners are first, then edges, faces and interior.
  unsigned int
  vtk_hexahedron_point(const std::array<unsigned int, 3> &n,
                       const unsigned int                 i,
                       const unsigned int                 j,
                       const unsigned int                 k);

  /// Writes the bodies of @p structure, deformed by @p u, to NAME_STEP.vtu in
  /// @p directory for ParaView and returns the name of the file. NAME is
  /// `solution` for load steps. Each
  /// section cell of each axis element is a Lagrange hexahedron. Strains and
  /// stresses are discontinuous between elements. Cell data are the ply (from 1
  /// at the bottom), the fiber direction and the body (from 1). If @p strength
  /// is not null, the largest inverse reserve factor is written at each point.
  /// @p factor is the time in ParaView.
  ///
  /// Cells have the degrees Body::cells().output_degrees, at most 4. Values are
  /// in single precision. Displacements and positions are rounded to 2^-24 of
  /// the largest value in the file; strains and stresses to 2^-11 of the
  /// largest in the element or 2^-24 of that in the file, whichever is larger.
  ///
  /// With several processes, each process writes NAME_STEP.PROCESS.vtu with
  /// its elements; the name of NAME_STEP.pvtu, which combines these files,
  /// is returned. Throws InputError if a file cannot be written. Collective.
  std::string
  write_vtu(const std::string   &directory,
            const std::string   &name,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength = nullptr);

  /// Writes NAME.pvd, a collection of @p files (load step, file name) for
  /// ParaView, to @p directory; nothing if @p files is empty. Throws InputError
  /// on failure. Must be called by one process only.
  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files);

  /// Mesh of the contact points on a slave surface for visualization:
  /// quadrilaterals between neighboring points, and isolated points.
  class ContactSurface
  {
  public:
    /// Indices of the four contact points at its corners, in cyclic order.
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Keeps references to @p contact and to the @p structure of its bodies.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Returns the quadrilaterals of the mesh as indices of contact points.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Returns the indices of the contact points outside of quadrilaterals.
    const std::vector<unsigned int> &
    isolated_points() const
    {
      return alone;
    }

    /// Returns the mesh, deformed by the displacements @p u of all bodies. Data
    /// at each point are its results in @p rows (columns of the file
    /// contact_NAME.csv) and `separation`, the vector to the point on the
    /// master surface with which it is paired.
    VtuGrid
    grid(const BlockVector &u, const std::vector<ContactRow> &rows) const;

    /// Writes the mesh with the results of load step @p step to the file
    /// contact_NAME_STEP.vtu in @p directory and returns its name. Throws
    /// InputError on failure. Must be called by one process only.
    std::string
    write_vtu(const std::string             &directory,
              const unsigned int             step,
              const BlockVector             &u,
              const std::vector<ContactRow> &rows) const;

  private:
    const ContactInterface    &contact;
    const Structure           &structure;
    std::vector<Quadrilateral> quads;
    std::vector<unsigned int>  alone;
    /// Locations of contact points on the slave body, and of the paired points
    /// on the master body, if it is deformable.
    std::vector<Location> first_locations, second_locations;
  };
} // namespace lamella

#endif
