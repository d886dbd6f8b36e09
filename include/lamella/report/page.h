// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_page_h
#define lamella_report_page_h

#include <string>

namespace lamella
{
  /**
   * `lamella report DIR`: what the run in @p folder left behind as one
   * self-contained HTML file @p target. The page is the work of a Python
   * program, scripts/report.py with its templates (doc/report.md), which this
   * process becomes: the message and the exit status are its own.
   *
   * The program is sought beside this one as it is installed
   * (`../share/lamella/scripts`), then in the tree that this one was built
   * from. It reads the folder's files; what only this program knows it is told:
   * the version, and the constants of the built-in materials
   * (library_material()) in Pa and in MPa.
   *
   * Throws InputError if it is in neither place, or if there is no python3 with
   * Jinja2.
   */
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
