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
   * independent of the number of points: for TE-N, N > 1, whose fields live on
   * all cells, from Section::moments(), and for dense lists (SectionSpace),
   * from SectionSpace::dense_S(). With assumed shear strains of TE-N the matrix
   * has three rows and columns of blocks, those of Section::moments().
   *
   * Strains come first: q' of the deflection and q / h of the slope, h the
   * section's reference length, shear a section alike and are added,
   *   q_w' + q_a / h,
   * before the product; the work on the slope is that on the sum.
   */
  class ProductSectionOperator : public SectionOperator
  {
  public:
    /// Computes the matrix, (2 or 3 times the list)^2 numbers. Requires
    /// is_possible().
    ProductSectionOperator(const SectionSpace       &space,
                           std::vector<unsigned int> list,
                           const bool                assumed_shear);

    /// Returns true if there are products of all fields of @p list for the
    /// parts that the axis distinguishes.
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

    /// Returns the entry of the block (@p p, @p q) for the fields @p a and @p b
    /// of the list.
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// Returns the row of part @p p of the first field of the list; shear
    /// values share the rows of values if these are one part.
    unsigned int
    first_row(const unsigned int p) const;

    /// Returns S_00, S_01, S_10, S_11 and the shear part of S_00 for the fields
    /// @p a and @p b of the list.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };
} // namespace lamella

#endif
