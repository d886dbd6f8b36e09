// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_units_h
#define lamella_base_units_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// Names of the units of a scene, and the conversion factor for built-in
  /// materials. All numbers of the input must be in consistent units: `m, N`
  /// implies stresses in Pa, `mm, N` in MPa. With `none`, names are empty and
  /// nothing is converted.
  struct Units
  {
    std::string length = "m";  ///< Name of the unit of length; may be empty.
    std::string force  = "N";  ///< Name of the unit of force; may be empty.
    std::string stress = "Pa"; ///< Name of the unit of stress; may be empty.
    /// Value of 1 Pa in the scene's unit of stress, e.g. 1e-6 for `mm, N`.
    double pascal = 1.;

    /// Returns the units for the text of @p entry, which is `m, N`, `mm, N` or
    /// `none`. Throws InputError for any other text.
    static Units
    parse(const Entry &entry);
  };
} // namespace lamella

#endif
