// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// A main direction in which a contact acts: unit normal, and number of the
  /// constraint with the smallest gap in this direction.
  struct MainNormal
  {
    unsigned int         row = 0;
    dealii::Tensor<1, 3> normal;
  };

  /// Returns the main normals, used as isostatic supports, of those constraints
  /// of @p interface (created from @p contact) whose gaps exceed the smallest
  /// by less than @p depth [length]. The normal at the smallest gap represents
  /// all constraints whose own normal is within 60 degrees of it; the remaining
  /// constraints are treated in the same way. A roller on a flat face has one
  /// main normal, normal to the face; a groove has one for each side. Other
  /// motions are not restrained.
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
