// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_product_section_operator_h
#define lamella_section_product_section_operator_h

#include <lamella/section/section_operator.h>

#include <vector>

namespace lamella
{
  /// A section operator that multiplies amplitudes q of section functions and
  /// derivatives q' by a dense matrix,
  ///   [W_0; W_1] = [S_00, S_01; S_10, S_11] [q; q'],
  /// where W_0 and W_1 are work-conjugate to q and q'. The matrix is computed
  /// from Section::moments() for TE-N, N > 1, and from SectionSpace::dense_S()
  /// for rigid functions and modes. With assumed shear strains, TE-N has a
  /// third block row and column for transverse shear.
  ///
  /// To avoid cancellation in slender beams, the shear strain q_w' + q_a / h of
  /// deflection w and slope a, with the reference length h, is summed before
  /// the matrix is applied. The force Q conjugate to this sum is added to the
  /// force on q_w', and Q / h to that on q_a.
  class ProductSectionOperator : public SectionOperator
  {
  public:
    /// Computes the matrix for the functions number @p fields of @p space, with
    /// assumed shear strains if @p assumed_shear. Requires is_possible().
    ProductSectionOperator(const SectionSpace       &space,
                           std::vector<unsigned int> fields,
                           const bool                assumed_shear);

    /// Returns true if dense matrices exist for the functions number @p fields:
    /// TE-N with N > 1, or rigid functions and modes without @p assumed_shear.
    static bool
    is_possible(const SectionSpace              &space,
                const std::vector<unsigned int> &fields,
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

    /// Returns the matrix entry of functions @p a, @p b for parts @p p, @p q.
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// Returns the first row in S of FieldPart @p p. Without assumed shear
    /// strains, FieldPart::shear_value has the rows of FieldPart::value.
    unsigned int
    first_row(const unsigned int p) const;

    /// Returns the entries of S_00, S_01, S_10, S_11 and of the transverse
    /// shear part of S_00 for the functions @p a, @p b.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };
} // namespace lamella

#endif
