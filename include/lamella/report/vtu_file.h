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
  /// A data array of a VTU file, with n_components numbers per point or cell.
  struct VtuArray
  {
    std::string  name;
    unsigned int n_components = 1;
    std::variant<std::vector<float>,
                 std::vector<double>,
                 std::vector<std::int32_t>,
                 std::vector<std::uint8_t>>
      values;
  };

  /// An unstructured grid with point data and cell data, in VTK's layout.
  struct VtuGrid
  {
    /// Cell types by VTK's numbers.
    static constexpr std::uint8_t vertex = 1, quadrilateral = 9,
                                  lagrange_hexahedron = 72;
    /// Name of the cell data array with degrees of Lagrange hexahedra.
    static constexpr const char *degrees_name = "HigherOrderDegrees";

    /// Positions of points.
    VtuArray points{"points", 3, {}};
    /// Point indices of all cells, end of each cell in this list, cell types.
    std::vector<std::int32_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    std::vector<VtuArray>     at_points, of_cells;
    /// Time and cycle (load step) that ParaView shows.
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

  /// Writes a PVTU file that combines the files @p parts, which have the same
  /// arrays as @p grid.
  void
  write_pvtu_file(std::ostream                   &out,
                  const VtuGrid                  &grid,
                  const std::vector<std::string> &parts);

  /// Returns the index in VTK's order of the node (@p i, @p j, @p k) of a
  /// Lagrange hexahedron of degrees @p n, i from 0 to n[0]: corners first, then
  /// edges, faces and interior.
  unsigned int
  vtk_hexahedron_point(const std::array<unsigned int, 3> &n,
                       const unsigned int                 i,
                       const unsigned int                 j,
                       const unsigned int                 k);
} // namespace lamella

#endif
