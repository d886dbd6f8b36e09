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

  /// As long as one lives, such a signal waits: what is being written is
  /// written to its end, and the words of it are said. A second one of the same
  /// kind ends the program at once. Before say_if_interrupted() it does
  /// nothing.
  class Uninterrupted
  {
  public:
    Uninterrupted();
    Uninterrupted(const Uninterrupted &) = delete;
    ~Uninterrupted();
  };
} // namespace lamella

#endif
