// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_hold_h
#define lamella_conditions_hold_h

#include <lamella/conditions/support.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * `Hold = statically determinate` of a body: where supports leave it free to
   * move, displacements are measured from its own middle.
   *
   * For each rigid motion q that nothing acts against, no support and no
   * contact along its normal, there is one row
   *   r(u) = 1 / n sum_p q(X_p) . u(X_p) = 0,
   * with the n points X_p where the section half way along the axis is furthest
   * from its centroid: there the body neither moves nor turns, on the mean. The
   * rows are as many as the motions, so they strain nothing. The force in a row
   * is what the loads lack of equilibrium, zero or an error
   * (check_balance_of_held()), and what contact forces off their normal do.
   */

  /// A place where a contact may act on a body, along a normal.
  struct ContactPlace
  {
    unsigned int         body = 0;
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> normal;
  };

  /// Returns n . u at @p place, or nothing if it is outside of its body.
  std::optional<BodyRow>
  row_of(const ContactPlace &place, const Bodies &bodies);

  /// What the hold of the body @p name is called among the supports.
  std::string
  name_of_hold(const std::string &name);

  /// Fills in the motions of the holds among @p supports: those of their bodies
  /// that neither the other supports nor contacts at @p places, on the surfaces
  /// of their bodies, act against.
  void
  find_held_motions(std::vector<Support>            &supports,
                    const Bodies                    &bodies,
                    const std::vector<ContactPlace> &places);

  /// Forgets them.
  void
  clear_held_motions(std::vector<Support> &supports);

  /// The rows of @p hold, which is number @p support of the supports.
  std::vector<PrescribedRow>
  rows_of_hold(const Hold        &hold,
               const unsigned int support,
               const Bodies      &bodies);

  /// Throws InputError if @p load, the load vector at load factor 1, does work
  /// on a motion that a hold among @p supports takes out of its body: nothing
  /// else could balance it.
  void
  check_balance_of_held(const std::vector<Support> &supports,
                        const Bodies               &bodies,
                        const BlockVector          &load);
} // namespace lamella

#endif
