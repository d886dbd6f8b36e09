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
  /// Sources of the error of a computed result.
  enum class Source
  {
    axis,    ///< elements along the beam axes
    fields,  ///< beam theory: set of section functions
    section, ///< section mesh and its degree; for solids the whole mesh
    contact, ///< penetration due to a penalty
    path     ///< size of load steps, on which friction depends
  };

  /// Names of the error sources in output files.
  template <>
  struct Names<Source>
  {
    /// Value and name of each error source, in the order of refinement.
    static constexpr NameOf<Source> all[] = {{Source::axis, "axis"},
                                             {Source::fields, "fields"},
                                             {Source::section, "section"},
                                             {Source::contact, "contact"},
                                             {Source::path, "path"}};
  };

  /// Returns the numbers of DoFs, nodes etc. of each body of @p model.
  std::vector<BodySize>
  sizes_of(const BuiltScene &model);

  /// Returns true if SV-N (section functions for N wave numbers) can replace
  /// the Lagrange expansion of @p body, of size @p size, at lower cost.
  bool
  may_have_responses(const BodyDescription &body,
                     const BodySize        &size,
                     const PlanRules       &rules = {});

  /// Returns @p scene with one error source, @p source, refined in all bodies.
  /// LE-N is the Lagrange expansion of degree N, SV-N the theory with section
  /// functions computed for N wave numbers:
  /// - axis: elements along beams are bisected;
  /// - fields: EBBT, TBT and TE-N become SV-10, SV to SV-5 become SV-6. They
  ///   become LE-2 instead if LE-2 has at most PlanRules::cheap_dofs DoFs, or
  /// if contacts extend over more than the fraction max_contact_share of the
  ///   body or a support acts on one of its sides. Other SV-N get four more
  ///   wave numbers;
  /// - section: the degree of LE-N and the section order of SV-N increase by
  ///   one. If they are 8 (PlanRules::highest_degree, corner_degree), a layer
  ///   of cells is added at the corners of the section instead; without corners
  ///   each cell is divided in four. solid-1 becomes solid-2; cells of solid-2
  ///   are divided in eight;
  /// - contact: penalties are replaced by exact contact;
  /// - path: substeps are doubled (for_estimates() sets their number).
  ///
  /// LE-N becomes SV-10 with the same section mesh if the body (its size is in
  /// @p sizes) would get more than PlanRules::max_layerwise_dofs DoFs and SV-10
  /// can replace it (may_have_responses()). Axes must be divided into elements
  /// (grade_axes()).
  Scene
  enriched(const Scene                 &scene,
           const Source                 source,
           const std::vector<BodySize> &sizes,
           const PlanRules             &rules = {});

  /// Returns @p scene with one degree more for bodies of LE-N (Lagrange
  /// expansions), and with LE-@p degree for others.
  Scene
  with_enriched_section(Scene scene, const unsigned int degree);

  /// Returns @p scene with LE-1 for beams whose sections change their shape.
  Scene
  with_first_degree(Scene scene);

  /// Returns true if @p scene has the error source that enriched() refines.
  bool
  has_source(const Scene &scene, const Source source);

  /// Returns the scene of the solved @p run for comparison models, without
  /// output except probes. It has only the last load step. With large rotations
  /// or friction, it has all load steps; with friction also the run's substeps.
  Scene
  for_estimates(const Simulation &run);

  /// Returns true if a contact of @p scene pairs nodes of two bodies, whose
  /// axes can only be refined alike.
  bool
  pairs_nodes(const Scene &scene);

  /// Returns @p scene with the axis elements @p marked of its beams bisected.
  /// The axes must already be divided into elements. If a contact pairs the
  /// nodes of two bodies, all or none of their elements must be marked.
  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked);

  /// Returns the axis elements to be bisected to reduce the errors of @p goals.
  /// For each goal, elements are selected in descending order of |error| per
  /// DoF. The sum of |error| of the selected elements is at least @p share
  /// times that of all, and that of the others at most @p left times the
  /// tolerance. Returns an empty optional without element errors or if a
  /// contact pairs nodes.
  std::optional<std::vector<ElementError>>
  marked_elements(const Scene                   &scene,
                  const std::vector<GoalResult> &goals,
                  const double                   left,
                  const double                   share);

  /// Returns @p scene, a scene of the bodies of @p run, with axis elements at
  /// supports bisected if they are longer than @p longest times the larger
  /// section side: at points, lines and ends that supports constrain. Empty if
  /// there are none.
  std::optional<Scene>
  with_short_elements_at_supports(Scene             scene,
                                  const Simulation &run,
                                  const double      longest);
} // namespace lamella

#endif
