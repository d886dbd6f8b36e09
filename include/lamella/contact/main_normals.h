// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// A main direction in which a contact acts.
  struct MainNormal
  {
    unsigned int         row = 0; ///< Constraint with smallest gap along it.
    dealii::Tensor<1, 3> normal;  ///< Unit vector, scene axes.
  };

  /// Returns the main normals, used as isostatic supports, of the constraints
  /// of @p interface (created from @p contact) whose gaps exceed the smallest
  /// by less than @p depth [length]. The normal at the smallest gap represents
  /// all constraints whose normal is within 60 degrees of it; the remaining
  /// constraints are treated in the same way. A roller on a flat face has one
  /// main normal, normal to the face; a groove has one for each side.
  ///
  /// A main normal is the normal of a flat surface, or the direction normal to
  /// the generators of two curved ones, and independent of the mesh. For two
  /// flat surfaces at an angle, the normal at the smallest gap is used.
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
