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
  /// The names of the built-in materials. In the order of the library, for
  /// messages and the documentation.
  std::vector<std::string>
  library_materials();

  /**
   * The built-in material @p name in the stresses of @p units: the four of the
   * paper (hertz-200, whose modulus has no unit, is not converted), plies, a
   * fabric, metals and cores whose sources stand in doc/materials.md. Throws
   * InputError with the nearest name if there is none; the second form takes
   * the name from an entry and says which one it is. Moduli and strengths are
   * multiplied with Units::pascal, densities with its square, ratios stay. What
   * a source does not have the material does not have.
   */
  Material
  library_material(const std::string &name, const Units &units);
  Material
  library_material(const Entry &entry, const Units &units);
} // namespace lamella

#endif
