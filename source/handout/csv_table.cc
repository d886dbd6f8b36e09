// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/handout/csv_table.h>

#include <boost/tokenizer.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

namespace lamella
{
  CsvTable
  CsvTable::read(const std::string &path)
  {
    // A quote within a cell is no part of any; nothing escapes it.
    const boost::escaped_list_separator<char> form("", ",", "\"");
    CsvTable                                  table;
    std::ifstream                             file(path);
    std::string                               line;
    for (unsigned int number = 1; std::getline(file, line); ++number)
      {
        const boost::tokenizer<boost::escaped_list_separator<char>> cells(line,
                                                                          form);
        std::vector<std::string> row(cells.begin(), cells.end());
        if (number == 1)
          table.names = std::move(row);
        else if (row.size() == table.names.size())
          table.rows.push_back(std::move(row));
        else
          throw InputError("line " + std::to_string(number) + " has " +
                           std::to_string(row.size()) +
                           " cells where the first line has " +
                           std::to_string(table.names.size()) +
                           ". The file was cut off or changed; run the scene "
                           "again.")
            .at(path + ": ");
      }
    return table;
  }



  const std::string &
  CsvTable::cell(const unsigned int row, const std::string &name) const
  {
    static const std::string nothing;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? nothing : rows[row][found - names.begin()];
  }



  double
  CsvTable::value(const unsigned int row, const std::string &name) const
  {
    const std::string &text  = cell(row, name);
    const char        *end   = text.data() + text.size();
    double             value = 0.;
    const auto         read  = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end && !text.empty() ?
             value :
             std::numeric_limits<double>::quiet_NaN();
  }



  CsvTable
  CsvTable::last_step() const
  {
    double last = -std::numeric_limits<double>::infinity();
    for (unsigned int k = 0; k < rows.size(); ++k)
      last = std::max(last, value(k, "step"));
    CsvTable part;
    part.names = names;
    for (unsigned int k = 0; k < rows.size(); ++k)
      if (!(value(k, "step") < last))
        part.rows.push_back(rows[k]);
    return part;
  }
} // namespace lamella
