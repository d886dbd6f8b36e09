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

    /// Returns true if the load stiffness df/du may be unsymmetric.
    virtual bool
    is_unsymmetric() const
    {
      return true;
    }

    /// Adds @p factor times the nodal forces at the displacement @p u to @p f.
    virtual void
    add_forces(const double factor, const Vector &u, Vector &f) const = 0;

    /// Adds to @p f this process's share of the derivative of the nodal forces
    /// at @p u in the direction @p w, times @p factor.
    virtual void
    add_derivative(const double  factor,
                   const Vector &u,
                   const Vector &w,
                   Vector       &f) const = 0;

    /// Calls @p use with this process's blocks of -@p factor times the
    /// symmetric part of the derivative of the nodal forces by @p u; if @p
    /// with_values is false, blocks have only DoFs, no values.
    virtual void
    for_each_stiffness_block(const double         factor,
                             const Vector        &u,
                             const bool           with_values,
                             const BlockCallback &use) const = 0;
  };

  /// Returns true if @p load is a couple or a follower pressure.
  bool
  is_follower_load(const Load &load);

  /// Returns true if @p load (not a temperature) must be applied to @p body as
  /// a FollowerLoad: any load if the body has rotational DoFs; a couple or a
  /// follower pressure if the body has finite rotations.
  bool
  depends_on_state(const Load &load, const Body &body);

  /// Returns the forces of @p load on its region @p region of @p body at any
  /// displacement: a pressure normal to the current surface, a Couple on the
  /// current surface for a moment (its direction is fixed), otherwise forces of
  /// fixed direction. Throws InputError as add_load() does, and if a pressure
  /// varies more within an element than the Gauss points resolve.
  std::unique_ptr<FollowerLoad>
  follower_load(const Load &load, const Region &region, const Body &body);

  /// Returns the thermal load on @p body, Body::add_thermal_load(); null if it
  /// does not depend on the displacement or is zero.
  std::unique_ptr<FollowerLoad>
  turning_heat(const Body &body);

  /// Returns the weight of @p body for @p acceleration [length / s^2]; null if
  /// its load vector does not depend on the displacement.
  std::unique_ptr<FollowerLoad>
  follower_weight(const dealii::Tensor<1, 3> &acceleration, const Body &body);
} // namespace lamella

#endif
