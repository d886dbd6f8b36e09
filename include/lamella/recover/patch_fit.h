// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_patch_fit_h
#define lamella_recover_patch_fit_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Strain, stress (order of Voigt), and stress in ply axes, six each.
  using FieldValues = dealii::Tensor<1, 18>;

  /// Values at a superconvergent point of an element of a patch, scene axes.
  struct PatchPoint
  {
    dealii::Point<3> position;
    FieldValues      values;
  };

  /// Least-squares polynomial through values at points, with a degree for each
  /// of three local coordinates. Terms are products of Legendre polynomials
  /// over the points' box, added by total degree. A term is omitted if less
  /// than a tenth of it at the points is linearly independent of previous
  /// terms. Polynomials that the points resolve are reproduced exactly. A fit
  /// of m points and n terms costs m n^2 operations, by orthogonalization and
  /// without normal equations. Outside the points' box it extrapolates.
  class PatchFit
  {
  public:
    /// Constructs the constant @p values.
    explicit PatchFit(const FieldValues &values);

    /// Fits @p points with local coordinates along the columns of @p frames,
    /// the edges of elements. The result is the mean of the fits in all frames,
    /// so it is independent of the elements' order. Terms have at most degree
    /// degrees[d] in coordinate d; there are (degrees[0] + 1)(degrees[1] +
    /// 1)(degrees[2] + 1). @p points and @p frames must not be empty. Columns
    /// of a frame are linearly independent, of any length.
    PatchFit(const std::vector<PatchPoint>           &points,
             const std::vector<dealii::Tensor<2, 3>> &frames,
             const std::array<unsigned int, 3>       &degrees);

    /// Returns the polynomial at @p x (scene axes), the mean over all frames.
    FieldValues
    operator()(const dealii::Point<3> &x) const;

    /// Returns the number of terms that the points determine.
    unsigned int
    rank() const
    {
      return n_terms;
    }

  private:
    /// Degrees of the Legendre polynomials in the three coordinates.
    using Term = std::array<unsigned int, 3>;

    /// The fitted polynomial in the coordinates of one frame.
    struct Polynomial
    {
      /// Map to coordinates in which the points fill the box [-1, 1]^3.
      dealii::Tensor<2, 3> to_box;
      dealii::Point<3>     center;
      /// Terms by total degree, with their coefficients; 0 if omitted.
      std::vector<Term>        terms;
      std::vector<FieldValues> coefficients;

      /// Returns the values of all terms at @p x.
      std::vector<double>
      basis(const dealii::Point<3> &x) const;

      /// Fits the coefficients. Returns the number of terms used.
      unsigned int
      fit(const std::vector<PatchPoint> &points);
    };

    /// Returns all terms up to @p degrees, ordered by total degree.
    static std::vector<Term>
    terms_of(const std::array<unsigned int, 3> &degrees);

    /// Returns a polynomial with the terms up to @p degrees and the box of
    /// @p points in the coordinates of @p frame. It may be flat along
    /// coordinates of degree 0.
    static Polynomial
    in_frame(const std::vector<PatchPoint>     &points,
             const dealii::Tensor<2, 3>        &frame,
             const std::array<unsigned int, 3> &degrees);

    /// Polynomials of the frames; none for a constant.
    std::vector<Polynomial> polynomials;
    FieldValues             constant;
    unsigned int            n_terms = 1;
  };
} // namespace lamella

#endif
