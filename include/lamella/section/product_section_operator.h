// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_product_section_operator_h
#define lamella_section_product_section_operator_h

#include <lamella/section/section_operator.h>

#include <vector>

namespace lamella
{
  /// A section operator that multiplies coefficients q, q' by a dense matrix S,
  ///   [W_0; W_1] = [S_00, S_01; S_10, S_11] [q; q'],
  /// which is Section::moments() for TE-N, N > 1, and SectionSpace::dense_S()
  /// for lists of rigid functions and modes. With assumed shear strains, TE-N
  /// has three block rows and columns, those of Section::moments().
  ///
  /// To avoid cancellation in slender beams, the shear strain of deflection w
  /// and slope a, with the reference length h, is added before the product,
  ///   q_w' + q_a / h.
  /// The force on the slope q_a is that on this sum divided by h.
  class ProductSectionOperator : public SectionOperator
  {
  public:
    /// Computes S for the functions @p list. is_possible() must be true.
    ProductSectionOperator(const SectionSpace       &space,
                           std::vector<unsigned int> list,
                           const bool                assumed_shear);

    /// Returns whether dense matrices exist for all functions @p list.
    static bool
    is_possible(const SectionSpace              &space,
                const std::vector<unsigned int> &list,
                const bool                       assumed_shear);

    SectionForces
    forces(const FieldParts &q) const override;

    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// FieldPart of each block row: value and derivative, or all three.
    std::vector<unsigned int> parts;
    /// Matrix S with block columns in the order of the block rows.
    dealii::LAPACKFullMatrix<double> S;

    /// Returns the entry of functions @p a, @p b in block (@p p, @p q).
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// Returns the first row of FieldPart @p p. Without assumed shear strains,
    /// shear values have the rows of values.
    unsigned int
    first_row(const unsigned int p) const;

    /// Returns the entries of S_00, S_01, S_10, S_11 and of the shear part of
    /// S_00 for the functions @p a, @p b.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };
} // namespace lamella

#endif
