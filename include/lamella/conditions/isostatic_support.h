// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_isostatic_support_h
#define lamella_conditions_isostatic_support_h

#include <lamella/conditions/support.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Isostatic support of a body, `Isostatic support = true`: it removes the
   * rigid motions that supports leave free, so that displacements are relative
   * to the body's middle.
   *
   * For each rigid motion q without resistance of a support, or of a contact
   * along its normal, there is one row
   *   r(u) = 1 / n sum_p q(X_p) . u(X_p) = 0,
   * with the n points X_p of the section half way along the axis that are
   * furthest from its centroid. The mean displacement and rotation there are
   * zero, without strain. The force in a row is the imbalance of the loads,
   * zero or an error (check_isostatic_balance()), and that of contact forces
   * off their normal.
   */

  /// A place where a contact may act on a body along a normal.
  struct PotentialContact
  {
    unsigned int         body = 0;
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> normal;
  };

  /// Returns n . u at @p place, or nothing if it is outside of its body.
  std::optional<BodyFunctional>
  row_of(const PotentialContact &place, const Bodies &bodies);

  /// Returns the name of the isostatic support of the body @p name.
  std::string
  name_of_isostatic_support(const std::string &name);

  /// Sets the motions of isostatic supports among @p supports: those that
  /// neither other supports nor contacts at @p places resist.
  void
  find_isostatic_motions(std::vector<Support>                &supports,
                         const Bodies                        &bodies,
                         const std::vector<PotentialContact> &places);

  /// Clears the motions of the isostatic supports among @p supports.
  void
  clear_isostatic_motions(std::vector<Support> &supports);

  /// Returns the rows of the isostatic support @p hold, number @p support.
  std::vector<PrescribedFunctional>
  rows_of_isostatic_support(const IsostaticSupport &hold,
                            const unsigned int      support,
                            const Bodies           &bodies);

  /// Throws InputError if @p load at load factor 1 does work on a motion that
  /// an isostatic support removes.
  void
  check_isostatic_balance(const std::vector<Support> &supports,
                          const Bodies               &bodies,
                          const BlockVector          &load);
} // namespace lamella

#endif
