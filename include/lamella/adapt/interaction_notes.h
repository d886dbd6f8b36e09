// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_interaction_notes_h
#define lamella_adapt_interaction_notes_h

#include <lamella/adapt/local_interactions.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Adds notes for the user on @p interactions of the Saint-Venant (SV)
  /// @p beam that have no fields of their own.
  void
  add_missing_field_notes(const Beam                          &beam,
                          const std::vector<LocalInteraction> &interactions,
                          std::vector<std::string>            &notes);

  /// Adds notes for the user on @p interactions of a heated @p beam that
  /// constrain sections in part: boundary-layer modes then omit heat.
  void
  add_guide_heat_notes(const Beam                          &beam,
                       const std::vector<LocalInteraction> &interactions,
                       std::vector<std::string>            &notes);
} // namespace lamella

#endif
