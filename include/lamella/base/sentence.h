// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_sentence_h
#define lamella_base_sentence_h

#include <lamella/base/text.h>

#include <string>

namespace lamella
{
  /// @p message without white space and the full stop at its end, to be put
  /// into a sentence that has its own.
  inline std::string
  without_full_stop(const std::string &message)
  {
    std::string text = trimmed(message);
    while (!text.empty() && text.back() == '.')
      text.pop_back();
    return text;
  }
} // namespace lamella

#endif
