// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_units_h
#define lamella_base_units_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// The unit labels of a scene and the conversion factor of built-in
  /// materials. All numbers of the input must be consistent with the labels:
  /// `m, N` implies stresses in Pa, `mm, N` in MPa; with `none`, there are no
  /// labels and conversions.
  struct Units
  {
    /// Labels for tables and messages; empty in a scene without units.
    std::string length = "m";
    std::string force  = "N";
    std::string stress = "Pa";
    /// Value of 1 Pa in the scene's unit of stress, e.g. 1e-6 for `mm, N`.
    double pascal = 1.;

    /// Returns the units of @p entry, which must be `m, N`, `mm, N` or `none`.
    /// Throws InputError for any other text.
    static Units
    parse(const Entry &entry);
  };
} // namespace lamella

#endif
