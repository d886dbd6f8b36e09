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
  /// Returns the number of the body in @p bodies, and the rest of `BODY: rest`.
  /// Throws InputError without a colon or a known name, suggesting the nearest.
  std::pair<unsigned int, std::string>
  parse_on_body(const Entry &entry, const std::vector<std::string> &bodies);

  /// Returns the regions of @p on, `BODY: point | line | body | SURFACE`
  /// between semicolons, with the positions @p at of points and lines. All
  /// points are one region; a line has two different ends. Throws InputError
  /// for no or repeated regions, and for too few, too many or unused positions.
  std::vector<Region>
  parse_regions(const Entry                    &on,
                const Entry                    &at,
                const std::vector<std::string> &bodies);

  /// The entry `Factors` of a load, a support or an obstacle.
  struct HistoryParameters
  {
    /// Declares the entry in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Adds the history in @p in to all @p steps and returns its number; 0 if
    /// it is empty. Throws InputError unless there is one number per step.
    static unsigned int
    parse(const Entries &in, std::vector<LoadFactor> &steps);
  };

  /// The entries of a `subsection Support NAME`.
  struct SupportParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the support @p name on bodies @p bodies. An empty u fixes all
    /// components; `free` leaves one free. A normal displacement excludes u and
    /// is for surfaces only. Throws InputError.
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

    /// Returns the load @p name on bodies @p bodies, expressions not yet
    /// parsed. Throws InputError, also for overlapping regions of one body
    /// (`all`, `ends`), forces on whole bodies, temperatures on anything else,
    /// pressures and couples not on a surface, couples on several surfaces, and
    /// totals at points or on lines beside surfaces.
    static Load
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
