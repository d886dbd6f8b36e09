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
  /// Measured constants of choose_fields(), with the smaller section extent H
  /// and the length h_e of the shortest loaded element
  /// (doc/theory/saint-venant-fields.md).
  struct FieldRules
  {
    /// Smallest wave number times the larger side of the section; the second
    /// value is for thin walls, which deform over long distances.
    double lowest_wave = 0.25, lowest_wave_of_walls = 0.05;
    /// A section with a smaller fraction of its bounding box has thin walls.
    double thin_walls = 0.5;
    /// Largest wave number near interactions times h_e; elsewhere times H.
    double highest_wave = 10., highest_wave_far = 4.;
    /// Smallest ratio of the largest to the smallest wave number.
    double min_wave_ratio = 2.;
    /// Tolerances of Warping::basis() for fields near interactions and
    /// elsewhere. For N > reference_waves wave numbers, the first is multiplied
    /// by (reference_waves / N)^2.
    double       near_tolerance = 3e-2, far_tolerance = 1e-2;
    unsigned int reference_waves = 6;
    /// Thermal load vectors of unit length whose part independent of the others
    /// is smaller are omitted.
    double heat_tolerance = 1e-3;
    /// Parameters of find_interactions().
    InteractionRules interactions = {};
    /// Nodes have the fields of an interaction within this multiple of H, and
    /// of a clamp within this multiple of the larger side.
    double influence_length = 2., influence_length_of_clamp = 1.5;
    /// Cache of boundary-layer modes at clamps, shared by the models of one
    /// scene. Without cache, tractions of the Saint-Venant warpings are load
    /// vectors.
    std::shared_ptr<BoundaryLayerModes> ends =
      std::make_shared<BoundaryLayerModes>();
    /// Parameters of the choice of models (plan()).
    PlanRules plan = {};
    /// Names of bodies with all fields, since models with fewer failed.
    std::vector<std::string> unsolved = {};
  };

  /// Range of a beam's axis in which a probe, line or cut requests stresses.
  struct StressRange
  {
    /// Number of the body in Bodies.
    unsigned int body = 0;
    /// Range along the body's axis [length].
    double begin = 0., end = 0.;
  };

  /// Returns the axial ranges of @p probes, @p lines and @p cuts in @p bodies.
  std::vector<StressRange>
  stress_ranges(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts);

  /// Returns the ranges of body number @p body as (begin, end).
  std::vector<std::pair<double, double>>
  requested_ranges(const unsigned int              body,
                   const std::vector<StressRange> &requested);

  /// Replaces bodies of the theory SV-N, and those with `Theories`, by bodies
  /// with the section fields that loads, supports and contacts excite. @p
  /// bodies are those of make_bodies() for @p descriptions, with all section
  /// fields at all nodes. Names, sections, axes and positions are unchanged;
  /// supports, loads and contacts must be created again.
  ///
  /// Each node has the six rigid fields, the Saint-Venant warpings, and
  /// - near interactions, section functions from harmonic loads
  ///   (SectionResponse): their section load vectors at N wave numbers in
  ///   geometric progression, from lowest_wave over the section extent to
  ///   highest_wave / h_e;
  /// - elsewhere, section functions from harmonic and constant loads: the mean
  ///   and linear part of all load vectors.
  /// All nodes of a body that is heated, or loaded by its weight under @p
  /// gravity (scene axes, length / s^2), have the section function from this
  /// constant load. Heat that varies along the axis counts as a load. Nodes
  /// near clamped sections, and near free ends of heated bodies, have
  /// boundary-layer modes. Dependent fields are removed. In segments of
  /// `Theories`, nodes of SV have rigid fields and warpings only, and nodes of
  /// LE-q have section fields up to degree q (Section::field_degree()). A node
  /// between two segments has the fields of the higher degree, next to SV all.
  ///
  /// The stress in an element is as accurate as at its node with the fewest
  /// fields: if stresses are @p requested in an element, each of its nodes has
  /// the fields of all its nodes. Bodies of the same section and theory share
  /// their fields. @p contacts belong to the old @p bodies. Returns notes for
  /// the user. If not null, @p why is set to the reason for the fields of each
  /// body of SV-N. Throws NumericsError if the matrices of a section cannot be
  /// factorized. Collective if bodies are.
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

  /// Returns true if choose_fields() would change any of the bodies.
  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions);
} // namespace lamella

#endif
