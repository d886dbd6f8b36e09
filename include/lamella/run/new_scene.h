// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_new_scene_h
#define lamella_run_new_scene_h

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Returns the names of the templates for new scenes, the default first.
  std::vector<std::string>
  kinds_of_new_scenes();

  /// Writes the template @p kind to the scene file NAME.prm, where @p name is
  /// NAME or FOLDER/NAME. Prints how to run it to @p out. Throws InputError for
  /// an unknown template, and if the file exists or cannot be written.
  void
  write_new_scene(const std::string &name,
                  const std::string &kind,
                  std::ostream      &out);
} // namespace lamella

#endif
