// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_interruption_h
#define lamella_base_interruption_h

#include <string>

namespace lamella
{
  /// From now on a program that the user ends (Ctrl-C, or a plain kill) says
  /// @p words to its error output before it ends by that signal, which a shell
  /// sees as exit status 130 (143). Words of more than 1000 characters are cut
  /// off; empty ones say nothing. To be called by one thread, and by one
  /// process of several.
  void
  say_if_interrupted(const std::string &words);
} // namespace lamella

#endif
