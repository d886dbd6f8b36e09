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
  /**
   * The body's number among @p bodies and the rest of an entry, or of a piece
   * of one, `BODY: rest`. Throws InputError for a text without a colon and for
   * a name that is none of them. @p bodies are the names in the order of the
   * scene; the number counts from 0. The message gives the nearest name.
   */
  std::pair<unsigned int, std::string>
  parse_on_body(const Entry &entry, const std::vector<std::string> &bodies);

  /**
   * The regions that @p on names, `BODY: point | line | body | SURFACE` between
   * semicolons, points and lines at the positions of @p at. Throws InputError
   * for none, for one that is named twice, and for positions that are too few,
   * too many or that nothing uses. Surfaces are not known yet and are checked
   * on the body (check_surface()). A semicolon at the end is no fault. All
   * points of @p at are one region; a line has exactly two different ends.
   */
  std::vector<Region>
  parse_regions(const Entry                    &on,
                const Entry                    &at,
                const std::vector<std::string> &bodies);

  /// `Factors` of a load, a support or an obstacle.
  struct HistoryParameters
  {
    /// Declares it in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The number of the history that the entry of @p in says, which is added
    /// to the load factors of all @p steps; 0, that of the scene, if it is
    /// empty. Throws InputError unless there is one number a step.
    static unsigned int
    parse(const Entries &in, std::vector<LoadFactor> &steps);
  };

  /// The entries of a `subsection Support NAME`. `On`, `At`, `u`, `Normal
  /// displacement`.
  struct SupportParameters
  {
    /// Declares them in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The support @p name of bodies with the names @p bodies. Throws
    /// InputError. An empty u holds all three components; `free` leaves one
    /// free, but not all. A normal displacement excludes u and is for surfaces
    /// only.
    static Support
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };

  /// The entries of a `subsection Load NAME`. `On`, `At`, and one of `Force`,
  /// `Total force`, `Pressure`, `Couple` and `Temperature`.
  struct LoadParameters
  {
    /// Declares them in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The load @p name on bodies with the names @p bodies, its expressions not
    /// yet parsed. Throws InputError. Regions of which one is part of another
    /// on the same body (`all`, `ends`) are refused: the load would act twice
    /// there. So are forces on a whole body, temperatures on anything else, and
    /// pressure and couples on anything but a surface, couples on several at
    /// once (`ends`, `all`), totals at points or on lines beside surfaces, too.
    static Load
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies);
  };
} // namespace lamella

#endif
