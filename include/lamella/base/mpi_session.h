// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_mpi_session_h
#define lamella_base_mpi_session_h

#include <deal.II/base/mpi.h>

namespace lamella
{
  /**
   * MPI (and what deal.II starts with it) for as long as the object lives;
   * Trilinos wants it for one process, too. The first object of a `main`.
   *
   * A process that no launcher started talks to nobody. Open MPI then need not
   * look for networks, nor start a daemon of its own (both take longer than a
   * small scene), nor keep files in the folder that all processes of a user
   * share: one run that ends removes that folder while the next one makes its
   * own in it, and of many runs side by side one in some hundreds fails at the
   * start (`orte_session_dir failed`). Settings of the environment come first.
   */
  class MpiSession
  {
  public:
    /// One thread: deal.II takes no more than that.
    MpiSession(int &argc, char **&argv);

  private:
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };

  /// A file that has reached its limit (SIGXFSZ), or a reader of the output
  /// that is gone (SIGPIPE; `| head -1`), is an error of that writing from now
  /// on and not the end of the run. MpiSession sees to it.
  void
  survive_failed_writes();

  /// As many processes as a launcher (mpirun) has started, or 1; known before
  /// MPI is.
  unsigned int
  n_launched();

  /// @p n threads from now on; the BLAS would start with one a core.
  void
  limit_threads(const unsigned int n);
} // namespace lamella

#endif
