// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_checks_h
#define lamella_scene_scene_checks_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError, before meshing, for the first body of @p scene whose
  /// stiffness matrix would exceed the memory. Checks only layer-wise beams and
  /// solids with laminated sections. The number of DoFs is estimated as
  ///   3 (p n_x + 1) (p n_z + 1) (q n_y + 1)
  /// with the degree p of the section expansion, the degree q of axis elements
  /// (p for solids), and n_x, n_z, n_y cells along width, height and axis. A
  /// matrix row has about 3 (p + 2)^2 (q + 2) nonzeros of 24 bytes. Only bodies
  /// above 2e5 DoFs are checked; MemoryBudget checks all after meshing.
  void
  check_sizes(const Scene &scene);

  /// Throws InputError for entries of @p scene that do not fit its friction:
  /// - with friction, a tolerance of goals;
  /// - without friction, `Substeps` other than 1 (a top-level entry in @p in);
  /// - a goal or Trade quantity `dissipated` of a contact without friction.
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
