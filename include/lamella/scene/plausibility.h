// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_plausibility_h
#define lamella_scene_plausibility_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
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
} // namespace lamella

#endif
