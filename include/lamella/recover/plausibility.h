// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_plausibility_h
#define lamella_recover_plausibility_h

#include <lamella/base/units.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/solve/checks.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * What results are as a rule not, if a scene is what its user means:
   * - in the units that it names: strains above 2 %, displacements above the
   *   length of a body, loads that strain nothing by 1e-9;
   * - bodies that a load step ends with in each other though no contact is
   *   between them and they were apart at the start;
   * - bodies that move while nothing strains, and no support moves them.
   *
   * Strains and displacements are looked at on the surface of each body, at a
   * thousand points of it, where bending strains most; so places where stresses
   * are singular hardly count.
   */
  class Plausibility
  {
  public:
    /// @p structure is referred to. Without @p units nothing is said of them.
    Plausibility(const Structure                     &structure,
                 const Units                         &units,
                 const std::vector<ContactInterface> &contacts);

    /// A sentence a fault, without a full stop, of the displacements @p u and
    /// their @p checks; of the @p last load step, which no step follows that
    /// might bring bodies together.
    std::vector<std::string>
    doubts(const BlockVector &u, const Checks &checks, const bool last);

  private:
    /// The largest of some values, and where it is.
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
    /// The points of a body where it is now, how they have turned, a box around
    /// them, and what is largest.
    struct Moved
    {
      std::vector<dealii::Point<3>> places;
      std::vector<Triad>            turns;
      dealii::BoundingBox<3>        box;
      Extreme                       strain, displacement;
    };

    /// Points of body @p b inside of the facets of its surface.
    std::vector<SurfacePoint>
    face_points(const unsigned int b) const;
    Moved
    moved_by(const Vector                    &u,
             const unsigned int               b,
             const std::vector<SurfacePoint> &points) const;
    void
    add_doubts_of_units(const std::vector<Moved> &moved,
                        const bool                is_rigid,
                        std::vector<std::string> &sentences) const;
    /// Where nothing is strained.
    void
    add_rigid_motion(const std::vector<Moved> &moved,
                     std::vector<std::string> &sentences) const;
    /// How deep @p a is in body @p b, and where, with the displacements @p u of
    /// that: at a point x of a the place X of b that is there now,
    ///   X + u(X) = x,
    /// by Newton's method with the rotation for the gradient, from the nearest
    /// point of the surface.
    Extreme
    deepest(const Moved       &a,
            const Moved       &b,
            const unsigned int number_of_b,
            const Vector      &u) const;
    /// How far @p X of body @p b, inside of it, is from its surface: from the
    /// nearest of the planes at the points around; zero if that is next to
    /// nothing.
    double
    depth(const dealii::Point<3> &X, const unsigned int b) const;
    /// Whether the middle of an element of @p a is inside of @p b from the
    /// start: whoever puts bodies into each other means it.
    bool
    are_nested(const Body &a, const Body &b) const;
    /// Bodies that no contact keeps apart.
    void
    add_overlaps(const std::vector<Moved> &moved,
                 const BlockVector        &u,
                 std::vector<std::string> &sentences) const;

    const Structure &structure;
    const Bodies    &bodies;
    Units            units;
    /// Numbers of bodies between which there is a contact, the lower one first.
    std::set<std::pair<unsigned int, unsigned int>> contacts;
    /// Of each body nodes of its surface, and face_points(), once somebody has
    /// asked: on large sections to list them takes a while.
    std::vector<std::vector<SurfacePoint>> places, faces;
  };
} // namespace lamella

#endif
