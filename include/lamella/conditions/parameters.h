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
  /// Parses the text `BODY: rest` of @p entry. Returns the index of BODY in the
  /// names @p bodies, and the text after the colon. Throws InputError, which
  /// suggests the most similar name, if BODY is unknown or there is no colon.
  std::pair<unsigned int, std::string>
  parse_on_body(const Entry &entry, const std::vector<std::string> &bodies);

  /// Returns the regions in entry @p on, a list of `BODY: point | line | body |
  /// SURFACE` separated by semicolons. Entry @p at has the positions of all
  /// points or of both ends of the line. Throws InputError if there is no
  /// region, a region is repeated, or the number of positions is wrong.
  std::vector<Region>
  parse_regions(const Entry                    &on,
                const Entry                    &at,
                const std::vector<std::string> &bodies);

  /// Parameter `Factors`: one factor per load step for a single load, support
  /// or obstacle, which replaces the load factor of the scene.
  struct HistoryParameters
  {
    /// Declares `Factors` in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Adds number k in `Factors` of @p in to @p steps[k], the factors of load
    /// step k. Returns the index of this factor for LoadFactor::of(), or 0
    /// (load factor of the scene) if the entry is empty; the factors are 0 if
    /// it is `harmonic`. Throws InputError if there is not one number per load
    /// step.
    static unsigned int
    parse(const Entries &in, std::vector<LoadFactor> &steps);
  };

  /// Parameters in `subsection Support NAME` of a scene file.
  struct SupportParameters
  {
    /// Declares these parameters in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the support @p name with the entries @p in; @p bodies are the
    /// names of all bodies. If `u` is empty, all displacement components are
    /// zero; the word `free` leaves one free. A normal displacement is for
    /// surfaces only and excludes `u`. Throws InputError for invalid entries.
    static Support
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// Parameters in `subsection Load NAME` of a scene file: the regions (`On`,
  /// `At`) and one force, traction or pressure.
  struct LoadParameters
  {
    /// Declares these parameters in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the load @p name with the entries @p in; @p bodies are the names
    /// of all bodies. Expressions are not parsed yet. Throws InputError for
    /// invalid entries and for regions on which a load of this kind cannot act.
    static Load
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
