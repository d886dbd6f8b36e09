// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_new_scene_h
#define lamella_run_new_scene_h

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// The kinds of scenes that there are templates of, the default first.
  std::vector<std::string>
  kinds_of_new_scenes();

  /// Writes the template @p kind as the scene NAME.prm, @p name with or without
  /// that ending and with its folder, and tells @p out what to do with it.
  /// Throws InputError for a kind that there is none of, and for a file that is
  /// there already or cannot be written.
  void
  write_new_scene(const std::string &name,
                  const std::string &kind,
                  std::ostream      &out);
} // namespace lamella

#endif
