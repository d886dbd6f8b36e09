// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_page_h
#define lamella_report_page_h

#include <string>

namespace lamella
{
  /// Implements `lamella report DIR`: makes one self-contained HTML file
  /// @p target of the results in @p folder. It replaces this process by
  /// scripts/report.py (doc/guides/report.md), installed or in the source tree.
  /// The script reads the files of the folder, and receives the version and the
  /// constants of the built-in materials in Pa and in MPa. Throws InputError if
  /// the script, or python3 with Jinja2, is not found.
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
