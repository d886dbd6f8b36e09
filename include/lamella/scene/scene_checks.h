// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_checks_h
#define lamella_scene_scene_checks_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/scene_text.h>

#include <string>
#include <vector>

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

  /// Returns warnings (sentences without a full stop) on numbers of @p scene
  /// that are probably in a wrong unit. @p meshes are the meshes of its
  /// sections. Lengths and stresses are checked only if the scene has `Units`.
  ///
  ///   number                    warning if
  ///   angles of a layup         probably radians: none exceeds 3.2, and one is
  ///                             pi/2, pi/3, pi/4 or pi/6 within 1e-3
  ///   modulus of the stiffest   below 1000 MPa, except cores, foams (below
  ///   material                  600 kg/m^3) and rubber (nu_12 >= 0.45)
  ///   section's smaller side    below 1 micrometer or above 10 m
  ///   ply of stiff fibers       thinner than 5 micrometers or above 100 mm
  ///   Gravity                   9.7 to 9.9 mm/s^2 or km/s^2 (probably m/s^2)
  ///   Rotation of a support     probably degrees: more than one turn
  std::vector<std::string>
  magnitude_warnings(const Scene &scene, const SectionMeshes &meshes);

  /// Replaces each body of @p text with the entry `Copies = N`, N > 1, by N
  /// bodies. For example, `leaf` becomes leaf-1 to leaf-N. They have the
  /// entries of `leaf`, except that body number k has
  ///   Origin = Origin + (k - 1) Origin step,
  ///   Length = Length + (k - 1) Length step.
  /// References to `leaf` are replaced as well:
  /// - a region `leaf: top` of a support or a load becomes one region per body;
  /// - a contact NAME between `leaf` and itself becomes the contacts NAME-1 to
  ///   NAME-(N-1), where NAME-k is between the bodies k and k + 1;
  /// - a contact NAME between `leaf` and another body becomes NAME-1 to NAME-N.
  ///
  /// Probes, lines and cuts must refer to one of the bodies, such as leaf-2.
  /// Throws InputError for a step without `Copies`, N outside of 1 to 1000,
  /// lengths that are not positive, and generated names that exist already.
  void
  expand_stacks(SceneText &text);

  /// Throws InputError for oscillating loads without `Find = response`, and for
  /// a response without oscillating loads or probes.
  void
  check_response(const Scene &scene);
} // namespace lamella

#endif
