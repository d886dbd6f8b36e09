// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_page_h
#define lamella_report_page_h

#include <string>

namespace lamella
{
  /// Implements `lamella report DIR`: writes the results in @p folder to the
  /// self-contained HTML file @p target. This process is replaced by
  /// scripts/report.py (doc/guides/report.md), which receives the version and
  /// the data of the built-in materials. Throws InputError if the script, or
  /// python3 with Jinja2, is not found.
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
