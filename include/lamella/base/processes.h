// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_processes_h
#define lamella_base_processes_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/base/mpi.h>

namespace lamella
{
  // How the processes of a run share the work: each knows the whole scene and
  // holds whole vectors, so rows, contact and reports read as they do on one.
  // Matrices, their solution and the loops over elements are shared: each
  // process has a contiguous part of a body.

  /// The communicator of the run.
  inline MPI_Comm
  communicator()
  {
    return MPI_COMM_WORLD;
  }

  /// 1 before MPI is started, too.
  inline unsigned int
  n_processes()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::n_mpi_processes(communicator()) :
             1;
  }

  inline unsigned int
  this_process()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::this_mpi_process(communicator()) :
             0;
  }

  /// Whether this process speaks for all: it alone prints and writes.
  inline bool
  is_speaker()
  {
    return this_process() == 0;
  }

  /// Whether @p here holds on all processes.
  inline bool
  on_all_processes(const bool here)
  {
    return dealii::Utilities::MPI::min(int(here), communicator()) == 1;
  }

  /// Replaces the shares @p v of the processes by their sum, on all of them.
  inline void
  sum_over_processes(Vector &v)
  {
    if (n_processes() > 1)
      dealii::Utilities::MPI::sum(v, communicator(), v);
  }
} // namespace lamella

#endif
