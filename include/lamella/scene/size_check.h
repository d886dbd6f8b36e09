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
   * wants), of layer-wise beams and solids. With the order p of the expansion,
   * the degree q of the axis elements (of solids p) and n_x cells across, n_z
   * through the thickness and n_y along the axis,
   *   DoFs = 3 (p n_x + 1) (p n_z + 1) (q n_y + 1),
   * and each couples with those of the cells around it at least, of which there
   * are 3 (p + 2)^2 (q + 2) on average; a non-zero takes 24 bytes. Bodies of
   * less than 2e5 DoFs pass: they are made in no time, and MemoryBudget then
   * tells exactly.
   */
  void
  check_sizes(const Scene &scene);
} // namespace lamella

#endif
