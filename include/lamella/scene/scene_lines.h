// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_lines_h
#define lamella_scene_scene_lines_h

#include <lamella/scene/scene_text.h>

#include <string>

namespace lamella
{
  /// @p text with runs of white space as single spaces.
  std::string
  collapsed(const std::string &text);

  /// How messages begin that are about the line @p line of @p file.
  std::string
  place_in(const std::string &file, const unsigned int line);

  /// Throws InputError, beginning with @p file, for bytes that no text of a
  /// scene has; returns it without the mark that some editors put before
  /// UTF-8.
  std::string
  checked_bytes(const std::string &text, const std::string &file);
} // namespace lamella

#endif
