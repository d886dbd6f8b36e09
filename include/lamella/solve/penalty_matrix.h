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
  /// A rank-one term w b_of^T b_on of the penalty stiffness, with weight w and
  /// the gradients b_of and b_on of two gaps or slips. The penalty on one gap
  /// or slip has of = on; with friction, terms couple slip `of` to gap `on`.
  struct PenaltyTerm
  {
    /// Number of the gap or slip with gradient b_of, see GapConstraints.
    unsigned int of;
    unsigned int on; ///< Number of the gap or slip with gradient b_on.
    /// Weight w, a stiffness [force / length].
    double weight;

    /// Returns true if `of`, `on` and `weight` are equal.
    bool
    operator==(const PenaltyTerm &other) const
    {
      return of == other.of && on == other.on && weight == other.weight;
    }
  };

  /// Matrix of the Newton step (Eqs. 22, 23 of Nagaraj et al. 2020) of a scene,
  ///   K + K^p,   K^p = B_A^T diag(1/d) B_A,
  /// in the free DoFs, with the stiffness K of a TangentOperator, the gradients
  /// B_A of the active gaps, and their compliances d [length / force]. With
  /// friction it is not symmetric (SparseInterfaceSystem).
  ///
  /// The sparsity pattern of the Trilinos matrix includes all constraints that
  /// were ever active. MUMPS factorizes it on all processes whenever K^p
  /// changes. Each process owns the matrix rows of a contiguous range of DoFs.
  /// Keeps references to its arguments. Collective.
  class PenaltyMatrix
  {
  public:
    /// Assembles the stiffness of @p tangent_operator, which needs no linear
    /// solvers, for the contact constraints @p rows.
    PenaltyMatrix(const TangentOperator &tangent_operator,
                  const GapConstraints  &rows,
                  const Symmetry         symmetry);

    /// Factorizes the matrix with the new penalty @p terms. Throws
    /// NumericsError if it is indefinite or, with friction, singular.
    void
    factorize(const std::vector<PenaltyTerm> &terms);

    /// Returns the sign of the determinant of the last factorization.
    int
    sign_of_determinant() const
    {
      return factor->sign_of_determinant();
    }

    /// Returns sum(b_i^2 / K_ii), with the entries b_i of the gap or slip @p
    /// number and the diagonal of K: an estimate of the local compliance of the
    /// bodies [length / force].
    double
    local_compliance(const unsigned int number) const;

    /// Returns the solution for the load vector @p f in all DoFs, with the last
    /// factorization; it is zero in prescribed DoFs.
    BlockVector
    solve(BlockVector f) const;

    /// Returns the forces K @p w by the assembled stiffness without penalties,
    /// zero in prescribed DoFs, for displacements that are zero there.
    BlockVector
    apply(const BlockVector &w) const;

    /// Returns the indices of the contact constraints that the sparsity pattern
    /// includes. A restart needs them for the same elimination order.
    std::vector<unsigned int>
    known_rows() const;
    /// Includes contact constraints @p known_rows in the next sparsity pattern.
    void
    restore(const std::vector<unsigned int> &known_rows);

    /// Returns a warning if the largest penalty eps causes a relative error
    /// above 1e-4, by the estimate eps N t / k of Nour-Omid and Wriggers
    /// (1987): N DoFs, rounding t of doubles, body stiffness k at the
    /// constraint.
    std::vector<std::string>
    warnings() const;

  private:
    /// Returns the support constraints of all bodies, for the elimination of
    /// prescribed DoFs; DoFs are numbered body after body.
    Constraints
    constraints_of_all() const;
    /// Assembles the stiffness of bodies and springs in the free DoFs.
    void
    assemble_stiffness();
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
    /// Returns the matrix entries of this process; upper half if symmetric.
    MatrixEntries
                           entries() const;
    const TangentOperator &tangent_operator;
    const Structure       &structure;
    const GapConstraints   rows;
    const Symmetry         symmetry;
    /// Support constraints of all bodies.
    Constraints constraints;
    /// DoFs of this process, a contiguous range.
    dealii::IndexSet owned;
    /// Stiffness without and with penalties; matrix rows of this process.
    SharedMatrix stiffness, system;
    /// Diagonal of the stiffness without penalties, on each process.
    Vector diagonal;
    /// Factor of `system`; null until analyzed.
    std::unique_ptr<RepeatedFactorization> factor;
    /// Contact constraints in the pattern of `system`.
    std::set<unsigned int> known;
    /// Terms of the last factorization.
    std::vector<PenaltyTerm> factorized_for;
    bool                     is_factorized = false;

    /// Largest ratio of penalty to body stiffness; penalty [force / length].
    double largest_penalty_ratio = 0., penalty_of_largest_ratio = 0.;
  };
} // namespace lamella

#endif
