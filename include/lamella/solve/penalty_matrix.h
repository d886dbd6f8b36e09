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
  /// A term of the penalty stiffness K^p, weight times b_of^T b_on with the
  /// rows of two gaps or slips: the penalty of a single gap or slip (of = on),
  /// or the coupling of a gap and a slip by friction.
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

  /// Matrix of the Newton step of the paper (Eqs. 22 and 23) for a whole scene,
  ///   K + K^p,   K^p = B_A^T diag(1/d) B_A,
  /// condensed by the supports, with the stiffness K of a TangentOperator and
  /// the rows B_A of the active constraints, each with its compliance d [length
  /// / force]. With friction it is not symmetric (FrictionNewton).
  ///
  /// K and K^p are assembled through the supports' AffineConstraints into a
  /// Trilinos matrix. Its pattern includes all constraints that were ever
  /// active and is analyzed again when constraints are added. MUMPS factorizes
  /// it on all processes whenever the terms of K^p change. A hard penalty costs
  /// digits, since K is lost in the rounding of K^p: see warnings(). Each
  /// process owns a contiguous part of the DoFs of all bodies, and these matrix
  /// rows. Keeps references to structure and constraints. Collective.
  class PenaltyMatrix
  {
  public:
    /// Assembles K of @p tangent_operator, which needs no solvers.
    PenaltyMatrix(const TangentOperator &tangent_operator,
                  const GapConstraints  &rows);

    /// Factorizes K + K^p with the new @p terms of K^p. Throws NumericsError if
    /// it is not positive definite or, with friction, singular.
    void
    factorize(const std::vector<PenaltyTerm> &terms);

    /// Returns the sign of the determinant of the last factorization.
    int
    sign_of_determinant() const
    {
      return factor->sign_of_determinant();
    }

    /// Returns (K + K^p)^-1 @p f with the last factorization; zero in
    /// prescribed DoFs. The forces @p f need not be condensed.
    BlockVector
    solve(BlockVector f) const;

    /// Returns the constraints in the pattern, which affect MUMPS's order.
    std::vector<unsigned int>
    known_rows() const;
    /// Includes the constraints @p known_rows in the next pattern.
    void
    restore(const std::vector<unsigned int> &known_rows);

    /// Returns a warning if the hardest penalty eps up to now leaves a relative
    /// error above 1e-4 by the estimate eps N t / k of Nour-Omid and Wriggers
    /// (1987), the basis of Eq. 24, with N DoFs, the rounding t of doubles and
    /// the stiffness k behind the constraint.
    std::vector<std::string>
    warnings() const;

  private:
    /// Returns the constraints u = G v of all bodies, numbered body after body.
    Constraints
    constraints_of_all() const;
    /// Assembles K of all bodies with their springs, condensed by the supports.
    void
    assemble_stiffness(const TangentOperator &tangent_operator);
    /// Sets diagonal entries of eliminated DoFs to the largest diagonal entry.
    void
    fill_diagonal();
    /// Includes the constraints of @p terms with their slips in the pattern.
    /// New constraints invalidate the factor and its symbolic analysis.
    void
    extend_pattern(const std::vector<PenaltyTerm> &terms);
    /// Adds @p term to K^p (Eq. 23 with the constraint row b for n).
    void
    add_penalty(const PenaltyTerm &term);
    /// Returns this process's entries for MUMPS, the upper half if symmetric.
    MatrixEntries
    entries() const;
    /// Updates the hardest penalty of @p terms relative to the stiffness k = 1
    /// / sum(b_i^2 / K_ii) behind the constraint with row b.
    void
    update_penalty_ratio(const std::vector<PenaltyTerm> &terms);

    const Structure     &structure;
    const GapConstraints rows;
    const Symmetry       symmetry;
    /// Constraints u = G v of all bodies.
    Constraints constraints;
    /// DoFs of this process, a contiguous part of those of all bodies.
    dealii::IndexSet owned;
    /// K, and K + K^p of the last active set; the matrix rows of this process.
    SharedMatrix stiffness, system;
    /// Diagonal of K, whole on each process.
    Vector diagonal;
    /// Factor of `system`; null until analyzed.
    std::unique_ptr<RepeatedFactorization> factor;
    /// Constraints in the pattern of `system`.
    std::set<unsigned int> known;
    /// Terms of the last factorization.
    std::vector<PenaltyTerm> factorized_for;
    bool                     is_factorized = false;

    /// Largest ratio eps / k up to now, and its penalty eps [force / length].
    double largest_penalty_ratio = 0., penalty_of_largest_ratio = 0.;
  };
} // namespace lamella

#endif
