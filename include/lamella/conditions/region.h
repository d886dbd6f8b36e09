// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `conditions`: what holds and loads bodies one by one. It owns
// regions (surfaces, lines, points), supports, loads and their integration,
// stabilising springs, and the elimination of what supports prescribe, all as
// rows of Body. It never knows that there is a second body to touch: no
// contact.

#ifndef lamella_conditions_region_h
#define lamella_conditions_region_h

#include <lamella/body/body.h>

#include <string>
#include <vector>

namespace lamella
{
  using Bodies = std::vector<std::unique_ptr<Body>>;

  /// The part of a body that a support or a load acts on.
  struct Region
  {
    enum class Kind
    {
      undefined,
      point,
      line,
      surface,
      body
    };
    unsigned int body = 0;
    Kind         kind = Kind::undefined;
    /// Of a surface its name (bottom, top, start, ends, ...).
    std::string surface;
    /// Of a point its position, of a line its two ends.
    std::vector<dealii::Point<3>> at;
  };

  /**
   * Locations that fix the displacement of @p body on @p region. Throws
   * InputError, beginning with @p what, if a point or a line is not in the body
   * or the body has no such surface.
   */
  std::vector<Location>
  region_locations(const Body        &body,
                   const Region      &region,
                   const std::string &what);

  /**
   * For each point its locations, one in each ply that it touches
   * (Body::locate()). Throws InputError, beginning with @p what, for a point
   * outside of @p body; the message gives the body's extent.
   */
  std::vector<std::vector<Location>>
  locate_sides(const Body                          &body,
               const std::vector<dealii::Point<3>> &points,
               const std::string                   &what);

  /// For each point the first of these (displacements are continuous).
  std::vector<Location>
  locate_all(const Body                          &body,
             const std::vector<dealii::Point<3>> &points,
             const std::string                   &what);

  /// Throws InputError, beginning with @p what, if @p body has no @p surface.
  void
  check_surface(const Body        &body,
                const std::string &surface,
                const std::string &what);
} // namespace lamella

#endif
