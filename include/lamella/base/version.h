// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_version_h
#define lamella_base_version_h

#include <string>

namespace lamella
{
  /// The version of this program, `MAJOR.MINOR.PATCH` of CMakeLists.txt: what
  /// results say, and what a run that is resumed must agree with.
  std::string
  version();
} // namespace lamella

#endif
