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
   * Of those rows of @p contact that are to touch first, closer than @p depth
   * to the closest one, the main normals: that of the closest row stands for
   * all whose own is within 60 degrees of it, and so on for those that are
   * left. A roller on a flat face has one, across the face, although most of
   * its rows are askew; a groove has one for each of its sides. What a contact
   * holds a body against is judged by these: askew rows give way where the body
   * slides.
   */
  std::vector<MainNormal>
  main_normals(const ContactInterface &contact, const double depth);
} // namespace lamella

#endif
