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
  /// The entries of a `subsection Measure NAME`: Of, Over, References.
  struct MeasureParameters
  {
    /// Declares them with their defaults, patterns and what they mean.
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * The measure @p name of columns of @p probes: Of says PROBE[/PLY]: COLUMN
     * - PROBE[/PLY]: COLUMN, Over a number or `distance`. Throws InputError for
     * anything else, for columns of different kinds (a displacement less a
     * stress), for a difference that is zero whatever happens, and where Over
     * is zero or the distance of two probes at one place.
     */
    static Measure
    parse(const Entries            &in,
          const std::string        &name,
          const std::vector<Probe> &probes);
  };

  /// Throws InputError of the list `Measures` if one of the measures of
  /// @p names is called as a probe, a support or a contact is: nobody could
  /// tell them apart.
  void
  check_names_of_measures(const QuantityNames &names);
} // namespace lamella

#endif
