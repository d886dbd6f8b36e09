// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/phase.h>

namespace lamella
{
  const std::vector<std::string> &
  phase_names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> all;
      for (const NameOf<Phase> &phase : Names<Phase>::all)
        all.push_back(phase.name);
      return all;
    }();
    return names;
  }
} // namespace lamella
