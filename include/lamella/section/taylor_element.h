// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_taylor_element_h
#define lamella_section_taylor_element_h

#include <lamella/section/cross_section_element.h>

namespace lamella
{
  /// The Taylor expansion TE-N of a cross-section (Eq. 2 of Nagaraj et al.
  /// 2020): all polynomials of x and z up to degree N over the whole section,
  /// (N + 1)(N + 2) / 2 functions (equivalent single layer). Strains are
  /// continuous at ply interfaces, so transverse stresses jump.
  ///
  /// The first three functions are 1, (x - x_c)/h, (z - z_c)/h. Since monomials
  /// x^i z^j are nearly linearly dependent for N >= 8, the other functions are
  /// polynomials that are orthonormal over the section of area A,
  ///   1/A int F_tau F_sigma dA = delta,
  /// by the Arnoldi process (Brubeck, Nakatsukasa and Trefethen, Vandermonde
  /// with Arnoldi, SIAM Review 63, 2021). Each new polynomial is x or z times
  /// an earlier polynomial, orthogonalized to all earlier ones. The same
  /// recurrence evaluates the functions at any point, with x and z scaled to
  /// [-1, 1] over the bounding box.
  ///
  /// Integrals use the Gauss points of the section, exact for straight-sided
  /// cells. An evaluation takes O(N^3) operations.
  class TaylorElement : public CrossSectionElement
  {
  public:
    /// Constructs TE-N of @p degree N >= 1 on @p mesh. Polynomials that are
    /// linearly dependent on earlier ones up to a relative 1e-10 are dropped.
    TaylorElement(const std::shared_ptr<const SectionMesh> &mesh,
                  const unsigned int                        degree);

    unsigned int
    degree() const override
    {
      return order;
    }

    /// Returns the polynomial degree of the functions along a side: N if
    /// straight, else min(3 N, N + 8), since x and z are cubic on curved sides.
    unsigned int
    trace_degree() const override;
    /// Returns the number of Gauss points per direction of a cell: N + 1 if
    /// sides are straight, N + 9 if any side is curved.
    unsigned int
    n_gauss_points() const override
    {
      return gauss_points;
    }

    /// Returns (N + 1)(N + 2) / 2 minus the number of dropped polynomials.
    unsigned int
    n_functions() const override
    {
      return recurrence.size();
    }

    /// Returns the indices of all functions, as each extends over all cells.
    const std::vector<unsigned int> &
    cell_functions(const unsigned int) const override
    {
      return functions;
    }

    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    /// Returns N + 1 Gauss-Lobatto points on each boundary side, each vertex
    /// once. Weights are integrals of the points' Lagrange polynomials.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// Returns approximate Fekete points (interpolation points of the section,
    /// as many as functions). They are selected from the Gauss-Lobatto points
    /// of the cells by pivoted Cholesky factorization of V V^T, where V has the
    /// values of the orthonormal polynomials at all candidates.
    std::vector<EdgePoint>
    section_points() const override;

    /// Returns the Gauss-Lobatto points of all cells, N + 1 per direction.
    /// Weights [length^2] of points common to several cells are summed.
    std::vector<EdgePoint>
    section_grid() const override;

  private:
    /// Recurrence of an orthonormal polynomial: the product of coordinate
    /// `direction` (0 for x, 1 for z) and polynomial number `parent`, minus the
    /// polynomials from number `first` on times `parts`; divided by `norm`. The
    /// product is orthogonal to those before `first`. Number 0 is the constant
    /// 1.
    struct Step
    {
      /// Indices as described above, and the degree of the polynomial.
      unsigned int        parent = 0, direction = 0, degree = 0, first = 0;
      std::vector<double> parts;
      double              norm = 1.;
    };

    /// Returns x and z scaled to [-1, 1] over the section's bounding box.
    dealii::Point<2>
    scaled(const dealii::Point<2> &position) const;

    /// Computes the orthonormal polynomials at @p position and their gradients.
    void
    evaluate_polynomials(const dealii::Point<2>            &position,
                         std::vector<double>               &values,
                         std::vector<dealii::Tensor<1, 2>> &gradients) const;

    /// Computes the integration points, with weights that sum to one.
    void
    collect_points(std::vector<dealii::Point<2>> &points,
                   std::vector<double>           &weights) const;

    /// Computes the recurrence: polynomials of each degree are x times all
    /// polynomials of one degree less, and z times the last of these.
    void
    orthonormalize();

    /// Adds the polynomial from @p parent and @p direction to the recurrence
    /// and its values to @p values, unless it depends on earlier polynomials.
    void
    add_polynomial(const unsigned int                   parent,
                   const unsigned int                   direction,
                   const std::vector<dealii::Point<2>> &points,
                   const std::vector<double>           &weights,
                   std::vector<std::vector<double>>    &values);

    /// Degree N, and number of Gauss points per direction.
    unsigned int order, gauss_points;
    /// Center and half side lengths of the bounding box [length].
    dealii::Point<2>     middle;
    dealii::Tensor<1, 2> half;
    std::vector<Step>    recurrence;
    /// Indices of all polynomials: 0, 1, ..., n_functions() - 1.
    std::vector<unsigned int> functions;
  };
} // namespace lamella

#endif
