// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_interruption_h
#define lamella_base_interruption_h

#include <string>

namespace lamella
{
  /// Installs a signal handler that prints @p words (at most 1000 characters)
  /// to standard error if the user ends the program by Ctrl-C or kill. The exit
  /// status is then 130 or 143. Must be called by one thread of one process.
  void
  set_interruption_message(const std::string &words);

  /// Delays the signals of Ctrl-C and kill during the lifetime of the object,
  /// so that files are complete. A second equal signal ends the program.
  class SignalBlock
  {
  public:
    SignalBlock();
    SignalBlock(const SignalBlock &) = delete;
    ~SignalBlock();
  };
} // namespace lamella

#endif
