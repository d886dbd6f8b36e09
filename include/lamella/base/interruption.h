// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_interruption_h
#define lamella_base_interruption_h

#include <string>

namespace lamella
{
  /// Installs a handler that prints @p words (at most 1000 characters) to the
  /// error output if the user ends the program (Ctrl-C, kill). The exit status
  /// is then 130 or 143. Must be called by one thread, and by one process of
  /// several.
  void
  set_interruption_message(const std::string &words);

  /// Delays such a signal during its lifetime, so that writing completes. A
  /// second signal of the same kind ends the program at once.
  class SignalBlock
  {
  public:
    SignalBlock();
    SignalBlock(const SignalBlock &) = delete;
    ~SignalBlock();
  };
} // namespace lamella

#endif
