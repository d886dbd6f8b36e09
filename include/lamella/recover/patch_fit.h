// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_patch_fit_h
#define lamella_recover_patch_fit_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Strain, stress and stress in ply axes in a row, six components each. Each
  /// in its order of components (Eq. 4; 11, 22, 33, 12, 13, 23 in ply axes):
  /// what is fitted at once, since all have the same points.
  using FieldValues = dealii::Tensor<1, 18>;

  /// Sampled values at a point of a patch, scene axes: a superconvergent point
  /// of one of its elements.
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
   *
   * With m points and n terms a fit costs m n^2 operations, by
   * orthogonalisation of the terms' values at the points and not by normal
   * equations. It keeps coefficients only and refers to nothing. Values far
   * outside of the points' box are extrapolated.
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
     *
     * @p degrees along the columns of the frames: the terms are those of degree
     * degrees[d] at most in coordinate d, (degrees[0] + 1)(degrees[1] + 1)
     * (degrees[2] + 1) in all. @p points and @p frames are not empty; the
     * columns of a frame are linearly independent, their lengths do not matter.
     */
    PatchFit(const std::vector<PatchPoint>           &points,
             const std::vector<dealii::Tensor<2, 3>> &frames,
             const std::array<unsigned int, 3>       &degrees);

    /// The polynomial at @p x, scene axes; the mean of those of all frames.
    FieldValues
    operator()(const dealii::Point<3> &x) const;

    /// The number of terms that the points fix, in the poorest frame. 1 for the
    /// same values everywhere.
    unsigned int
    rank() const
    {
      return n_terms;
    }

  private:
    /// Degrees of the Legendre polynomials in the three coordinates.
    using Term = std::array<unsigned int, 3>;

    /// The fit in one frame.
    struct Polynomial
    {
      /// To coordinates in which the points fill the box [-1, 1]^3.
      dealii::Tensor<2, 3> to_box;
      dealii::Point<3>     centre;
      /// By total degree, and a coefficient of each; zero for those left out.
      std::vector<Term>        terms;
      std::vector<FieldValues> coefficients;

      /// The values of all terms at @p x.
      std::vector<double>
      basis(const dealii::Point<3> &x) const;

      /// Fits the coefficients; the number of terms taken in.
      unsigned int
      fit(const std::vector<PatchPoint> &points);
    };

    /// By total degree.
    static std::vector<Term>
    terms_of(const std::array<unsigned int, 3> &degrees);

    /// The terms and the box of @p points in the coordinates of @p frame, not
    /// yet fitted. Along coordinates of degree 0 the box need not have any
    /// extension.
    static Polynomial
    in_frame(const std::vector<PatchPoint>     &points,
             const dealii::Tensor<2, 3>        &frame,
             const std::array<unsigned int, 3> &degrees);

    /// One a frame; none for a constant, which is zero otherwise.
    std::vector<Polynomial> polynomials;
    FieldValues             constant;
    unsigned int            n_terms = 1;
  };
} // namespace lamella

#endif
