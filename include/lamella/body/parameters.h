// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_parameters_h
#define lamella_body_parameters_h

#include <lamella/axis/axis.h>
#include <lamella/base/entry.h>
#include <lamella/body/body.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/section/theory.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Entries of `subsection Kinematics` for the mesh of a solid, with defaults:
  ///   Refinements    divisions of all hexahedra into eight           (0)
  ///   Refine near    further divisions of hexahedra in balls,
  ///                  `x, y, z: radius: times`, separated by '|'      (none)
  /// Balls are in scene axes. Beams ignore both entries.
  struct SolidParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the mesh refinement of a body at @p placement, with balls in
    /// body axes. Throws InputError for an invalid ball, a radius that is not
    /// positive, and more than 8 divisions.
    static SolidRefinement
    parse(const Entries &in, const Placement &placement);
  };

  /// Description of a body as read from a scene: placement, section, theory and
  /// axial mesh. make_bodies() constructs the body.
  struct BodyDescription
  {
    std::string name, ///< Name of the body.
      section;        ///< Name of its cross-section.
    /// Theory of the body; the first one if it varies along the axis.
    Theory theory;
    /// Theory of each axial range (entry `Theories`); empty if it is constant.
    TheoryPieces pieces;
    /// Position and axes in the scene.
    Placement placement;
    /// Length and elements along the axis.
    AxisMesh axis;
    /// Stiffness of springs against unconstrained rigid motions, as a fraction
    /// (0 to 0.01) of E A / L; 0: none; empty: none unless the body is in
    /// contact (stabilization_of_contact).
    std::optional<double> stabilization;
    /// True if an isostatic support removes free rigid motions of the body.
    bool is_held = false;
    /// True for finite rotations, false for small displacements and rotations.
    bool has_finite_rotations = false;
    /// True if the analysis includes inertial forces (Find = modes).
    bool has_inertia = false;
    /// Refinement of the hexahedra of a solid; unused for beams.
    SolidRefinement refinement;
  };

  /// BodyDescription::stabilization of bodies that contact may constrain.
  constexpr double stabilization_of_contact = 1e-6;

  /// Entries of `subsection Body NAME` and its subsection `Kinematics`. The
  /// former (defaults in parentheses, scene axes, units of the scene) are
  ///   Section          name of a section of the scene
  ///   Origin           position of the start of the axis         (0, 0, 0)
  ///   Axis             direction of the axis, y                  (y)
  ///   Up               direction whose part normal to Axis is z  (z)
  ///   Length           length of the axis
  ///   Stabilization    fraction of E A / L, 0 to 0.01            (auto)
  ///   Isostatic support  true or false                           (false)
  /// `Kinematics` has the entries of TheoryParameters, AxisParameters and
  /// SolidParameters; entries that the theory does not need are ignored.
  struct BodyParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the description of the body @p name from its subsection, the
    /// current one of @p prm. @p scene_theory is the default theory;
    /// @p sections are the names of all sections. Throws InputError, with the
    /// name of the entry, for an unknown section, a length <= 0, parallel Axis
    /// and Up, EBBT with elements other than B4, and other invalid entries.
    static BodyDescription
    parse(dealii::ParameterHandler       &prm,
          const std::string              &name,
          const Entry                    &scene_theory,
          const std::vector<std::string> &sections);
  };

  /// Constructs the bodies of @p descriptions with the section @p meshes.
  /// Solids may use @p memory_limit bytes (0: memory of the machine). Beams
  /// with the same mesh and theory share a Section. In Saint-Venant theory and
  /// with several theories along the axis, all nodes have all section functions
  /// until choose_fields() selects some per node. Throws InputError for a body
  /// longer than 1e7 times its section (beyond double precision) or a beam with
  /// fewer axis nodes than processes, and as HexahedralMesh does. Collective.
  Bodies
  make_bodies(const std::vector<BodyDescription> &descriptions,
              const SectionMeshes                &meshes,
              const double                        memory_limit = 0.);
} // namespace lamella

#endif
