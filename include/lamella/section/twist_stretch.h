// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_twist_stretch_h
#define lamella_section_twist_stretch_h

#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// Returns the strain of a fiber at @p point of a section with the twist k,
  /// divided by k^2 / 2 [length^2]: the axial strain r^2, with the distance r
  /// from the centroid, and the lateral contraction of StrainCompletion.
  Voigt
  stretch_of_fiber(const Section &section, const SectionPoint &point);

  /// The second-order axial strain of a beam due to a twist k [rad / length]:
  /// fibers at the distance r from the centroid are inclined by k r and thus
  /// elongated (Wagner effect, 1929),
  ///   epsilon_2 = k^2 / 2 (r^2 e_yy + D_s v),
  /// where e_yy is a unit strain along y, D_s v the in-plane strain of the free
  /// contraction v, and S_00 v = -int D_s^T C e_yy r^2 dA with the elasticity
  /// matrix C and the section matrix S_00. With I_n = int r^n dA and I_p = I_2,
  /// this effect adds E (I_4 - I_p^2 / A) k^2 / 2 to the stiffness G J of a
  /// strip. It reduces G J of a column under the compression N by N I_p / A.
  /// Only for LE with a fine mesh. On one cell of LE-2, I_4 - I_p^2 / A is 19 %
  /// too large in a bar of 8 x 5 and 7 % in a strip of 30 x 0.8.
  class TwistStretch
  {
  public:
    /// Computes the strain from the Saint-Venant solutions of a section.
    explicit TwistStretch(const SaintVenant &states);

    /// Returns the second-order strain at @p point for k^2 / 2 = 1 [length^2].
    Voigt
    strain(const SectionPoint &point) const;

    /// Returns the generalized forces of the second-order strain for k^2 / 2 =
    /// 1 [force length^2], conjugate to the axial derivatives of amplitudes of
    /// section functions. The forces conjugate to the amplitudes are zero.
    const std::vector<double> &
    work() const
    {
      return on_derivatives;
    }

    /// Returns int e . C e dA of the second-order strain e at k^2 / 2 = 1
    /// [force length^4], with the elasticity matrix C.
    double
    stiffness() const
    {
      return square;
    }

    /// Returns the coefficient c [length^2] of the torque M = G J k (1 + c k^2)
    /// due to the second-order strain, for a beam that is free to stretch.
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
