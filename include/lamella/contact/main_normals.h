// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Row number of a contact, and the unit main direction of contact there.
  struct MainNormal
  {
    unsigned int         row = 0;
    dealii::Tensor<1, 3> normal;
  };

  /**
   * Returns the main normals of those rows of @p interface, made of @p contact,
   * whose gaps are less than @p depth above the smallest one. One main normal
   * stands for all rows whose own normal is within 60 degrees of that of the
   * closest row; the remaining rows are treated likewise. A roller on a flat
   * face has one, across the face; a groove has one for each side. The contact
   * does not restrain motions along other normals.
   *
   * A main normal is common to both surfaces in contact: that of a flat
   * surface, or the normal across the generators of two curved ones (sides of
   * bodies and cylinders are ruled). It does not depend on the mesh. For two
   * flat surfaces at an angle, an edge on a face, it is that of the closest
   * row.
   */
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
