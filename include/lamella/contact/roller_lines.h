// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_roller_lines_h
#define lamella_contact_roller_lines_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/obstacle.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Place on the undeformed surface that penetrates a roller or another body,
  /// its depth [length], and whether it is on the second side.
  struct SunkPlace
  {
    dealii::Point<3> position;
    double           depth     = 0.;
    bool             of_second = false;
  };

  /// Returns whether points @p spacing apart along a beam are too coarse for a
  /// roller of @p radius [lengths]. A point half a spacing beside the contact
  /// line has a normal that is off by 0.5 spacing / radius, and the force is
  /// off by as much.
  inline bool
  are_coarse_on(const double spacing, const double radius)
  {
    // [rad] Errors at longer spacings: doc/contact.md.
    constexpr double coarse_angle = 3e-3;
    return 0.5 * spacing > coarse_angle * radius;
  }

  /// Active contact points on a roller, along the body: spacing of neighbors
  /// and distance of the outermost two [length].
  struct ContactArc
  {
    double spacing = 0., length = 0.;

    /// Returns whether the contact is a line: two points share a force between
    /// them, and averages around points may activate a third.
    bool
    is_line() const
    {
      return length <= 2. * (1. + arithmetic::alike) * spacing;
    }
  };

  /// Returns the arc of the rows @p active of @p interface, against a roller.
  ContactArc
  contact_arc(const ContactInterface          &interface,
              const std::vector<unsigned int> &active);

  /**
   * Where a roller touches the surface of a beam that goes over it: material
   * lines of the surface along the beam, one at each station along the roller's
   * axis, and on each the point that is nearest to that axis, which wanders as
   * the beam bends. There the gap
   *   g = |r| - R,   r what x - c has across the axis through c,
   * is stationary along the line, so that its gradient has no part of the
   * wandering. A material point at a distance d from there would have a normal
   * that is d / R off, and the force with it.
   */
  class RollerLines
  {
  public:
    /// Through the points of @p interface, whose rows are those of nodes of
    /// @p surface, undeformed, against @p roller: of the rows of each line one
    /// is kept, the one nearest to the roller.
    RollerLines(const MeshSurface &surface,
                const Obstacle    &roller,
                ContactInterface  &interface);

    /// Puts the carrying places of @p points, one a line, where the lines of
    /// the surface, as it is @p now, are nearest to the axis of @p roller, as
    /// it stands now. A place stays on its facet until it is 5 % of its length
    /// beyond a side where another goes on. Where a line ends before it is
    /// nearest that is its end.
    void
    follow(const MeshSurface     &now,
           const Obstacle        &roller,
           std::vector<GapPoint> &points) const;

    /// Returns the largest curvature of @p surface, deformed as @p now, over
    /// that of @p roller at its current place, on the lines through @p places
    /// of the undeformed surface that touch. It follows from the gaps one node
    /// spacing before and behind the closest point. From 1 on no equilibrium
    /// has a single contact line: the surface wraps around the roller.
    static double
    curvature(const Obstacle                      &roller,
              const MeshSurface                   &surface,
              const MeshSurface                   &now,
              const std::vector<dealii::Point<3>> &places);

    /// The deepest place in @p roller, where it stands, of the lines through
    /// all nodes of @p surface, as it is @p now, at which the axis is ahead.
    /// Points of a surface see it only if they are near. None where nothing is
    /// inside, and where the roller lies along the body.
    static std::optional<SunkPlace>
    deepest_in(const Obstacle    &roller,
               const MeshSurface &surface,
               const MeshSurface &now);

  private:
    /// A facet that a line goes through, along t, at this s.
    struct Piece
    {
      unsigned int facet;
      double       s;
    };
    using Line = std::vector<Piece>;

    /// The pieces of @p surface at @p station of the axis of @p roller.
    static Line
    line_at(const MeshSurface &surface,
            const Obstacle    &roller,
            const double       station);

    /// The place of @p line that is nearest to the axis of @p roller, where it
    /// was at @p last.
    static MeshSurface::FacetPlace
    nearest_place(const Line                    &line,
                  const MeshSurface             &now,
                  const Obstacle                &roller,
                  const MeshSurface::FacetPlace &last);

    std::vector<Line> lines;
  };
} // namespace lamella

#endif
