// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/process/search_path.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#ifdef __linux__
#  include <sys/prctl.h>
#endif

namespace lamella
{
  namespace
  {
    /// Environment without MPI's variables: the child must not join it.
    std::vector<std::string>
    environment_without_mpi()
    {
      const auto begins = [](const std::string &text, const char *prefix) {
        return text.rfind(prefix, 0) == 0;
      };
      std::vector<std::string> kept;
      for (char **variable = environ; *variable != nullptr; ++variable)
        if (begins(*variable, "OMPI_ALLOW") ||
            !(begins(*variable, "PMIX_") || begins(*variable, "ORTE_") ||
              begins(*variable, "OMPI_")))
          kept.emplace_back(*variable);
      return kept;
    }



    /// Settings of the child before its work.
    void
    limit_child(const double processor_seconds)
    {
#ifdef __linux__
      prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
      if (processor_seconds > 0.)
        {
          const auto seconds =
            static_cast<rlim_t>(std::ceil(processor_seconds));
          const rlimit limit{seconds, seconds + 1};
          setrlimit(RLIMIT_CPU, &limit);
        }
    }



    /// What the system says of a child that has ended.
    void
    set_end(const int status, ProcessEnd &end)
    {
      if (WIFSIGNALED(status))
        {
          end.status             = -1;
          end.signal             = WTERMSIG(status);
          end.time_limit_reached = end.signal == SIGXCPU;
        }
      else
        end.status = WEXITSTATUS(status);
    }
  } // namespace



  namespace
  {
    /// Opens @p path, if not empty, as file descriptor @p descriptor.
    void
    redirect(const int descriptor, const std::string &path, const int flags)
    {
      if (path.empty())
        return;
      const int file = open(path.c_str(), flags, 0666);
      if (file >= 0)
        dup2(file, descriptor);
    }



    /// Whether that went well.
    bool
    write_all(const int descriptor, const std::string &text)
    {
      for (std::size_t done = 0; done < text.size();)
        {
          const ssize_t n =
            write(descriptor, text.data() + done, text.size() - done);
          if (n < 0 && errno == EINTR)
            continue;
          if (n <= 0)
            return false;
          done += n;
        }
      return true;
    }



    std::string
    read_all(const int descriptor)
    {
      std::string            text;
      std::array<char, 4096> piece;
      for (;;)
        {
          const ssize_t n = read(descriptor, piece.data(), piece.size());
          if (n == 0 || (n < 0 && errno != EINTR))
            return text;
          if (n > 0)
            text.append(piece.data(), n);
        }
    }



    /// What the copy of this process does, to its end.
    [[noreturn]] void
    run_child(const std::function<std::string()> &work,
              const std::string                  &output,
              const std::string                  &errors,
              const double                        processor_seconds,
              const int                           forces_of_part)
    {
      limit_child(processor_seconds);
      // A program that replaces this process sends no answer.
      fcntl(forces_of_part, F_SETFD, FD_CLOEXEC);
      redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
      constexpr int anew = O_WRONLY | O_CREAT | O_TRUNC;
      redirect(STDOUT_FILENO, output, anew);
      redirect(STDERR_FILENO, errors, anew);
      static std::vector<std::string> variables = environment_without_mpi();
      clearenv();
      for (std::string &variable : variables)
        putenv(variable.data());
      std::string   result;
      const Outcome outcome = outcome_of([&] { result = work(); });
      if (outcome.status != 0)
        std::cerr << outcome.message << std::endl;
      std::cout.flush();
      const bool told = write_all(forces_of_part, result);
      // What this process would do at its end (files, MPI) is its parent's.
      _exit(told ? outcome.status : 2);
    }
  } // namespace



  ProcessEnd
  run_forked(const std::function<std::string()> &work,
             const std::string                  &output,
             const std::string                  &errors,
             const double                        processor_seconds)
  {
    using Clock              = std::chrono::steady_clock;
    const auto         begin = Clock::now();
    std::array<int, 2> ends;
    std::cout.flush();
    // If SIGCHLD is ignored (inherited), the status of a child is lost.
    std::signal(SIGCHLD, SIG_DFL);
    if (pipe(ends.data()) != 0)
      throw InputError("base.too-many-files: cannot start a process: too many "
                       "files are open. Close programs, or raise ulimit -n.");
    const pid_t child = fork();
    if (child < 0)
      throw InputError("base.no-process: cannot start another process: the "
                       "limit of the operating system is reached. Close other "
                       "programs, or raise the limit (ulimit -u).");
    if (child == 0)
      {
        close(ends[0]);
        run_child(work, output, errors, processor_seconds, ends[1]);
      }
    close(ends[1]);
    ProcessEnd end;
    end.result = read_all(ends[0]);
    close(ends[0]);
    int   status = 0;
    pid_t ended;
    do
      ended = waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
    if (ended == child)
      set_end(status, end);
    else
      end.status = -1;
    end.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return end;
  }



  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds)
  {
    const auto work = [&]() -> std::string {
      try
        {
          exec_program(program, words);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
    };
    const ProcessEnd end = run_forked(work, output, errors, processor_seconds);
    if (!end.result.empty())
      throw InputError(end.result);
    return end;
  }



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
    for (const std::string &python :
         {std::string("/usr/bin/python3"),
          boost::process::search_path("python3").string()})
      if (std::filesystem::exists(python) &&
          run_process(
            python, {"-c", "import " + module}, "/dev/null", "/dev/null")
              .status == 0)
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
