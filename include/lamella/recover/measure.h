// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_measure_h
#define lamella_recover_measure_h

#include <lamella/base/entry.h>
#include <lamella/recover/named_quantity.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Entries of `subsection Measure NAME`, a difference of two probe results
  /// that can be divided by a number or length: Of, Over, References.
  struct MeasureParameters
  {
    /// Declares the entries with defaults, patterns and descriptions.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the measure @p name, a difference of results of @p probes. Of has
    /// the form PROBE[/PLY]: COLUMN - PROBE[/PLY]: COLUMN, Over is a number or
    /// `distance` (of the probes). Throws InputError for other forms, columns
    /// of different units, a difference that is always zero, and if Over is
    /// zero.
    static Measure
    parse(const Entries            &in,
          const std::string        &name,
          const std::vector<Probe> &probes);
  };

  /// Throws InputError if a measure has the name of another object.
  void
  check_names_of_measures(const QuantityNames &names);
} // namespace lamella

#endif
