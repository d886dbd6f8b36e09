// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_sentence_h
#define lamella_base_sentence_h

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>

#include <string>

namespace lamella
{
  /// Returns the text of @p message (Message) without white space and full
  /// stops at its end, for use within a sentence.
  inline std::string
  strip_period(const std::string &message)
  {
    std::string text = trimmed(Message(message).text);
    while (!text.empty() && text.back() == '.')
      text.pop_back();
    return text;
  }

  /// Returns the console's line of @p note, a text with its identifier and
  /// without a full stop: the text as a sentence, then the identifier.
  inline std::string
  note_line(const std::string &note)
  {
    Message message(note);
    message.text = "Note: " + message.text + ".";
    return message.shown();
  }
} // namespace lamella

#endif
