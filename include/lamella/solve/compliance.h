// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_compliance_h
#define lamella_solve_compliance_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/tangent_operator.h>

#include <vector>

namespace lamella
{
  /// The compliance of contact constraints, the Schur complement
  ///   C = B K^-1 B^T
  /// with the condensed stiffness K of each body and the constraint rows B
  /// included so far. C_ij [length / force] is the gap in constraint i due to a
  /// unit force in constraint j. C is symmetric, and positive definite if the
  /// constraints are independent. Slips are included like gaps, by their
  /// numbers (GapConstraints). With the Cholesky factor L of K, C = Y^T Y, Y =
  /// L^-1 B^T, where CHOLMOD computes only nonzeros. Memory: n (n + 1) / 2
  /// numbers for n constraints, and Y. Keeps references to the tangent operator
  /// and the constraints. include() is collective.
  class Compliance
  {
  public:
    /// Keeps references to both arguments, which must outlive this object;
    /// @p tangent_operator must have solvers.
    Compliance(const TangentOperator &tangent_operator,
               const GapConstraints  &rows);

    /// Includes the constraints @p wanted in the compliance. Those not yet
    /// included are solved for together, in each body on which they act.
    void
    include(const std::vector<unsigned int> &wanted);

    /// Returns the included constraints in one group per call of include(). The
    /// same calls reproduce the compliance bit for bit.
    const std::vector<std::vector<unsigned int>> &
    row_groups() const
    {
      return included;
    }

    /// Returns true if constraint @p row was included, as required below.
    bool
    is_included(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// Returns the change of gap @p row due to a unit force in it [length /
    /// force]; zero between supported points.
    double
    diagonal(const unsigned int row) const;

    /// Returns the submatrix of C for the constraints @p of, by columns.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// Returns K^-1 B^T lambda, the displacements due to the forces @p lambda
    /// in the distinct constraints @p of; zero in prescribed DoFs.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// Solutions K^-1 b^T for constraint rows b of a body; their rows in C.
    struct BodyConstraints
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const TangentOperator       &tangent_operator;
    const GapConstraints         rows;
    std::vector<BodyConstraints> bodies;

    /// Position of each constraint in C, and lower triangle of C by rows.
    std::vector<unsigned int>        place;
    std::vector<std::vector<double>> entries;

    std::vector<std::vector<unsigned int>> included;
  };
} // namespace lamella

#endif
