// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_local_errors_h
#define lamella_estimate_local_errors_h

#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// @p errors of the elements of a coarser model by those of @p finer: each
  /// has its share of the one that it lies in.
  LocalErrors
  by_pairs(const LocalErrors &errors, const Simulation &finer);

  /**
   * Tells where the error of a goal comes from, by dual weighted residuals.
   * With u_H of the coarser model on the finer one's nodes, K, the gap rows B
   * and the forces lambda of the finer one, and the dual solution z, nu of the
   * goal J,
   *   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda   (active rows),
   * the difference of the two models is, to rounding,
   *   J(u_h) - J(u_H) = r . z - nu . s,
   *   r = t f + B^T l - f_int(u_H),   s = -(g(u_H) + a l),
   * whichever forces l stand in the rows; they are lambda, scaled to the
   * resultants of the coarser model. Of z its interpolant I z in the coarser
   * model is taken off, to which r is orthogonal but for contact, so that what
   * is left is local: the error of an element is the sum of r_k (z - I z)_k
   * over its nodes k, half of it where two elements share one.
   *
   * Both models have the same bodies; beams of the same section, whose axes
   * differ, and solids that are the same. Both are solved and referred to.
   * (Becker and Rannacher, Acta Numerica 10 (2001), sec. 3; deal.II's step-14.)
   */
  class Localisation
  {
  public:
    /// Whether bodies are what they have to be.
    static bool
    is_possible(const Simulation &coarse, const Simulation &fine);

    /// Collective, as is errors().
    Localisation(const Simulation &coarse, const Simulation &fine);

    /// Of the goal @p goal, whose values differ by @p change between the two.
    /// None for what has no derivative here (a jump, a moment, pressure, width
    /// and strips of a contact). Where stresses are recovered the derivative is
    /// that of the elements' own. One solution with the factor that is there.
    std::optional<LocalErrors>
    errors(const NamedQuantity &goal, const double change) const;

  private:
    /// The elements' part of the errors, r . (z - I z).
    LocalErrors
    of_elements(const BlockVector &z) const;

    /// Displacements of one model on the nodes of the other.
    BlockVector
    on_fine(const BlockVector &u) const;
    BlockVector
    on_coarse(const BlockVector &u) const;

    /// Adds the errors of the elements of @p body, of the products @p share of
    /// its DoFs.
    void
    add_elements(const unsigned int body,
                 const Vector      &share,
                 LocalErrors       &result) const;

    const Simulation &coarse, &fine;
    LoadFactor        factor;
    GoalDual          dual;
    BlockVector       residual;
    /// s of the active rows.
    Vector mismatch;
  };

  /// Of each of @p goals, those of @p run, where the model @p finer changes it;
  /// empty where Localisation is not possible.
  std::vector<std::optional<LocalErrors>>
  errors_of(const RunGoals   &goals,
            const Simulation &run,
            const Simulation &finer);
} // namespace lamella

#endif
