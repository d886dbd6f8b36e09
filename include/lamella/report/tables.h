// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_tables_h
#define lamella_report_tables_h

#include <lamella/body/body.h>
#include <lamella/recover/results.h>
#include <lamella/shape/section_mesh.h>

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <type_traits>

namespace lamella
{
  /// Returns @p value with at most 15 significant digits, in any locale.
  std::string
  csv(const double value);

  /// A line of a CSV file.
  class CsvLine
  {
  public:
    /// Appends @p cell: a text (not quoted), a number (csv()), 1 or 0 for true
    /// and false, a value that may be absent (an empty cell), or the components
    /// of a tensor.
    template <typename Cell>
    CsvLine &
    operator<<(const Cell &cell)
    {
      if constexpr (std::is_same_v<Cell, bool>)
        return append(cell ? "1" : "0");
      else if constexpr (std::is_integral_v<Cell>)
        return append(std::to_string(cell));
      else if constexpr (std::is_floating_point_v<Cell>)
        return append(csv(cell));
      else if constexpr (std::is_same_v<Cell, std::optional<double>>)
        return append(cell ? csv(*cell) : "");
      else if constexpr (std::is_convertible_v<Cell, std::string>)
        return append(cell);
      else
        for (unsigned int c = 0; c < Cell::dimension; ++c)
          *this << double(cell[c]);
      return *this;
    }

    /// Returns the line with a newline.
    std::string
    text() const
    {
      return content + "\n";
    }

  private:
    CsvLine &
    append(const std::string &cell)
    {
      content += separator + cell;
      separator = ",";
      return *this;
    }

    std::string content, separator;
  };

  /// Contents of result files by file name, such as `lines/NAME.csv`.
  using FileTexts = std::map<std::string, std::string>;

  /// Returns the header lines of all tables (doc/reference/output.md) for the
  /// probes, lines, cuts, contacts and supports named in @p results. Columns:
  ///   probes   step, probe, fields
  ///   lines    s (arc length), step, line, fields
  ///   cuts     step, cut, cell, i, j, fields
  ///   contacts step, both points, normal, area, initial_gap, gap, force,
  ///            pressure (force over area), active (1 if in contact)
  ///   history  step, load_factor, then three components of the force of each
  ///            support and contact and of the displacement of each probe
  FileTexts
  table_headers(const Results &results);

  /// Returns the lines of all tables for the load step @p step of @p results,
  /// without headers. A probe on a ply interface has one line per ply.
  FileTexts
  table_rows(const Results &results, const StepResults &step);

  /// Returns the content of failure.csv, a line for each load factor at which
  /// the search for first ply failure solved the scene: smallest reserve
  /// factor, forces and displacements as in history.csv.
  std::string
  failure_table(const Results &results);

  /// Returns the content of fields.csv: the number of section functions (terms
  /// of the expansion over the cross-section) at each axis node of each beam. A
  /// line per node has the columns
  ///   body, node (from 1), s (distance from the first node), x, y, z
  ///   (undeformed position), fields (number of section functions).
  std::string
  fields_of_nodes(const Bodies &bodies);

  /// Returns the mesh of a section as CSV for plots. Each cell has a line with
  /// number, ply (from 1), material and fiber angle [degrees], and a line for
  /// each of its four sides, counter-clockwise. The line of a side has the name
  /// of the boundary (empty inside) and points `x z;x z;...` in section axes:
  /// two ends, and seven points between them if the side is curved.
  std::string
  section_table(const SectionMesh &section);

  /// Prints the critical ply, criterion and failure mode of each load step, the
  /// five smallest reserve factors of the last step, and the load at first
  /// failure. No output if the scene has no strength analysis.
  void
  print_reserves(std::ostream &out, const Results &results);
} // namespace lamella

#endif
