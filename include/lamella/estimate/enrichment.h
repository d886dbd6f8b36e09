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
  /// Sources of the error of a result.
  enum class Source
  {
    axis,    ///< the elements along the axes
    fields,  ///< the displacement fields: theory, wave numbers
    section, ///< degree and cells of the sections; of solids all their cells
    contact, ///< penetration under a penalty
    path     ///< the load steps on which friction depends
  };

  /// Names of the sources, in the order in which they are refined.
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

  /// Returns true if SV-N may have fewer fields than LE-N for @p body.
  bool
  may_have_responses(const BodyDescription &body,
                     const BodySize        &size,
                     const PlanRules       &rules = {});

  /// Returns @p scene with one source of error reduced in all bodies:
  /// - axis: elements along beams are bisected;
  /// - fields: EBBT, TBT and TE-N become SV-10, SV to SV-5 become SV-6. All of
  ///   these become LE-2 if LE-2 has at most PlanRules::cheap_dofs DoFs or
  ///   contacts extend over more than max_contact_share of the body. SV-N gets
  ///   four more wave numbers;
  /// - section: the degree of LE-N and the section order of SV-N increase by
  ///   one. At 8 (PlanRules::highest_degree, corner_degree) a layer of cells is
  ///   added at the corners of the section, or without corners each cell is
  ///   divided in four. (At ply ends, degrees converge at twice the rate of
  ///   equal cells, Szabo and Babuska 1991.) solid-1 becomes solid-2; then
  ///   hexahedra are divided in eight;
  /// - contact: penalties are replaced by exact contact;
  /// - path: substeps are doubled (for_estimates() sets their number).
  ///
  /// LE-N becomes SV-10 with the same section functions if the body, of the
  /// size in @p sizes, would exceed PlanRules::max_layerwise_dofs and
  /// may_have_responses() holds. The axes of @p scene must already be divided
  /// into elements (grade_axes()).
  Scene
  enriched(const Scene                 &scene,
           const Source                 source,
           const std::vector<BodySize> &sizes,
           const PlanRules             &rules = {});

  /// Returns true if enriched() would change @p scene.
  bool
  has_source(const Scene &scene, const Source source);

  /// Returns the scene for comparison models of the solved @p run: probes, and
  /// the last load step (with friction all, with the run's substeps).
  Scene
  for_estimates(const Simulation &run);
} // namespace lamella

#endif
