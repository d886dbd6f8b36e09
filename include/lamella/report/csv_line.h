// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_csv_line_h
#define lamella_report_csv_line_h

#include <lamella/report/tables.h>

#include <optional>
#include <string>
#include <type_traits>

namespace lamella
{
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
} // namespace lamella

#endif
