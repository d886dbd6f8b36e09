// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_page_h
#define lamella_report_page_h

#include <string>

namespace lamella
{
  /// Implements `lamella report DIR`: writes the results in @p folder to the
  /// self-contained HTML file @p target. The current process is replaced by the
  /// script scripts/report.py (doc/guides/report.md). Throws InputError if the
  /// script, or python3 with Jinja2, is not found.
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
