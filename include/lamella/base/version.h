// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_version_h
#define lamella_base_version_h

#include <string>

namespace lamella
{
  /// Returns the program version, `MAJOR.MINOR.PATCH` . A resumed run must have
  /// the same.
  std::string
  version();

  /// Returns the output of --version: versions of program, libraries and
  /// compiler.
  std::string
  full_version();
} // namespace lamella

#endif
