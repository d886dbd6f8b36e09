// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/adapt/interaction_notes.h>

#include <algorithm>

namespace lamella
{
  void
  add_missing_field_notes(const Beam                          &beam,
                          const std::vector<LocalInteraction> &interactions,
                          std::vector<std::string>            &notes)
  {
    const auto add = [&notes](const std::string &note) {
      if (std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back(note);
    };
    for (const LocalInteraction &interaction : interactions)
      if (interaction.is_contact_side)
        add("body " + beam.name() + ": SV has no fields that " +
            interaction.name +
            " can dent: forces are those of a beam, pressures and stresses "
            "there are not to be used. Use SV-N, SV-6 say");
      else if (interaction.is_heat_source)
        add("body " + beam.name() +
            ": SV has no fields for heat that varies along the axis: stresses "
            "are not to be used where it does. Use SV-N, SV-6 say");
  }



  void
  add_guide_heat_notes(const Beam                          &beam,
                       const std::vector<LocalInteraction> &interactions,
                       std::vector<std::string>            &notes)
  {
    if (!beam.is_heated())
      return;
    for (unsigned int t = 0; t < interactions.size(); ++t)
      if (interactions[t].constrains_section)
        {
          const auto held = constrained_sections(interactions, t, beam.axis());
          if (held[0].rows.size() < beam.section().n_fields() &&
              held[0].by[0] == interactions[t].name)
            notes.push_back(
              "body " + beam.name() + " is heated, and " +
              interactions[t].name +
              " holds its section in part: SV-N has no fields for what heat "
              "does there, and stresses within a height or two of it are not "
              "to be used. Use LE-N, or Theories with LE-N there");
        }
  }
} // namespace lamella
