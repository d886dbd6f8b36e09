// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_local_interactions_h
#define lamella_adapt_local_interactions_h

#include <lamella/adapt/section_load.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_constraints.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A load, a support or one side of a contact on a beam, with its section
  /// load vectors. It acts on the DoFs u_(i,alpha) of node i and section field
  /// alpha by
  ///   r(u) = sum_i sum_alpha w_i f_alpha u_(i,alpha),
  /// with weights w_i along the axis and section load vectors f. The section
  /// fields must represent the deformation by these vectors only. The vectors
  /// are computed for a beam with all fields at all nodes.
  struct LocalInteraction
  {
    /// Name, for example "contact nose".
    std::string name;
    /// Linearly independent section load vectors f, of unit length.
    std::vector<Vector> loads;
    /// Load vectors for distant nodes: mean over the area and linear part.
    std::vector<Vector> smooth;
    /// Range of the loaded axis elements, or position of the node [length].
    double begin = 0., end = 0.;
    /// Length of the shortest loaded axis element [length].
    double element = 0.;
    /// True if the whole section is constrained: a clamp (is_clamp()).
    bool constrains_section = false;
    /// True for an end of the body without constraint.
    bool is_free = false;
    /// Rows r of a clamp, r(u) = 0, in the fields of the section.
    std::vector<LinearFunctional> held;
    /// True for a side of a contact; for a support; for heat.
    bool is_contact_side = false, holds = false, is_heat_source = false;
  };

  /// Returns the interactions of body number @p body, @p beam with all fields
  /// at all nodes, in the order of supports, loads, contacts. After each
  /// contact follows its friction along both tangents. The axial component of a
  /// contact normal to the axis is omitted. A temperature that varies along the
  /// axis is a load with the name "heat".
  std::vector<LocalInteraction>
  find_interactions(const Beam                          &beam,
                    const unsigned int                   body,
                    const Bodies                        &bodies,
                    const std::vector<Support>          &supports,
                    const std::vector<Load>             &loads,
                    const std::vector<ContactInterface> &contacts,
                    const InteractionRules              &rules = {});

  /// Returns the load vector of @p load on body number @p body at factor 1.
  Vector
  load_vector_on(const Load        &load,
                 const unsigned int body,
                 const Bodies      &bodies);

  /// Returns the ends of the heated @p beam that no interaction constrains as a
  /// whole; the axial thermal stress vanishes there.
  std::vector<LocalInteraction>
  heated_free_ends(const Beam                          &beam,
                   const std::vector<LocalInteraction> &interactions);
} // namespace lamella

#endif
