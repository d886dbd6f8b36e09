// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_compliance_h
#define lamella_solve_compliance_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/structure.h>

#include <vector>

namespace lamella
{
  /**
   * The compliance of gap rows,
   *   C = B K^-1 B^T,
   * for those rows that were asked for so far, many at a time. With CHOLMOD
   * only the forward half of a solution is computed, where it is not zero:
   * C = Y^T Y, Y = L^-1 P B^T.
   */
  class Compliance
  {
  public:
    /// Both are referred to; @p structure must be factorised.
    Compliance(const Structure &structure, const GapRows &rows);

    /// Makes the compliance of @p wanted rows known.
    void
    include(const std::vector<unsigned int> &wanted);

    /// The known rows, as they were included together: included again in these
    /// batches they have the same compliance to the last bit.
    const std::vector<std::vector<unsigned int>> &
    batches() const
    {
      return included;
    }

    bool
    knows(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// The gap that a unit force in the known row @p row opens there.
    double
    diagonal(const unsigned int row) const;

    /// The gaps that unit forces in each of the known rows @p of open in them:
    /// a symmetric matrix, column by column.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// K^-1 B^T lambda of the known rows @p of, expanded.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// One body's solved rows, and which gap rows they are of.
    struct BodyRows
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const Structure      &structure;
    const GapRows         rows;
    std::vector<BodyRows> bodies;

    /// The place of each row in the compliance, if it is known, and its lower
    /// triangle by rows.
    std::vector<unsigned int>        place;
    std::vector<std::vector<double>> entries;

    std::vector<std::vector<unsigned int>> included;
  };
} // namespace lamella

#endif
