// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_units_h
#define lamella_base_units_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /**
   * The units a scene is written in. They label results and convert the
   * built-in materials (kept in pascals); no other number is touched. All other
   * numbers of a scene have to be in one consistent system, which the two
   * labels name: `m, N` has stresses in Pa, `mm, N` in MPa = N/mm^2; `none`
   * prints no labels and converts nothing.
   */
  struct Units
  {
    /// Labels for tables and messages; empty in a scene without units.
    std::string length = "m";
    std::string force  = "N";
    std::string stress = "Pa";
    /// How many of the scene's units of stress one pascal is. 1e-6 for `mm, N`:
    /// a modulus of 9e9 Pa is 9e3 there.
    double pascal = 1.;

    /// Reads `m, N`, `mm, N` or `none`; throws InputError for anything else.
    /// Words are separated by a comma; blanks around it do not matter.
    static Units
    parse(const Entry &entry);
  };
} // namespace lamella

#endif
