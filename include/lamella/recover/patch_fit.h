// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_patch_fit_h
#define lamella_recover_patch_fit_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Strain, stress and stress in ply axes, each six components (Voigt order).
  using FieldValues = dealii::Tensor<1, 18>;

  /// Strains and stresses at a superconvergent point of an element.
  struct PatchPoint
  {
    dealii::Point<3> position; ///< Undeformed position, scene axes [length].
    FieldValues      values;   ///< Strains and stresses at the position.
  };

  /// Least-squares polynomial through values at points, with a degree for each
  /// of three local coordinates. Terms are products of Legendre polynomials
  /// over the bounding box of the points, ordered by total degree. A term is
  /// omitted if less than a tenth of the vector of its values at the points is
  /// orthogonal to the terms before it. If none is omitted, polynomials of the
  /// given degrees are reproduced. A fit of m points and n terms costs m n^2
  /// operations (orthogonalization instead of normal equations).
  class PatchFit
  {
  public:
    /// Constructs a constant polynomial that has the @p values everywhere.
    explicit PatchFit(const FieldValues &values);

    /// Fits @p points in local coordinates along the columns of each of
    /// @p frames (edges of elements, of any length). The polynomial is the mean
    /// of these fits, so that it is independent of the order of the elements.
    /// It has (degrees[0] + 1) (degrees[1] + 1) (degrees[2] + 1) terms of at
    /// most degree degrees[d] in coordinate d.
    PatchFit(const std::vector<PatchPoint>           &points,
             const std::vector<dealii::Tensor<2, 3>> &frames,
             const std::array<unsigned int, 3>       &degrees);

    /// Returns the value of the polynomial at the point @p x (scene axes).
    FieldValues
    operator()(const dealii::Point<3> &x) const;

    /// Returns the number of polynomial terms that the fitted points determine.
    unsigned int
    rank() const
    {
      return n_terms;
    }

  private:
    /// Degrees of a product of three Legendre polynomials, one per coordinate.
    using Term = std::array<unsigned int, 3>;

    /// The fitted polynomial in the coordinates of one frame.
    struct Polynomial
    {
      /// Map to coordinates in which the box [-1, 1]^3 bounds the points.
      dealii::Tensor<2, 3> to_box;
      dealii::Point<3>     center;
      /// Terms by total degree, and their coefficients; 0 for omitted terms.
      std::vector<Term>        terms;
      std::vector<FieldValues> coefficients;

      /// Returns the values of all terms at the point @p x, scene axes.
      std::vector<double>
      basis(const dealii::Point<3> &x) const;

      /// Fits the coefficients to @p points. Returns the number of terms used.
      unsigned int
      fit(const std::vector<PatchPoint> &points);
    };

    /// Returns all terms up to @p degrees, ordered by total degree.
    static std::vector<Term>
    terms_of(const std::array<unsigned int, 3> &degrees);

    /// Returns a polynomial with the terms up to @p degrees on the bounding box
    /// of @p points in the coordinates of @p frame, without coefficients. The
    /// box may be flat along coordinates of degree 0.
    static Polynomial
    in_frame(const std::vector<PatchPoint>     &points,
             const dealii::Tensor<2, 3>        &frame,
             const std::array<unsigned int, 3> &degrees);

    /// Fitted polynomial of each frame; empty if this object is a constant.
    std::vector<Polynomial> polynomials;
    FieldValues             constant;
    unsigned int            n_terms = 1;
  };
} // namespace lamella

#endif
