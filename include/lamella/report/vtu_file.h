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
  /// Named numbers, @p n_components per point or cell.
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

  /// An unstructured grid with fields, in the layout of VTK.
  struct VtuGrid
  {
    /// VTK's numbers of cell types.
    static constexpr std::uint8_t vertex = 1, quadrilateral = 9,
                                  lagrange_hexahedron = 72;
    /// Name of the array of `of_cells` with the degrees of Lagrange hexahedra.
    static constexpr const char *degrees_name = "HigherOrderDegrees";

    /// Points, with three components.
    VtuArray points{"points", 3, {}};
    /// Points of all cells, ends of the cells therein, and cell types.
    std::vector<std::int32_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    std::vector<VtuArray>     at_points, of_cells;
    /// Time and cycle that readers show.
    std::optional<std::pair<double, unsigned int>> time;

    /// Adds a cell with the points @p corners.
    template <typename Numbers>
    void
    add_cell(const std::uint8_t type, const Numbers &corners)
    {
      connectivity.insert(connectivity.end(), corners.begin(), corners.end());
      offsets.push_back(connectivity.size());
      types.push_back(type);
    }
  };

  /// Writes @p grid as a .vtu: raw appended arrays, compressed in blocks by the
  /// fastest zlib level. The file has version 2.2, in which Lagrange hexahedra
  /// are numbered as in VTK 9.
  void
  write_vtu_file(std::ostream &out, const VtuGrid &grid);

  /// Writes the .pvtu of the files @p parts, which have the arrays of @p grid.
  void
  write_pvtu_file(std::ostream                   &out,
                  const VtuGrid                  &grid,
                  const std::vector<std::string> &parts);

  /// Returns the number, in VTK's order, of the lattice point (@p i, @p j,
  /// @p k) of a Lagrange hexahedron of degrees @p n: corners first, then edges,
  /// faces and the inside. Corners and upright edges are in cyclic order, lower
  /// corners first; edges along, and faces normal to, the first coordinate come
  /// first.
  unsigned int
  vtk_hexahedron_point(const std::array<unsigned int, 3> &n,
                       const unsigned int                 i,
                       const unsigned int                 j,
                       const unsigned int                 k);
} // namespace lamella

#endif
