// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_opposing_surface_h
#define lamella_contact_opposing_surface_h

#include <lamella/contact/obstacle.h>

#include <memory>
#include <optional>

namespace lamella
{
  /// Where a ray meets a surface, and on which facet if the surface has any;
  /// the normal is that of MeshSurface::smooth_normal(). An obstacle has no
  /// facets: then `facet` is invalid_unsigned_int.
  struct SurfaceHit : public Hit
  {
    unsigned int facet = dealii::numbers::invalid_unsigned_int;
    /// The place on the facet's unit square; up to 1e-7 outside of it.
    dealii::Point<2> st;
  };

  /**
   * A surface as the points of another one see it, which may come to touch it:
   * all that the projection of points onto the other side needs (closest-point
   * projection along an averaged normal, opposing_place()). Implemented by the
   * mesh of a body, by some of its facets and by a rigid obstacle. Undeformed
   * positions, scene axes; lengths in scene units.
   */
  class OpposingSurface
  {
  public:
    virtual ~OpposingSurface() = default;

    /**
     * The place nearest to @p x, ahead or behind and at most @p reach away,
     * where the line x + t d, d a unit vector, meets the surface with d against
     * its outward normal.
     *
     * The hit's distance is t, negative where the surfaces overlap. Nothing if
     * there is no such place.
     */
    virtual std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const = 0;

    /// The outward normal somewhere near the point of the surface nearest to
    /// @p x. A first guess for opposing_place(), of length 1 (on the axis of a
    /// cylinder 0).
    virtual dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const = 0;
  };

  /// Where a point X_1 with the outward normal n_1 faces another surface: the
  /// pair of places that a gap function is made of.
  struct Opposition
  {
    SurfaceHit hit;
    /// The unit normal n of opposing_place(); the initial gap is hit.distance.
    dealii::Tensor<1, 3> normal;
    /// Between n_1 and -n_2, in rad. 0 where they are opposed.
    double angle = 0.;
  };

  /// cos 60: normals further from opposed do not face each other. An edge, at
  /// which a surface ends, faces all that opposes the surface at all.
  constexpr double faces_from_60 = 0.5, edge_faces_from = 0.;

  /**
   * The place X_2 of @p other that the point @p x of a surface with the outward
   * normal @p n1 faces: where the line from X_1 along
   *   n = (n_1(X_1) - n_2(X_2)) / |n_1(X_1) - n_2(X_2)|
   * meets it. Both surfaces count alike: from X_2 the place opposite is X_1 and
   * the normal is -n, and of bodies that mirror each other n is the normal of
   * the mirror. A fixed point iteration from n = n_1 finds it (from the normal
   * of a place nearby, if the line along n_1 misses). None if the normals are
   * not opposed to @p opposed, the cosine of the angle between n_1 and -n_2: 60
   * degrees.
   *
   * None either if the other surface lies further off than @p reach [length]
   * along n, or if the iteration does not settle to 1e-11 in 50 steps (on flat
   * faces it needs none, near contact two or three).
   */
  std::optional<Opposition>
  opposing_place(const OpposingSurface      &other,
                 const dealii::Point<3>     &x,
                 const dealii::Tensor<1, 3> &n1,
                 const double                reach,
                 const double                opposed = faces_from_60);

  /// The surface of a rigid obstacle in closed form (see meet() of an
  /// Obstacle), where it stands before it moves. Shares the obstacle.
  class ObstacleSurface : public OpposingSurface
  {
  public:
    explicit ObstacleSurface(std::shared_ptr<const Obstacle> obstacle);

    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const override;
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

  private:
    std::shared_ptr<const Obstacle> obstacle;
  };
} // namespace lamella

#endif
