// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_quantities_h
#define lamella_tests_unit_quantities_h

#include <lamella/recover/named_quantity.h>

#include <string>

namespace lamella
{
  inline NamedQuantity
  quantity_of(const NamedQuantity::ObjectKind of,
              const std::string              &name,
              const std::string              &column)
  {
    NamedQuantity quantity;
    quantity.of     = of;
    quantity.name   = name;
    quantity.column = column;
    return quantity;
  }
} // namespace lamella

#endif
