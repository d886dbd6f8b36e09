// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `conditions`: what holds and loads bodies one by one. It owns
// regions (surfaces, lines, points), supports, loads and their integration,
// stabilising springs, and the elimination of what supports prescribe, all as
// rows of Body. It never knows that there is a second body to touch: no
// contact.

#ifndef lamella_conditions_region_h
#define lamella_conditions_region_h

#include <lamella/base/names.h>
#include <lamella/body/body.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The part of a body that a support or a load acts on. What a scene writes
  /// as `On = BODY: point | line | body | SURFACE` with `At`. Names of surfaces
  /// are the body's (Body::surfaces()) and are not known to the parser;
  /// check_surface() checks them.
  struct Region
  {
    /// undefined is nothing yet: reading it is a fault of the program.
    enum class Kind
    {
      undefined,
      point,
      line,
      surface,
      body
    };
    /// The number in the scene's list of bodies.
    unsigned int body = 0;
    /// Which of the members below count.
    Kind kind = Kind::undefined;
    /// Of a surface its name (bottom, top, start, ends, ...).
    std::string surface;
    /// Of a point its position, of a line its two ends, in scene axes [length].
    /// Several points are one region.
    std::vector<dealii::Point<3>> at;

    /// Whether this is a surface that is, or has for a part, @p side of the
    /// body.
    bool
    covers(const std::string &side) const;
    /// Whether this is a surface with the body's whole start (or its end).
    bool
    covers_end(const bool at_start) const;
    /// Whether this is the body as a whole, its inside, too.
    bool
    is_whole_body() const
    {
      return kind == Kind::body;
    }
    /// Whether this is made of points or lines, one of which is at @p x (scene
    /// axes) up to @p near [length].
    bool
    has_point_at(const dealii::Point<3> &x, const double near) const;
    /// Whether this is a surface that is made of several: no single place.
    bool
    is_several_surfaces() const;
  };

  /// The words for regions that are no surface, which has a name of its own.
  template <>
  struct Names<Region::Kind>
  {
    static constexpr NameOf<Region::Kind> all[] = {
      {Region::Kind::point, "point"},
      {Region::Kind::line, "line"},
      {Region::Kind::body, "body"}};
  };

  /**
   * Locations that fix the displacement of @p body on @p region. Throws
   * InputError of the entry or subsection @p path if a point or a line is not
   * in the body or the body has no such surface.
   *
   *   Kind     locations
   *   point    one for each position in `at`
   *   line     Body::line_points() of the segment: as many an element as its
   *            polynomial degree along the line takes
   *   surface  Body::fixing_points()
   *   body     Body::body_points()
   *
   * Prescribing the displacement at all of them prescribes its trace on the
   * whole region, and some rows more than once, which RowReduction sorts out.
   * Only the two ends of a line are tested for being in the body before its
   * crossings are sought; all its points must be found.
   */
  std::vector<Location>
  region_locations(const Body        &body,
                   const Region      &region,
                   const std::string &path);

  /**
   * For each point its locations, one in each ply that it touches
   * (Body::locate()). Throws InputError of the entry or subsection @p path for
   * a point outside of @p body; the message gives the body's extent. The order
   * is that of @p points. Stresses jump between plies, so who samples them
   * needs all sides.
   */
  std::vector<std::vector<Location>>
  locate_sides(const Body                          &body,
               const std::vector<dealii::Point<3>> &points,
               const std::string                   &path);

  /// For each point the first of these (displacements are continuous). Throws
  /// as locate_sides() does.
  std::vector<Location>
  locate_all(const Body                          &body,
             const std::vector<dealii::Point<3>> &points,
             const std::string                   &path);

  /// Throws InputError of the entry or subsection @p path if @p body has no
  /// @p surface. The message lists the surfaces that there are, the nearest
  /// name first.
  void
  check_surface(const Body        &body,
                const std::string &surface,
                const std::string &path);
} // namespace lamella

#endif
