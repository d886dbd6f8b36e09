// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/version.h>

namespace lamella
{
  std::string
  version()
  {
    return LAMELLA_VERSION;
  }
} // namespace lamella
