// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/report/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Binary digits that are kept of what is largest in a file, those of a
    // float, and in an element: five decimals for who reads values off a
    // picture. (With 11, an eighth of a step of 256 colors, the files of
    // prm/flexure_test.prm are a seventh shorter.)
    constexpr int digits_of_file = 24, digits_of_element = 16;

    using Range = std::pair<std::size_t, std::size_t>;



    double
    largest_of(const std::vector<float> &values, const Range &range)
    {
      float largest = 0.f;
      for (std::size_t k = range.first; k < range.second; ++k)
        largest = std::max(largest, std::abs(values[k]));
      return largest;
    }



    /// The power of two of which @p largest has 2^(digits - 1) to 2^digits.
    double
    unit_of(const double largest, const int digits)
    {
      int exponent;
      std::frexp(largest, &exponent);
      return std::max<double>(std::ldexp(1., exponent - digits),
                              std::numeric_limits<float>::min());
    }



    /// Rounds to multiples of @p unit. Numbers become short, and files half as
    /// long; sides of elements with continuous fields still agree.
    void
    round_to(const double unit, std::vector<float> &values, const Range &range)
    {
      // Of numbers near it, the spacing of doubles is the unit.
      const double shift = std::ldexp(1.5 * unit, 52);
      for (std::size_t k = range.first; k < range.second; ++k)
        values[k] = (values[k] + shift) - shift;
    }



    void
    round_vectors(std::vector<float> &values)
    {
      const Range all{0, values.size()};
      round_to(unit_of(largest_of(values, all), digits_of_file), values, all);
    }



    /// Of the @p n components from @p first on each for itself in each element,
    /// whose points end at @p ends, no finer than the largest asks for.
    void
    round_fields(std::vector<std::vector<float>> &fields,
                 const unsigned int               first,
                 const unsigned int               n,
                 const std::vector<std::int32_t> &ends)
    {
      double largest = 0.;
      for (unsigned int c = first; c < first + n; ++c)
        largest =
          std::max(largest, largest_of(fields[c], {0, fields[c].size()}));
      const double finest = unit_of(largest, digits_of_file);
      for (unsigned int c = first; c < first + n; ++c)
        {
          Range element{0, 0};
          for (const std::int32_t end : ends)
            {
              element = {element.second, end};
              const double unit =
                unit_of(largest_of(fields[c], element), digits_of_element);
              round_to(std::max(unit, finest), fields[c], element);
            }
        }
    }



    /// The output cells of all bodies, each with points of its own.
    class BodiesPicture
    {
    public:
      /// With reserve factors by @p strength, unless it is null.
      explicit BodiesPicture(const StrengthSweep *strength)
        : strength(strength)
        , fields(3 * 6 + (strength != nullptr ? 1 : 0))
      {}

      void
      add(const Body &body, const unsigned int number, const Vector &u)
      {
        // Cells of a degree that readers draw; expansions may be higher.
        GridIntervals n = body.cells().output_degrees;
        for (unsigned int &degree : n)
          degree = std::min(degree, 4u);
        const Lattice     lattice     = lattice_of(n);
        const std::size_t first_cell  = grid.types.size(),
                          size        = lattice.points.size();
        const std::size_t first_point = positions.size() / 3;
        body.for_each_output_cell(
          n, u, [&](const unsigned int k, const OutputCell &cell) {
            add_to_cells(first_cell + k, n, cell, number);
            add_to_points(first_point + k * size, lattice, cell, number);
          });
        // By their numbers elements that are neighbors in the section follow
        // each other, and what they share is near in the file.
        for (std::size_t k = 0; first_cell + k < plies.size(); ++k)
          {
            std::vector<std::int32_t> corners;
            for (const unsigned int p : lattice.vtk_order)
              corners.push_back(first_point + k * size + p);
            grid.add_cell(VtuGrid::lagrange_hexahedron, corners);
          }
      }

      /// What there is to be drawn; no more can be added.
      VtuGrid
      take()
      {
        round_vectors(positions);
        round_vectors(displacements);
        for (const unsigned int first : {0, 6, 12})
          round_fields(fields, first, 6, grid.offsets);
        grid.points.values = std::move(positions);
        grid.at_points.push_back({"displacement", 3, std::move(displacements)});
        // Displacements are first; the jump, not known here, is last.
        std::vector<std::string> names(field_names().begin() + 3,
                                       field_names().end() - 1);
        names.push_back("inverse_reserve_factor");
        for (unsigned int f = 0; f < fields.size(); ++f)
          grid.at_points.push_back({names[f], 1, std::move(fields[f])});
        grid.of_cells = {{"ply", 1, std::move(plies)},
                         {"body", 1, std::move(bodies)},
                         {"fiber", 3, std::move(fibers)},
                         {VtuGrid::degrees_name, 3, std::move(degrees)}};
        return std::move(grid);
      }

    private:
      /// The points of an element as the file has them, along the axis fastest:
      /// neighbors share the longest runs then. Their numbers in an
      /// OutputCell, and those of the file in the order of VTK.
      struct Lattice
      {
        std::vector<unsigned int> points, vtk_order;
      };

      static Lattice
      lattice_of(const GridIntervals &n)
      {
        Lattice lattice;
        lattice.vtk_order.resize((n[0] + 1) * (n[1] + 1) * (n[2] + 1));
        for (unsigned int k = 0; k <= n[2]; ++k)
          for (unsigned int i = 0; i <= n[0]; ++i)
            for (unsigned int j = 0; j <= n[1]; ++j)
              {
                lattice.vtk_order[vtk_hexahedron_point(n, i, j, k)] =
                  lattice.points.size();
                lattice.points.push_back((k * (n[1] + 1) + j) * (n[0] + 1) + i);
              }
        return lattice;
      }

      /// The @p count numbers of @p values from @p begin on, made if missing.
      template <typename Number>
      static Number *
      part_of(std::vector<Number> &values,
              const std::size_t    begin,
              const std::size_t    count)
      {
        if (values.size() < begin + count)
          values.resize(begin + count);
        return values.data() + begin;
      }

      void
      add_to_cells(const std::size_t    k,
                   const GridIntervals &n,
                   const OutputCell    &cell,
                   const unsigned int   body)
      {
        *part_of(plies, k, 1)  = cell.ply + 1;
        *part_of(bodies, k, 1) = body + 1;
        std::copy(n.begin(), n.end(), part_of(degrees, 3 * k, 3));
        float *const fiber = part_of(fibers, 3 * k, 3);
        for (unsigned int c = 0; c < 3; ++c)
          fiber[c] = cell.fiber[c];
      }

      void
      add_to_points(const std::size_t  begin,
                    const Lattice     &lattice,
                    const OutputCell  &cell,
                    const unsigned int body)
      {
        const unsigned int size = lattice.points.size();
        float             *x    = part_of(positions, 3 * begin, 3 * size),
              *u                = part_of(displacements, 3 * begin, 3 * size);
        for (const unsigned int p : lattice.points)
          for (unsigned int c = 0; c < 3; ++c)
            {
              *u++ = cell.samples[p].displacement[c];
              *x++ = cell.positions[p][c] + cell.samples[p].displacement[c];
            }
        add_tensor(0, &FieldSample::strain, begin, lattice, cell);
        add_tensor(6, &FieldSample::stress, begin, lattice, cell);
        add_tensor(12, &FieldSample::ply_stress, begin, lattice, cell);
        if (strength == nullptr)
          return;
        float *reserve = part_of(fields.back(), begin, size);
        for (const unsigned int p : lattice.points)
          *reserve++ = strength->inverse_reserve(body,
                                                 cell.ply,
                                                 cell.samples[p].ply_stress);
      }

      void
      add_tensor(const unsigned int first,
                 Voigt FieldSample::*part,
                 const std::size_t   begin,
                 const Lattice      &lattice,
                 const OutputCell   &cell)
      {
        for (unsigned int c = 0; c < 6; ++c)
          {
            float *value =
              part_of(fields[first + c], begin, lattice.points.size());
            for (const unsigned int p : lattice.points)
              *value++ = (cell.samples[p].*part)[c];
          }
      }

      const StrengthSweep            *strength;
      VtuGrid                         grid;
      std::vector<float>              positions, displacements, fibers;
      std::vector<std::vector<float>> fields;
      std::vector<std::int32_t>       plies, bodies;
      std::vector<std::uint8_t>       degrees;
    };



    /// The file that @p process writes of the picture @p name.
    std::string
    part_of_picture(const std::string &name, const unsigned int process)
    {
      return n_processes() == 1 ? name + ".vtu" :
                                  name + "." + std::to_string(process) + ".vtu";
    }
  } // namespace



  std::string
  write_vtu(const std::string   &directory,
            const std::string   &series,
            const unsigned int   step,
            const double         factor,
            const Structure     &structure,
            const BlockVector   &u,
            const StrengthSweep *strength)
  {
    BodiesPicture picture(strength);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      picture.add(*structure.bodies()[b], b, u.block(b));
    VtuGrid grid = picture.take();
    grid.time    = {factor, step};

    const std::string name  = series + "_" + Utilities::int_to_string(step, 4);
    const auto        write = [&directory](const std::string &file_name,
                                    const auto        &content) {
      OutputFile file(directory + "/" + file_name);
      content(file.stream());
      return file.commit();
    };
    bool written =
      write(part_of_picture(name, this_process()),
            [&grid](std::ostream &file) { write_vtu_file(file, grid); });
    if (n_processes() > 1 && is_root_process())
      {
        std::vector<std::string> parts;
        for (unsigned int p = 0; p < n_processes(); ++p)
          parts.push_back(part_of_picture(name, p));
        written = write(name + ".pvtu",
                        [&](std::ostream &file) {
                          write_pvtu_file(file, grid, parts);
                        }) &&
                  written;
      }
    if (!true_on_all_processes(written))
      throw_cannot_write(directory + "/" + name + ".vtu");
    return name + (n_processes() == 1 ? ".vtu" : ".pvtu");
  }


  void
  write_pvd(const std::string                                 &directory,
            const std::string                                 &name,
            const std::vector<std::pair<double, std::string>> &files)
  {
    if (files.empty())
      return;
    std::ostringstream text;
    DataOutBase::write_pvd_record(text, files);
    write_file(directory + "/" + name + ".pvd", text.str());
  }
} // namespace lamella
