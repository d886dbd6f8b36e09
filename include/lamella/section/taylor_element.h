// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_taylor_element_h
#define lamella_section_taylor_element_h

#include <lamella/section/cross_section_element.h>
#include <lamella/shape/section_geometry.h>

namespace lamella
{
  /**
   * The Taylor expansion TE-N (Eq. 2): all polynomials of x and z up to degree
   * N, (N + 1)(N + 2) / 2 functions over the whole section (equivalent single
   * layer). Strains are continuous across ply interfaces, so transverse
   * stresses jump there.
   *
   * The first three functions are 1, (x - x_c)/h, (z - z_c)/h. Monomials x^i
   * z^j are nearly dependent from N = 8 on, so the other functions are
   * polynomials of the same space that are orthonormal over the actual section,
   *   1/A int F_tau F_sigma dA = delta,
   * by the Arnoldi process (Brubeck, Nakatsukasa and Trefethen, Vandermonde
   * with Arnoldi, SIAM Review 63, 2021). Each new polynomial is x or z times an
   * earlier one, less its parts along the earlier ones (twice). Points are
   * evaluated by the same recurrence, with x and z from -1 to 1 over the
   * section's bounding box.
   *
   * Integrals are over the section's Gauss points, exact on straight cells. The
   * basis takes of the order of N^2 vectors over these points; an evaluation of
   * the order of N^3 operations.
   */
  class TaylorElement : public CrossSectionElement
  {
  public:
    /// Constructs TE-N of @p degree N from 1 on @p mesh, which it shares. Drops
    /// polynomials that depend on earlier ones to 1e-10 of their size.
    TaylorElement(std::shared_ptr<const SectionMesh> mesh,
                  const unsigned int                 degree);

    unsigned int
    degree() const override
    {
      return order;
    }

    /// Returns N on straight sides; on curved ones, where x and z are cubic in
    /// the side's parameter, 3 N, but N + 8 at most.
    unsigned int
    trace_degree() const override;
    /// Returns N + 1; eight more on curved cells.
    unsigned int
    n_gauss_points() const override
    {
      return gauss_points;
    }

    /// Returns (N + 1)(N + 2) / 2 less the number of dropped polynomials.
    unsigned int
    n_functions() const override
    {
      return recurrence.size();
    }

    /// Returns all functions, on every cell.
    const std::vector<unsigned int> &
    cell_functions(const unsigned int) const override
    {
      return functions;
    }

    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const override
    {
      return geometry.map(cell, unit);
    }

    /// Returns degree() + 1 Gauss-Lobatto points per side, vertices shared.
    /// Weights are integrals of their Lagrange polynomials along the side.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// Returns as many points as functions, whose values determine the
    /// expansion, from the Gauss-Lobatto points of the cells (approximate
    /// Fekete points). The values V of the orthonormal polynomials at the
    /// candidates select them by pivoted Cholesky factorization of V V^T.
    std::vector<EdgePoint>
    section_points() const override;

    /// Returns the Gauss-Lobatto points of all cells, degree() + 1 per
    /// direction. Common points come once, with the Gauss-Lobatto weights of
    /// all cells there [length^2].
    std::vector<EdgePoint>
    section_grid() const override;

  private:
    /// Recurrence of an orthonormal polynomial: coordinate @p direction times
    /// number @p parent, less @p parts of numbers from @p first on, over
    /// @p norm. Parts before @p first vanish: <x p, q> = <p, x q>, and x q is
    /// of a lower degree than p. Number 0 is the constant 1 without a step.
    struct Step
    {
      /// Direction is 0 for x, 1 for z; @p degree is the polynomial's own.
      unsigned int        parent = 0, direction = 0, degree = 0, first = 0;
      std::vector<double> parts;
      double              norm = 1.;
    };

    /// Returns x and z scaled to [-1, 1].
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

    /// Computes the recurrence: x times all polynomials of one degree less, and
    /// z times the last of these.
    void
    orthonormalize();

    /// Adds the step from @p parent along @p direction and appends its values
    /// to @p values, unless it depends on earlier ones.
    void
    add_polynomial(const unsigned int                   parent,
                   const unsigned int                   direction,
                   const std::vector<dealii::Point<2>> &points,
                   const std::vector<double>           &weights,
                   std::vector<std::vector<double>>    &values);

    /// N, and Gauss points per direction.
    unsigned int order, gauss_points;
    /// Geometry of degree 3 if edges are curved, else bilinear.
    SectionGeometry geometry;
    /// Middle of the bounding box, and half its extensions [length].
    dealii::Point<2>     middle;
    dealii::Tensor<1, 2> half;
    std::vector<Step>    recurrence;
    /// Numbers 0 ... n_functions() - 1.
    std::vector<unsigned int> functions;
  };
} // namespace lamella

#endif
