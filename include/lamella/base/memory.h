// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_memory_h
#define lamella_base_memory_h

#include <string>

namespace lamella
{
  /// Of tables and summaries: bytes in an MB.
  constexpr double megabyte = 1024. * 1024.;

  /// What this process has taken of the machine, and the most that it had
  /// taken, in bytes.
  double
  resident_memory();
  double
  peak_memory();

  /// The sum of @p bytes over the processes on this machine.
  double
  sum_over_machine(const double bytes);

  /**
   * What the processes on a machine may still take together, in bytes: what
   * the machine has, or what its control group (a container, a batch job)
   * leaves it if that is less. With a @p limit it is this limit less what they
   * have taken. The least of all machines, the same on all processes.
   */
  double
  available_memory(const double limit = 0.);

  /// `2 GB`, `500 MB` or `auto`, which is 0. Throws InputError; @p what names
  /// the entry.
  double
  to_bytes(const std::string &text, const std::string &what);

  /// As in "2.4 GB".
  std::string
  gigabytes(const double bytes);
} // namespace lamella

#endif
