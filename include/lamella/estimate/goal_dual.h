// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_goal_dual_h
#define lamella_estimate_goal_dual_h

#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <functional>
#include <optional>
#include <vector>

namespace lamella
{
  /// Dual solutions of goals on the factorization of a solved model. With its K
  /// and the gap rows B that are active at its last step,
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda,
  /// so that a load f and gaps s change the goal J by f . z - nu . s.
  class GoalDual
  {
  public:
    /// Vector of displacement DoFs and of forces of the active rows.
    struct Pair
    {
      BlockVector u;
      Vector      force;
    };

    /// Displacement that is 1 in a direction (0, 1, 2) at a support.
    using Influence =
      std::function<BlockVector(const unsigned int, const unsigned int)>;

    /// Refers to the solved @p model; @p influence is that of its supports by
    /// default. Collective, as all members.
    explicit GoalDual(const Simulation &model, Influence influence = {});
    /// Provides derivatives by the forces of @p rows, without solve().
    GoalDual(const Simulation &model, std::vector<unsigned int> rows);

    /// Returns J'_u, and J'_lambda of the active rows. Nothing for a jump, a
    /// moment, pressure, width and strips of a contact, and with friction. Of
    /// recovered stresses it is that of the elements' own.
    std::optional<Pair>
    derivative(const NamedQuantity &goal) const;

    /// Returns w, to be subtracted from z in changes of J from one space to
    /// another: for a force of a support, whose derivative K w has a w of each
    /// space's own, that w. (With L w of the poorer space and the change e of
    /// u, which vanishes at supports, J changes by a(e, (1 - L)(z - w)).)
    std::optional<BlockVector>
    lifting(const NamedQuantity &goal) const;

    /// Returns z and nu, with one step of iterative refinement.
    Pair
    solve(const Pair &derivative) const;

    /// Returns the rows that are active at the last step, or those given.
    const std::vector<unsigned int> &
    active_rows() const
    {
      return active;
    }

    /// Returns the influence of a support of @p structure.
    static BlockVector
    influence_of_support(const Structure   &structure,
                         const unsigned int support,
                         const unsigned int direction);

  private:
    Pair
    zero() const;
    /// Returns the number of the support that @p goal is a force of.
    unsigned int
    support_of(const NamedQuantity &goal) const;
    /// Returns the derivative of a column of a probe.
    std::optional<Pair>
    at_probe(const NamedQuantity &goal) const;
    /// Returns the derivative of a support's force component: w . (f_int - t f
    /// - B^T lambda) with the displacement w that is 1 there.
    std::optional<Pair>
    of_support(const NamedQuantity &goal) const;
    std::optional<Pair>
    of_contact(const NamedQuantity &goal) const;
    std::optional<Pair>
    of_measure(const NamedQuantity &goal) const;

    const Simulation         &model;
    Influence                 influence;
    std::vector<unsigned int> active;
  };
} // namespace lamella

#endif
