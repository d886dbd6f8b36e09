// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_interaction_notes_h
#define lamella_adapt_interaction_notes_h

#include <lamella/adapt/local_interactions.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Adds notes on @p interactions of the SV @p beam without fields.
  void
  add_missing_field_notes(const Beam                          &beam,
                          const std::vector<LocalInteraction> &interactions,
                          std::vector<std::string>            &notes);

  /// Adds notes on @p interactions of a heated @p beam that constrain sections
  /// in part, where end fields do not cover heat.
  void
  add_guide_heat_notes(const Beam                          &beam,
                       const std::vector<LocalInteraction> &interactions,
                       std::vector<std::string>            &notes);
} // namespace lamella

#endif
