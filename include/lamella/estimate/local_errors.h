// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_local_errors_h
#define lamella_estimate_local_errors_h

#include <lamella/estimate/error_bar.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <functional>
#include <optional>
#include <vector>

namespace lamella
{
  /// Dual (adjoint) solutions of goals J, computed with the factorization of a
  /// solved model. K is the stiffness, B the matrix and a the compliances of
  /// the constraints that are active at the last load step. The dual
  /// displacements z and contact forces nu satisfy
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda,
  /// so that a load f and gaps s change J by f . z - nu . s. J'_u and J'_lambda
  /// are the derivatives by displacements and contact forces.
  class GoalDual
  {
  public:
    /// A dual solution, or a derivative of a goal, per DoF and constraint.
    struct Pair
    {
      BlockVector u;     ///< Component for each DoF.
      Vector      force; ///< Component for each active constraint.
    };

    /// Function that returns, for the index of a support and a direction (0, 1,
    /// 2), a virtual displacement that is 1 there; the work of the residual in
    /// this displacement is the support force.
    using Influence =
      std::function<BlockVector(const unsigned int, const unsigned int)>;

    /// Keeps a reference to the solved @p model. @p given defaults to
    /// influence_of_support(). All functions are collective.
    explicit GoalDual(const Simulation &model, Influence given = {});
    /// Constructs an object for derivatives by the forces of the constraints
    /// with indices @p rows, active or not. solve() must not be called.
    GoalDual(const Simulation &model, std::vector<unsigned int> rows);

    /// Returns the derivatives of @p goal by DoFs and contact forces. Empty
    /// optional for moments, jumps, pressure, width and strips of contacts, and
    /// with friction. Element stresses replace recovered stresses.
    std::optional<Pair>
    derivative(const NamedQuantity &goal) const;

    /// Returns the displacement w to be subtracted from the dual solution z to
    /// compute the change of a support force J between two spaces; empty for
    /// other goals. J has the derivative K w, with the stiffness K and a
    /// different w in each space. (With interpolant L and change e of u, zero
    /// at supports, J changes by a(e, (1 - L)(z - w)).)
    std::optional<BlockVector>
    lifting(const NamedQuantity &goal) const;

    /// Returns the dual solution of @p derivative, refined iteratively once.
    Pair
    solve(const Pair &derivative) const;

    /// Returns the indices of the constraints to which Pair::force refers.
    const std::vector<unsigned int> &
    active_rows() const
    {
      return active;
    }

    /// Returns a displacement field that is 1 in @p direction (0, 1, 2) at the
    /// support with index @p support and 0 at other supports.
    static BlockVector
    influence_of_support(const Structure   &structure,
                         const unsigned int support,
                         const unsigned int direction);

  private:
    Pair
    zero() const;
    /// Returns the derivative of a displacement, strain or stress at a probe.
    std::optional<Pair>
    at_probe(const NamedQuantity &goal) const;
    /// Returns the derivatives by displacements and contact forces lambda of a
    /// component of a support force, w . (f_int - t f - B^T lambda) at load
    /// factor t, with a virtual displacement w that is 1 at the support.
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

  /// Returns @p errors with the error of each axis element divided equally
  /// among the elements of the model @p finer that it contains.
  LocalErrors
  distribute_to_finer(const LocalErrors &errors, const Simulation &finer);

  /// Error of a goal J per axis element, from dual-weighted residuals (Becker
  /// and Rannacher, Acta Numerica 10 (2001), sec. 3; deal.II's step-14). u_H
  /// are the displacements of the coarser model, interpolated to the nodes of
  /// the finer one. The finer model has displacements u_h, stiffness K,
  /// internal forces f_int, loads t f, contact forces lambda, and active
  /// constraints with matrix B, gaps g and compliances a. Its dual solution z,
  /// nu (GoalDual) satisfies
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda.
  /// The difference of the goal between both models is, to rounding,
  ///   J(u_h) - J(u_H) = r . z - nu . s,
  ///   r = t f + B^T l - f_int(u_H),   s = -(g(u_H) + a l),
  /// for any contact forces l, here lambda scaled to the resultants of the
  /// coarser model. Except for contact, r . I z = 0 with the interpolant I z in
  /// the coarser model. The error of an element is therefore, over the DoFs k
  /// of its nodes, the sum of r_k (z - I z)_k, half of it at nodes of two
  /// elements.
  ///
  /// Both models must have the same bodies: beams with the same section
  /// functions and different axes, and identical solids.
  class Localization
  {
  public:
    /// Returns true if both models have the same numbers of section functions
    /// in each beam and of DoFs in each solid.
    static bool
    is_possible(const Simulation &coarse, const Simulation &fine);

    /// Computes the residual of the coarser solution on the finer model. Keeps
    /// references to both models. Collective, as is errors().
    Localization(const Simulation &coarse, const Simulation &fine);

    /// Returns the error of @p goal per element; @p change is the difference of
    /// its value between both models. Returns an empty optional if the goal has
    /// no derivative (GoalDual). Costs one solution with the finer stiffness.
    std::optional<LocalErrors>
    errors(const NamedQuantity &goal, const double change) const;

  private:
    /// Adds the errors of elements of @p body, sums of the products @p share.
    void
    add_elements(const unsigned int body,
                 const Vector      &share,
                 LocalErrors       &result) const;

    const Simulation &coarse, &fine;
    LoadFactor        factor;
    GoalDual          dual;
    BlockVector       residual;
    Vector mismatch; ///< Residual of each active constraint [length].
  };

  /// Returns the error per axis element of each goal of @p run by comparison
  /// with @p finer; empty if Localization is not possible.
  std::vector<std::optional<LocalErrors>>
  errors_of(const RunGoals   &goals,
            const Simulation &run,
            const Simulation &finer);
} // namespace lamella

#endif
