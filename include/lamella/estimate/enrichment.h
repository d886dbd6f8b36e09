// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_enrichment_h
#define lamella_estimate_enrichment_h

#include <lamella/adapt/plan.h>
#include <lamella/base/names.h>
#include <lamella/recover/results.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// What the error of a number comes from.
  enum class Source
  {
    axis,    ///< the elements along the axes
    fields,  ///< the fields that nodes carry: theories, wave numbers
    section, ///< degree and cells of the sections; of solids all their cells
    contact, ///< penetration under a penalty
    path     ///< the load steps on which friction depends
  };

  /// In the order in which they are made less, one after the other.
  template <>
  struct Names<Source>
  {
    static constexpr NameOf<Source> all[] = {{Source::axis, "axis"},
                                             {Source::fields, "fields"},
                                             {Source::section, "section"},
                                             {Source::contact, "contact"},
                                             {Source::path, "path"}};
  };

  /// Those of the bodies of @p model.
  std::vector<BodySize>
  sizes_of(const BuiltScene &model);

  /// Whether a body of LE-N could have its section's own fields instead, and
  /// these would be fewer.
  bool
  may_have_responses(const BodyDescription &body,
                     const BodySize        &size,
                     const PlanRules       &rules = {});

  /**
   * @p scene with less of one source of error, in all bodies:
   *   axis      elements along beams halved;
   *   fields    EBBT, TBT and TE-N become SV-10, SV to SV-5 SV-6, or all of
   *             these LE-2 where that has at most cheap_dofs or others may
   *             touch the body along more than long_contact of it (PlanRules);
   * SV-N gets four wave numbers more; LE-N has all fields of its section
   *             already;
   *   section   LE-N becomes LE-(N+1); the section order of SV-N grows by one;
   *             where either is 8 already (PlanRules::highest_degree,
   *             corner_degree) a layer of cells comes to the corners of the
   *             section, or where it has none its cells are divided in four
   *             (degrees come first: they converge at twice the
   *             rate of equal cells where plies end, Szabo and Babuska 1991);
   *             solid-1 becomes solid-2, whose hexahedra are divided in eight;
   *   contact   penalties become exact;
   *   path      twice as many substeps (for_estimates() says how many).
   * LE-N becomes SV-10 with the same functions where the body, of the size
   * @p sizes now, would have more than most_dofs_of_layers, and the fields of
   * responses are fewer than those of the section (may_have_responses()).
   * Nothing changes where there is no such source: see has_source(). The axes
   * of @p scene have to be made (grade_axes()).
   */
  Scene
  enriched(const Scene                 &scene,
           const Source                 source,
           const std::vector<BodySize> &sizes,
           const PlanRules             &rules = {});

  /// Whether enriched() would change anything.
  bool
  has_source(const Scene &scene, const Source source);

  /// The scene of @p run, which is solved, as an estimate needs it: its last
  /// load step only, and nothing asked for but probes. With friction all load
  /// steps, each in as many substeps as it took.
  Scene
  for_estimates(const Simulation &run);
} // namespace lamella

#endif
