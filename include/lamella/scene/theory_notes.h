// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_theory_notes_h
#define lamella_scene_theory_notes_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Sentences on what the choices of @p scene are known to get wrong, from its
   * entries alone:
   * - shear locking of axis elements below B4 with full shear strains, and
   *   Poisson locking of LE-1, whose cells cannot contract linearly;
   * - hexahedra of degree 1 on sections that are neither laminates nor thin
   *   walls: incompatible modes help rectangles only;
   * - EBBT, TBT and TE-1 on layups that twist when they bend: by classical
   *   lamination theory they are too stiff by EI_untwisted / EI, told from 1 %
   *   on.
   * A sentence has no full stop.
   */
  std::vector<std::string>
  notes_on_choices(const Scene &scene);

  /**
   * Sentences on bodies of @p scene whose theory or axis does not suit them,
   * from constants of their sections (section/theory_limits.h): EBBT, TBT and
   * TE-N in the shear of laminates and sandwiches at the length that they have,
   * TE-N in the torsion of other sections; long elements at ends that supports
   * hold as a whole. @p meshes are those of the scene's sections.
   *
   * Shear: with phi = 12 E I / (k G A L^2) of the plies' true shear stiffness
   * and phi_N of what the theory has (zero for EBBT), bending is too stiff by
   * (1 + phi) / (1 + phi_N); told from 2 % on. Torsion: G J of the theory on
   * this mesh over that of LE-2; told from 5 % on, and it costs a solution on
   * the section. Clamps: what a clamp disturbs dies away within about a width
   * of the section, but a long element carries it over its own length;
   * constants measured (doc/theories.md).
   */
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
