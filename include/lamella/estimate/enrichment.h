// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_enrichment_h
#define lamella_estimate_enrichment_h

#include <lamella/base/names.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// What the error of a number comes from.
  enum class Source
  {
    axis,    ///< the elements along the axes
    fields,  ///< the fields that nodes carry: theories, wave numbers
    section, ///< degree and cells of the sections; of solids all their cells
    contact  ///< penetration under a penalty
  };

  template <>
  struct Names<Source>
  {
    static constexpr NameOf<Source> all[] = {{Source::axis, "axis"},
                                             {Source::fields, "fields"},
                                             {Source::section, "section"},
                                             {Source::contact, "contact"}};
  };

  /// The DoFs of a body up to which LE-N is enriched as it is; beyond them the
  /// section's own fields stand in.
  constexpr double most_dofs_of_layers = 60000.;

  /**
   * @p scene with less of one source of error, in all bodies:
   *   axis      elements along beams halved;
   *   fields    EBBT, TBT and TE-N become SV-10, SV-N up to SV-5 SV-6, and
   *             others get four wave numbers more; LE-N has all fields of its
   *             section already;
   *   section   LE-N becomes LE-(N+1); the section order of SV-N grows by one;
   *             solid-1 becomes solid-2, whose hexahedra are divided in eight;
   *   contact   penalties become exact.
   * LE-N becomes SV-10 with the same functions where the body, which has
   * @p dofs DoFs now, would have more than @p most_dofs. Nothing changes where
   * there is no such source: see has_source(). The axes of @p scene have to be
   * made (grade_axes()).
   */
  Scene
  enriched(const Scene                     &scene,
           const Source                     source,
           const std::vector<unsigned int> &dofs,
           const double                     most_dofs);

  /// Whether enriched() would change anything.
  bool
  has_source(const Scene &scene, const Source source);

  /// The scene as an estimate needs it: its last load step only, and nothing
  /// asked for but probes.
  Scene
  for_estimates(Scene scene);
} // namespace lamella

#endif
