// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/material/layup.h>

#include <regex>

namespace lamella
{
  namespace
  {
    /// The angles of one piece between slashes: one, or a pair for `+-45`.
    std::vector<double>
    parse_angle(const std::string &piece, const std::string &what)
    {
      static const std::regex pair(R"((\+-|-\+)\s*([0-9.]+))");
      std::smatch             match;
      if (std::regex_match(piece, match, pair))
        {
          const double angle = to_number(match[2], what);
          return match[1] == "+-" ? std::vector<double>{angle, -angle} :
                                    std::vector<double>{-angle, angle};
        }
      return {to_number(piece, what)};
    }
  } // namespace



  std::vector<double>
  parse_layup(const std::string &code, const std::string &what)
  {
    if (code.size() > 1000)
      throw InputError(what + " is longer than 1000 characters. Use brackets "
                              "and a repetition, as in [0/90]50s.");
    // A bracket, what it holds, and what follows it; or no bracket at all.
    static const std::regex form(
      R"(\s*(\[?)([^\[\]]*)(\]?)\s*([0-9]*)(s?)\s*)");
    std::smatch       match;
    const bool        fits      = std::regex_match(code, match, form);
    const bool        bracketed = fits && match[1].length() == 1;
    const std::string rule =
      what + " = " + code +
      ": must be ply angles in degrees between slashes, bottom to top, as in "
      "0/90/0 or [0/+-45/90]2s";
    if (!fits || bracketed != (match[3].length() == 1))
      throw InputError(rule + "; brackets must pair and enclose all plies.");

    // Without brackets the greedy second group takes everything.
    std::vector<double> angles;
    for (const std::string &piece : split(match[2], '/'))
      try
        {
          const std::vector<double> some = parse_angle(piece, what);
          angles.insert(angles.end(), some.begin(), some.end());
        }
      catch (const InputError &)
        {
          throw InputError(rule + "; '" + piece + "' is not an angle.");
        }
    if (angles.empty())
      throw InputError(rule + "; there is no ply.");

    const int repetitions =
      match[4].length() > 0 ? std::stoi(match[4].str().substr(0, 4)) : 1;
    if (repetitions < 1 || repetitions > 1000)
      throw InputError(rule + "; the repetition must be from 1 to 1000.");
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
