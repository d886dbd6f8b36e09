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
  /// Numbers of a VTU file with a name, those of one point or cell after
  /// another, @p n_components of each.
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

  /// An unstructured grid with fields, as VTK's readers take it.
  struct VtuGrid
  {
    /// VTK's numbers of cell types.
    static constexpr std::uint8_t vertex = 1, quadrilateral = 9,
                                  lagrange_hexahedron = 72;
    /// Of `of_cells` the array with the three degrees of each Lagrange
    /// hexahedron; readers know it by this name.
    static constexpr const char *degrees_name = "HigherOrderDegrees";

    /// Three components.
    VtuArray points{"points", 3, {}};
    /// The points of all cells, where those of each end, and the cells' types.
    std::vector<std::int32_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    std::vector<VtuArray>     at_points, of_cells;
    /// The time and the cycle that readers show.
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

  /**
   * Writes @p grid as a .vtu: arrays as they are in memory behind the XML
   * (`appended`, `raw`), compressed by zlib at its fastest in blocks, each
   * array once. Compresses arrays side by side where the run has threads. The
   * file is of version 2.2, whose Lagrange hexahedra are numbered as those of
   * VTK 9; cells with degrees of their own need VTK 9.0.
   */
  void
  write_vtu_file(std::ostream &out, const VtuGrid &grid);

  /// Writes the .pvtu of the files @p parts, which have the arrays of @p grid.
  void
  write_pvtu_file(std::ostream                   &out,
                  const VtuGrid                  &grid,
                  const std::vector<std::string> &parts);

  /**
   * The place in VTK's order of the points of a Lagrange hexahedron of the
   * degrees @p n of the point (@p i, @p j, @p k) of its lattice: corners first,
   * then edges, faces and the inside. The corners go round below, then above,
   * and the upright edges likewise; of edges and faces come first those along
   * the first coordinate, normal to it.
   */
  unsigned int
  vtk_hexahedron_point(const std::array<unsigned int, 3> &n,
                       const unsigned int                 i,
                       const unsigned int                 j,
                       const unsigned int                 k);
} // namespace lamella

#endif
