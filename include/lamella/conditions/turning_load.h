// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_turning_load_h
#define lamella_conditions_turning_load_h

#include <lamella/body/body.h>
#include <lamella/conditions/load.h>

#include <memory>
#include <vector>

namespace lamella
{
  /**
   * A load on one body that turns by any angle (Body::turns()), whose forces
   * f(u) depend on where the body is. Of small displacements it is the dead
   * one of add_load().
   */
  class TurningLoad
  {
  public:
    virtual ~TurningLoad() = default;

    /// Whether df/du has a part that is not symmetric.
    virtual bool
    is_skew() const
    {
      return true;
    }

    /// f += @p factor f(u), u the displacement @p u of the body.
    virtual void
    add_forces(const double factor, const Vector &u, Vector &f) const = 0;

    /// f += @p factor df/du @p w at @p u.
    virtual void
    add_derivative(const double  factor,
                   const Vector &u,
                   const Vector &w,
                   Vector       &f) const = 0;

    /// What it adds to the tangent stiffness, the symmetric part of
    /// -@p factor df/du, block by block; without values where @p with_values
    /// is false.
    virtual void
    for_each_stiffness_block(
      const double                                       factor,
      const Vector                                      &u,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const = 0;
  };

  using TurningLoads = std::vector<std::unique_ptr<TurningLoad>>;

  /// Whether @p load turns along with bodies that turn by any angle: a couple,
  /// or a pressure that follows.
  bool
  turns_along(const Load &load);

  /// Whether @p load is a TurningLoad on @p body: where it turns along with
  /// it, and any load where what the body feels of a force depends on its state
  /// (Body::rows_turn()).
  bool
  depends_on_state(const Load &load, const Body &body);

  /**
   * @p load on its region @p region of @p body,
   *
   * - a pressure p(X) that follows, per area of the deformed surface, whose
   *   material coordinates are s, t:
   *     f . v = -integral p v . (x_,s x x_,t) ds dt,
   *   by Gauss points of each facet;
   * - a couple, as the tractions of Load::couple at the places where the
   *   surface is now,
   *     t = theta x (x - c),   J theta = M,
   *   with c and J those of the points x that the undeformed area carries
   *   there: in all no force and the moment M, of a fixed direction, at any
   *   turn.
   *
   * - any other load, as forces that keep their direction.
   *
   * Throws InputError as add_load() does, and where a pressure varies within an
   * element by more than the Gauss points see.
   */
  std::unique_ptr<TurningLoad>
  turning_load(const Load &load, const Region &region, const Body &body);

  /// What heat does to @p body (Body::add_heat_at()).
  std::unique_ptr<TurningLoad>
  turning_heat(const Body &body);

  /// The weight of @p body under @p acceleration, likewise.
  std::unique_ptr<TurningLoad>
  turning_weight(const dealii::Tensor<1, 3> &acceleration, const Body &body);
} // namespace lamella

#endif
