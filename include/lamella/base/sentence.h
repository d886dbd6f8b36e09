// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_sentence_h
#define lamella_base_sentence_h

#include <lamella/base/text.h>

#include <string>

namespace lamella
{
  /// Returns @p message without white space and full stops at its end, for use
  /// within a sentence.
  inline std::string
  strip_period(const std::string &message)
  {
    std::string text = trimmed(message);
    while (!text.empty() && text.back() == '.')
      text.pop_back();
    return text;
  }
} // namespace lamella

#endif
