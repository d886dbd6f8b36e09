// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_lines_h
#define lamella_scene_scene_lines_h

#include <lamella/scene/scene_text.h>

#include <string>

namespace lamella
{
  /// Returns @p text with each run of white space replaced by a space.
  std::string
  collapsed(const std::string &text);

  /// Returns the beginning of messages about line @p line of @p file.
  std::string
  line_prefix(const std::string &file, const unsigned int line);

  /// Returns @p text without a UTF-8 byte order mark. Throws InputError, with
  /// @p file, for invalid bytes.
  std::string
  checked_bytes(const std::string &text, const std::string &file);

  /// Returns the name of the entry @p path of version 0.2.0 since it was
  /// renamed; empty for any other.
  std::string
  new_name(const std::string &path);
} // namespace lamella

#endif
