// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_twist_stretch_h
#define lamella_section_twist_stretch_h

#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// Returns the stretch of a fiber at @p point tilted by twist, |X - X_c|^2
  /// times a unit stretch of the axis, completed by the theory [length^2].
  Voigt
  stretch_of_fiber(const Section &section, const SectionPoint &point);

  /**
   * The stretch by a twist k [rad / length]: fibers off the axis are tilted by
   * k r, and longer by half its square (Wagner 1929),
   *   epsilon_2 = k^2 / 2 (r^2 e_yy + D_s v),
   * where r is the distance from the centroid and v the free contraction of the
   * section, S_00 v = -int D_s^T C e_yy r^2 dA. It stiffens a twisted strip, by
   * E (I_4 - I_p^2 / A) k^2 / 2 on G J, and reduces the torsional stiffness of
   * a column by N I_p / A. For sections of LE, preferably fine: one cell of
   * LE-2 has 19 % too much of I_4 - I_p^2 / A in a bar of 8 x 5, and 7 % in a
   * strip of 30 x 0.8.
   */
  class TwistStretch
  {
  public:
    explicit TwistStretch(const SaintVenant &states);

    /// Returns epsilon_2 at @p point for k^2 / 2 = 1 [length^2].
    Voigt
    strain(const SectionPoint &point) const;

    /// Returns the work on derivatives of each field, int D_y^T C epsilon_2 dA
    /// [force length^2]. The work on values is zero by v.
    const std::vector<double> &
    work() const
    {
      return on_derivatives;
    }

    /// Returns int epsilon_2 . C epsilon_2 dA [force length^4].
    double
    stiffness() const
    {
      return square;
    }

    /// Returns the c of M = G J k (1 + c k^2) from this stretch about the
    /// torsion center, with the length of the axis free
    /// (stiffening_by_shape()).
    double
    stiffening() const
    {
      return c;
    }

  private:
    double
    stiffening_of(const SaintVenant &states) const;

    const Section      &section;
    Vector              relaxation;
    std::vector<double> on_derivatives;
    double              square = 0., c = 0.;
  };
} // namespace lamella

#endif
