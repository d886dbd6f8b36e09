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
  /// Sources of the error of a number.
  enum class Source
  {
    axis,    ///< the elements along the axes
    fields,  ///< the fields that nodes carry: theories, wave numbers
    section, ///< degree and cells of the sections; of solids all their cells
    contact, ///< penetration under a penalty
    path     ///< the load steps on which friction depends
  };

  /// Names, in the order in which sources are enriched.
  template <>
  struct Names<Source>
  {
    static constexpr NameOf<Source> all[] = {{Source::axis, "axis"},
                                             {Source::fields, "fields"},
                                             {Source::section, "section"},
                                             {Source::contact, "contact"},
                                             {Source::path, "path"}};
  };

  /// Returns the sizes of the bodies of @p model.
  std::vector<BodySize>
  sizes_of(const BuiltScene &model);

  /// Returns whether SV-N would have fewer fields for a body of LE-N.
  bool
  may_have_responses(const BodyDescription &body,
                     const BodySize        &size,
                     const PlanRules       &rules = {});

  /**
   * Returns @p scene with less of one source of error in all bodies:
   *   axis      elements along beams are halved;
   *   fields    EBBT, TBT and TE-N become SV-10, SV to SV-5 become SV-6; all
   *             of these become LE-2 where that has at most cheap_dofs or
   *             contacts cover more than max_contact_share of the body
   *             (PlanRules). SV-N gets four wave numbers more;
   *   section   the degree of LE-N and the section order of SV-N grow by one.
   *             At 8 (PlanRules::highest_degree, corner_degree) a layer of
   *             cells is added at the corners of the section, or without
   *             corners each cell is divided in four. (Degrees converge at
   *             twice the rate of equal cells where plies end, Szabo and
   *             Babuska 1991.) solid-1 becomes solid-2, whose hexahedra are
   *             divided in eight;
   *   contact   penalties become exact;
   *   path      substeps are doubled (for_estimates() sets their number).
   * LE-N becomes SV-10 with the same functions if the body, of the size in @p
   * sizes, would exceed max_layerwise_dofs and may_have_responses() holds. The
   * axes of @p scene have to be made (grade_axes()).
   */
  Scene
  enriched(const Scene                 &scene,
           const Source                 source,
           const std::vector<BodySize> &sizes,
           const PlanRules             &rules = {});

  /// Returns whether enriched() would change anything.
  bool
  has_source(const Scene &scene, const Source source);

  /// Returns the scene of the solved @p run for estimates: only its last load
  /// step (with friction all, in the run's substeps), and only probes.
  Scene
  for_estimates(const Simulation &run);
} // namespace lamella

#endif
