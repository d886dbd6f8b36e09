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
  /// Place on the undeformed surface that penetrates a roller or a body, with
  /// its depth [length] and side.
  struct CylinderPenetration
  {
    dealii::Point<3> position;
    double           depth     = 0.;
    bool             of_second = false;
  };

  /// Returns whether points @p spacing apart along a beam are too coarse for a
  /// roller of @p radius [lengths]. Half a spacing beside the contact line,
  /// normal and force are off by 0.5 spacing / radius.
  inline bool
  are_too_coarse_for(const double spacing, const double radius)
  {
    // [rad] Errors at longer spacings: doc/theory/contact.md.
    constexpr double coarse_angle = 3e-3;
    return 0.5 * spacing > coarse_angle * radius;
  }

  /// Active points on a roller along the body: spacing and extent [length].
  struct ContactArc
  {
    double spacing = 0., length = 0.;

    /// Returns whether the contact is a line: two points share its force, and
    /// averages may activate a third.
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

  /// Contact lines between a beam and a roller: material lines of the surface
  /// along the beam, one at each station along the roller axis, with the point
  /// nearest to that axis, which moves as the beam bends. There the gap
  ///   g = |r| - R,   r the part of x - c normal to the axis through c,
  /// is stationary along the line, so the point's motion does not enter its
  /// gradient. At a fixed point at a distance d, the normal is off by d / R.
  class CylinderContactLines
  {
  public:
    /// Creates lines through the points of @p interface, nodal rows of @p
    /// surface against @p roller. Keeps the row per line nearest to it.
    CylinderContactLines(const MeshSurface &surface,
                         const Obstacle    &roller,
                         ContactInterface  &interface);

    /// Moves the slave places of @p points, one per line, to the points of the
    /// surface @p now nearest to the axis of @p roller. A place remains on its
    /// facet up to 5 % of its length beyond a side with an adjacent facet. The
    /// end of a line is used if no point is stationary.
    void
    follow(const MeshSurface     &now,
           const Obstacle        &roller,
           std::vector<GapPoint> &points) const;

    /// Returns the largest curvature of @p surface, deformed as @p now, over
    /// that of @p roller, on the active lines through @p places, from the gaps
    /// one node spacing before and behind the closest point. From 1 on the
    /// surface wraps around the roller, and no equilibrium has a single contact
    /// line.
    static double
    curvature(const Obstacle                      &roller,
              const MeshSurface                   &surface,
              const MeshSurface                   &now,
              const std::vector<dealii::Point<3>> &places);

    /// Returns the deepest place in @p roller on the lines through all nodes of
    /// @p surface, currently @p now, with the axis ahead. Empty without
    /// penetration, and if the roller is along the body.
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

    /// Returns the place of @p line nearest to the axis, after @p last.
    static MeshSurface::FacetPoint
    nearest_point_on_line(const Line                    &line,
                          const MeshSurface             &now,
                          const Obstacle                &roller,
                          const MeshSurface::FacetPoint &last);

    std::vector<Line> lines;
  };
} // namespace lamella

#endif
