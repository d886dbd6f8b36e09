// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_size_check_h
#define lamella_scene_size_check_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /**
   * Throws InputError for the first body of @p scene with a stiffness that
   * cannot fit into memory, before meshing. Only layer-wise beams and solids
   * with laminated sections are counted. The order p of the expansion, the
   * degree q of the axis elements (p for solids), and n_x cells across, n_z
   * through the thickness and n_y along the axis give
   *   DoFs = 3 (p n_x + 1) (p n_z + 1) (q n_y + 1),
   * each coupled with those of the adjacent cells, 3 (p + 2)^2 (q + 2) on
   * average at least; a nonzero takes 24 bytes. Bodies below 2e5 DoFs pass;
   * MemoryBudget is exact for these.
   */
  void
  check_sizes(const Scene &scene);
} // namespace lamella

#endif
