// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/report/fields_table.h>

#include <array>
#include <charconv>

namespace lamella
{
  const std::vector<std::string> &
  field_names()
  {
    static const std::vector<std::string> names{"ux",  "uy",  "uz",  "exx",
                                                "eyy", "ezz", "gxy", "gxz",
                                                "gyz", "sxx", "syy", "szz",
                                                "sxy", "sxz", "syz", "s11",
                                                "s22", "s33", "s12", "s13",
                                                "s23", "jump"};
    return names;
  }



  std::vector<double>
  field_values(const FieldSample &sample)
  {
    std::vector<double> values;
    for (unsigned int c = 0; c < 3; ++c)
      values.push_back(sample.displacement[c]);
    for (const Voigt *part :
         {&sample.strain, &sample.stress, &sample.ply_stress})
      for (unsigned int c = 0; c < 6; ++c)
        values.push_back((*part)[c]);
    values.push_back(sample.jump);
    return values;
  }



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
  fields_line(const std::string      &body,
              const unsigned int      ply,
              const dealii::Point<3> &position,
              const FieldSample      &sample)
  {
    std::string line = body + "," + std::to_string(ply + 1);
    for (unsigned int c = 0; c < 3; ++c)
      line.append(",").append(csv(position[c]));
    for (const double value : field_values(sample))
      line.append(",").append(csv(value));
    return line;
  }
} // namespace lamella
