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
  /// with the condensed stiffness K of each body and the rows B of all
  /// constraints added by include(). C_ij [length / force] is the gap in
  /// constraint i due to a unit force in constraint j; slips are constraints,
  /// too (see GapConstraints). C is symmetric, and positive definite if the
  /// constraints are independent. Memory: n (n + 1) / 2 numbers for n
  /// constraints, and the nonzeros of L^-1 B^T (Cholesky factor L of K).
  class Compliance
  {
  public:
    /// Keeps references to both arguments, which must outlive this object;
    /// @p tangent_operator must have factorized the stiffnesses of all bodies.
    Compliance(const TangentOperator &tangent_operator,
               const GapConstraints  &rows);

    /// Adds the constraints with the indices @p wanted to the compliance, by
    /// one solution per body for all that have not been added before.
    void
    include(const std::vector<unsigned int> &wanted);

    /// Returns the indices of the constraints added by each call of include().
    /// A repetition of these calls reproduces the compliance bit for bit.
    const std::vector<std::vector<unsigned int>> &
    row_groups() const
    {
      return included;
    }

    /// Returns true if constraint @p row has been added by include().
    bool
    is_included(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// Returns the change of the gap of constraint @p row due to a unit force
    /// in it [length / force]; zero if the force acts on supported points only.
    double
    diagonal(const unsigned int row) const;

    /// Returns the compliance matrix of the constraints @p of, by columns.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// Returns the displacements K^-1 B^T lambda due to the forces @p lambda in
    /// the distinct constraints @p of. They are zero in prescribed DoFs.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// Solutions K^-1 b^T for the constraint rows b of one body, and the index
    /// of each row in the compliance matrix.
    struct BodyConstraints
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const TangentOperator       &tangent_operator;
    const GapConstraints         rows;
    std::vector<BodyConstraints> bodies;

    /// Index of each constraint in C, and lower triangle of C by rows.
    std::vector<unsigned int>        place;
    std::vector<std::vector<double>> entries;

    std::vector<std::vector<unsigned int>> included;
  };
} // namespace lamella

#endif
