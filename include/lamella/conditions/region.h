// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `conditions`: supports and loads of single bodies. It owns regions
// (surfaces, lines, points), supports, loads and their integration, stabilizing
// springs, and the elimination of what supports prescribe, all as rows of Body.
// It does not depend on contact.

#ifndef lamella_conditions_region_h
#define lamella_conditions_region_h

#include <lamella/base/names.h>
#include <lamella/body/body.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The points, line or surface of a body, or the whole body, on which a
  /// support or a load acts: entry `On = BODY: point | line | body | SURFACE`.
  struct Region
  {
    /// Kind of region; `undefined` must not be used.
    enum class Kind
    {
      undefined,
      point,
      line,
      surface,
      body
    };
    /// Index of the body in the scene.
    unsigned int body = 0;
    /// Kind, which determines the member below that is used.
    Kind kind = Kind::undefined;
    /// Name of a surface (bottom, top, start, ends, ...).
    std::string surface;
    /// Positions of the points, or of the two ends of the line.
    std::vector<dealii::Point<3>> at;

    /// Returns whether this is a surface that contains the surface @p side.
    bool
    covers(const std::string &side) const;
    /// Returns whether this is a surface that contains the start section of the
    /// body, or its end section if @p at_start is false.
    bool
    covers_end(const bool at_start) const;
    /// Returns whether this is the whole body, including its interior.
    bool
    is_whole_body() const
    {
      return kind == Kind::body;
    }
    /// Returns whether a point or line of this region is closer to @p x than
    /// the distance @p near.
    bool
    has_point_at(const dealii::Point<3> &x, const double near) const;
    /// Returns whether this is a surface composed of several (`ends`, `all`).
    bool
    is_several_surfaces() const;
  };

  /// Names of the kinds of regions; surfaces have individual names.
  template <>
  struct Names<Region::Kind>
  {
    static constexpr NameOf<Region::Kind> all[] = {
      {Region::Kind::point, "point"},
      {Region::Kind::line, "line"},
      {Region::Kind::body, "body"}};
  };

  /// Returns locations that determine the displacement of @p body on @p region.
  ///
  ///   Kind     locations
  ///   point    one for each position in `at`
  ///   line     Body::line_points() of the segment: as many per element as its
  ///            polynomial degree along the line requires
  ///   surface  Body::constraint_points()
  ///   body     Body::body_points()
  ///
  /// RowReduction removes redundant constraints. Throws InputError, which names
  /// the entry or subsection @p path, if a point or a line is not in the body
  /// or the body has no such surface.
  std::vector<Location>
  region_locations(const Body        &body,
                   const Region      &region,
                   const std::string &path);

  /// Returns for each of @p points one location per adjacent ply
  /// (Body::locate()), since stresses jump between plies. Throws InputError,
  /// which names the entry @p path, for a point outside of @p body.
  std::vector<std::vector<Location>>
  locate_in_plies(const Body                          &body,
                  const std::vector<dealii::Point<3>> &points,
                  const std::string                   &path);

  /// Returns the first location of each point, sufficient for displacements.
  /// Throws as locate_in_plies() does.
  std::vector<Location>
  locate_all(const Body                          &body,
             const std::vector<dealii::Point<3>> &points,
             const std::string                   &path);

  /// Throws InputError with the entry @p path if @p body has no @p surface.
  void
  check_surface(const Body        &body,
                const std::string &surface,
                const std::string &path);
} // namespace lamella

#endif
