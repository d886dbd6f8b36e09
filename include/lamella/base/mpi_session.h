// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_mpi_session_h
#define lamella_base_mpi_session_h

#include <deal.II/base/mpi.h>

namespace lamella
{
  /**
   * Starts MPI, and deal.II's use of it, for the object's lifetime; Trilinos
   * needs it for one process, too. Must be the first object of a `main`, on
   * every process, and its destructor the last use of MPI;
   * n_launched_processes() is available before.
   *
   * Without a launcher, Open MPI is set not to look for networks, not to start
   * a daemon and not to keep files in the user's shared folder. The first two
   * take longer than a small scene; a run that ends removes the folder while
   * another creates its own, so that one start in some hundreds fails
   * (`orte_session_dir failed`). Environment settings have precedence.
   */
  class MpiSession
  {
  public:
    /// Starts MPI for one thread, deal.II's limit. MPI may remove its own words
    /// from main()'s @p argc and @p argv.
    MpiSession(int &argc, char **&argv);

  private:
    /// MPI guard, whose destructor ends MPI.
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };

  /// Makes the process survive SIGXFSZ (file size limit) and SIGPIPE (closed
  /// reader, `| head -1`): the stream fails instead, and is checked
  /// (OutputFile::commit()). MpiSession calls it.
  void
  ignore_write_signals();

  /// Returns the number of processes that a launcher (mpirun) has started, or
  /// 1, from environment variables of Open MPI and PMI. Available before MPI.
  unsigned int
  n_launched_processes();

  /// Limits deal.II and OpenBLAS, if that is loaded, to @p n threads; a BLAS
  /// otherwise starts one per core. Other ones use their environment variables.
  void
  limit_threads(const unsigned int n);
} // namespace lamella

#endif
