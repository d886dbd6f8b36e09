// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_parameters_h
#define lamella_conditions_parameters_h

#include <lamella/base/entry.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Parses the text `BODY: rest` of @p entry. Returns the index of BODY in @p
  /// bodies and the text after the colon. Throws InputError if there is no
  /// colon or BODY is unknown; the message suggests the nearest name.
  std::pair<unsigned int, std::string>
  parse_on_body(const Entry &entry, const std::vector<std::string> &bodies);

  /// Returns the regions in @p on, a list `BODY: point | line | body | SURFACE`
  /// separated by semicolons. @p at has the positions of all points (one
  /// region) and of the two ends of each line. Throws InputError if there is no
  /// region, if a region is repeated, and if the number of positions is wrong.
  std::vector<Region>
  parse_regions(const Entry                    &on,
                const Entry                    &at,
                const std::vector<std::string> &bodies);

  /// The entry `Factors`: load factors of one load, support or obstacle.
  struct HistoryParameters
  {
    /// Declares the entry in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Adds the factors in @p in to @p steps, one per load step, and returns
    /// the index of the history (LoadFactor::of()); 0 if the entry is empty.
    /// Throws InputError if there is not one number per step.
    static unsigned int
    parse(const Entries &in, std::vector<LoadFactor> &steps);
  };

  /// The entries of a `subsection Support NAME`.
  struct SupportParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the support @p name; @p bodies are the names of all bodies. If
    /// the displacement is empty, all components are zero; `free` leaves a
    /// component free. A normal displacement is for surfaces only and excludes
    /// displacement components. Throws InputError for invalid entries.
    static Support
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Load NAME`: `On`, `At`, and one kind of load.
  struct LoadParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the load @p name; @p bodies are the names of all bodies.
    /// Expressions are not parsed yet. Throws InputError for invalid entries
    /// and for regions on which a load of its kind cannot act.
    static Load
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
