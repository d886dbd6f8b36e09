// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_processes_h
#define lamella_base_processes_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/base/mpi.h>

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
} // namespace lamella

#endif
