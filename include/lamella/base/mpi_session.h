// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_mpi_session_h
#define lamella_base_mpi_session_h

#include <deal.II/base/mpi.h>

namespace lamella
{
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
} // namespace lamella

#endif
