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
  /**
   * A body as a scene describes it: plain data, names checked. Where it stands,
   * what section it has, and its discretisation: the theory (the paper's
   * Sec. 2) and the mesh along the axis. No mesh, matrix or material is made
   * yet: make_bodies() does that.
   */
  struct BodyDescription
  {
    /// Its name, and that of its section.
    std::string name, section;
    /// The body's own, or else the scene's; a solid, too, is a theory here. Of
    /// `Theories` the leading one.
    Theory theory;
    /// Where the nodes of the axis differ by hand; else empty.
    TheoryPieces pieces;
    /// Its place and directions in the scene.
    Placement placement;
    /// The length, and elements along it; of a solid those it is extruded in.
    AxisMesh axis;
    /// Share of E A / L that the springs have which hold its free rigid
    /// motions; 0: none, at most 0.01. What they are is a condition's business.
    double stabilisation = 0.;
    /// Whether rigid motions that nothing acts against are taken out, and those
    /// that contact may hold get springs (conditions/hold.h).
    bool is_held = false;
    /// Whether it may turn by any angle (GreenBeam).
    bool turns = false;
    /// Of a solid: how often its hexahedra are divided. Beams ignore it. The
    /// memory limit in it is set by make_bodies().
    SolidRefinement refinement;
  };

  /**
   * The entries of a `subsection Body NAME`, its `Kinematics` among them. Those
   * of the subsection itself are
   *   Section          a name of the scene's sections
   *   Origin           of the section at the start of the axis   (0, 0, 0)
   *   Axis, Up         directions of y, and that z leans towards (y, z)
   *   Length           of the axis
   *   Stabilisation    share of E A / L, 0 to 0.01               (0)
   *   Hold             statically determinate, or empty          (empty)
   * in the scene's axes and unit of length. `Kinematics` has the entries of
   * TheoryParameters, AxisParameters and SolidParameters, whichever of them the
   * theory needs: a scene may change its theory and keep all others.
   */
  struct BodyParameters
  {
    /// Declares them in the subsection that @p prm stands in.
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * Reads the body @p name from @p prm, which stands in its subsection and
     * comes back to it. @p scene_theory is the scene's entry `Theory`, which
     * counts where the body has none; @p sections are the names that `Section`
     * may say.
     *
     * Throws InputError, naming the entry, if the section is unknown, the
     * length missing or not positive, Axis and Up parallel or zero,
     * Stabilisation out of its range, or an entry of Kinematics wrong; EBBT
     * needs B4, as Kirchhoff's constraint takes cubic deflections.
     */
    static BodyDescription
    parse(dealii::ParameterHandler       &prm,
          const std::string              &name,
          const Entry                    &scene_theory,
          const std::vector<std::string> &sections);
  };

  /**
   * The bodies of @p descriptions on their section meshes: beams, or solids
   * which may take @p memory_limit bytes (0: what the machine has). Beams with
   * the same mesh and theory share their section, whose matrices S_pq are
   * integrated once for all of them; each has an axis of its own. Collective.
   *
   * The nodes of SV-N, and those of bodies with `Theories`, carry all fields of
   * their section here: which of them the scene wants, and which further ones,
   * is chosen when it is known what touches the bodies (choose_fields()).
   *
   * @p meshes has all sections that the descriptions name. Throws InputError
   * for a body so long that its rigid motions cannot be told apart in doubles,
   * 1e7 times the extent of its section (doc/stable-basis.md), for a beam with
   * fewer nodes along its axis than there are processes, and what
   * HexahedralMesh throws.
   */
  Bodies
  make_bodies(const std::vector<BodyDescription> &descriptions,
              const SectionMeshes                &meshes,
              const double                        memory_limit = 0.);
} // namespace lamella

#endif
