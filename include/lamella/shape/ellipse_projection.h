// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_ellipse_projection_h
#define lamella_shape_ellipse_projection_h

#include <deal.II/base/point.h>

namespace lamella
{
  /// Closest-point projection onto the ellipse that a wall follows,
  ///   E(phi) = center + (a cos phi, b sin phi),
  /// with the outward normal n = (b cos phi, a sin phi) over its length. Curves
  /// at a constant depth are parallel to it, and no ellipses unless a = b.
  class EllipseProjection
  {
  public:
    /// Constructs an ellipse with semi-axes @p a along x and @p b along z.
    EllipseProjection(const dealii::Point<2> &center,
                      const double            a,
                      const double            b)
      : center(center)
      , a(a)
      , b(b)
    {}

    /// Returns the parameter of the closest point to @p x, in (-pi, pi], by
    /// Newton's method for (x - E) . E' = 0 within the quadrant. Unique at
    /// depths below the smallest radius of curvature, min(a, b)^2 / max(a, b).
    double
    parameter(const dealii::Point<2> &x) const;

    /// Returns E(@p phi).
    dealii::Point<2>
    point(const double phi) const;

    /// Returns the unit vector n = (n_x, n_z) at E(@p phi).
    dealii::Tensor<1, 2>
    normal(const double phi) const;

  private:
    dealii::Point<2> center;
    double           a, b;
  };
} // namespace lamella

#endif
