// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_follower_load_h
#define lamella_conditions_follower_load_h

#include <lamella/body/body.h>
#include <lamella/conditions/load.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// A load on a body with finite rotations, whose nodal forces f(u) depend on
  /// the displacement u. f(0) is the load vector for small displacements.
  class FollowerLoad
  {
  public:
    virtual ~FollowerLoad() = default;

    /// Returns whether the load stiffness df/du is not symmetric.
    virtual bool
    is_unsymmetric() const
    {
      return true;
    }

    /// Adds @p factor times f(u) to @p f.
    virtual void
    add_forces(const double factor, const Vector &u, Vector &f) const = 0;

    /// Adds @p factor times df/du @p w, the derivative at @p u, to @p f.
    virtual void
    add_derivative(const double  factor,
                   const Vector &u,
                   const Vector &w,
                   Vector       &f) const = 0;

    /// Calls @p use for the blocks of the load stiffness, the symmetric part of
    /// -@p factor df/du; blocks have no values if @p with_values is false.
    virtual void
    for_each_stiffness_block(
      const double                                       factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;
  };

  using FollowerLoads = std::vector<std::unique_ptr<FollowerLoad>>;

  /// Returns whether @p load is a couple or a follower pressure.
  bool
  is_follower_load(const Load &load);

  /// Returns whether @p load must be applied to @p body as a FollowerLoad: if
  /// it is a follower load and the body has finite rotations, or if the body
  /// has rotational DoFs (Body::constraints_rotate()).
  bool
  depends_on_state(const Load &load, const Body &body);

  /// Returns the FollowerLoad of @p load on its region @p region of @p body:
  /// - for a follower pressure p(X) per deformed area, with material
  ///   coordinates s, t and test function v, integrated over each facet by
  ///   Gauss points:
  ///     f . v = -integral p v . (x_,s x x_,t) ds dt;
  /// - for a couple M, tractions t on the current surface:
  ///     t = theta x (x - c),   J theta = M,
  ///   with centroid c and area tensor J of the current points x, weighted by
  ///   undeformed area (Couple); M keeps its direction at any rotation;
  /// - for any other load, forces of fixed direction.
  /// Throws InputError as add_load() does, and if a pressure varies more within
  /// an element than the Gauss points resolve.
  std::unique_ptr<FollowerLoad>
  follower_load(const Load &load, const Region &region, const Body &body);

  /// Returns the thermal load on @p body as a FollowerLoad with the forces of
  /// Body::add_thermal_load_at().
  std::unique_ptr<FollowerLoad>
  turning_heat(const Body &body);

  /// Returns the weight of @p body under @p acceleration as a FollowerLoad.
  std::unique_ptr<FollowerLoad>
  follower_weight(const dealii::Tensor<1, 3> &acceleration, const Body &body);
} // namespace lamella

#endif
