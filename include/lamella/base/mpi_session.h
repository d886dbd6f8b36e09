// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_mpi_session_h
#define lamella_base_mpi_session_h

#include <deal.II/base/mpi.h>

namespace lamella
{
  /**
   * Starts MPI, and deal.II's use of it, for the object's lifetime; Trilinos
   * needs it for one process, too. Must be the first object of a `main`, on
   * every process, and its destructor the last use of MPI.
   *
   * Without a launcher, Open MPI uses no network, daemon or session folder,
   * which start slowly and sometimes fail (`orte_session_dir failed`).
   * Environment settings have precedence.
   */
  class MpiSession
  {
  public:
    /// Starts MPI for one thread. MPI may change @p argc and @p argv.
    MpiSession(int &argc, char **&argv);

  private:
    /// MPI guard, whose destructor ends MPI.
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };

  /// Ignores SIGXFSZ (file size limit) and SIGPIPE (closed reader): the stream
  /// fails instead, and OutputFile::commit() checks it.
  void
  ignore_write_signals();

  /// Returns the number of processes that a launcher (mpirun) has started,
  /// or 1. Available before MPI is started.
  unsigned int
  n_launched_processes();

  /// Limits deal.II and OpenBLAS, if loaded, to @p n threads. Other BLAS
  /// libraries use their environment variables.
  void
  limit_threads(const unsigned int n);
} // namespace lamella

#endif
