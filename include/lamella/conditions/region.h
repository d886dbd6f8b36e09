// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `conditions`: supports and loads of single bodies. It owns regions
// (surfaces, lines, points), supports, loads and their integration, stabilizing
// springs, and the elimination of support constraints, which are functionals of
// Body. It does not depend on contact.

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
    /// Geometry of a region; `undefined` until it is set.
    enum class Kind
    {
      undefined,
      point,
      line,
      surface,
      body
    };
    /// Index of the body in the scene, from 0.
    unsigned int body = 0;
    /// Geometry. `point` and `line` use `at`, `surface` uses `surface`.
    Kind kind = Kind::undefined;
    /// Surface name (bottom, top, start, ends, ...), empty for other kinds.
    std::string surface;
    /// Positions of the points, or of the two ends of the line, scene axes
    /// [length]; empty for other kinds.
    std::vector<dealii::Point<3>> at;

    /// Returns true if the region is a surface that contains surface @p side.
    bool
    covers(const std::string &side) const;
    /// Returns true if the region is a surface that contains the start section
    /// of the body (@p at_start true) or its end section (false).
    bool
    covers_end(const bool at_start) const;
    /// Returns true if the region is the whole body, including its interior.
    bool
    is_whole_body() const
    {
      return kind == Kind::body;
    }
    /// Returns true if the region consists of points or a line, and a point of
    /// it is closer to @p x than the distance @p near.
    bool
    has_point_at(const dealii::Point<3> &x, const double near) const;
    /// Returns true if `surface` denotes several surfaces (`ends`, `all`).
    bool
    is_several_surfaces() const;
  };

  /// Returns the distance of @p x from the segment between @p begin and @p end.
  double
  distance_to_segment(const dealii::Point<3> &x,
                      const dealii::Point<3> &begin,
                      const dealii::Point<3> &end);

  /// Names of region kinds in parameter files. Surfaces use their own names.
  template <>
  struct Names<Region::Kind>
  {
    static constexpr NameOf<Region::Kind> all[] = {
      {Region::Kind::point, "point"},
      {Region::Kind::line, "line"},
      {Region::Kind::body, "body"}}; ///< Value and name of each kind.
  };

  /// Returns points of @p body that determine its displacement on @p region.
  ///
  ///   Kind     locations
  ///   point    one for each position in `at`
  ///   line     line_points() of the segment: as many per element as its
  ///            polynomial degree along the line requires
  ///   surface  Body::constraint_points()
  ///   body     Body::body_points()
  ///
  /// RowReduction removes redundant constraints. Throws InputError of entry @p
  /// path if a point or line is not in the body or it has no such surface.
  std::vector<Location>
  region_locations(const Body        &body,
                   const Region      &region,
                   const std::string &path);

  /// Returns for each of @p points its locations in @p body, one per adjacent
  /// ply, since stresses jump between plies. Throws InputError of the entry @p
  /// path for a point outside of @p body.
  std::vector<std::vector<Location>>
  locate_in_plies(const Body                          &body,
                  const std::vector<dealii::Point<3>> &points,
                  const std::string                   &path);

  /// Returns one location in @p body, sufficient for displacements, for each of
  /// @p points. Throws as locate_in_plies() does.
  std::vector<Location>
  locate_all(const Body                          &body,
             const std::vector<dealii::Point<3>> &points,
             const std::string                   &path);

  /// Throws InputError of entry @p path if @p body has no surface @p surface.
  void
  check_surface(const Body        &body,
                const std::string &surface,
                const std::string &path);
} // namespace lamella

#endif
