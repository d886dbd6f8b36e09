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
   *
   * Every process of a run makes one, before anything that asks for the number
   * of processes as MPI knows it; n_launched() tells it earlier. Its destructor
   * must be the last thing that speaks to MPI.
   */
  class MpiSession
  {
  public:
    /// One thread: deal.II takes no more than that. @p argc and @p argv are
    /// main()'s; MPI may take words of its own out of them.
    MpiSession(int &argc, char **&argv);

  private:
    /// Ends MPI in its destructor.
    dealii::Utilities::MPI::MPI_InitFinalize session;
  };

  /// A file that has reached its limit (SIGXFSZ), or a reader of the output
  /// that is gone (SIGPIPE; `| head -1`), is an error of that writing from now
  /// on and not the end of the run. MpiSession sees to it. Streams then fail
  /// and are asked (OutputFile::put_in_place()).
  void
  survive_failed_writes();

  /// As many processes as a launcher (mpirun) has started, or 1; known before
  /// MPI is. From the launcher's environment variables (Open MPI's, PMI's).
  unsigned int
  n_launched();

  /// @p n threads from now on; the BLAS would start with one a core. Of deal.II
  /// and of OpenBLAS, if that is the BLAS that was loaded; another one has to
  /// be told by its environment variable.
  void
  limit_threads(const unsigned int n);
} // namespace lamella

#endif
