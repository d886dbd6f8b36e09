// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_taylor_element_h
#define lamella_section_taylor_element_h

#include <lamella/section/cross_section_element.h>
#include <lamella/shape/section_geometry.h>

namespace lamella
{
  /**
   * The Taylor expansion TE-N (Eq. 2): all polynomials of x and z up to degree
   * N, (N + 1)(N + 2) / 2 functions over the whole section.
   *
   * The functions beyond 1, x, z are not the monomials x^i z^j, which are
   * nearly dependent from N = 8 on, but polynomials that span the same space
   * and are orthonormal over the actual section,
   *   1/A int F_tau F_sigma dA = delta,
   * built by the Arnoldi process: each new polynomial is x or z times an
   * earlier one, less its parts along the earlier ones (twice), and points are
   * evaluated by the same recurrence (Brubeck, Nakatsukasa and Trefethen,
   * Vandermonde with Arnoldi, SIAM Review 63, 2021). x and z run from -1 to 1
   * over the section's bounding box there, so the functions have no units.
   *
   * The first three functions are 1, (x - x_c)/h, (z - z_c)/h as in every
   * expansion; they replace the first three polynomials, whose space is the
   * same. All functions live on all cells: an equivalent single layer, whose
   * strains are continuous across ply interfaces and whose transverse stresses
   * therefore jump there.
   *
   * The integrals above are those over the section's Gauss points, exact on
   * straight cells. The basis takes of the order of N^2 vectors over these
   * points; an evaluation of the order of N^3 operations.
   */
  class TaylorElement : public CrossSectionElement
  {
  public:
    /**
     * @p degree from 1. A polynomial that is a combination of the earlier ones
     * on this section to 1e-10 of its size is left out.
     *
     * Shares @p mesh.
     */
    TaylorElement(std::shared_ptr<const SectionMesh> mesh,
                  const unsigned int                 degree);

    unsigned int
    degree() const override
    {
      return order;
    }

    /// N on straight sides. On curved ones x and z are cubic in the side's
    /// parameter, so 3 N, but N + 8 at most: what is beyond is small.
    unsigned int
    trace_degree() const override;
    /// N + 1; eight more on curved cells, where the integrands are no
    /// polynomials of degree 2 N.
    unsigned int
    n_gauss_points() const override
    {
      return gauss_points;
    }

    /// (N + 1)(N + 2) / 2 less those that are left out.
    unsigned int
    n_functions() const override
    {
      return recurrence.size();
    }

    /// All of them, on every cell.
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

    /// A grid of degree() + 1 Gauss-Lobatto points a side of a cell. Sides that
    /// meet in a vertex share the point there. Weights are integrals of the
    /// grid's Lagrange polynomials along the side.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /**
     * As many points as functions, so chosen among the Gauss-Lobatto points of
     * the cells that the expansion is fixed by its values there (approximate
     * Fekete points: column-pivoted elimination).
     *
     * V the values of the orthonormal polynomials at the candidates: its rows
     * are chosen greedily, the one with the largest part across those before
     * it, as in a pivoted Cholesky factorisation of V V^T.
     */
    std::vector<EdgePoint>
    section_points() const override;

    /// The Gauss-Lobatto points of all cells, degree() + 1 a direction. Points
    /// on sides between cells count once, with the Gauss-Lobatto weights of all
    /// cells there [length^2].
    std::vector<EdgePoint>
    section_grid() const override;

  private:
    /**
     * How an orthonormal polynomial comes about: coordinate @p direction times
     * number @p parent, less @p parts of number @p first and the later ones,
     * over @p norm. It has no parts of those before @p first, of three degrees
     * less: <x p, q> = <p, x q>, and x q is of a lower degree than p.
     * Number 0 is the constant 1 and has no step. The polynomials are ordered
     * by degree.
     */
    struct Step
    {
      /// @p direction: 0 for x, 1 for z; @p degree is the polynomial's own.
      unsigned int        parent = 0, direction = 0, degree = 0, first = 0;
      std::vector<double> parts;
      double              norm = 1.;
    };

    /// x and z from -1 to 1.
    dealii::Point<2>
    scaled(const dealii::Point<2> &position) const;

    /// The orthonormal polynomials at @p position with their gradients. By the
    /// recurrence; gradients with respect to x and z [1 / length]. The vectors
    /// are overwritten.
    void
    evaluate_polynomials(const dealii::Point<2>            &position,
                         std::vector<double>               &values,
                         std::vector<dealii::Tensor<1, 2>> &gradients) const;

    /// The integration points of the section, with weights that sum to one.
    void
    collect_points(std::vector<dealii::Point<2>> &points,
                   std::vector<double>           &weights) const;

    /// Makes the recurrence: for each degree x times all polynomials of one
    /// degree less, and z times the last of these.
    void
    orthonormalise();

    /// The step from @p parent along @p direction, its values at all points
    /// appended to @p values, unless it depends on the earlier ones.
    void
    add_polynomial(const unsigned int                   parent,
                   const unsigned int                   direction,
                   const std::vector<dealii::Point<2>> &points,
                   const std::vector<double>           &weights,
                   std::vector<std::vector<double>>    &values);

    /// N; Gauss points a direction.
    unsigned int order, gauss_points;
    /// Of degree 3 where edges are curved, else bilinear.
    SectionGeometry geometry;
    /// Of the bounding box, and half its extensions [length].
    dealii::Point<2>     middle;
    dealii::Tensor<1, 2> half;
    std::vector<Step>    recurrence;
    /// 0 ... n_functions() - 1.
    std::vector<unsigned int> functions;
  };
} // namespace lamella

#endif
