// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_theory_notes_h
#define lamella_scene_theory_notes_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns warnings (sentences without a full stop) on theories and axis
  /// elements of @p scene with known errors, from its entries alone:
  /// - shear locking of axis elements below B4 with full integration of shear
  ///   strains, and Poisson locking of LE-1;
  /// - hexahedra of degree 1 on sections other than laminates and thin walls,
  ///   since incompatible modes are accurate for rectangles only;
  /// - EBBT, TBT and TE-1 for layups with bend-twist coupling. They are too
  ///   stiff by EI_0 / EI, the bending stiffnesses of classical lamination
  ///   theory with twist suppressed and with free twist; reported from 1 % on.
  std::vector<std::string>
  notes_on_choices(const Scene &scene);

  /// Returns warnings on bodies of @p scene with an unsuitable theory or axis
  /// mesh, by constants of their sections (section/theory_limits.h), of which
  /// @p meshes are the meshes:
  ///
  /// - Shear of laminates and sandwiches: bending by EBBT, TBT and TE-N is too
  ///   stiff by (1 + phi) / (1 + phi_N), where phi = 12 E I / (k G A L^2) has
  ///   the exact shear stiffness k G A and phi_N that of the theory (phi_N = 0
  ///   for EBBT); reported from 2 % on.
  /// - Torsion of other sections: ratio of G J of TE-N to G J of LE-2 on the
  ///   same mesh; reported from 5 % on.
  /// - Long axis elements at clamped ends: the boundary layer decays within
  ///   about one section width, which a longer element does not resolve
  ///   (doc/theory/theories.md).
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
