// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_compliance_h
#define lamella_solve_compliance_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/structure.h>

#include <map>
#include <vector>

namespace lamella
{
  /**
   * The compliance of gap rows,
   *   C = B K^-1 B^T = Y^T Y,  Y = L^-1 P B^T,
   * for those rows that were asked for so far: only the forward half of a
   * solution is computed, for several rows at a time.
   */
  class Compliance
  {
  public:
    /// Both are referred to; @p structure must be factorised.
    Compliance(const Structure &structure, const std::vector<GapRow> &rows);

    /// Makes the compliance of @p wanted rows known.
    void
    include(const std::vector<unsigned int> &wanted);

    /// The gap that a unit force in row @p j opens in row @p i; both known.
    double
    operator()(const unsigned int i, const unsigned int j) const;

    /// K^-1 B^T lambda of the known rows @p of, expanded.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// One body's columns Y of the rows that touch it.
    struct BodyColumns
    {
      std::vector<Vector> y;
      /// Number of a gap row -> column of y.
      std::map<unsigned int, unsigned int> column;
    };

    /// y_i . y_j over all bodies.
    double
    product(const unsigned int row_i, const unsigned int row_j) const;

    const Structure           &structure;
    const std::vector<GapRow> &rows;
    std::vector<BodyColumns>   columns;

    /// The known rows, their place in the compliance, and its lower triangle by
    /// rows.
    std::vector<unsigned int>            known_rows;
    std::map<unsigned int, unsigned int> place;
    std::vector<std::vector<double>>     entries;
  };
} // namespace lamella

#endif
