// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_library_h
#define lamella_material_library_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns the names of the built-in materials in the order of the library.
  std::vector<std::string>
  library_materials();

  /// Returns the built-in material @p name, converted to the stress unit of @p
  /// units. Data that its source (doc/reference/materials.md) lacks are empty.
  /// hertz-200, whose modulus has no unit, is not converted. Throws InputError,
  /// which suggests the most similar name, if there is no such material.
  Material
  library_material(const std::string &name, const Units &units);
  /// Returns the built-in material whose name is the text of @p entry, in the
  /// stress unit of @p units. Throws InputError if there is none.
  Material
  library_material(const Entry &entry, const Units &units);
} // namespace lamella

#endif
