// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_compliance_h
#define lamella_solve_compliance_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/tangent_operator.h>

#include <vector>

namespace lamella
{
  /**
   * The compliance of contact constraints, the Schur complement
   *   C = B K^-1 B^T
   * of the rows included so far. C_ij is the gap in row i due to a unit force
   * in row j (length over force), with the condensed stiffness K of each body.
   * C is symmetric, and positive definite if the rows are independent. Slips
   * are rows like gaps, by their numbers (GapConstraints). CHOLMOD computes
   * only the nonzero part of the forward substitution: C = Y^T Y, Y = L^-1 P
   * B^T, K = P^T L L^T P. Memory: n (n + 1) / 2 numbers for n rows, and what
   * the solvers keep of each. Refers to the tangent operator and views the
   * rows. Collective where processes share a matrix, except for look-ups.
   */
  class Compliance
  {
  public:
    /// Refers to both arguments; @p tangent_operator must have solvers.
    Compliance(const TangentOperator &tangent_operator,
               const GapConstraints  &rows);

    /// Includes the @p wanted rows in the compliance, without cost if they are.
    /// Others are solved for together, in each body they act on.
    void
    include(const std::vector<unsigned int> &wanted);

    /// Returns the included rows, grouped by the calls that included them,
    /// which reproduce the compliance bit for bit.
    const std::vector<std::vector<unsigned int>> &
    row_groups() const
    {
      return included;
    }

    /// Returns true if @p row was included, as the functions below require.
    bool
    is_included(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// Returns C_rr, the gap due to a unit force in @p row [length / force];
    /// zero between supported points.
    double
    diagonal(const unsigned int row) const;

    /// Returns the n x n submatrix of C for the rows @p of, column by column.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// Returns K^-1 B^T lambda, the displacements due to the forces @p lambda
    /// in the distinct rows @p of, zero in prescribed DoFs.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// The solved rows of one body, with their positions in the compliance.
    struct BodyConstraints
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const TangentOperator       &tangent_operator;
    const GapConstraints         rows;
    std::vector<BodyConstraints> bodies;

    /// Position of each included row, and the lower triangle of C by rows.
    std::vector<unsigned int>        place;
    std::vector<std::vector<double>> entries;

    std::vector<std::vector<unsigned int>> included;
  };
} // namespace lamella

#endif
