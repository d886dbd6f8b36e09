// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_version_h
#define lamella_base_version_h

#include <string>

namespace lamella
{
  /// Returns the program version, `MAJOR.MINOR.PATCH`. A computation can only
  /// be resumed by the version that started it.
  std::string
  version();

  /// Returns the output of `lamella --version`: the versions of the program,
  /// its libraries and the compiler.
  std::string
  full_version();
} // namespace lamella

#endif
