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
        add("adapt.fields-missing: body " + beam.name() +
            ": theory SV has no local deformation of sections near " +
            interaction.name +
            ", so pressures and stresses are inaccurate there. Use SV-6");
      else if (interaction.is_heat_source)
        add("adapt.fields-missing: body " + beam.name() +
            ": theory SV does not represent temperatures that vary along the "
            "axis, so thermal stresses are not accurate. Use Theory = SV-6");
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
          const auto constrained =
            constrained_sections(interactions, t, beam.axis());
          if (constrained[0].rows.size() < beam.section().n_fields() &&
              constrained[0].by[0] == interactions[t].name)
            notes.push_back(
              "adapt.fields-missing: body " + beam.name() +
              " has a Temperature, and " + interactions[t].name +
              " constrains some displacements of a section only: SV-N is not "
              "accurate there. Do not use stresses within two section heights "
              "of this support, or use LE-N there (Theory or Theories)");
        }
  }
} // namespace lamella
