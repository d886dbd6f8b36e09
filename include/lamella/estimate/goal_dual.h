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
  /// Dual (adjoint) solutions of goals with the factorization of a solved
  /// model. With the stiffness K, the matrix B and the compliances a of the
  /// constraints that are active at the last step, the dual solution z, nu
  /// satisfies
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda,
  /// so that a load f and gaps s change the goal J by f . z - nu . s.
  class GoalDual
  {
  public:
    /// A vector of displacements with a vector of active constraints' forces.
    struct Pair
    {
      BlockVector u;
      Vector      force;
    };

    /// Returns a displacement field that is 1 in a direction (0, 1, 2) at a
    /// support, both given by number, to extract the force of this support.
    using Influence =
      std::function<BlockVector(const unsigned int, const unsigned int)>;

    /// Keeps a reference to the solved @p model; @p influence defaults to
    /// influence_of_support(). All functions are collective.
    explicit GoalDual(const Simulation &model, Influence influence = {});
    /// Provides derivatives by the forces of constraints @p rows; no solve().
    GoalDual(const Simulation &model, std::vector<unsigned int> rows);

    /// Returns the derivatives J'_u by displacements and J'_lambda by forces of
    /// active constraints. Empty for moments, jumps, with friction, and for
    /// pressure, width and strips of contacts. For recovered stresses, returns
    /// the derivative of element stresses.
    std::optional<Pair>
    derivative(const NamedQuantity &goal) const;

    /// Returns the displacement w to be subtracted from z in the change of a
    /// support force J between two spaces; none for other goals. J has the
    /// derivative K w with a different w in each space. (With interpolant L and
    /// change e of u, zero at supports, J changes by a(e, (1 - L)(z - w)).)
    std::optional<BlockVector>
    lifting(const NamedQuantity &goal) const;

    /// Returns z and nu, with one step of iterative refinement.
    Pair
    solve(const Pair &derivative) const;

    /// Returns the active constraints of the last step, or the given ones.
    const std::vector<unsigned int> &
    active_rows() const
    {
      return active;
    }

    /// Returns the displacement that is 1 in @p direction at @p support.
    static BlockVector
    influence_of_support(const Structure   &structure,
                         const unsigned int support,
                         const unsigned int direction);

  private:
    Pair
    zero() const;
    /// Returns the number of the support whose force is @p goal.
    unsigned int
    support_of(const NamedQuantity &goal) const;
    /// Returns the derivative of a column of a probe.
    std::optional<Pair>
    at_probe(const NamedQuantity &goal) const;
    /// Returns the derivative of a component of a support force, w . (f_int - t
    /// f - B^T lambda), with the displacement w that is 1 at the support.
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
