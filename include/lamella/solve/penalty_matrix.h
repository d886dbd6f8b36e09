// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_penalty_matrix_h
#define lamella_solve_penalty_matrix_h

#include <lamella/base/linear_algebra.h>
#include <lamella/linear/factorisation.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/linearisation.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The matrix of the paper's Newton step (Eqs. 22 and 23): of a whole scene,
   *   K + K^p,   K^p = B_A^T diag(1/d) B_A,
   * with K of a Linearisation and the gap rows B_A that are active, each with
   * its softness d (a length over a force). Condensed by the supports.
   *
   * K and K^p are assembled through the supports' AffineConstraints into
   * Trilinos' matrix. Its pattern has room for all rows that were active so far
   * (room for all that might be is many times the fill) and is analysed when
   * others join; MUMPS factorises it on all processes whenever the active set
   * or the stiffening changes. Time and memory are those of a factor of the
   * whole scene. A hard penalty costs digits, as K drowns in the rounding of
   * K^p: warnings() tells how many.
   *
   * Collective: all processes call all functions. Each owns a contiguous part
   * of the DoFs of all bodies, the rows of its share of the matrix. Refers to
   * the structure and, through a view, to the rows.
   */
  class PenaltyMatrix
  {
  public:
    /// Assembles K of @p linearisation, which needs no solvers.
    PenaltyMatrix(const Linearisation &linearisation, const GapRows &rows);

    /// Factorises K + K^p of the rows @p active, if that is not what was
    /// factorised last. Throws LostDigits where it is not positive definite in
    /// doubles.
    void
    factorise(const std::vector<unsigned int> &active,
              const NumericalSoftness         &softness);

    /// (K + K^p)^-1 @p f of what was factorised last; forces @p f need not be
    /// condensed, and displacements are expanded, zero in what supports
    /// prescribe.
    BlockVector
    solve(BlockVector f) const;

    /// The rows that the pattern has room for, ascending: they decide in which
    /// order MUMPS eliminates.
    std::vector<unsigned int>
    known_rows() const;
    /// Makes room for @p known_rows when it is factorised next.
    void
    recall(const std::vector<unsigned int> &known_rows);

    /// A sentence if the hardest penalty so far leaves an error of more than
    /// 1e-4 by the estimate eps N t / k of Nour-Omid and Wriggers (1987; N
    /// DoFs, t the rounding of doubles), the reasoning behind Eq. 24
    /// (doc/penalty.md).
    std::vector<std::string>
    warnings() const;

  private:
    /// Those of the supports and theories of all bodies, u = G v, in the
    /// numbering of the scene: body after body.
    Constraints
    constraints_of_all() const;
    /// K of all bodies with their springs, condensed.
    void
    assemble_stiffness(const Linearisation &linearisation);
    /// Diagonal entries of eliminated DoFs become the largest of all others;
    /// keeps the diagonal.
    void
    fill_diagonal();
    /// Makes room in K + K^p for the rows @p active, too; drops the factor and
    /// its symbolic analysis if some of them are new.
    void
    make_room(const std::vector<unsigned int> &active);
    /// Adds what the gap row @p row makes of K^p, b^T b / d (Eq. 23 with the
    /// row b in the place of n), at the softness d = @p softness_of_row.
    void
    add_penalty(const GapRow &row, const double softness_of_row);
    /// The upper half of this process's entries of K + K^p, as triplets counted
    /// from 1: what MUMPS takes of a symmetric matrix.
    UpperTriangle
    upper_triangle() const;
    /// Keeps the hardest of the penalties of @p active over what the DoFs of
    /// the row offer, k = 1 / sum(b_i^2 / K_ii).
    void
    measure_hardness(const std::vector<unsigned int> &active,
                     const NumericalSoftness         &softness);

    const Structure &structure;
    const GapRows    rows;
    /// constraints_of_all().
    Constraints constraints;
    /// Of a process: a contiguous part of the DoFs of all bodies.
    dealii::IndexSet owned;
    /// K, and K + K^p of the last active set; this process's rows of each.
    SharedMatrix stiffness, system;
    /// That of K, whole on each process.
    Vector diagonal;
    /// Of `system`; null until it is analysed.
    std::unique_ptr<RepeatedFactorisation> factor;
    /// The rows that `system` has room for.
    std::set<unsigned int> known;
    /// What `factor` was made for: rows and stiffening.
    std::vector<unsigned int> factorised_for;
    double                    factorised_with = 0.;
    bool                      is_factorised   = false;

    /// The largest eps / k so far, a number, and its eps (force / length).
    double hardest = 0., hardest_penalty = 0.;
  };
} // namespace lamella

#endif
