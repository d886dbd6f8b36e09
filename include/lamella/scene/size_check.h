// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_size_check_h
#define lamella_scene_size_check_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError for the first body of @p scene whose stiffness matrix
  /// exceeds the memory, before meshing. Only layer-wise beams and solids with
  /// laminated sections are estimated. With the order p of the expansion, the
  /// degree q of the axis elements (p for solids), and n_x cells across, n_z
  /// through the thickness and n_y along the axis, the number of DoFs is
  ///   DoFs = 3 (p n_x + 1) (p n_z + 1) (q n_y + 1),
  /// A row of the matrix has at least 3 (p + 2)^2 (q + 2) nonzeros of 24 bytes
  /// on average. Bodies below 2e5 DoFs are accepted; MemoryBudget checks them
  /// exactly after meshing.
  void
  check_sizes(const Scene &scene);
} // namespace lamella

#endif
