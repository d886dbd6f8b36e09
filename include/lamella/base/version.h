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

  /// What --version prints: the version with the commit that was built, then
  /// the libraries and the compiler that it was built with, a line each; of the
  /// BLAS what is loaded.
  std::string
  version_in_full();
} // namespace lamella

#endif
