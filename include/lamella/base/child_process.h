// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_child_process_h
#define lamella_base_child_process_h

#include <string>
#include <vector>

namespace lamella
{
  /// Replaces this process by the executable at the path @p program, without a
  /// shell, with the arguments @p words. MPI must not have been started before.
  /// Throws InputError if the program cannot be started.
  [[noreturn]] void
  exec_program(const std::string              &program,
               const std::vector<std::string> &words);

  /// Returns the path of a python3 that can import @p module: /usr/bin/python3
  /// or the first python3 in PATH. Returns an empty path if there is none.
  std::string
  python_with(const std::string &module);

  /// Returns the path of Lamella's script @p name in the installation or the
  /// source tree. Throws InputError if it is in neither.
  std::string
  path_of_script(const std::string &name);

  /// Returns the absolute path of the program that this process runs.
  std::string
  executable_path();
} // namespace lamella

#endif
