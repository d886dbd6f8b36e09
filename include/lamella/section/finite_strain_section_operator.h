// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_finite_strain_section_operator_h
#define lamella_section_finite_strain_section_operator_h

#include <lamella/section/finite_strain.h>
#include <lamella/section/section_operator.h>

#include <functional>
#include <optional>
#include <vector>

namespace lamella
{
  /// Computes section forces and tangent stiffness of a total Lagrangian beam
  /// by integration over a section. The displacement gradient (H_i: derivative
  /// by x_i) follows from section functions Phi with amplitudes q(y),
  ///   H_x = q Phi_,x,   H_y = q' Phi,   H_z = q Phi_,z.
  /// With the Green-Lagrange strain E and the stress S = C E (small strains),
  /// the energy, the forces W and the tangent per length are
  ///   energy = int E . C E / 2 dA,   W = int dE/dq^T S dA,
  ///   dW/dq = int (dE/dq)^T C dE/dq + S_ij (dH_i/dq)^T dH_j/dq dA.
  /// At q = 0, the tangent equals the linear stiffness of SectionOperator.
  ///
  /// To avoid membrane locking, E_yy is an assumed strain of degree 2 along
  /// elements of degree 3. The component of degree 3 is subtracted from the
  /// values E_k at the Gauss points k (stations) with weights w_k of sum 1,
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

    /// Returns the generalized forces at the Gauss points (stations) of an axis
    /// element, conjugate to @p q, amplitudes of section functions and their
    /// derivatives.
    SectionForces
    forces(const FieldParts &q) const;

    /// Returns the largest rotation and strains over the section and the Gauss
    /// points (stations) of an axis element with amplitudes @p q.
    Stretch
    largest(const FieldParts &q) const;

    /// Returns the station and the first section point with det F <= 0 in an
    /// axis element with amplitudes @p q, if there is one.
    std::optional<std::pair<unsigned int, dealii::Point<2>>>
    inverted_point(const FieldParts &q) const;

    /// Returns the indices of the section functions that are nonzero on each
    /// cell. Cells are in the order of for_each_cell().
    std::vector<const std::vector<unsigned int> *>
    fields_of_cells() const;

    /// Tangent matrix of one section cell at one station of the axis.
    struct CellTangent
    {
      /// Indices of the section functions that are nonzero on the cell.
      const std::vector<unsigned int> *fields = nullptr;
      /// Symmetric tangent. Rows are the amplitudes q of these functions, then
      /// their derivatives q' along the axis.
      dealii::LAPACKFullMatrix<double> matrix;
      dealii::LAPACKFullMatrix<double>
        stretch,    ///< Row dE_yy/dq for each integration point.
        on_stretch; ///< Rows weight ((C dE/dq)_yy - C_yyyy dE_yy/dq / 2).
    };

    /// Calls @p use for each section cell with its tangents at the Gauss points
    /// (stations) of an axis element with amplitudes @p q. @p correction is the
    /// last Newton correction of q (see predicted_strain()). For the assumed
    /// strain, the caller must subtract (Y^T X + X^T Y) times the element's
    /// length from its tangent, where X and Y are the sums over the stations k
    /// of share(k) times `stretch` and `on_stretch`.
    void
    for_each_cell(
      const FieldParts                                            &q,
      const FieldParts                                            &correction,
      const std::function<void(const std::vector<CellTangent> &)> &use) const;

    /// Returns w_k l_k (see the class) at station @p k: Gauss weight times
    /// sqrt(7) P_3, with the Legendre polynomial P_3, for the assumed strain.
    double
    share(const unsigned int k) const
    {
      return weights[k] * modes[k];
    }

    /// Calls @p use for each section cell with its geometric stiffness int S_ij
    /// (dH_i/dq)^T dH_j/dq dA due to the given stress S = @p stress(cell,
    /// point), such as that of temperatures. H_i is the derivative of
    /// displacements by x_i.
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
    /// Integration points with the same nonzero section functions. The matrix G
    /// = dH/d(q, q') has nine rows per point.
    struct Cell
    {
      const std::vector<unsigned int> *fields = nullptr;
      std::vector<Point>               points;
      dealii::LAPACKFullMatrix<double> G;
    };

    /// Subtracts the component of degree 3 along the axis from the yy
    /// components of @p values, strains or stresses at the stations.
    void
    lower(std::vector<Voigt> &values) const;

    /// Returns the tangent of @p cell at one station for the gradients @p H and
    /// the @p second Piola-Kirchhoff stresses at its points.
    static CellTangent
    tangent_at(const Cell                  &cell,
               const std::vector<Gradient> &H,
               const std::vector<Voigt>    &second);

    /// Returns first Piola-Kirchhoff stresses times integration weights for
    /// each station and point of @p cell, from the displacement gradients @p H.
    /// Adds the energy per length at each station to @p energy.
    std::vector<Vector>
    first_stresses(const Cell                               &cell,
                   const std::vector<std::vector<Gradient>> &H,
                   std::vector<double>                      &energy) const;

    /// Returns int (dH/dq)^T D dH/dq dA over @p cell, with D = @p D(point).
    static CellTangent
    tangent_of(
      const Cell                                                    &cell,
      const std::function<dealii::Tensor<2, 9>(const unsigned int)> &D);

    /// Returns the displacement gradients at each station and point of @p cell.
    std::vector<std::vector<Gradient>>
    gradients(const Cell &cell, const FieldParts &q) const;

    const SectionSpace &space;
    std::vector<Cell>   cells;
    std::vector<double> weights, modes;
  };
} // namespace lamella

#endif
