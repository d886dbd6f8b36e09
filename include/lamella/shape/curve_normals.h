// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_curve_normals_h
#define lamella_shape_curve_normals_h

#include <lamella/shape/section_mesh.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /// Closest-point projection onto the elliptical outer surface of a tube,
  ///   E(phi) = center + (a cos phi, b sin phi),
  /// with the outward unit normal n = (b cos phi, a sin phi) / |...|. Curves at
  /// a constant depth below the surface are ellipses only if a = b.
  class EllipseProjection
  {
  public:
    /// Constructs the ellipse with semi-axes @p a along x and @p b along z.
    EllipseProjection(const dealii::Point<2> &center,
                      const double            a,
                      const double            b)
      : center(center)
      , a(a)
      , b(b)
    {}

    /// Returns the parameter phi in (-pi, pi] of the point E(phi) of the
    /// ellipse closest to @p x, by Newton's method for (x - E) . E' = 0 within
    /// a quadrant. phi is unique if @p x is less deep below the ellipse than
    /// the smallest radius of curvature, min(a, b)^2 / max(a, b).
    double
    parameter(const dealii::Point<2> &x) const;

    /// Returns center + (a cos phi, b sin phi), a point of the ellipse.
    dealii::Point<2>
    point(const double phi) const;

    /// Returns the outward unit normal (n_x, n_z) at the parameter @p phi.
    dealii::Tensor<1, 2>
    normal(const double phi) const;

  private:
    dealii::Point<2> center;
    double           a, b;
  };

  /// The outward unit normals n of some boundaries of a section, extended to
  /// all points x of the section: n(x) = n(p) at the nearest boundary point p
  /// for which n(p) is parallel to x - p. Along a boundary edge, n is linear.
  /// At a vertex, the normals of both edges are averaged unless they differ by
  /// more than 30 degrees.
  class CurveNormals
  {
  public:
    /// Collects the edges of the boundaries @p names of @p section.
    CurveNormals(const SectionMesh              &section,
                 const std::vector<std::string> &names);

    /// Returns the outward unit normal, extended from the boundaries to the
    /// point @p x of the section. All edges are searched.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const;

  private:
    struct Side
    {
      std::array<dealii::Point<2>, 2>     ends;
      std::array<dealii::Tensor<1, 2>, 2> normals;
    };
    std::vector<Side> sides;
  };
} // namespace lamella

#endif
