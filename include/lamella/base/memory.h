// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_memory_h
#define lamella_base_memory_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// Of tables and summaries: bytes in an MB. 1024^2, unlike the GB of
  /// gigabytes() and `Memory limit`, which are 1e9.
  constexpr double megabyte = 1024. * 1024.;

  /// What this process has taken of the machine, and the most that it had
  /// taken, in bytes. The resident set (VmRSS of Linux), libraries and MPI's
  /// buffers included.
  double
  resident_memory();
  /// Its largest value since the process started (VmHWM).
  double
  peak_memory();

  /// Throws InputError where a limit on the address space (ulimit -v) leaves
  /// too little of it to begin with: BLAS (OpenBLAS) waits for ever for a
  /// buffer that it does not get. To be called before anything else.
  void
  require_address_space();

  /// The sum of @p bytes over the processes on this machine. Collective over
  /// all processes; each gets the sum of its own machine.
  double
  sum_over_machine(const double bytes);

  /**
   * What the processes on a machine may still take together, in bytes: what the
   * machine has, or what its control group (a container, a batch job) leaves it
   * if that is less. With a @p limit it is this limit less what they have
   * taken. The least of all machines, the same on all processes. Never
   * negative. Collective. Files that the system merely keeps in memory count as
   * free. @p limit is in bytes, for each machine; 0: none was set.
   */
  double
  available_memory(const double limit = 0.);

  /// Bytes of an entry `2 GB`, `500 MB` or `auto`, which is 0. Throws
  /// InputError for anything else. GB and MB are decimal here, 1e9 and 1e6
  /// bytes. One blank stands between number and unit, at least.
  double
  to_bytes(const Entry &entry);

  /// As in "2.4 GB", of 1e9 bytes each; two digits below one GB, three from
  /// there on.
  std::string
  gigabytes(const double bytes);
} // namespace lamella

#endif
