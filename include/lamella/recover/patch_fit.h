// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_patch_fit_h
#define lamella_recover_patch_fit_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Strain, stress and stress in ply axes in a row, six components each.
  using FieldValues = dealii::Tensor<1, 18>;

  /// Values at a point of a patch.
  struct PatchPoint
  {
    dealii::Point<3> position;
    FieldValues      values;
  };

  /**
   * A polynomial through values at points by least squares, of a degree of its
   * own in each of three local coordinates.
   *
   * Terms (products of Legendre polynomials over the box of the points) are
   * taken in by total degree. One of which the points see less than a tenth
   * beside the terms before it is left out: two Gauss points across an element
   * tell no parabola from a constant, however the element is distorted. So
   * polynomials of the degrees that the points can tell are reproduced exactly.
   */
  class PatchFit
  {
  public:
    /// The same @p values everywhere.
    explicit PatchFit(const FieldValues &values);

    /**
     * Local coordinates run along the columns of @p frames, edges of the
     * elements. Where elements have different ones, a fit is made in each frame
     * and the result is their mean, which does not depend on the elements'
     * order.
     */
    PatchFit(const std::vector<PatchPoint>           &points,
             const std::vector<dealii::Tensor<2, 3>> &frames,
             const std::array<unsigned int, 3>       &degrees);

    FieldValues
    operator()(const dealii::Point<3> &x) const;

    /// The number of terms that the points fix, in the poorest frame.
    unsigned int
    rank() const
    {
      return n_terms;
    }

  private:
    using Term = std::array<unsigned int, 3>;

    /// The fit in one frame.
    struct Polynomial
    {
      /// To coordinates in which the points fill the box [-1, 1]^3.
      dealii::Tensor<2, 3>     to_box;
      dealii::Point<3>         centre;
      std::vector<Term>        terms;
      std::vector<FieldValues> coefficients;

      std::vector<double>
      basis(const dealii::Point<3> &x) const;

      /// Fits the coefficients; the number of terms taken in.
      unsigned int
      fit(const std::vector<PatchPoint> &points);
    };

    static Polynomial
    in_frame(const std::vector<PatchPoint>     &points,
             const dealii::Tensor<2, 3>        &frame,
             const std::array<unsigned int, 3> &degrees);

    std::vector<Polynomial> polynomials;
    FieldValues             constant;
    unsigned int            n_terms = 1;
  };
} // namespace lamella

#endif
