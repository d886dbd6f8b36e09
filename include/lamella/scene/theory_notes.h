// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_theory_notes_h
#define lamella_scene_theory_notes_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns warnings (sentences without a full stop) on theories and axis
  /// elements of @p scene with known errors. Only entries are used, no meshes.
  /// - Shear locking: B2 and B3 axis elements with full integration of shear
  ///   strains. Poisson locking: LE-1.
  /// - Hexahedra of degree 1 on sections other than laminates and thin walls:
  ///   their incompatible modes are accurate for rectangular cells only.
  /// - EBBT, TBT and TE-1 for layups with bend-twist coupling: they suppress
  ///   the twist. A warning states the ratio of the bending stiffnesses without
  ///   and with free twist (classical lamination theory) if it exceeds 1.01.
  std::vector<std::string>
  notes_on_choices(const Scene &scene);

  /// Returns warnings on bodies of @p scene with an unsuitable theory or axis
  /// mesh, from stiffnesses of their sections (section/theory_limits.h) with
  /// the meshes @p meshes:
  ///
  /// - Shear of laminates and sandwiches, for EBBT, TBT and TE-N: a beam of
  ///   length L is too stiff in bending by the factor (1 + phi) / (1 + phi_N)
  ///   with phi = 12 E I / (k G A L^2) for the shear stiffness k G A by
  ///   equilibrium, and phi_N for that of the theory (0 for EBBT); a warning
  ///   from 1.02 on.
  /// - Torsion of other sections: torsional stiffness of TE-N over that of LE-2
  ///   on the same mesh; a warning if this ratio is 1.05 or more.
  /// - Axis elements at clamped ends that are longer than the boundary layer,
  ///   which decays within about one section width (doc/theory/theories.md).
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
