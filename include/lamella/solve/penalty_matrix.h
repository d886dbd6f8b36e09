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
  /// A term of K^p, weight times b_of^T b_on: of a gap or a slip with itself,
  /// where it is its penalty, or, where friction couples them, with another of
  /// the same row.
  struct PenaltyTerm
  {
    /// Numbers of gaps or slips (GapRows).
    unsigned int of, on;
    /// [force / length]
    double weight;

    bool
    operator==(const PenaltyTerm &other) const
    {
      return of == other.of && on == other.on && weight == other.weight;
    }
  };

  /**
   * The matrix of the paper's Newton step (Eqs. 22 and 23): of a whole scene,
   *   K + K^p,   K^p = B_A^T diag(1/d) B_A,
   * with K of a Linearisation and the gap rows B_A that are active, each with
   * its softness d (a length over a force). Condensed by the supports. With
   * friction there are terms between gaps and slips, and it is not symmetric
   * (FullStrategy).
   *
   * K and K^p are assembled through the supports' AffineConstraints into
   * Trilinos' matrix. Its pattern has room for all rows that were active so far
   * (room for all that might be is many times the fill) and is analysed when
   * others join; MUMPS factorises it on all processes whenever the terms
   * change. Time and memory are those of a factor of the whole scene. A hard
   * penalty costs digits, as K drowns in the rounding of K^p: warnings() tells
   * how many.
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

    /// Factorises K + K^p of @p terms, if that is not what was factorised last.
    /// Throws NumericsError where it is not positive definite in doubles or,
    /// with friction, singular.
    void
    factorise(const std::vector<PenaltyTerm> &terms);

    /// Of what was factorised last (RepeatedFactorisation).
    int
    sign_of_determinant() const
    {
      return factor->sign_of_determinant();
    }

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
    /// Makes room in K + K^p for the rows of @p terms, too, with their slips;
    /// drops the factor and its symbolic analysis if some of them are new.
    void
    make_room(const std::vector<PenaltyTerm> &terms);
    /// Adds @p term to K^p (Eq. 23 with the row b in the place of n).
    void
    add_penalty(const PenaltyTerm &term);
    /// This process's entries of K + K^p, the upper half of them if it is
    /// symmetric: what MUMPS takes.
    MatrixEntries
    entries() const;
    /// Keeps the hardest of the penalties among @p terms over what the DoFs of
    /// the row offer, k = 1 / sum(b_i^2 / K_ii).
    void
    measure_hardness(const std::vector<PenaltyTerm> &terms);

    const Structure &structure;
    const GapRows    rows;
    const Symmetry   symmetry;
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
    /// What `factor` was made for.
    std::vector<PenaltyTerm> factorised_for;
    bool                     is_factorised = false;

    /// The largest eps / k so far, a number, and its eps (force / length).
    double hardest = 0., hardest_penalty = 0.;
  };
} // namespace lamella

#endif
