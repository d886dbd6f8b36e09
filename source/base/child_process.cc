// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/process.hpp>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>

namespace lamella
{
  void
  exec_program(const std::string              &program,
               const std::vector<std::string> &words)
  {
    std::vector<std::string> all{program};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char *> pointers;
    for (std::string &word : all)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::cout.flush();
    execv(program.c_str(), pointers.data());
    throw InputError(
      "base.program-not-run: the operating system could not run " + program +
      " (" + std::strerror(errno) + ").");
  }



  std::string
  python_with(const std::string &module)
  {
    namespace bp = boost::process;
    // If SIGCHLD is ignored (inherited), the status of a child is lost.
    std::signal(SIGCHLD, SIG_DFL);
    for (const std::string &python :
         {std::string("/usr/bin/python3"), bp::search_path("python3").string()})
      if (std::filesystem::exists(python) &&
          bp::system(python,
                     "-c",
                     "import " + module,
                     bp::std_in<bp::null, bp::std_out> bp::null,
                     bp::std_err > bp::null) == 0)
        return python;
    return "";
  }



  std::string
  executable_path()
  {
    return boost::dll::program_location().string();
  }



  std::string
  path_of_script(const std::string &name)
  {
    namespace fs = std::filesystem;
    const fs::path installed =
      fs::path(executable_path()).parent_path().parent_path() /
      "share/lamella/scripts";
    std::error_code error;
    for (const fs::path &folder : {installed, fs::path(LAMELLA_SCRIPTS)})
      if (fs::is_regular_file(folder / name, error))
        return (folder / name).string();
    throw InputError("base.program-missing: the file " + name +
                     " of Lamella is neither in " + installed.string() +
                     " nor in " LAMELLA_SCRIPTS ". Install Lamella again.");
  }
} // namespace lamella
