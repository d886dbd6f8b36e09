// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_theory_notes_h
#define lamella_scene_theory_notes_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Returns sentences, without a full stop, on known errors of the choices of
   * @p scene, from its entries alone:
   * - shear locking of axis elements below B4 with full shear strains, and
   *   Poisson locking of LE-1, whose cells cannot contract linearly;
   * - hexahedra of degree 1 on sections that are neither laminates nor thin
   *   walls: incompatible modes help rectangles only;
   * - EBBT, TBT and TE-1 on layups with bend-twist coupling: by classical
   *   lamination theory too stiff by EI_untwisted / EI, reported from 1 % on.
   */
  std::vector<std::string>
  notes_on_choices(const Scene &scene);

  /**
   * Returns sentences on bodies of @p scene with unsuitable theory or axis,
   * from constants of their sections (section/theory_limits.h) with the
   * @p meshes:
   *
   * - Shear of laminates and sandwiches: bending by EBBT, TBT and TE-N is too
   *   stiff by (1 + phi) / (1 + phi_N), phi = 12 E I / (k G A L^2) from the
   *   true shear stiffness and phi_N of the theory (zero for EBBT); reported
   *   from 2 % on.
   * - Torsion of other sections: G J of TE-N over that of LE-2 on this mesh;
   *   reported from 5 % on.
   * - Long elements at clamped ends: the disturbance decays within about a
   *   width of the section, but a long element spreads it over its own length
   *   (doc/theory/theories.md).
   */
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
