// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_product_section_operator_h
#define lamella_section_product_section_operator_h

#include <lamella/section/section_operator.h>

#include <vector>

namespace lamella
{
  /**
   * A section operator by products of whole fields, one dense matrix for all
   * stations,
   *   [W_0; W_1] = [S_00, S_01; S_10, S_11] [q; q'],
   * from Section::moments() for TE-N, N > 1, and from SectionSpace::dense_S()
   * for dense lists. TE-N with assumed shear strains has three rows and columns
   * of blocks, those of Section::moments().
   *
   * Strains come first: q' of the deflection and q / h of the slope, with the
   * section's reference length h, are added before the product,
   *   q_w' + q_a / h.
   * The work on the slope is that on the sum.
   */
  class ProductSectionOperator : public SectionOperator
  {
  public:
    /// Computes the matrix. Requires is_possible().
    ProductSectionOperator(const SectionSpace       &space,
                           std::vector<unsigned int> list,
                           const bool                assumed_shear);

    /// Returns true if there are products of all fields of @p list.
    static bool
    is_possible(const SectionSpace              &space,
                const std::vector<unsigned int> &list,
                const bool                       assumed_shear);

    SectionForces
    forces(const FieldParts &q) const override;

    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// FieldPart of each row of blocks: value and derivative, or all three.
    std::vector<unsigned int> parts;
    /// Blocks, columns in the order of rows.
    dealii::LAPACKFullMatrix<double> S;

    /// Returns entry (@p a, @p b), fields of the list, of the block (@p p,
    /// @p q).
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// Returns the row of part @p p of the first field; shear values share the
    /// rows of values if these are one part.
    unsigned int
    first_row(const unsigned int p) const;

    /// Returns S_00, S_01, S_10, S_11 and the shear part of S_00 for @p a,
    /// @p b.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };
} // namespace lamella

#endif
