// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_sentence_h
#define lamella_base_sentence_h

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>

#include <string>

namespace lamella
{
  /// Returns the text of @p message without its identifier, and without white
  /// space and full stops at its end, to be inserted into a longer sentence.
  inline std::string
  strip_period(const std::string &message)
  {
    std::string text = trimmed(Message(message).text);
    while (!text.empty() && text.back() == '.')
      text.pop_back();
    return text;
  }

  /// Returns the console line `Note: TEXT. [ID]` for a @p note `ID: TEXT`.
  inline std::string
  note_line(const std::string &note)
  {
    Message message(note);
    message.text = "Note: " + message.text + ".";
    return message.shown();
  }
} // namespace lamella

#endif
