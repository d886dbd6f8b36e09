// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_main_normals_h
#define lamella_contact_main_normals_h

#include <lamella/contact/gap_rows.h>

#include <vector>

namespace lamella
{
  /// A row of a contact, by its number, with the way along which its contact
  /// acts there as a whole: a unit vector.
  struct MainNormal
  {
    unsigned int         row = 0;
    dealii::Tensor<1, 3> normal;
  };

  /**
   * The main normals of those rows of @p interface, made of @p contact, that
   * are to touch first, closer than @p depth to the closest one: one stands for
   * all rows whose own normal is within 60 degrees of that of the closest row,
   * and so on for those that are left. A roller on a flat face has one, across
   * the face, although most of its rows are askew; a groove has one for each of
   * its sides. Motions along which askew rows give way are not held by a
   * contact.
   *
   * The main normal is the one that both surfaces have where they touch: that
   * of a flat one; of two curved ones that across the generators of both, as
   * sides of bodies and cylinders are ruled. It does not depend on where the
   * mesh has its points. Of two flat ones that are askew, an edge on a face, it
   * is that of the closest row.
   */
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
