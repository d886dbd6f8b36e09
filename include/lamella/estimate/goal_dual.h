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
  /**
   * The dual solutions of goals on the factor that a solved model leaves
   * behind: with its K and the gap rows B that are active at its last step,
   *   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda,
   * so that what a load f and gaps s change of the goal J is f . z - nu . s.
   */
  class GoalDual
  {
  public:
    /// What is in the DoFs and, of the active rows, in their forces.
    struct Pair
    {
      BlockVector u;
      Vector      force;
    };

    /// The displacement that is 1 in a direction (0, 1, 2) where the support of
    /// a number holds.
    using Influence =
      std::function<BlockVector(const unsigned int, const unsigned int)>;

    /// @p model is solved and referred to. @p influence is its own unless
    /// another one is given. Collective, as all that follows.
    explicit GoalDual(const Simulation &model, Influence influence = {});
    /// The derivatives with respect to the forces of @p rows; solve() is not
    /// to be called.
    GoalDual(const Simulation &model, std::vector<unsigned int> rows);

    /// J'_u, and J'_lambda of the active rows; none for what has no derivative
    /// here: a jump, a moment, pressure, width and strips of a contact, and
    /// with friction anything, which depends on the steps before. Where
    /// stresses are recovered it is that of the elements' own.
    std::optional<Pair>
    derivative(const NamedQuantity &goal) const;

    /// What z is to be less in products that are to tell how J changes from one
    /// space to another: of a force or moment of a support, whose derivative
    /// K w itself has a w of each space's own, that w; nothing of others. (With
    /// L w that of the poorer space and e the change of u, which vanishes where
    /// supports hold, J changes by a(e, L w) = a(e, (1 - L)(z - w)).)
    std::optional<BlockVector>
    lifting(const NamedQuantity &goal) const;

    /// z and nu, refined once against what the strains say.
    Pair
    solve(const Pair &derivative) const;

    /// The rows that are active at the last step, or those that were given.
    const std::vector<unsigned int> &
    active_rows() const
    {
      return active;
    }

    /// That of a model's own supports.
    static BlockVector
    influence_of_support(const Structure   &structure,
                         const unsigned int support,
                         const unsigned int direction);

  private:
    Pair
    zero() const;
    /// The number of the support that @p goal is a force of.
    unsigned int
    support_of(const NamedQuantity &goal) const;
    /// Of a column of a probe.
    std::optional<Pair>
    at_probe(const NamedQuantity &goal) const;
    /// Of a component of what a support does: w (f_int - t f - B^T lambda)
    /// with the displacement w that is 1 where the support holds.
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
