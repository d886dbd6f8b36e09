// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_memory_h
#define lamella_base_memory_h

#include <lamella/base/entry.h>

#include <string>

namespace lamella
{
  /// Bytes per MB in tables and summaries; gigabytes() uses 1 GB = 1e9 bytes.
  constexpr double megabyte = 1024. * 1024.;

  /// Returns the resident memory of this process (VmRSS of Linux) [bytes].
  double
  resident_memory();
  /// Returns the largest resident memory since the start (VmHWM) [bytes].
  double
  peak_memory();

  /// Throws InputError if the limit on the address space (ulimit -v) is too low
  /// for OpenBLAS. Must be called at the start of the program.
  void
  require_address_space();

  /// Returns the sum of @p bytes over the processes on this machine. Must be
  /// called by all processes.
  double
  sum_over_machine(const double bytes);

  /// Returns the free memory for all processes of one machine together, the
  /// minimum over all machines [bytes]. It is limited by the machine, its
  /// control group (container, batch job) and @p limit, in bytes per machine
  /// (0: none). File caches count as free. Must be called by all processes.
  double
  available_memory(const double limit = 0.);

  /// Converts an entry such as `2 GB` or `500 MB` to bytes (1 GB = 1e9 bytes);
  /// returns 0 for `auto`. Throws InputError for any other text.
  double
  to_bytes(const Entry &entry);

  /// Returns @p bytes as text, e.g. "2.4 GB" (1 GB = 1e9 bytes).
  std::string
  gigabytes(const double bytes);
} // namespace lamella

#endif
