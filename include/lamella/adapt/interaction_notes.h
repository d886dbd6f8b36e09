// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_interaction_notes_h
#define lamella_adapt_interaction_notes_h

#include <lamella/adapt/local_interactions.h>

#include <string>
#include <vector>

namespace lamella
{
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
} // namespace lamella

#endif
