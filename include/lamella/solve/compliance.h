// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_compliance_h
#define lamella_solve_compliance_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/linearisation.h>

#include <vector>

namespace lamella
{
  /**
   * The compliance of gap rows, the Schur complement of contact,
   *   C = B K^-1 B^T,
   * for those rows that were asked for so far, many at a time: C_ij is the gap
   * that a unit force in row j opens in row i, a length over a force, with the
   * condensed stiffness K of each body. It is symmetric, and positive definite
   * where rows are independent. A row adds the compliances of both of its
   * bodies; rows that share no body have none in common. Slips are rows here
   * as gaps are, by their numbers (GapRows).
   *
   * With CHOLMOD only the forward half of a solution is computed, where it is
   * not zero: C = Y^T Y, Y = L^-1 P B^T, K = P^T L L^T P.
   *
   * Memory: n (n + 1) / 2 numbers for n known rows, and what the solvers keep
   * of each row. Refers to the linearisation and its structure, and views the
   * rows. Where processes share a matrix, all of them call all functions that
   * are not a look-up, with the same arguments.
   */
  class Compliance
  {
  public:
    /// Both are referred to; @p linearisation must have solvers.
    Compliance(const Linearisation &linearisation, const GapRows &rows);

    /// Makes the compliance of @p wanted rows known; costs nothing for those
    /// that are. The others are solved for all at once, in each body that they
    /// touch, and multiplied with all known rows.
    void
    include(const std::vector<unsigned int> &wanted);

    /// The known rows, as they were included together: included again in these
    /// batches they have the same compliance to the last bit.
    const std::vector<std::vector<unsigned int>> &
    batches() const
    {
      return included;
    }

    /// Whether @p row was included. What follows asks for known rows only.
    bool
    knows(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// C_rr: the gap that a unit force in the known row @p row opens there, a
    /// length over a force. Zero for a row between points that supports hold.
    double
    diagonal(const unsigned int row) const;

    /// The gaps that unit forces in each of the known rows @p of open in them:
    /// the symmetric n x n matrix C of these, column by column, both triangles.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// K^-1 B^T lambda: what the forces @p lambda in the known rows @p of (one
    /// each, each row once) do to the displacements, expanded by G, so zero
    /// where supports prescribe. With CHOLMOD one backward half a body.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// One body's solved rows, and which gap rows they are of, by their places
    /// in the compliance.
    struct BodyRows
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const Linearisation  &linearisation;
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
