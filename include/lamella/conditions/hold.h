// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_hold_h
#define lamella_conditions_hold_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * `Hold = statically determinate` of a body: where supports leave it free to
   * move, displacements are measured from its own middle.
   *
   * For each rigid motion q that nothing acts against, no support and no pair
   * of a contact, there is one row
   *   r(u) = 1 / n sum_p q(X_p) . u(X_p) = 0,
   * with the n points X_p where the section half way along the axis is furthest
   * from its centroid: there the body neither moves nor turns, on the mean. The
   * rows are as many as the motions, so they strain nothing, and nothing but
   * loads does work on such a motion: the force in a row is what the loads lack
   * of equilibrium, zero or an error (check_balance_of_held()).
   */

  /// What the hold of the body @p name is called among the supports.
  std::string
  name_of_hold(const std::string &name);

  /// Fills in the motions of the holds among @p supports: those of their bodies
  /// that neither the other supports nor @p others, rows of contacts, act
  /// against.
  void
  find_held_motions(std::vector<Support>       &supports,
                    const Bodies               &bodies,
                    const std::vector<BodyRow> &others);

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
