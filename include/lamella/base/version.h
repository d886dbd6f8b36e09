// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_version_h
#define lamella_base_version_h

#include <string>

namespace lamella
{
  /// Returns the program version, `MAJOR.MINOR.PATCH` of CMakeLists.txt,
  /// printed in results. A resumed run must have the same.
  std::string
  version();

  /// Returns the output of --version: version and commit, then libraries (the
  /// BLAS as loaded) and compiler, a line each.
  std::string
  full_version();
} // namespace lamella

#endif
