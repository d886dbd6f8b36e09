// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_master_surface_h
#define lamella_contact_master_surface_h

#include <lamella/contact/obstacle.h>

#include <memory>
#include <optional>

namespace lamella
{
  /// Intersection of a ray with a surface, with MeshSurface::smooth_normal().
  /// `facet` is invalid_unsigned_int for an obstacle.
  struct SurfaceHit : public Hit
  {
    unsigned int facet = dealii::numbers::invalid_unsigned_int;
    /// Point on the unit square of the facet, up to 1e-7 outside.
    dealii::Point<2> st;
  };

  /// Interface of a master surface for the projection of points
  /// (find_master_point()): the mesh of a body, a subset of its facets or a
  /// rigid obstacle, in undeformed scene axes.
  class MasterSurface
  {
  public:
    virtual ~MasterSurface() = default;

    /// Returns the nearest intersection, in either direction and at most @p
    /// search_radius away, of the line x + t d, with unit d, and the surface,
    /// entered against its normal. Its distance is t, negative for overlap.
    virtual std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const = 0;

    /// Returns the outward normal near the point nearest to @p x, a first guess
    /// for find_master_point() (0 on the axis of a cylinder).
    virtual dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const = 0;
  };

  /// Facing points of a gap function: the place opposite X_1 with normal n_1.
  struct MasterPoint
  {
    SurfaceHit hit;
    /// Unit normal n of find_master_point(); the initial gap is hit.distance.
    dealii::Tensor<1, 3> normal;
    /// Angle between n_1 and -n_2 [rad]; 0 if opposed.
    double angle = 0.;
  };

  /// Smallest cosine of facing normals, cos 60 degrees; at an edge, where a
  /// surface ends, 0.
  constexpr double min_facing_cosine = 0.5, min_facing_cosine_edge = 0.;

  /**
   * Returns the place X_2 of @p other that the point @p x with outward normal
   * @p n1 faces: the intersection of @p other with the line from X_1 along
   *   n = (n_1(X_1) - n_2(X_2)) / |n_1(X_1) - n_2(X_2)|.
   * This is symmetric: the place opposite X_2 is X_1 with normal -n, and
   * between mirrored bodies n is the mirror normal. A fixed-point iteration
   * starts from n = n_1, or from a normal nearby if that line misses. @p
   * opposed is the smallest cosine of the angle between n_1 and -n_2. Empty if
   * the normals are not opposed, if the other surface is farther than @p
   * search_radius along n, or without convergence to 1e-11 in 50 steps (usually
   * two or three).
   */
  std::optional<MasterPoint>
  find_master_point(const MasterSurface        &other,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &n1,
                    const double                search_radius,
                    const double                opposed = min_facing_cosine);

  /// Exact surface of a rigid obstacle at its initial position.
  class ObstacleSurface : public MasterSurface
  {
  public:
    explicit ObstacleSurface(std::shared_ptr<const Obstacle> obstacle);

    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const override;
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

  private:
    std::shared_ptr<const Obstacle> obstacle;
  };
} // namespace lamella

#endif
