// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_parameters_h
#define lamella_body_parameters_h

#include <lamella/axis/axis.h>
#include <lamella/base/entry.h>
#include <lamella/body/body.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>
#include <lamella/section/theory.h>
#include <lamella/shape/section_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Description of a body as read from a scene: placement, section, theory
  /// (Sec. 2 of the paper) and axial mesh. make_bodies() constructs the body.
  struct BodyDescription
  {
    /// Names of the body and of its section.
    std::string name, section;
    /// Theory of the body, beam or solid (the first of `Theories`).
    Theory theory;
    /// Theory of each axial range (`Theories`); may be empty.
    TheoryPieces pieces;
    /// Position and axes in the scene.
    Placement placement;
    /// Length and elements along the axis, of beams and solids.
    AxisMesh axis;
    /// Stiffness of springs on unconstrained rigid motions, as a fraction of E
    /// A / L, 0 to 0.01 (Stabilization).
    double stabilization = 0.;
    /// True if the body has an isostatic support.
    bool is_held = false;
    /// True if the body has finite rotations (TotalLagrangianBeam).
    bool has_finite_rotations = false;
    /// Refinement of the hexahedra of a solid.
    SolidRefinement refinement;
  };

  /// The entries of `subsection Body NAME` and its subsection `Kinematics`. The
  /// former (defaults in parentheses, scene axes, units of the scene) are
  ///   Section          a name of the scene's sections
  ///   Origin           of the section at the start of the axis   (0, 0, 0)
  ///   Axis, Up         direction of y; direction whose normal part is z (y, z)
  ///   Length           of the axis
  ///   Stabilization    fraction of E A / L, 0 to 0.01            (0)
  ///   Isostatic support  true or false                          (false)
  /// `Kinematics` has the entries of TheoryParameters, AxisParameters and
  /// SolidParameters; entries that the theory does not need are ignored.
  struct BodyParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the body @p name; the current subsection of @p prm must be that
    /// of the body. @p scene_theory is the default of the theory; @p sections
    /// are the names of all sections. Throws InputError, which names the entry,
    /// for an unknown section, a length that is not positive, parallel Axis and
    /// Up, EBBT with elements other than B4, and other invalid entries.
    static BodyDescription
    parse(dealii::ParameterHandler       &prm,
          const std::string              &name,
          const Entry                    &scene_theory,
          const std::vector<std::string> &sections);
  };

  /// Constructs the bodies of @p descriptions with the section @p meshes.
  /// Solids may use @p memory_limit bytes (0: memory of the machine). Beams
  /// with the same mesh and theory share a Section. Nodes of SV-N, and of
  /// bodies with `Theories`, have all section functions until choose_fields()
  /// selects some of them. Throws InputError for a body longer than 1e7 times
  /// the extent of its section (beyond double precision), for a beam with fewer
  /// axis nodes than processes, and as HexahedralMesh. Collective.
  Bodies
  make_bodies(const std::vector<BodyDescription> &descriptions,
              const SectionMeshes                &meshes,
              const double                        memory_limit = 0.);
} // namespace lamella

#endif
