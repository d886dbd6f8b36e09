// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_penalty_matrix_h
#define lamella_solve_penalty_matrix_h

#include <lamella/base/linear_algebra.h>
#include <lamella/linear/factorization.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/tangent_operator.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// A term of K^p, weight times b_of^T b_on: the penalty of a gap or slip, or
  /// a frictional coupling within a row.
  struct PenaltyTerm
  {
    /// Numbers of gaps or slips (GapConstraints).
    unsigned int of, on;
    /// Weight [force / length].
    double weight;

    bool
    operator==(const PenaltyTerm &other) const
    {
      return of == other.of && on == other.on && weight == other.weight;
    }
  };

  /**
   * The matrix of the paper's Newton step (Eqs. 22 and 23) of a whole scene,
   *   K + K^p,   K^p = B_A^T diag(1/d) B_A,
   * condensed by the supports, with K of a TangentOperator and the active rows
   * B_A, each with its compliance d (length over force). With friction, terms
   * couple gaps and slips, and the matrix is not symmetric (FullStrategy).
   *
   * K and K^p are assembled through the supports' AffineConstraints into a
   * Trilinos matrix. Its pattern includes all rows that were ever active and is
   * analyzed again when others join. MUMPS factorizes it on all processes
   * whenever the terms change. A hard penalty costs digits, as K drowns in the
   * rounding of K^p: see warnings(). Each process owns a contiguous part of the
   * DoFs of all bodies, and these matrix rows. Refers to the structure and
   * views the contact rows. Collective.
   */
  class PenaltyMatrix
  {
  public:
    /// Assembles K of @p tangent_operator, which needs no solvers.
    PenaltyMatrix(const TangentOperator &tangent_operator,
                  const GapConstraints  &rows);

    /// Factorizes K + K^p of new @p terms. Throws NumericsError if it is not
    /// positive definite in doubles or, with friction, singular.
    void
    factorize(const std::vector<PenaltyTerm> &terms);

    /// Returns the sign of the last determinant (RepeatedFactorization).
    int
    sign_of_determinant() const
    {
      return factor->sign_of_determinant();
    }

    /// Returns (K + K^p)^-1 @p f of the last factorization, zero in prescribed
    /// DoFs. The forces @p f need not be condensed.
    BlockVector
    solve(BlockVector f) const;

    /// Returns the rows in the pattern, which affect MUMPS's elimination order.
    std::vector<unsigned int>
    known_rows() const;
    /// Includes @p known_rows in the pattern of the next factorization.
    void
    restore(const std::vector<unsigned int> &known_rows);

    /// Returns a sentence if the hardest penalty so far leaves an error above
    /// 1e-4 by the estimate eps N t / k of Nour-Omid and Wriggers (1987; N
    /// DoFs, t the rounding of doubles), the basis of Eq. 24.
    std::vector<std::string>
    warnings() const;

  private:
    /// Returns the constraints u = G v of all bodies, numbered body after body.
    Constraints
    constraints_of_all() const;
    /// Assembles K of all bodies with their springs, condensed.
    void
    assemble_stiffness(const TangentOperator &tangent_operator);
    /// Sets diagonal entries of eliminated DoFs to the largest of all others.
    void
    fill_diagonal();
    /// Includes the rows of @p terms with their slips in the pattern; new ones
    /// drop the factor and its symbolic analysis.
    void
    extend_pattern(const std::vector<PenaltyTerm> &terms);
    /// Adds @p term to K^p (Eq. 23 with the row b in the place of n).
    void
    add_penalty(const PenaltyTerm &term);
    /// Returns this process's entries for MUMPS, the upper half if symmetric.
    MatrixEntries
    entries() const;
    /// Updates the hardest penalty of @p terms relative to its row's stiffness
    /// k = 1 / sum(b_i^2 / K_ii).
    void
    update_penalty_ratio(const std::vector<PenaltyTerm> &terms);

    const Structure     &structure;
    const GapConstraints rows;
    const Symmetry       symmetry;
    /// constraints_of_all().
    Constraints constraints;
    /// DoFs of this process, a contiguous part of those of all bodies.
    dealii::IndexSet owned;
    /// K, and K + K^p of the last active set; this process's rows of each.
    SharedMatrix stiffness, system;
    /// Diagonal of K, whole on each process.
    Vector diagonal;
    /// Factor of `system`; null until analyzed.
    std::unique_ptr<RepeatedFactorization> factor;
    /// Rows in the pattern of `system`.
    std::set<unsigned int> known;
    /// Terms that were factorized last.
    std::vector<PenaltyTerm> factorized_for;
    bool                     is_factorized = false;

    /// Largest eps / k so far, and its eps (force / length).
    double largest_penalty_ratio = 0., penalty_of_largest_ratio = 0.;
  };
} // namespace lamella

#endif
