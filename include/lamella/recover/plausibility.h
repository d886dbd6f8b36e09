// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_plausibility_h
#define lamella_recover_plausibility_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/checks.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Checks for results that suggest a mistake in the scene:
  /// - implausible values in the units of the scene: strains above 2 %,
  ///   displacements above the length of a body, loads with strains below 1e-9;
  /// - bodies without a contact that penetrate each other at the end of a load
  ///   step, although they were apart at the start;
  /// - bodies that move without strain and without a moving support.
  /// Strains and displacements are evaluated at a thousand points of the
  /// surface of each body; few of the points are near stress singularities.
  class Plausibility
  {
  public:
    /// Keeps a reference to @p structure. Checks values only with @p units.
    Plausibility(const Structure                     &structure,
                 const Units                         &units,
                 const std::vector<ContactInterface> &contacts);

    /// Returns a sentence for each implausible result of the displacements @p u
    /// and their @p checks. The @p last load step has additional checks.
    std::vector<std::string>
    plausibility_warnings(const BlockVector &u,
                          const Checks      &checks,
                          const bool         last);

  private:
    /// The largest of some values, and its position.
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

    /// Returns about 500 surface nodes of body @p b, evenly selected.
    std::vector<SurfacePoint>
    sample_nodes(const unsigned int b) const;
    /// Returns about 500 points within the surface facets of body @p b.
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
    /// Adds a sentence on rigid motion of bodies without strain.
    void
    add_rigid_motion(const std::vector<CurrentBody> &moved,
                     std::vector<std::string>       &sentences) const;
    /// Returns the largest penetration of @p a into @p b, and its position.
    /// With the displacements @p u of @p b, a point x of @p a coincides with
    /// the material point X of b for which X + u(X) = x, found by Newton's
    /// method from the nearest surface point.
    Extreme
    deepest(const CurrentBody &a,
            const CurrentBody &b,
            const unsigned int number_of_b,
            const Vector      &u) const;
    /// Returns the distance of @p X, inside body @p b, from the nearest of the
    /// tangent planes at the surrounding surface points. Zero below rounding.
    double
    depth(const dealii::Point<3> &X, const unsigned int b) const;
    /// Returns true if an element center of @p a is initially inside @p b.
    bool
    are_nested(const Body &a, const Body &b) const;
    /// Adds sentences on overlapping bodies without a contact.
    void
    add_overlaps(const std::vector<CurrentBody> &moved,
                 const BlockVector              &u,
                 std::vector<std::string>       &sentences) const;

    const Structure &structure;
    const Bodies    &bodies;
    Units            units;
    /// Pairs of bodies with a contact, the lower number first.
    std::set<std::pair<unsigned int, unsigned int>> contacts;
    /// sample_nodes() and face_points() of each body, computed at first use.
    std::vector<std::vector<SurfacePoint>> nodes, faces;
  };
} // namespace lamella

#endif
