// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_plausibility_h
#define lamella_recover_plausibility_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/checks.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Checks of results for a probable mistake in the scene:
  /// - implausible values in the units of the scene: strains above 2 %,
  ///   displacements above the length of a body, loads with strains below 1e-9;
  /// - bodies without a contact that penetrate each other at the end of a load
  ///   step, although they were apart at the start;
  /// - bodies that move without strain and without a moving support.
  /// Values are evaluated at a few hundred surface points of each body.
  class Plausibility
  {
  public:
    /// Keeps a reference to @p structure. Values are checked only if @p units
    /// are given, and penetration only for bodies without one of @p interfaces.
    Plausibility(const Structure                     &structure,
                 const Units                         &units,
                 const std::vector<ContactInterface> &interfaces);

    /// Returns a warning for each implausible result of a load step with the
    /// displacements @p u and the @p checks. Rigid-body motion is checked only
    /// if this is the @p last load step.
    std::vector<std::string>
    plausibility_warnings(const BlockVector &u,
                          const Checks      &checks,
                          const bool         last);

  private:
    /// Largest value of a quantity over several points, and the point.
    struct Extreme
    {
      double           value = 0.;
      dealii::Point<3> place;

      void
      take(const double other, const dealii::Point<3> &at)
      {
        if (other > value)
          {
            value = other;
            place = at;
          }
      }
    };
    /// Deformed surface points of a body, with largest strain and displacement.
    struct CurrentBody
    {
      std::vector<dealii::Point<3>> places;
      std::vector<Triad>            rotations;
      dealii::BoundingBox<3>        box;
      Extreme                       strain, displacement;
    };

    /// Returns about 500 surface nodes of the body with index @p b.
    std::vector<SurfacePoint>
    sample_nodes(const unsigned int b) const;
    /// Returns about 500 points in surface facets of the body with index @p b.
    std::vector<SurfacePoint>
    face_points(const unsigned int b) const;
    CurrentBody
    make_current_body(const Vector                    &u,
                      const unsigned int               b,
                      const std::vector<SurfacePoint> &points) const;
    void
    add_unit_warnings(const std::vector<CurrentBody> &moved,
                      const bool                      is_rigid,
                      std::vector<std::string>       &sentences) const;
    /// Adds a warning if bodies move without strain and no support moves.
    void
    add_rigid_motion(const std::vector<CurrentBody> &moved,
                     std::vector<std::string>       &sentences) const;
    /// Returns the largest penetration [length] of surface points of body @p a
    /// into body @p b with displacements @p u. A point x of @p a coincides with
    /// the material point X of @p b for which X + u(X) = x (Newton's method,
    /// started at the nearest surface point).
    Extreme
    deepest(const CurrentBody &a,
            const CurrentBody &b,
            const unsigned int number_of_b,
            const Vector      &u) const;
    /// Returns the distance of the point @p X inside the body with index @p b
    /// from the nearest tangent plane at surface points around it; 0 if this is
    /// negligible compared with the element size.
    double
    depth(const dealii::Point<3> &X, const unsigned int b) const;
    /// Returns true if an element center of @p a is initially inside @p b.
    bool
    are_nested(const Body &a, const Body &b) const;
    /// Adds a warning for each pair of bodies without contact that penetrate.
    void
    add_overlaps(const std::vector<CurrentBody> &moved,
                 const BlockVector              &u,
                 std::vector<std::string>       &sentences) const;

    const Structure &structure;
    const Bodies    &bodies;
    Units            units;
    /// Pairs of bodies with a contact, by index, the smaller index first.
    std::set<std::pair<unsigned int, unsigned int>> contacts;
    /// Surface nodes and points in facets of each body, computed at first use.
    std::vector<std::vector<SurfacePoint>> nodes, faces;
  };
} // namespace lamella

#endif
