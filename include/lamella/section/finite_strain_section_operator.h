// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_finite_strain_section_operator_h
#define lamella_section_finite_strain_section_operator_h

#include <lamella/section/finite_strain.h>
#include <lamella/section/section_operator.h>

#include <functional>
#include <vector>

namespace lamella
{
  /**
   * The total Lagrangian operator of a section with finite rotations, by the
   * points of the section. The displacement gradient has sums over fields,
   *   H_x = q Phi_,x,   H_y = q' Phi,   H_z = q Phi_,z.
   * Green's strain E and the second Piola-Kirchhoff stress S = C E of small
   * strains give, per length of the beam (over the undeformed section)
   *   energy = int E . C E / 2 dA,   W = int dE/dq^T S dA,
   *   dW/dq = int (dE/dq)^T C dE/dq + S_ij (dH_i/dq)^T dH_j/dq dA.
   * The matrices at q = 0 are those of SectionOperator.
   *
   * Bending has degree 2 in elements of degree 3, and the squares in E_yy have
   * degree 4. Terms that cannot cancel cause locking and stress oscillations,
   * so E_yy is an assumed strain of degree 2. The part of degree 3 of its
   * values at the stations (Gauss weights w_k of sum 1) is subtracted,
   *   E_k - l_k sum_m w_m l_m E_m,   l_k = sqrt(7) P_3 at station k,
   * which is zero for strains that are linear in q.
   *
   * For sections whose strains are those of their displacements: LE, TE-2 and
   * up. Fields of LE are sparse; the derivative comes cell by cell. Refers to
   * the space.
   */
  class FiniteStrainSectionOperator
  {
  public:
    /// Constructs the operator for @p n_stations stations per element. The
    /// section completes no strains (StrainCompletion); the space has no modes.
    FiniteStrainSectionOperator(const SectionSpace &space,
                                const unsigned int  n_stations);

    /// Returns the forces on all fields, at the stations @p q of an element.
    SectionForces
    forces(const FieldParts &q) const;

    /// Returns the largest values over the points, or of means over the
    /// section, and over the stations of @p q.
    Stretch
    largest(const FieldParts &q) const;

    /// Returns the fields of each cell, in the order of for_each_cell().
    std::vector<const std::vector<unsigned int> *>
    fields_of_cells() const;

    /// Derivative of the work at the points of a cell, symmetric: rows for each
    /// value, then each derivative of its fields.
    struct CellTangent
    {
      const std::vector<unsigned int> *fields = nullptr;
      dealii::LAPACKFullMatrix<double> matrix;
      /// Rows dE_yy/dq, one per point, and the weight times
      ///   (C dE/dq)_yy - C_yyyy dE_yy/dq / 2.
      dealii::LAPACKFullMatrix<double> stretch, on_stretch;
    };

    /// Calls @p use with the tangents of each cell, one for each station @p q
    /// of an element, after the @p correction (predicted_strain()). X is the
    /// sum over the stations of w_k l_k stretch, Y that of w_k l_k on_stretch.
    /// The assumed strain subtracts Y^T X + X^T Y times the element's length.
    void
    for_each_cell(
      const FieldParts                                            &q,
      const FieldParts                                            &correction,
      const std::function<void(const std::vector<CellTangent> &)> &use) const;

    /// Returns w_k l_k of station @p k.
    double
    share(const unsigned int k) const
    {
      return weights[k] * modes[k];
    }

    /// Calls @p use with the geometric part of the tangent of each cell, int
    /// S_ij (dH_i/dq)^T dH_j/dq dA, for the constant S that @p stress gives at
    /// a point of a cell.
    void
    for_each_cell_of_stress(
      const std::function<Voigt(const unsigned int, const dealii::Point<2> &)>
                                                     &stress,
      const std::function<void(const CellTangent &)> &use) const;

  private:
    struct Point
    {
      double           weight;
      ElasticLaw       law;
      unsigned int     cell;
      dealii::Point<2> position;
    };
    /// Points with the same fields, and the matrix G of H at them for unit
    /// values, then unit derivatives of each field: nine rows per point.
    struct Cell
    {
      const std::vector<unsigned int> *fields = nullptr;
      std::vector<Point>               points;
      dealii::LAPACKFullMatrix<double> G;
    };

    /// Reduces E_yy or S_yy in @p values at the stations to degree 2.
    void
    lower(std::vector<Voigt> &values) const;

    /// Returns the tangent at a station of @p cell for @p H and @p second
    /// stresses.
    static CellTangent
    tangent_at(const Cell                  &cell,
               const std::vector<Gradient> &H,
               const std::vector<Voigt>    &second);

    /// Returns at each station the first Piola-Kirchhoff stresses at the points
    /// of @p cell times their areas, from the gradients @p H. Adds the energy
    /// per length of each station to @p energy.
    std::vector<Vector>
    first_stresses(const Cell                               &cell,
                   const std::vector<std::vector<Gradient>> &H,
                   std::vector<double>                      &energy) const;

    /// Returns int (dH/dq)^T D dH/dq dA over @p cell, D given by point.
    static CellTangent
    tangent_of(
      const Cell                                                    &cell,
      const std::function<dealii::Tensor<2, 9>(const unsigned int)> &D);

    /// Returns H at the points of @p cell for each station of @p q.
    std::vector<std::vector<Gradient>>
    gradients(const Cell &cell, const FieldParts &q) const;

    const SectionSpace &space;
    std::vector<Cell>   cells;
    std::vector<double> weights, modes;
  };
} // namespace lamella

#endif
