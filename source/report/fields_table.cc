// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/report/fields_table.h>

#include <array>
#include <charconv>

namespace lamella
{
  std::string
  csv(const double value)
  {
    // As a stream would write it, in a fifth of the time: files of cuts hold
    // hundreds of thousands of numbers.
    std::array<char, 32> text;
    const auto           end = std::to_chars(text.data(),
                                   text.data() + text.size(),
                                   value,
                                   std::chars_format::general,
                                   15);
    return {text.data(), end.ptr};
  }



  std::string
  fields_header()
  {
    return "body,ply,x,y,z," + joined(field_names(), ",");
  }



  std::string
  fields_line(const FieldRow &row)
  {
    std::string line = row.body + "," + std::to_string(row.ply + 1);
    for (unsigned int c = 0; c < 3; ++c)
      line.append(",").append(csv(row.position[c]));
    for (const double value : field_values(row.sample))
      line.append(",").append(csv(value));
    return line;
  }
} // namespace lamella
