// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_product_answer_h
#define lamella_section_product_answer_h

#include <lamella/section/section_answer.h>

#include <vector>

namespace lamella
{
  /**
   * By the products of whole fields, one dense matrix for all stations at once,
   *   [W_0; W_1] = [S_00, S_01; S_10, S_11] [q; q'],
   * whatever the number of the section's points: for the fields of TE-N, N > 1,
   * of which each lives on all cells, from Section::moments(), and for dense
   * lists (FieldSpace), from FieldSpace::dense_S(). Where TE-N has assumed
   * shear strains the matrix has three rows and columns of blocks, those of
   * Section::moments().
   *
   * Strain first here, too: the slope of a section shears it as the slope of
   * the axis does, so q' of the deflection and q / h of the slope are added,
   *   q_w' + q_a / h,   h the section's reference length,
   * before anything multiplies them, and the work on the slope is that on the
   * sum.
   */
  class ProductAnswer : public SectionAnswer
  {
  public:
    /// Gathers the matrix, (2 or 3 times the list)^2 numbers. is_possible() has
    /// to be true.
    ProductAnswer(const FieldSpace         &space,
                  std::vector<unsigned int> list,
                  const bool                assumed_shear);

    /// Whether there are products of all fields of @p list with the parts that
    /// the axis tells apart.
    static bool
    is_possible(const FieldSpace                &space,
                const std::vector<unsigned int> &list,
                const bool                       assumed_shear);

    SectionForces
    forces(const FieldParts &q) const override;

    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// Of each row of blocks the FieldPart it belongs to: value and derivative,
    /// or all three.
    std::vector<unsigned int> parts;
    /// The blocks, columns in the order of rows.
    dealii::LAPACKFullMatrix<double> S;

    /// The entry of the block of the parts @p p and @p q for the fields @p a
    /// and @p b of the list.
    double
    product(const unsigned int p,
            const unsigned int q,
            const unsigned int a,
            const unsigned int b) const;

    /// The row of the matrix that belongs to the part @p p of the first field
    /// of the list; where values are one part they are so in shear, too.
    unsigned int
    first_row(const unsigned int p) const;

    /// S_00, S_01, S_10, S_11 and the shear part of S_00 for the fields @p a
    /// and @p b of the list.
    std::array<double, 5>
    entries(const unsigned int a, const unsigned int b) const;
  };
} // namespace lamella

#endif
