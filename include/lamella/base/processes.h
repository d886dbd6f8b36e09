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

  /// The communicator of the run. All processes that were started together;
  /// nothing is ever split off but for the memory of one machine
  /// (sum_over_machine()).
  inline MPI_Comm
  communicator()
  {
    return MPI_COMM_WORLD;
  }

  /// The number of processes of the run; 1 before MPI is started, too.
  inline unsigned int
  n_processes()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::n_mpi_processes(communicator()) :
             1;
  }

  /// The number of this process, from 0; 0 before MPI is started, too.
  inline unsigned int
  this_process()
  {
    return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::this_mpi_process(communicator()) :
             0;
  }

  /// Whether this process speaks for all: it alone prints and writes. It is the
  /// number 0, and computes its share like all others.
  inline bool
  is_speaker()
  {
    return this_process() == 0;
  }

  /// Whether @p here holds on all processes. Collective: all processes must
  /// call it, and it is how they agree on what to do where one alone has met a
  /// fault.
  inline bool
  on_all_processes(const bool here)
  {
    return dealii::Utilities::MPI::min(int(here), communicator()) == 1;
  }

  /// Replaces the shares @p v of the processes by their sum, on all of them.
  /// Collective, and the same to the last bit on all processes, which lets them
  /// take the same decisions afterwards. @p v has the same size everywhere;
  /// each process has left zeros where it has no share. Costs the communication
  /// of the whole vector; nothing on one process.
  inline void
  sum_over_processes(Vector &v)
  {
    if (n_processes() > 1)
      dealii::Utilities::MPI::sum(v, communicator(), v);
  }
} // namespace lamella

#endif
