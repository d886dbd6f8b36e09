// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_page_h
#define lamella_report_page_h

#include <string>

namespace lamella
{
  /**
   * Implements `lamella report DIR`: makes one self-contained HTML file
   * @p target of the results in @p folder. It replaces this process by
   * scripts/report.py (doc/guides/report.md), which then determines messages
   * and exit status.
   *
   * The script is searched for in `../share/lamella/scripts` beside this
   * program, then in its source tree. It reads the files of the folder, and is
   * passed the version and the constants of the built-in materials
   * (library_material()) in Pa and in MPa.
   *
   * Throws InputError if the script, or python3 with Jinja2, is not found.
   */
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
