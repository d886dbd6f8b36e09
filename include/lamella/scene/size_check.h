// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_size_check_h
#define lamella_scene_size_check_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /**
   * Throws InputError for the first body of @p scene whose stiffness cannot fit
   * into memory, before a mesh is made: from the numbers of cells, elements and
   * the order alone, on laminated sections (others are as fine as their shape
   * wants). DoFs = 3 (p n_x + 1) (p n_z + 1) (q n_y + 1), and each couples with
   * those of the cells around it at least.
   */
  void
  check_sizes(const Scene &scene);

  /// Throws InputError if @p body is so long for the section @p mesh that its
  /// rigid motions cannot be told apart in doubles.
  void
  check_slenderness(const BodyDescription &body, const SectionMesh &mesh);
} // namespace lamella

#endif
