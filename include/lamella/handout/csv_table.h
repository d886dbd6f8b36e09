// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_handout_csv_table_h
#define lamella_handout_csv_table_h

#include <string>
#include <vector>

namespace lamella
{
  /**
   * A table that a run has left, cells as text: numbers keep the digits that
   * they were written with. The first line of the file has the names of the
   * columns.
   */
  struct CsvTable
  {
    std::vector<std::string> names;
    /// As many cells each as there are names.
    std::vector<std::vector<std::string>> rows;

    /// Reads the file @p path: cells between commas, those with commas between
    /// double quotes. Without columns and rows if there is no such file. Throws
    /// InputError for a row that is shorter or longer than the first line.
    static CsvTable
    read(const std::string &path);

    /// Whether there is nothing to show.
    bool
    empty() const
    {
      return rows.empty();
    }

    /// The cell of column @p name in row @p row; empty if there is no such
    /// column, as in the table of another version.
    const std::string &
    cell(const unsigned int row, const std::string &name) const;

    /// The number in that cell; a quiet NaN where there is none.
    double
    value(const unsigned int row, const std::string &name) const;

    /// Its rows of the largest `step`; all of them if there is no such column.
    CsvTable
    last_step() const;
  };
} // namespace lamella

#endif
