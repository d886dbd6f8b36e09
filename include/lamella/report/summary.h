// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_summary_h
#define lamella_report_summary_h

#include <lamella/recover/results.h>

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the content of summary.json (doc/reference/output.md): resultants
  /// and checks of the last load step in @p results, and the warnings of all
  /// steps. Bytes that are not valid UTF-8 are replaced.
  std::string
  summary_text(const Results &results);

  /// Prints mass, center of mass and moments of inertia about the center.
  void
  print_inertia(std::ostream &out, const Inertia &inertia);

  /// Returns modes.csv: a line per natural mode, then per buckling mode, with
  /// the columns of doc/reference/output.md.
  std::string
  modes_csv(const Results &results);

  /// Returns response.csv: amplitude and phase angle [degrees] of each column
  /// of probes.csv, a line per frequency, probe and ply.
  std::string
  response_csv(const Results &results);

  /// Prints tables of modes and of the largest amplitudes of a response;
  /// nothing if there are none.
  void
  print_modes(std::ostream &out, const Results &results);

  /// Adds the keys `inertia`, `modes` and `buckling_modes` to @p json.
  void
  add_modes(const Results &results, nlohmann::ordered_json &json);
} // namespace lamella

#endif
