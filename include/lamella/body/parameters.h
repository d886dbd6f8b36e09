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
  /// Input of a body as plain data: placement, section, theory (the paper's
  /// Sec. 2) and mesh along the axis. make_bodies() creates the body.
  struct BodyDescription
  {
    /// Names of the body and of its section.
    std::string name, section;
    /// Theory of the body or the scene, beam or solid; the first of `Theories`.
    Theory theory;
    /// Theories of pieces of the axis, if given; else empty.
    TheoryPieces pieces;
    /// Position and axes in the scene.
    Placement placement;
    /// Length, and elements along it, of beams and extruded solids.
    AxisMesh axis;
    /// Stiffness of springs on free rigid motions, share of E A / L, 0 to 0.01.
    double stabilization = 0.;
    /// Flag: unloaded rigid motions are removed
    /// (conditions/isostatic_support.h).
    bool is_held = false;
    /// Flag: finite rotations (TotalLagrangianBeam).
    bool has_finite_rotations = false;
    /// Refinement of a solid's hexahedra; make_bodies() sets its memory limit.
    SolidRefinement refinement;
  };

  /**
   * The entries of a `subsection Body NAME`, with its `Kinematics`. Those of
   * the subsection itself are
   *   Section          a name of the scene's sections
   *   Origin           of the section at the start of the axis   (0, 0, 0)
   *   Axis, Up         directions of y, and that z leans towards (y, z)
   *   Length           of the axis
   *   Stabilization    share of E A / L, 0 to 0.01               (0)
   *   Isostatic support  true or false                          (false)
   * in the scene's axes and unit of length. `Kinematics` has all entries of
   * TheoryParameters, AxisParameters and SolidParameters; those that the theory
   * does not need may stay when it changes.
   */
  struct BodyParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the body @p name from @p prm, whose current subsection, restored
    /// at the end, is that of the body. @p scene_theory, `Theory` of the scene,
    /// is the default; @p sections are the valid names. Throws InputError,
    /// naming the entry, if the section is unknown, the length not positive,
    /// Axis and Up parallel or zero, or another entry wrong. EBBT needs B4, as
    /// Kirchhoff's constraint takes cubic deflections.
    static BodyDescription
    parse(dealii::ParameterHandler       &prm,
          const std::string              &name,
          const Entry                    &scene_theory,
          const std::vector<std::string> &sections);
  };

  /**
   * Returns the bodies of @p descriptions on their section @p meshes. Solids
   * may take @p memory_limit bytes (0: that of the machine). Beams with the
   * same mesh and theory share their section with its matrices S_pq. Nodes of
   * SV-N, and of bodies with `Theories`, carry all fields: choose_fields()
   * selects them later. Throws InputError for a body longer than 1e7 times the
   * extent of its section, whose rigid motions doubles cannot distinguish
   * (doc/theory/stable-basis.md), for a beam with fewer axis nodes than
   * processes, and as HexahedralMesh does. Collective.
   */
  Bodies
  make_bodies(const std::vector<BodyDescription> &descriptions,
              const SectionMeshes                &meshes,
              const double                        memory_limit = 0.);
} // namespace lamella

#endif
