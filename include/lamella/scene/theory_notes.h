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
  /// - EBBT, TBT and TE-1 for layups with bend-twist coupling: the bending
  ///   stiffness is too large by the ratio of those with twist suppressed and
  ///   with free twist (classical lamination theory), if this is above 1.01.
  std::vector<std::string>
  notes_on_choices(const Scene &scene);

  /// Returns warnings on bodies of @p scene with an unsuitable theory or axis
  /// mesh, from stiffnesses of their sections (section/theory_limits.h) with
  /// the meshes @p meshes:
  ///
  /// - Shear of laminates and sandwiches: bending by EBBT, TBT and TE-N is too
  ///   stiff by (1 + phi) / (1 + phi_N), phi = 12 E I / (k G A L^2), where phi
  ///   has the exact shear stiffness k G A and phi_N that of the theory (zero
  ///   for EBBT); reported from 2 % on.
  /// - Torsion of other sections: ratio of the torsional stiffnesses of TE-N
  ///   and LE-2 on the same mesh; reported from 5 % on.
  /// - Axis elements at clamped ends that are longer than the boundary layer,
  ///   which decays within about one section width (doc/theory/theories.md).
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
