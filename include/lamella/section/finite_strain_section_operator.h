// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_finite_strain_section_operator_h
#define lamella_section_finite_strain_section_operator_h

#include <lamella/section/finite_strain.h>
#include <lamella/section/section_operator.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// Computes section forces and tangent stiffness of a total Lagrangian beam
  /// by integration over a section. The displacement gradient (H_i: derivative
  /// by x_i) follows from section functions Phi with coefficients q(y),
  ///   H_x = q Phi_,x,   H_y = q' Phi,   H_z = q Phi_,z.
  /// With Green's strain E, the second Piola-Kirchhoff stress S = C E (small
  /// strains) and the undeformed section, the energy, the forces W and the
  /// tangent per length of the beam are
  ///   energy = int E . C E / 2 dA,   W = int dE/dq^T S dA,
  ///   dW/dq = int (dE/dq)^T C dE/dq + S_ij (dH_i/dq)^T dH_j/dq dA.
  /// At q = 0, the tangent equals the linear stiffness of SectionOperator.
  ///
  /// In axis elements of degree 3, the linear part of E_yy has degree 2 and the
  /// quadratic part degree 4, which causes membrane locking and stress
  /// oscillations. Therefore E_yy is an assumed strain of degree 2: the
  /// component of degree 3 of its values at the stations, the Gauss points of
  /// an element with weights w_k of sum 1, is subtracted,
  ///   E_k - l_k sum_m w_m l_m E_m,   l_k = sqrt(7) P_3 at station k,
  /// with the Legendre polynomial P_3. Strains linear in q are not changed.
  ///
  /// Only for theories without StrainCompletion: LE and TE-N, N > 1. Keeps a
  /// reference to the SectionSpace.
  class FiniteStrainSectionOperator
  {
  public:
    /// Constructs the operator for @p n_stations Gauss points (stations) per
    /// axis element. @p space must have section functions only, no modes.
    FiniteStrainSectionOperator(const SectionSpace &space,
                                const unsigned int  n_stations);

    /// Returns the section forces conjugate to all section functions at the
    /// stations of an axis element with the coefficients @p q.
    SectionForces
    forces(const FieldParts &q) const;

    /// Returns the largest rotation and strains over the section and the
    /// stations of an element with the coefficients @p q.
    Stretch
    largest(const FieldParts &q) const;

    /// Returns the functions of each cell, in the order of for_each_cell().
    std::vector<const std::vector<unsigned int> *>
    fields_of_cells() const;

    /// Symmetric tangent of one section cell. Rows and columns are the
    /// coefficients q of the functions of the cell, then their derivatives q'.
    struct CellTangent
    {
      const std::vector<unsigned int> *fields = nullptr;
      dealii::LAPACKFullMatrix<double> matrix;
      /// For each integration point a row dE_yy/dq, and the weight times
      ///   (C dE/dq)_yy - C_yyyy dE_yy/dq / 2.
      dealii::LAPACKFullMatrix<double> stretch, on_stretch;
    };

    /// Calls @p use for each section cell with its tangents at the stations of
    /// an axis element with the coefficients @p q and their last @p correction
    /// (see predicted_strain()). To account for the assumed strain, the caller
    /// must subtract (Y^T X + X^T Y) times the element's length: X is the sum
    /// of share(k) stretch and Y of share(k) on_stretch over the stations k.
    void
    for_each_cell(
      const FieldParts                                            &q,
      const FieldParts                                            &correction,
      const std::function<void(const std::vector<CellTangent> &)> &use) const;

    /// Returns the factor w_k l_k of station @p k in the assumed strain.
    double
    share(const unsigned int k) const
    {
      return weights[k] * modes[k];
    }

    /// Calls @p use for each section cell with its geometric stiffness int S_ij
    /// (dH_i/dq)^T dH_j/dq dA, for the stress S = @p stress(cell, point).
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
    /// Integration points with the same section functions, and the matrix G =
    /// dH/d(q, q') at these points, nine rows per point.
    struct Cell
    {
      const std::vector<unsigned int> *fields = nullptr;
      std::vector<Point>               points;
      dealii::LAPACKFullMatrix<double> G;
    };

    /// Subtracts the component of degree 3 from the yy component of @p values,
    /// strains or stresses at the stations.
    void
    lower(std::vector<Voigt> &values) const;

    /// Returns the tangent of @p cell at one station for the gradients @p H and
    /// the @p second Piola-Kirchhoff stresses.
    static CellTangent
    tangent_at(const Cell                  &cell,
               const std::vector<Gradient> &H,
               const std::vector<Voigt>    &second);

    /// Returns for each station the first Piola-Kirchhoff stresses times the
    /// integration weights at the points of @p cell, from the displacement
    /// gradients @p H. Adds the energy per length at each station to @p energy.
    std::vector<Vector>
    first_stresses(const Cell                               &cell,
                   const std::vector<std::vector<Gradient>> &H,
                   std::vector<double>                      &energy) const;

    /// Returns int (dH/dq)^T D dH/dq dA over @p cell, with @p D at a point.
    static CellTangent
    tangent_of(
      const Cell                                                    &cell,
      const std::function<dealii::Tensor<2, 9>(const unsigned int)> &D);

    /// Returns displacement gradients at the points of @p cell by station.
    std::vector<std::vector<Gradient>>
    gradients(const Cell &cell, const FieldParts &q) const;

    const SectionSpace &space;
    std::vector<Cell>   cells;
    std::vector<double> weights, modes;
  };
} // namespace lamella

#endif
