// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Main direction in which a contact acts at a constraint.
  struct MainNormal
  {
    unsigned int         row = 0; ///< Index of the constraint.
    dealii::Tensor<1, 3> normal;  ///< Unit vector, scene axes.
  };

  /// Returns the main normal of each constraint of @p interface (created from
  /// @p contact) whose gap exceeds the smallest by at most @p depth [length].
  /// Isostatic supports do not resist rigid motions along these normals. The
  /// normal at the smallest gap represents all constraints whose normal is
  /// within 60 degrees of it; the remaining constraints are treated in the same
  /// way. A roller on a flat face has one main normal; in a groove it has two.
  ///
  /// To be independent of the mesh, it is replaced by the normal of a flat
  /// surface if only one is flat or both are parallel. For two curved surfaces,
  /// components along their generators (straight lines) are removed.
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
