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
  /// A load, a support or a side of a contact on a beam, as seen by the
  /// section. It acts through rows over the DoFs,
  ///   r(u) = sum_i sum_alpha w_i f_alpha u_(i,alpha),
  /// with axis weights w and section load vectors f, the only loads that the
  /// section has to respond to, from a beam with all fields at all nodes.
  struct LocalInteraction
  {
    /// Name, as in "contact nose".
    std::string name;
    /// Independent section load vectors f of unit length.
    std::vector<Vector> loads;
    /// Area-weighted mean of all rows, and linear part across: the far load.
    std::vector<Vector> smooth;
    /// Range of the axis elements, or of the node [length].
    double begin = 0., end = 0.;
    /// Length of the shortest axis element there [length].
    double element = 0.;
    /// True if it constrains the section as a whole: a clamp (is_clamp()).
    bool constrains_section = false;
    /// True if it is only an end that is free to deform.
    bool is_free = false;
    /// Rows r(u) = 0 of a clamp, in the fields of the section.
    std::vector<LinearFunctional> held;
    /// True if it is a side of a contact, a support, or heat.
    bool is_contact_side = false, holds = false, is_heat_source = false;
  };

  /// Returns the interactions of body @p body, @p beam with all fields at all
  /// nodes, in the order of supports, loads, contacts. A contact is followed by
  /// its friction along either tangent. Contact normal to the axis is taken
  /// without its part along it. Heat that varies along the axis is a load
  /// "heat".
  std::vector<LocalInteraction>
  find_interactions(const Beam                          &beam,
                    const unsigned int                   body,
                    const Bodies                        &bodies,
                    const std::vector<Support>          &supports,
                    const std::vector<Load>             &loads,
                    const std::vector<ContactInterface> &contacts,
                    const InteractionRules              &rules = {});

  /// Returns the load vector of @p load on body number @p body, at factor 1.
  Vector
  load_vector_on(const Load        &load,
                 const unsigned int body,
                 const Bodies      &bodies);

  /// Returns the ends of the heated @p beam that no interaction constrains as a
  /// whole, where thermal stress along the axis ends.
  std::vector<LocalInteraction>
  heated_free_ends(const Beam                          &beam,
                   const std::vector<LocalInteraction> &interactions);
} // namespace lamella

#endif
