// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_strip_h
#define lamella_tests_unit_strip_h

#include "fixtures.h"

#include <map>

namespace lamella
{

  struct Strip
  {
    std::string name;
    Laminate    laminate;
    Materials   materials;

    std::shared_ptr<const Section>
    section(const std::string &theory) const
    {
      return make_section(make_section_mesh(laminate, materials),
                          Theory::parse({"Theory", theory}));
    }
  };
} // namespace lamella

#endif
