// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_plausibility_h
#define lamella_material_plausibility_h

#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <string>

namespace lamella
{
  /// What is odd about the moduli of @p material, which the scene calls
  /// @p name: those outside of 1 MPa to 2 TPa, between which nearly all solids
  /// are, are typed in other units than @p units as a rule. A sentence without
  /// a full stop; empty if there is nothing to say, or without units.
  std::string
  doubt_of_moduli(const std::string &name,
                  const Material    &material,
                  const Units       &units);
} // namespace lamella

#endif
