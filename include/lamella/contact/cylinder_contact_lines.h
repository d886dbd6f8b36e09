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
  /// Point on the undeformed surface of a body that penetrates a roller or the
  /// other body, with its depth [length] and body number.
  struct CylinderPenetration
  {
    dealii::Point<3> position;
    double           depth     = 0.;
    bool             of_second = false;
  };

  /// Returns true if a point spacing @p spacing along a beam is too coarse for
  /// contact with a roller of @p radius [both lengths]. Half a spacing off the
  /// contact line, normal and force have an error of 0.5 spacing / radius.
  inline bool
  are_too_coarse_for(const double spacing, const double radius)
  {
    // [rad] Errors at longer spacings: doc/theory/contact.md.
    constexpr double coarse_angle = 3e-3;
    return 0.5 * spacing > coarse_angle * radius;
  }

  /// Arc of active contact points on a roller, in the direction of the beam
  /// axis: point spacing and arc length [length].
  struct ContactArc
  {
    double spacing = 0., length = 0.;

    /// Returns true if the contact is a line: its force is shared by two
    /// points, and weighted gaps may activate a third.
    bool
    is_line() const
    {
      return length <= 2. * (1. + arithmetic::same_value) * spacing;
    }
  };

  /// Returns the arc of the constraints @p active of @p interface.
  ContactArc
  contact_arc(const ContactInterface          &interface,
              const std::vector<unsigned int> &active);

  /// Contact lines between a beam and a roller. At each station along the
  /// roller axis, a material line of the surface runs along the beam; its
  /// contact point is the one nearest to the roller axis, which moves as the
  /// beam bends. At this point the gap
  ///   g = |r| - R,   r the part of x - c normal to the axis through c,
  /// is stationary along the line, so the motion of the point does not enter
  /// the gradient of g. At a distance d from it, the normal is off by d / R.
  class CylinderContactLines
  {
  public:
    /// Creates lines through the contact points of @p interface, nodal
    /// constraints of @p surface against @p roller. On each line, removes all
    /// constraints except the one nearest to the roller.
    CylinderContactLines(const MeshSurface &surface,
                         const Obstacle    &roller,
                         ContactInterface  &interface);

    /// Moves the slave points of @p points, one per line, to the points of the
    /// deformed surface @p now nearest to the axis of @p roller. A point
    /// remains on its facet up to 5 % of the facet length outside a side with
    /// an adjacent facet. If no point of a line is stationary, its end is used.
    void
    follow(const MeshSurface     &now,
           const Obstacle        &roller,
           std::vector<GapPoint> &points) const;

    /// Returns the largest curvature of the deformed surface @p now over that
    /// of @p roller, on the active lines through the undeformed points
    /// @p places of @p surface, from the gaps one node spacing before and
    /// behind the closest point. From a value of 1 on, the surface wraps around
    /// the roller, and no equilibrium has a single contact line.
    static double
    curvature(const Obstacle                      &roller,
              const MeshSurface                   &surface,
              const MeshSurface                   &now,
              const std::vector<dealii::Point<3>> &places);

    /// Returns the deepest penetration into @p roller on lines through all
    /// nodes of @p surface, deformed as @p now, among points whose normal
    /// points to the roller axis. Empty if none, or for a roller along the
    /// body.
    static std::optional<CylinderPenetration>
    deepest_in(const Obstacle    &roller,
               const MeshSurface &surface,
               const MeshSurface &now);

  private:
    /// A facet crossed by a line along t at constant s.
    struct Piece
    {
      unsigned int facet;
      double       s;
    };
    using Line = std::vector<Piece>;

    /// Returns the line on @p surface at the coordinate @p station along the
    /// axis of @p roller, as facets in sequence.
    static Line
    line_at(const MeshSurface &surface,
            const Obstacle    &roller,
            const double       station);

    /// Returns the point of @p line on the deformed surface @p now nearest to
    /// the axis, starting from the previous point @p last.
    static MeshSurface::FacetPoint
    nearest_point_on_line(const Line                    &line,
                          const MeshSurface             &now,
                          const Obstacle                &roller,
                          const MeshSurface::FacetPoint &last);

    std::vector<Line> lines;
  };
} // namespace lamella

#endif
