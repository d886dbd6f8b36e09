// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Main direction in which a contact acts: constraint and unit normal.
  struct MainNormal
  {
    unsigned int         row = 0;
    dealii::Tensor<1, 3> normal;
  };

  /// Returns the main normals of those constraints of @p interface, created
  /// from @p contact, whose gaps are less than @p depth above the smallest one.
  /// The normal at the smallest gap represents all constraints whose own normal
  /// is within 60 degrees of it; the remaining constraints are treated in the
  /// same way. A roller on a flat face has one main normal, normal to the face;
  /// a groove has one for each side. Other motions are not restrained.
  ///
  /// A main normal is common to both surfaces in contact: the normal of a flat
  /// surface, or the direction normal to the generators of two curved surfaces
  /// (sides of bodies and cylinders are ruled). It does not depend on the mesh.
  /// For two flat surfaces at an angle (an edge on a face), the closest
  /// constraint's normal is used.
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
