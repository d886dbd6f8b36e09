// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_memory_h
#define lamella_base_memory_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// Bytes per MB in tables and summaries: 1024^2; a GB in gigabytes() is 1e9.
  constexpr double megabyte = 1024. * 1024.;

  /// Returns the resident memory of this process in bytes (VmRSS of Linux).
  double
  resident_memory();
  /// Returns the largest resident memory since the start (VmHWM), in bytes.
  double
  peak_memory();

  /// Throws InputError if a limit on the address space (ulimit -v) is too low
  /// for OpenBLAS. Must be called first.
  void
  require_address_space();

  /// Returns the sum of @p bytes over the processes on this machine.
  /// Collective.
  double
  sum_over_machine(const double bytes);

  /// Returns the memory in bytes that the processes on a machine can still use
  /// together, the minimum over all machines. It is limited by the machine, its
  /// control group (a container, a batch job) and @p limit, in bytes per
  /// machine (0: none). File caches count as free. Collective.
  double
  available_memory(const double limit = 0.);

  /// Returns the bytes of an entry `2 GB`, `500 MB` (decimal, with a blank) or
  /// `auto`, which is 0. Throws InputError for anything else.
  double
  to_bytes(const Entry &entry);

  /// Returns @p bytes as in "2.4 GB" (1e9 bytes), with two or three digits.
  std::string
  gigabytes(const double bytes);
} // namespace lamella

#endif
