// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_twist_stretch_h
#define lamella_section_twist_stretch_h

#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// How a fibre at @p point is stretched that twist tilts, r^2 = |X - X_c|^2
  /// times a unit stretch of the axis, completed as the theory demands
  /// [length^2].
  Voigt
  stretch_of_fibre(const Section &section, const SectionPoint &point);

  /**
   * What a twist k [rad / length] stretches: fibres off the axis are tilted by
   * k r, and so longer by half its square (Wagner 1929),
   *
   *   epsilon_2 = k^2 / 2 (r^2 e_yy + D_s v),
   *
   * where r is the distance from the centre of area and v what makes the
   * section contract as it likes, S_00 v = -int D_s^T C e_yy r^2 dA. That is
   * what stiffens a twisted strip, by E (I_4 - I_p^2 / A) k^2 / 2 on G J, and
   * what takes torsional stiffness from a column, N I_p / A. Of the section of
   * an LE, the finer the better: one cell of LE-2 has 19 % too much of I_4 -
   * I_p^2 / A in a bar of 8 x 5, and 7 % in a strip of 30 x 0.8.
   */
  class TwistStretch
  {
  public:
    explicit TwistStretch(const SaintVenant &states);

    /// epsilon_2 at @p point for k^2 / 2 = 1 [length^2].
    Voigt
    strain(const SectionPoint &point) const;

    /// int D_y^T C epsilon_2 dA of each field [force length^2]: what it does on
    /// derivatives of fields. On their values, which v has relaxed, it does
    /// nothing.
    const std::vector<double> &
    work() const
    {
      return on_derivatives;
    }

    /// int epsilon_2 . C epsilon_2 dA [force length^4].
    double
    stiffness() const
    {
      return square;
    }

    /// The c of M = G J k (1 + c k^2) that this makes about the torsion centre,
    /// with the shears that go with it, alone and with the axis free to be as
    /// long as it likes (stiffening_by_shape()).
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
