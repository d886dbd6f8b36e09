// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/material/material.h>

#include <regex>

namespace lamella
{
  namespace
  {
    /// The angles of one piece between slashes: one, two for `+-45`, or none.
    std::vector<double>
    parse_angle(const std::string &piece)
    {
      const auto is_number = [](const std::string &text) {
        return number_error(text).rule.empty();
      };
      static const std::regex pair(R"((\+-|-\+)\s*([0-9.]+))");
      std::smatch             match;
      if (std::regex_match(piece, match, pair) && is_number(match[2]))
        {
          const double angle = to_number(match[2]);
          return match[1] == "+-" ? std::vector<double>{angle, -angle} :
                                    std::vector<double>{-angle, angle};
        }
      if (is_number(piece))
        return {to_number(piece)};
      return {};
    }



    const std::string layup_rule =
      "material.invalid-layup: write the angles of the plies in degrees, from "
      "bottom to top, with slashes between, as in 0/90/0 or [0/+-45/90]2s";



    /// Of all @p pieces between slashes. Throws InputError of @p entry.
    std::vector<double>
    parse_angles(const std::string &pieces, const Entry &entry)
    {
      std::vector<double> angles;
      for (const std::string &piece : split(pieces, '/'))
        {
          const std::vector<double> some = parse_angle(piece);
          if (some.empty())
            entry.refuse(layup_rule + "; '" + piece + "' is not an angle");
          angles.insert(angles.end(), some.begin(), some.end());
        }
      if (angles.empty())
        entry.refuse(layup_rule + "; there is no ply");
      return angles;
    }
  } // namespace



  std::vector<double>
  parse_layup(const Entry &entry)
  {
    const std::string &code = entry.text();
    if (code.size() > 1000)
      entry.refuse("material.layup-too-long: the layup exceeds 1000 characters",
                   "Use brackets and repetitions, as in [0/90]50s.");
    // A bracket, what it holds, and what follows it; or no bracket at all.
    static const std::regex form(
      R"(\s*(\[?)([^\[\]]*)(\]?)\s*([0-9]*)(s?)\s*)");
    std::smatch match;
    const bool  fits      = std::regex_match(code, match, form);
    const bool  bracketed = fits && match[1].length() == 1;
    if (!fits || bracketed != (match[3].length() == 1))
      entry.refuse(layup_rule + "; brackets must pair and enclose all plies");

    // Without brackets the greedy second group takes everything.
    std::vector<double> angles = parse_angles(match[2], entry);

    constexpr double most = 1000.;
    const double     repetitions =
      match[4].length() > 0 ? to_number(match[4].str()) : 1.;
    if (!(repetitions >= 1. && repetitions <= most))
      entry.refuse(layup_rule + "; the repetition must be from 1 to 1000");
    const std::vector<double> once = angles;
    for (int i = 1; i < repetitions; ++i)
      angles.insert(angles.end(), once.begin(), once.end());
    if (match[5].length() == 1)
      {
        const std::vector<double> half = angles;
        angles.insert(angles.end(), half.rbegin(), half.rend());
      }
    return angles;
  }
} // namespace lamella
