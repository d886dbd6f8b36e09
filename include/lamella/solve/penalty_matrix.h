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
  /// A rank-one term w b_of^T b_on of the penalty stiffness. w is `weight`, and
  /// b_of and b_on are the derivatives of two gaps or slips with respect to the
  /// DoFs. The penalty on one gap or slip has of = on. With friction, terms
  /// couple the slip `of` to the gap `on`.
  struct PenaltyTerm
  {
    /// Numbers of the two gaps or slips (GapConstraints::constraint()).
    unsigned int of, on;
    /// Weight w [force / length].
    double weight;

    bool
    operator==(const PenaltyTerm &other) const
    {
      return of == other.of && on == other.on && weight == other.weight;
    }
  };

  /// Matrix of the Newton step of the paper (Eqs. 22 and 23) for a whole scene,
  ///   K + K^p,   K^p = B_A^T diag(1/d) B_A,
  /// in the free DoFs, with the stiffness K of a TangentOperator and the rows
  /// B_A of the active constraints, each with its compliance d [length /
  /// force]. With friction it is not symmetric (FrictionNewton).
  ///
  /// The sparsity pattern of the Trilinos matrix includes all constraints that
  /// were ever active. MUMPS factorizes it on all processes whenever the terms
  /// of K^p change. A hard penalty costs digits: see warnings(). Each process
  /// owns the matrix rows of a contiguous part of the DoFs. Keeps references to
  /// structure and constraints. Collective.
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

    /// Returns the contact constraints whose entries the sparsity pattern
    /// contains. A restarted run needs them for the same elimination order.
    std::vector<unsigned int>
    known_rows() const;
    /// Includes the constraints @p known_rows in the next sparsity pattern.
    void
    restore(const std::vector<unsigned int> &known_rows);

    /// Returns a warning if the hardest penalty eps up to now leaves a relative
    /// error above 1e-4 by the estimate eps N t / k of Nour-Omid and Wriggers
    /// (1987), the basis of Eq. 24, with N DoFs, the rounding t of doubles and
    /// the stiffness k behind the constraint.
    std::vector<std::string>
    warnings() const;

  private:
    /// Returns the support constraints of all bodies, which eliminate
    /// prescribed DoFs, with DoFs numbered body after body.
    Constraints
    constraints_of_all() const;
    /// Assembles the stiffness of bodies and springs in the free DoFs.
    void
    assemble_stiffness(const TangentOperator &tangent_operator);
    /// Sets diagonal entries of eliminated DoFs to the largest diagonal entry.
    void
    fill_diagonal();
    /// Includes the constraints of @p terms with their slips in the pattern.
    /// New constraints invalidate the factor and its symbolic analysis.
    void
    extend_pattern(const std::vector<PenaltyTerm> &terms);
    /// Adds the entries of @p term to `system`.
    void
    add_penalty(const PenaltyTerm &term);
    /// Returns this process's entries for MUMPS, the upper half if symmetric.
    MatrixEntries
    entries() const;
    /// Updates the largest ratio of a penalty in @p terms to the stiffness of
    /// the bodies behind its constraint, k = 1 / sum(b_i^2 / K_ii), with the
    /// entries b_i of the constraint row.
    void
    update_penalty_ratio(const std::vector<PenaltyTerm> &terms);

    const Structure     &structure;
    const GapConstraints rows;
    const Symmetry       symmetry;
    /// Support constraints of all bodies.
    Constraints constraints;
    /// DoFs of this process, a contiguous part of those of all bodies.
    dealii::IndexSet owned;
    /// K, and K + K^p of the last active set; the matrix rows of this process.
    SharedMatrix stiffness, system;
    /// Diagonal of K, whole on each process.
    Vector diagonal;
    /// Factor of `system`; null until analyzed.
    std::unique_ptr<RepeatedFactorization> factor;
    /// Contact constraints in the pattern of `system`.
    std::set<unsigned int> known;
    /// Terms of the last factorization.
    std::vector<PenaltyTerm> factorized_for;
    bool                     is_factorized = false;

    /// Largest ratio of penalty to stiffness; its penalty [force / length].
    double largest_penalty_ratio = 0., penalty_of_largest_ratio = 0.;
  };
} // namespace lamella

#endif
