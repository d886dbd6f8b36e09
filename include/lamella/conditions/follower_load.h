// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_follower_load_h
#define lamella_conditions_follower_load_h

#include <lamella/body/body.h>
#include <lamella/conditions/load.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// A load with state-dependent forces f(u) on a body with finite rotations.
  /// For small displacements it is the dead load of add_load().
  class FollowerLoad
  {
  public:
    virtual ~FollowerLoad() = default;

    /// Returns whether df/du has a skew part.
    virtual bool
    is_unsymmetric() const
    {
      return true;
    }

    /// Adds @p factor f(u) to f at the displacement @p u of the body.
    virtual void
    add_forces(const double factor, const Vector &u, Vector &f) const = 0;

    /// Adds @p factor df/du @p w at @p u to f.
    virtual void
    add_derivative(const double  factor,
                   const Vector &u,
                   const Vector &w,
                   Vector       &f) const = 0;

    /// Calls @p use for the blocks of its tangent stiffness, the symmetric part
    /// of -@p factor df/du; without values if @p with_values is false.
    virtual void
    for_each_stiffness_block(
      const double                                       factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;
  };

  using FollowerLoads = std::vector<std::unique_ptr<FollowerLoad>>;

  /// Returns whether @p load is a couple or a following pressure.
  bool
  is_follower_load(const Load &load);

  /// Returns whether @p load on @p body is a FollowerLoad: a follower load at
  /// finite rotations, or any load if Body::constraints_rotate().
  bool
  depends_on_state(const Load &load, const Body &body);

  /**
   * Returns the FollowerLoad of @p load on its region @p region of @p body:
   * - a pressure p(X) that follows, per deformed area with material coordinates
   *   s, t, by Gauss points of each facet:
   *     f . v = -integral p v . (x_,s x x_,t) ds dt;
   * - a couple as the tractions of Load::couple at the current places,
   *     t = theta x (x - c),   J theta = M,
   *   with c and J of the points x that carry the undeformed area: no force,
   *   and the moment M of fixed direction at any rotation;
   * - any other load as forces of fixed direction.
   * Throws InputError as add_load() does, and if a pressure varies within an
   * element by more than the Gauss points resolve.
   */
  std::unique_ptr<FollowerLoad>
  follower_load(const Load &load, const Region &region, const Body &body);

  /// Returns the load of heat on @p body (Body::add_thermal_load_at()).
  std::unique_ptr<FollowerLoad>
  turning_heat(const Body &body);

  /// Returns the weight of @p body under @p acceleration as a FollowerLoad.
  std::unique_ptr<FollowerLoad>
  follower_weight(const dealii::Tensor<1, 3> &acceleration, const Body &body);
} // namespace lamella

#endif
