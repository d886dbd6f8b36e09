// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_lines_h
#define lamella_scene_scene_lines_h

#include <lamella/scene/scene_text.h>

#include <string>

namespace lamella
{
  /// Returns @p text with each sequence of white space replaced by one blank.
  std::string
  collapsed(const std::string &text);

  /// Returns `FILE:LINE: `, the prefix of messages on line @p line of @p file.
  std::string
  line_prefix(const std::string &file, const unsigned int line);

  /// Returns @p text without a UTF-8 byte order mark. Throws InputError, with
  /// the name @p file, if the text is not valid UTF-8.
  std::string
  checked_bytes(const std::string &text, const std::string &file);

  /// Returns the name of the entry for which @p path has a former name (`Points
  /// on`) or the name in other programs (`Torque`); empty otherwise.
  std::string
  new_name(const std::string &path);
} // namespace lamella

#endif
