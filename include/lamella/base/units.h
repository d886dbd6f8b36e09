// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_units_h
#define lamella_base_units_h

#include <string>

namespace lamella
{
  /**
   * The units a scene is written in. They label results and convert the
   * built-in materials (kept in pascals); no other number is touched.
   */
  struct Units
  {
    std::string length = "m";
    std::string force  = "N";
    std::string stress = "Pa";
    /// How many of the scene's units of stress one pascal is.
    double pascal = 1.;

    /// Reads `m, N`, `mm, N` or `none`; throws InputError for anything else.
    static Units
    parse(const std::string &text);
  };
} // namespace lamella

#endif
