// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_ellipse_foot_h
#define lamella_shape_ellipse_foot_h

#include <deal.II/base/point.h>

namespace lamella
{
  /**
   * An ellipse with axes along x and z as the surface that a wall follows: of
   * any point its foot, the nearest point of the ellipse, and how deep inside
   * of it the point lies. With the parameter phi the ellipse is
   *   E(phi) = centre + (a cos phi, b sin phi),
   * its outward normal n = (b cos phi, a sin phi) over its length. Curves at a
   * constant depth are parallel to it, and no ellipses unless a = b.
   */
  class EllipseFoot
  {
  public:
    /// With the semi-axes @p a along x and @p b along z, both positive
    /// [length].
    EllipseFoot(const dealii::Point<2> &centre, const double a, const double b)
      : centre(centre)
      , a(a)
      , b(b)
    {}

    /// The parameter of the foot of @p x, in (-pi, pi]. Unique for points less
    /// deep than the smallest radius of curvature, min(a, b)^2 / max(a, b); of
    /// a circle the polar angle. By Newton's method for (x - E) . E' = 0, held
    /// between the axes of the quadrant, where it has one root.
    double
    parameter(const dealii::Point<2> &x) const;

    /// E(@p phi).
    dealii::Point<2>
    point(const double phi) const;

    /// n at E(@p phi), a unit vector (n_x, n_z).
    dealii::Tensor<1, 2>
    normal(const double phi) const;

  private:
    dealii::Point<2> centre;
    double           a, b;
  };
} // namespace lamella

#endif
