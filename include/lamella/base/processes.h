// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_processes_h
#define lamella_base_processes_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace lamella
{
  // The MPI processes of a run. Each process stores the whole scene and whole
  // vectors. Matrices, their solution and loops over elements are distributed:
  // each process owns a contiguous range of the DoFs and elements of a body.

  /// Returns the MPI communicator of the run.
  inline MPI_Comm
  communicator()
  {
    return MPI_COMM_WORLD;
  }

  /// Returns the number of processes of the run; 1 before MPI is started.
  inline unsigned int
  n_processes()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::n_mpi_processes(communicator()) :
             1;
  }

  /// Returns the index of this process, from 0; 0 before MPI is started.
  inline unsigned int
  this_process()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::this_mpi_process(communicator()) :
             0;
  }

  /// Returns true if this is process 0, which alone prints and writes files.
  inline bool
  is_root_process()
  {
    return this_process() == 0;
  }

  /// Returns true if @p here is true on all processes, so that all of them can
  /// throw an exception together. Must be called by all processes.
  inline bool
  true_on_all_processes(const bool here)
  {
    return dealii::Utilities::MPI::min(int(here), communicator()) == 1;
  }

  /// Replaces @p v, of equal size on all processes, by its sum over all
  /// processes, bitwise equal on all. Must be called by all processes.
  inline void
  sum_over_processes(Vector &v)
  {
    if (n_processes() > 1)
      dealii::Utilities::MPI::sum(v, communicator(), v);
  }

  /// Starts MPI in its constructor and ends MPI in its destructor. Trilinos
  /// needs MPI even for one process. The object must be the first one in
  /// `main`. Without a launcher (mpirun), Open MPI is configured without
  /// network, daemon and session folder, which start slowly and sometimes fail
  /// (`orte_session_dir failed`). Settings in the environment have precedence.
  class MpiSession
  {
  public:
    /// Starts MPI with one thread. MPI may change @p argc and @p argv.
    MpiSession(int &argc, char **&argv);

  private:
    /// MPI guard, whose destructor ends MPI.
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };

  /// Ignores the signals SIGXFSZ (file size limit) and SIGPIPE (closed pipe).
  /// Instead, writing fails, which OutputFile::commit() reports.
  void
  ignore_write_signals();

  /// Returns the number of processes that a launcher (mpirun) has started; 1
  /// without a launcher. May be called before MPI is started.
  unsigned int
  n_launched_processes();

  /// Limits deal.II and OpenBLAS to @p n threads. Other BLAS libraries are
  /// controlled by environment variables only.
  void
  limit_threads(const unsigned int n);

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

  /// Installs a signal handler that prints @p words (at most 1000 characters)
  /// to standard error if the user ends the program by Ctrl-C or kill. The exit
  /// status is then 130 or 143. Must be called by one thread of one process.
  void
  set_interruption_message(const std::string &words);

  /// Delays the signals of Ctrl-C and kill during the lifetime of the object,
  /// so that files are complete. A second equal signal ends the program.
  class SignalBlock
  {
  public:
    SignalBlock();
    SignalBlock(const SignalBlock &) = delete;
    ~SignalBlock();
  };
} // namespace lamella

#endif
