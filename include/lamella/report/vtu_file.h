// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_vtu_file_h
#define lamella_report_vtu_file_h

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
} // namespace lamella

#endif
