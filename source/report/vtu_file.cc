// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/report/vtu.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parallel.h>

#include <algorithm>
#include <functional>

#include <zlib.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    const char *
    type_of(const VtuArray &array)
    {
      constexpr std::array<const char *, 4> names{
        {"Float32", "Float64", "Int32", "UInt8"}};
      return names[array.values.index()];
    }



    /// Appends @p numbers as they are in memory.
    void
    append(std::string &to, const std::vector<std::uint32_t> &numbers)
    {
      to.append(reinterpret_cast<const char *>(numbers.data()),
                4 * numbers.size());
    }



    /// The array as VTK's readers take it: the number of blocks, their size,
    /// that of a shorter last one, all compressed sizes, and the blocks.
    std::string
    compressed(const VtuArray &array)
    {
      constexpr std::size_t block_size = 1 << 20;
      const auto [data, size]          = std::visit(
        [](const auto &v) {
          return std::make_pair(reinterpret_cast<const Bytef *>(v.data()),
                                v.size() * sizeof(v[0]));
        },
        array.values);
      std::vector<std::uint32_t> header{std::uint32_t((size + block_size - 1) /
                                                      block_size),
                                        std::uint32_t(block_size),
                                        std::uint32_t(size % block_size)};
      std::string                blocks;
      std::vector<Bytef>         block(compressBound(block_size));
      for (std::size_t begin = 0; begin < size; begin += block_size)
        {
          uLongf    length = block.size();
          const int status = compress2(block.data(),
                                       &length,
                                       data + begin,
                                       std::min(block_size, size - begin),
                                       Z_BEST_SPEED);
          AssertThrow(status == Z_OK, ExcMessage("zlib has failed."));
          header.push_back(length);
          blocks.append(reinterpret_cast<const char *>(block.data()), length);
        }
      std::string result;
      append(result, header);
      return result + blocks;
    }



    /// The arrays by the element of the file that they stand in; @p use is
    /// called with its name and attributes, and with the arrays.
    using UseOfArrays =
      std::function<void(const std::string &,
                         const std::string &,
                         const std::vector<const VtuArray *> &)>;
    void
    for_each_group(const VtuGrid               &grid,
                   const std::vector<VtuArray> &cells,
                   const std::string           &prefix,
                   const UseOfArrays           &use)
    {
      const auto all = [](const std::vector<VtuArray> &arrays) {
        std::vector<const VtuArray *> result;
        for (const VtuArray &array : arrays)
          result.push_back(&array);
        return result;
      };
      std::string degrees;
      for (const VtuArray &array : grid.of_cells)
        if (array.name == VtuGrid::degrees_name)
          degrees = " HigherOrderDegrees=\"" + array.name + "\"";
      use(prefix + "Points", "", {&grid.points});
      if (!cells.empty())
        use("Cells", "", all(cells));
      use(prefix + "PointData", "", all(grid.at_points));
      use(prefix + "CellData", degrees, all(grid.of_cells));
    }



    void
    write_array_start(std::ostream      &out,
                      const std::string &element,
                      const VtuArray    &array)
    {
      out << "<" << element << " type=\"" << type_of(array) << "\" Name=\""
          << array.name << "\" NumberOfComponents=\"" << array.n_components
          << "\"";
    }



    void
    write_start(std::ostream      &out,
                const std::string &type,
                const std::string &attributes)
    {
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
          << "\" version=\"2.2\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt32\""
          << attributes << ">\n";
    }



    /// The load factor, which ParaView takes for a time, and the step.
    void
    write_time(std::ostream &out, const double time, const unsigned int step)
    {
      out << "<FieldData>\n<DataArray type=\"Float32\" Name=\"CYCLE\" "
             "NumberOfTuples=\"1\" format=\"ascii\">"
          << step
          << "</DataArray>\n<DataArray type=\"Float32\" Name=\"TIME\" "
             "NumberOfTuples=\"1\" format=\"ascii\">"
          << time << "</DataArray>\n</FieldData>\n";
    }



    /// All arrays, in the order of for_each_group(), each on its own thread.
    std::vector<std::string>
    all_compressed(const VtuGrid &grid, const std::vector<VtuArray> &cells)
    {
      std::vector<const VtuArray *> arrays;
      for_each_group(grid,
                     cells,
                     "",
                     [&arrays](const auto &, const auto &, const auto &part) {
                       arrays.insert(arrays.end(), part.begin(), part.end());
                     });
      std::vector<std::string> packed(arrays.size());
      parallel::apply_to_subranges(
        std::size_t(0),
        arrays.size(),
        [&](const std::size_t begin, const std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            packed[k] = compressed(*arrays[k]);
        },
        1);
      return packed;
    }
  } // namespace



  void
  write_vtu_file(std::ostream &out, const VtuGrid &grid)
  {
    const std::vector<VtuArray>    cells{{"connectivity", 1, grid.connectivity},
                                      {"offsets", 1, grid.offsets},
                                      {"types", 1, grid.types}};
    const std::vector<std::string> packed = all_compressed(grid, cells);

    write_start(out,
                "UnstructuredGrid",
                " compressor=\"vtkZLibDataCompressor\"");
    out << "<UnstructuredGrid>\n";
    if (grid.time)
      write_time(out, grid.time->first, grid.time->second);
    const std::size_t n_points =
      std::visit([](const auto &v) { return v.size(); }, grid.points.values) /
      3;
    out << "<Piece NumberOfPoints=\"" << n_points << "\" NumberOfCells=\""
        << grid.types.size() << "\">\n";
    std::size_t offset = 0, k = 0;
    for_each_group(
      grid,
      cells,
      "",
      [&](const std::string &name, const std::string &more, const auto &part) {
        out << "<" << name << more << ">\n";
        for (const VtuArray *array : part)
          {
            write_array_start(out, "DataArray", *array);
            out << " format=\"appended\" offset=\"" << offset << "\"/>\n";
            offset += packed[k++].size();
          }
        out << "</" << name << ">\n";
      });
    out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    for (const std::string &array : packed)
      out << array;
    out << "\n</AppendedData>\n</VTKFile>\n";
  }



  void
  write_pvtu_file(std::ostream                   &out,
                  const VtuGrid                  &grid,
                  const std::vector<std::string> &parts)
  {
    write_start(out, "PUnstructuredGrid", "");
    out << "<PUnstructuredGrid GhostLevel=\"0\">\n";
    for_each_group(grid,
                   {},
                   "P",
                   [&](const std::string &name,
                       const std::string &more,
                       const auto        &part) {
                     out << "<" << name << more << ">\n";
                     for (const VtuArray *array : part)
                       {
                         write_array_start(out, "PDataArray", *array);
                         out << "/>\n";
                       }
                     out << "</" << name << ">\n";
                   });
    for (const std::string &part : parts)
      out << "<Piece Source=\"" << part << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }



  unsigned int
  vtk_hexahedron_point(const std::array<unsigned int, 3> &n,
                       const unsigned int                 i,
                       const unsigned int                 j,
                       const unsigned int                 k)
  {
    const bool i_ends = i == 0 || i == n[0], j_ends = j == 0 || j == n[1],
               k_ends    = k == 0 || k == n[2];
    const unsigned int a = n[0] - 1, b = n[1] - 1, c = n[2] - 1;
    const unsigned int round = i > 0 ? (j > 0 ? 2 : 1) : (j > 0 ? 3 : 0);
    if (i_ends && j_ends && k_ends)
      return round + (k > 0 ? 4 : 0);

    unsigned int first = 8;
    if (j_ends && k_ends)
      return first + i - 1 + (j > 0 ? a + b : 0) + (k > 0 ? 2 * (a + b) : 0);
    if (i_ends && k_ends)
      return first + j - 1 + (i > 0 ? a : 2 * a + b) +
             (k > 0 ? 2 * (a + b) : 0);
    first += 4 * (a + b);
    if (i_ends && j_ends)
      return first + k - 1 + c * round;

    first += 4 * c;
    if (i_ends)
      return first + j - 1 + b * (k - 1 + (i > 0 ? c : 0));
    first += 2 * b * c;
    if (j_ends)
      return first + i - 1 + a * (k - 1 + (j > 0 ? c : 0));
    first += 2 * a * c;
    if (k_ends)
      return first + i - 1 + a * (j - 1 + (k > 0 ? b : 0));
    return first + 2 * a * b + i - 1 + a * (j - 1 + b * (k - 1));
  }
} // namespace lamella
