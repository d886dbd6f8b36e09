// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_master_surface_h
#define lamella_contact_master_surface_h

#include <lamella/contact/contact_pair.h>

#include <memory>
#include <optional>

namespace lamella
{
  /// Intersection of a line with a surface; `normal` is continuous on meshes.
  struct SurfaceHit : public Hit
  {
    /// Index of the intersected facet; invalid_unsigned_int for an obstacle.
    unsigned int facet = dealii::numbers::invalid_unsigned_int;
    /// Point in the unit square of the facet, up to 1e-7 outside it.
    dealii::Point<2> st;
  };

  /// Interface of a master surface for find_master_point(): a body's mesh, some
  /// of its facets, or an obstacle, undeformed, in scene axes.
  class MasterSurface
  {
  public:
    virtual ~MasterSurface() = default;

    /// Returns the nearest intersection of the surface with the line x + t d,
    /// |t| <= @p search_radius, at which the unit vector @p d points into the
    /// body. `distance` is t, negative for overlap. Empty if there is none.
    virtual std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const = 0;

    /// Returns approximately the outward normal at the surface point nearest to
    /// @p x, to start find_master_point(); 0 on the axis of a cylinder.
    virtual dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const = 0;
  };

  /// Point of the master surface opposite a slave point.
  struct MasterPoint
  {
    SurfaceHit hit; ///< Point on the master surface; `distance` is the gap.
    /// Unit averaged normal of both surfaces, outward from the slave.
    dealii::Tensor<1, 3> normal;
    /// Angle between both surfaces' normals [rad]; 0 for parallel surfaces.
    double angle = 0.;
  };

  /// Smallest cosine of the angle between the normals n_1 and -n_2 in contact.
  constexpr double min_facing_cosine      = 0.5,
                   min_facing_cosine_edge = 0.; ///< Limit where a surface ends.

  /// Returns the point X_2 of @p other that the point @p x = X_1 with outward
  /// normal @p n1 faces: the intersection of @p other, with outward normal n_2,
  /// and the line from X_1 along the averaged normal
  ///   n = (n_1(X_1) - n_2(X_2)) / |n_1(X_1) - n_2(X_2)|.
  /// The relation is symmetric: the point opposite X_2 is X_1, with the normal
  /// -n. A fixed-point iteration starts from n = n_1, or from normal_near() if
  /// the line along n_1 misses the surface. @p opposed is the smallest
  /// permitted cosine of the angle between n_1 and -n_2. The result is empty if
  /// the normals are not opposed, if @p other is farther than @p search_radius
  /// along n, or without convergence in 50 steps.
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
    /// Constructs the surface of @p obstacle, which must not be null.
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
