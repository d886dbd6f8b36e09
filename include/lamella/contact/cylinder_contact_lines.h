// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_cylinder_contact_lines_h
#define lamella_contact_cylinder_contact_lines_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/mesh_surface.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// A point on the surface of a body that penetrates a roller or another body.
  struct CylinderPenetration
  {
    dealii::Point<3> position;          ///< Undeformed position, scene axes.
    double           depth     = 0.;    ///< Penetration, positive [length].
    bool             of_second = false; ///< True: point of the second body.
  };

  /// Returns true if contact points at the distance @p spacing along a beam are
  /// too far apart for contact with a roller of @p radius [both lengths]. Half
  /// a spacing off the line, the normal is wrong by spacing / (2 radius).
  inline bool
  are_too_coarse_for(const double spacing, const double radius)
  {
    // [rad] Errors at longer spacings: doc/theory/contact.md.
    constexpr double coarse_angle = 3e-3;
    return 0.5 * spacing > coarse_angle * radius;
  }

  /// Arc of active contact points on a roller, measured along the beam axis.
  struct ContactArc
  {
    double spacing = 0., ///< Distance of adjacent contact points [length].
      length       = 0.; ///< Length of the arc [length].

    /// Returns true if the arc is at most two spacings long. Then the contact
    /// can be a line, whose force two or three points share.
    bool
    is_line() const
    {
      return length <= 2. * (1. + arithmetic::same_value) * spacing;
    }
  };

  /// Returns the arc of the constraints @p active (numbers in @p interface).
  ContactArc
  contact_arc(const ContactInterface          &interface,
              const std::vector<unsigned int> &active);

  /// Contact lines between a beam and a roller. Material lines of the surface
  /// run along the beam, one per position along the roller axis. The contact
  /// point of a line is its point nearest to the roller axis, which changes as
  /// the beam bends. At this point the gap
  ///   g = |r| - R,   r the component of x - c normal to the axis through c,
  /// with the roller radius R is stationary along the line but for differences
  /// of the slopes of adjacent elements, so the gradient of g omits the motion
  /// of the point. At a distance d from it, the normal is off by the angle d/R.
  class CylinderContactLines
  {
  public:
    /// Creates lines through the contact points of @p interface, constraints of
    /// single nodes of @p surface against @p roller. On each line, removes all
    /// constraints except the one nearest to the roller.
    CylinderContactLines(const MeshSurface &surface,
                         const Obstacle    &roller,
                         ContactInterface  &interface);

    /// Moves the slave points @p points, one per contact line, along the lines
    /// to the points of the deformed surface @p now nearest to the axis of @p
    /// roller: the continuous normal of the surface is along the distance r.
    /// Without a minimum of the distance, the end of the line is used.
    void
    follow(const MeshSurface     &now,
           const Obstacle        &roller,
           std::vector<GapPoint> &points) const;

    /// Returns the ratio of the curvature of the deformed surface @p now to
    /// that of @p roller, on the contact line through the undeformed point @p
    /// place of @p surface. It is computed from the gaps one node spacing
    /// before and behind the closest point; at least 0. For ratios above 1, the
    /// surface wraps around the roller, and no equilibrium has a single contact
    /// line.
    static double
    curvature(const Obstacle         &roller,
              const MeshSurface      &surface,
              const MeshSurface      &now,
              const dealii::Point<3> &place);

    /// Returns the deepest penetration into @p roller on lines through all
    /// nodes of @p surface, deformed as @p now, among points whose normal
    /// points to the roller axis. Empty if there is none or the roller is along
    /// the body.
    static std::optional<CylinderPenetration>
    deepest_in(const Obstacle    &roller,
               const MeshSurface &surface,
               const MeshSurface &now);

  private:
    /// The part of a contact line (facet coordinate s constant, t varying) that
    /// lies in one facet of the surface.
    struct Piece
    {
      unsigned int facet;
      double       s;
    };
    using Line = std::vector<Piece>;

    /// Returns the line on @p surface at the coordinate @p station along the
    /// axis of @p roller, as a sequence of facets.
    static Line
    line_at(const MeshSurface &surface,
            const Obstacle    &roller,
            const double       station);

    /// Returns the point of @p line on the deformed surface @p now nearest to
    /// the axis of @p roller, an end of it if none is nearest.
    static MeshSurface::FacetPoint
    nearest_point_on_line(const Line        &line,
                          const MeshSurface &now,
                          const Obstacle    &roller);

    std::vector<Line> lines;
  };
} // namespace lamella

#endif
