// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_local_interactions_h
#define lamella_adapt_local_interactions_h

#include <lamella/adapt/section_load.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/gap_constraints.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A load, a support or one side of a contact on a beam. It acts on the DoFs
  /// u_(i,alpha) of axis node i and section function alpha by
  ///   r(u) = sum_i sum_alpha w_i f_alpha u_(i,alpha),
  /// with weights w_i along the axis and section load vectors f. The load
  /// vectors refer to all functions of the section. Fewer functions suffice if
  /// they represent the deformation due to these vectors.
  struct LocalInteraction
  {
    /// Name, for example "contact nose".
    std::string name;
    /// Linearly independent section load vectors f, of unit length.
    std::vector<Vector> loads;
    /// Load vectors that replace `loads` at distant nodes: their mean over the
    /// loaded area and their component linear in the section coordinates.
    std::vector<Vector> smooth;
    double begin = 0.; ///< Start of the loaded axis elements, y [length].
    double end   = 0.; ///< End of the loaded axis elements, y [length].
    /// Length of the shortest loaded axis element [length].
    double element = 0.;
    /// True if the interaction constrains the whole section, such as a clamp.
    bool constrains_section = false;
    /// True for an unconstrained end of a heated body (heated_free_ends()).
    bool is_free = false;
    /// Functionals r of the constraints r(u) = 0 of a clamp, where u are the
    /// amplitudes of section functions; empty unless constrains_section.
    std::vector<LinearFunctional> held;
    bool is_contact_side = false; ///< True for normal forces of a contact.
    bool holds           = false; ///< True for a support.
    bool is_heat_source  = false; ///< True for a temperature varying along y.
  };

  /// Returns the interactions on body number @p body, @p beam with all section
  /// functions at all nodes, in the order of supports, loads, temperature,
  /// contacts. Each contact is followed by its friction along both tangents. A
  /// small axial component of contact normals is omitted (InteractionRules). A
  /// temperature that varies along the axis is a load with the name "heat".
  std::vector<LocalInteraction>
  find_interactions(const Beam                          &beam,
                    const unsigned int                   body,
                    const Bodies                        &bodies,
                    const std::vector<Support>          &supports,
                    const std::vector<Load>             &loads,
                    const std::vector<ContactInterface> &contacts,
                    const InteractionRules              &rules = {});

  /// Returns nodal forces of @p load on body number @p body for load factor 1.
  Vector
  load_vector_on(const Load        &load,
                 const unsigned int body,
                 const Bodies      &bodies);

  /// Returns those ends of the heated @p beam that none of @p interactions
  /// constrains as a whole. The axial thermal stress vanishes there.
  std::vector<LocalInteraction>
  heated_free_ends(const Beam                          &beam,
                   const std::vector<LocalInteraction> &interactions);

  /// Adds to @p notes a message for each of @p interactions whose local
  /// deformation of the section the Saint-Venant theory (SV) of @p beam cannot
  /// represent: contacts, and temperatures that vary along the axis.
  void
  add_missing_field_notes(const Beam                          &beam,
                          const std::vector<LocalInteraction> &interactions,
                          std::vector<std::string>            &notes);

  /// Adds to @p notes a message for each of @p interactions that constrains
  /// only some displacements of a section of a heated @p beam. There,
  /// boundary-layer modes exclude thermal loads, so stresses are inaccurate.
  void
  add_guide_heat_notes(const Beam                          &beam,
                       const std::vector<LocalInteraction> &interactions,
                       std::vector<std::string>            &notes);

  /// Returns the reason why strains and stresses diverge under refinement at @p
  /// position (scene axes) of body number @p body: a sentence without a full
  /// stop, empty if no reason is known. Known reasons are
  /// - loads on a point or a line: stresses grow as 1/r^2 or 1/r, distance r;
  /// - clamps: an end constrained along the axis and along the normal of an
  ///   adjacent unconstrained side. Stresses grow as r^-0.29 for a Poisson's
  ///   ratio of 0.3 (Williams, J. Appl. Mech. 19 (1952) 526-528). An end
  ///   constrained in one of these directions only is a symmetry plane;
  /// - contacts: an end of a body on another body that continues beyond it, in
  ///   the undeformed scene, as at the edge of a punch;
  /// - corners of the section, re-entrant or at ends of different plies
  ///   (singular_corners()), if the theory lets the section deform.
  ///
  /// Not considered: loads that do not excite a singularity, such as bending at
  /// the corner of an L; supported points; and edges of obstacles.
  std::string
  singularity_reason(const dealii::Point<3>         &position,
                     const unsigned int              body,
                     const Bodies                   &bodies,
                     const std::vector<Support>     &supports,
                     const std::vector<Load>        &loads,
                     const std::vector<ContactPair> &contacts);
} // namespace lamella

#endif
