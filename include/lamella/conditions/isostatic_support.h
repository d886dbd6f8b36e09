// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_isostatic_support_h
#define lamella_conditions_isostatic_support_h

#include <lamella/conditions/support.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  // Isostatic support of a body, `Isostatic support = true`: it removes the
  // rigid motions that supports leave free, so that displacements are relative
  // to the middle of the body.
  //
  // For each rigid motion q that neither a support nor the normal force of a
  // contact resists, there is one constraint
  //   r(u) = 1 / n sum_p q(X_p) . u(X_p) = 0,
  // with the n points X_p of the section at mid-length that are furthest from
  // its centroid. These constraints set the mean displacement and rotation of
  // the section to zero, without strain. Their reactions balance tangential
  // contact forces; loads must be balanced already
  // (check_isostatic_balance()).

  /// A point of a body at which a contact force along a normal may act.
  struct PotentialContact
  {
    unsigned int         body = 0; ///< Index of the body.
    dealii::Point<3>     position; ///< Undeformed position, scene axes.
    dealii::Tensor<1, 3> normal;   ///< Unit normal, scene axes.
  };

  /// Returns the normal displacement at the contact point @p place as a
  /// functional of the DoFs; an empty optional if the point is not in the body.
  std::optional<BodyFunctional>
  row_of(const PotentialContact &place, const Bodies &bodies);

  /// Returns the name of the isostatic support of the body @p name, for output.
  std::string
  name_of_isostatic_support(const std::string &name);

  /// Sets the rigid motions that the isostatic supports in @p supports remove:
  /// those that neither other supports nor contacts at @p places resist.
  void
  find_isostatic_motions(std::vector<Support>                &supports,
                         const Bodies                        &bodies,
                         const std::vector<PotentialContact> &places);

  /// Clears the removed rigid motions of the isostatic supports in @p supports.
  void
  clear_isostatic_motions(std::vector<Support> &supports);

  /// Returns the constraints of the isostatic support @p hold, one per removed
  /// rigid motion. @p support is its index among all supports.
  std::vector<PrescribedFunctional>
  rows_of_isostatic_support(const IsostaticSupport &hold,
                            const unsigned int      support,
                            const Bodies           &bodies);

  /// Throws InputError if the load vector @p load (load factor 1) does work on
  /// a rigid motion that an isostatic support removes.
  void
  check_isostatic_balance(const std::vector<Support> &supports,
                          const Bodies               &bodies,
                          const BlockVector          &load);
} // namespace lamella

#endif
