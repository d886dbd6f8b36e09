// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/base/units.h>

namespace lamella
{
  Units
  Units::parse(const Entry &entry)
  {
    const std::string words = joined(entry.items());
    if (words == "m, N")
      return {"m", "N", "Pa", 1.};
    if (words == "mm, N")
      return {"mm", "N", "MPa", 1e-6};
    if (words == "none")
      return {"", "", "", 1.};
    entry.refuse(
      "base.unknown-units: write 'm, N' (stresses in Pa), 'mm, N' (stresses in "
      "MPa) or 'none' (results without units, built-in materials in Pa)");
  }
} // namespace lamella
