// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_units_h
#define lamella_base_units_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// The units of a scene. They label results and convert built-in materials.
  /// All other numbers must be in the consistent system of the labels: `m, N`
  /// has stresses in Pa, `mm, N` in MPa; `none` has no labels and converts no
  /// number.
  struct Units
  {
    /// Labels for tables and messages; empty in a scene without units.
    std::string length = "m";
    std::string force  = "N";
    std::string stress = "Pa";
    /// Value of one pascal in the scene's unit of stress: 1e-6 for `mm, N`.
    double pascal = 1.;

    /// Returns the units of `m, N`, `mm, N` or `none`. Throws InputError for
    /// anything else.
    static Units
    parse(const Entry &entry);
  };
} // namespace lamella

#endif
