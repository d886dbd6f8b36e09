// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `adapt`: the choice of fields for each node of a beam from the
// supports, loads and contacts of the bodies, which are made anew. It solves
// sections (their states and responses) and short pieces of a beam at an end
// (boundary_layer_modes()), never the scene.

#ifndef lamella_adapt_node_fields_h
#define lamella_adapt_node_fields_h

#include <lamella/adapt/boundary_layer_cache.h>
#include <lamella/adapt/plan_rules.h>
#include <lamella/body/parameters.h>
#include <lamella/recover/requests.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Measured constants of the choice of fields, with the smaller section
  /// extent H and the shortest loaded element h_e
  /// (doc/theory/saint-venant-fields.md).
  struct FieldRules
  {
    /// Smallest wave number over the larger extent of the section, and that of
    /// thin walls, which deform over long distances.
    double lowest_wave = 0.25, lowest_wave_of_walls = 0.05;
    /// Share of the bounding box below which a section has thin walls.
    double thin_walls = 0.5;
    /// Largest wave number near interactions over h_e, far from them over H.
    double highest_wave = 10., highest_wave_far = 4.;
    /// Least ratio of the largest to the smallest wave number.
    double min_wave_ratio = 2.;
    /// Tolerances of responses near and far (Warping::basis()), the near one
    /// times (6 / N)^2 for N > 6 = reference_waves.
    double       near_tolerance = 3e-2, far_tolerance = 1e-2;
    unsigned int reference_waves = 6;
    /// Independent part of a unit vector of a node's heat that is negligible.
    double heat_tolerance = 1e-3;
    /// Rules for interactions.
    InteractionRules interactions = {};
    /// Distance of responses over H, of clamps over the larger extent.
    double influence_length = 2., influence_length_of_clamp = 1.5;
    /// Cache of end fields for clamps (BoundaryLayerRules), shared by the
    /// models of one scene. Without end fields, tractions S_10 w and S_11 w of
    /// the six warpings w are load vectors.
    std::shared_ptr<BoundaryLayerModes> ends =
      std::make_shared<BoundaryLayerModes>();
    /// Rules for bodies with chosen fields.
    PlanRules plan = {};
    /// Names of bodies that keep all fields, as doubles could not solve fewer.
    std::vector<std::string> unsolved = {};
  };

  /// A range of an axis with requested stresses: a probe or box, a line, a cut.
  struct StressRange
  {
    /// Number of the body in Bodies.
    unsigned int body = 0;
    /// Range along the body's axis [length].
    double begin = 0., end = 0.;
  };

  /// Returns the places of @p probes, @p lines and @p cuts in @p bodies.
  std::vector<StressRange>
  stress_ranges(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts);

  /// Returns the intervals along the axis of body number @p body in which
  /// stresses are requested.
  std::vector<std::pair<double, double>>
  requested_ranges(const unsigned int              body,
                   const std::vector<StressRange> &requested);

  /**
   * Replaces bodies of SV-N, and those with `Theories`, by bodies with the
   * fields that their scene excites. @p bodies are those of make_bodies() for
   * @p descriptions, with all section fields at all nodes. Names, sections,
   * axes and places stay; conditions and contacts have to be made anew.
   *
   * Each node carries the six rigid fields, the Saint-Venant warpings, and
   * - near interactions, the responses at N wave numbers to their section load
   *   vectors (SectionResponse), from lowest_wave over the section to
   *   highest_wave / h_e in equal ratios;
   * - elsewhere, the responses to the mean and linear part of all interactions,
   *   also constant along the axis.
   * All nodes of a body that is heated, or under @p gravity (scene axes, length
   * / s^2), carry the response to that, constant along the axis; heat that
   * varies along it is a load there. Nodes beside clamped sections, and beside
   * free ends of heated bodies, carry end fields (boundary_layer_modes()).
   * Dependent fields are removed. In `Theories`, pieces of SV have none of
   * these, and nodes of LE-q carry section fields up to degree q
   * (Section::field_degree()). The end of such a piece has those of the higher
   * degree, and next to SV all of them.
   *
   * The stress in an element is as accurate as at its poorest node: all nodes
   * of an element with a place of @p requested carry the fields of any. Bodies
   * of the same section and theory share their fields. @p contacts are made of
   * @p bodies. Returns notes; @p why, if not null, gets the reason for the
   * fields of each body of SV-N. Throws NumericsError if the section's matrices
   * cannot be factorized. Collective where Beam is.
   */
  std::vector<std::string>
  choose_fields(Bodies                              &bodies,
                const std::vector<BodyDescription>  &descriptions,
                const std::vector<Support>          &supports,
                const std::vector<Load>             &loads,
                const std::vector<ContactInterface> &contacts,
                const std::vector<StressRange>      &requested = {},
                const FieldRules                    &rules     = {},
                const dealii::Tensor<1, 3>          &gravity   = {},
                std::vector<std::string>            *why       = nullptr);

  /// Returns whether choose_fields() would change any of the bodies.
  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions);
} // namespace lamella

#endif
