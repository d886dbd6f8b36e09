// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_processes_h
#define lamella_base_processes_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/base/mpi.h>

namespace lamella
{
  // The processes of a run: each has the whole scene and whole vectors.
  // Matrices, their solution and the loops over elements are distributed: each
  // process has a contiguous part of a body.

  /// Returns the communicator of the run.
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

  /// Returns the number of this process, from 0; 0 before MPI is started.
  inline unsigned int
  this_process()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::this_mpi_process(communicator()) :
             0;
  }

  /// Returns whether this is process 0, the only one that prints and writes.
  inline bool
  is_root_process()
  {
    return this_process() == 0;
  }

  /// Returns whether @p here is true on all processes, so that they agree on
  /// errors that only one has met. Collective.
  inline bool
  true_on_all_processes(const bool here)
  {
    return dealii::Utilities::MPI::min(int(here), communicator()) == 1;
  }

  /// Replaces the shares @p v by their sum over the processes, equal to the
  /// last bit on all. @p v has the same size everywhere, and zeros outside of a
  /// process's share. Collective.
  inline void
  sum_over_processes(Vector &v)
  {
    if (n_processes() > 1)
      dealii::Utilities::MPI::sum(v, communicator(), v);
  }
} // namespace lamella

#endif
