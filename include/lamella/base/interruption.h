// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_interruption_h
#define lamella_base_interruption_h

#include <string>

namespace lamella
{
  /// Installs a signal handler that prints @p words (at most 1000 characters)
  /// to standard error if the user ends the program (Ctrl-C or kill). The exit
  /// status after such a signal is 130 or 143. Must be called by one thread, in
  /// a parallel run by one process only.
  void
  set_interruption_message(const std::string &words);

  /// Delays the signals of Ctrl-C and kill during its lifetime, so that files
  /// are written completely. A second equal signal ends the program at once.
  class SignalBlock
  {
  public:
    SignalBlock();
    SignalBlock(const SignalBlock &) = delete;
    ~SignalBlock();
  };
} // namespace lamella

#endif
