// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_cylinder_contact_lines_h
#define lamella_contact_cylinder_contact_lines_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/obstacle.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Place on the undeformed surface that penetrates a roller or another body,
  /// its depth [length], and whether it is on the second side.
  struct CylinderPenetration
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
  are_too_coarse_for(const double spacing, const double radius)
  {
    // [rad] Errors at longer spacings: doc/theory/contact.md.
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
      return length <= 2. * (1. + arithmetic::same_value) * spacing;
    }
  };

  /// Returns the arc of the rows @p active of @p interface, against a roller.
  ContactArc
  contact_arc(const ContactInterface          &interface,
              const std::vector<unsigned int> &active);

  /**
   * Contact lines between a beam and a roller: material lines of the surface
   * along the beam, one at each station along the roller axis, with the point
   * nearest to that axis, which moves as the beam bends. There the gap
   *   g = |r| - R,   r the part of x - c normal to the axis through c,
   * is stationary along the line, so the motion of the point does not enter its
   * gradient. At a fixed material point at a distance d from there, normal and
   * force direction would be off by d / R.
   */
  class CylinderContactLines
  {
  public:
    /// Creates the lines through the points of @p interface, whose rows are
    /// those of nodes of @p surface, undeformed, against @p roller. Keeps one
    /// row per line, the one nearest to the roller.
    CylinderContactLines(const MeshSurface &surface,
                         const Obstacle    &roller,
                         ContactInterface  &interface);

    /// Moves the slave places of @p points, one per line, to the points of the
    /// surface @p now nearest to the axis of @p roller, both in their current
    /// positions. A place remains on its facet up to 5 % of its length beyond a
    /// side with an adjacent facet. The end of a line is used if no point is
    /// stationary.
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

    /// Returns the deepest place in @p roller, at its position, on the lines
    /// through all nodes of @p surface, currently @p now, with the axis ahead.
    /// Contact points detect a roller only nearby. Empty without penetration,
    /// and if the roller is along the body.
    static std::optional<CylinderPenetration>
    deepest_in(const Obstacle    &roller,
               const MeshSurface &surface,
               const MeshSurface &now);

  private:
    /// A facet crossed by a line, along t, at this s.
    struct Piece
    {
      unsigned int facet;
      double       s;
    };
    using Line = std::vector<Piece>;

    /// Returns the pieces of @p surface at @p station of the axis of @p roller.
    static Line
    line_at(const MeshSurface &surface,
            const Obstacle    &roller,
            const double       station);

    /// Returns the place of @p line nearest to the axis of @p roller; @p last
    /// is the previous one.
    static MeshSurface::FacetPoint
    nearest_point_on_line(const Line                    &line,
                          const MeshSurface             &now,
                          const Obstacle                &roller,
                          const MeshSurface::FacetPoint &last);

    std::vector<Line> lines;
  };
} // namespace lamella

#endif
