// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `adapt`: the choice of section functions for each axis node of a
// beam from supports, loads and contacts. It solves equations of sections
// (their states and responses) and of short end segments of beams
// (boundary_layer_modes()), never those of the scene.

#ifndef lamella_adapt_node_fields_h
#define lamella_adapt_node_fields_h

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/adapt/plan.h>
#include <lamella/body/parameters.h>
#include <lamella/recover/requests.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Parameters of choose_fields(), found by measurements
  /// (doc/theory/saint-venant-fields.md).
  struct FieldRules
  {
    /// Smallest wave number of harmonic loads, times the larger section side.
    double lowest_wave = 0.25;
    /// Value of lowest_wave for thin walls, which deform over long distances.
    double lowest_wave_of_walls = 0.05;
    /// Fraction of its bounding box below which a section has thin walls.
    double thin_walls = 0.5;
    /// Largest wave number near loads, times the shortest element length.
    double highest_wave = 10.;
    /// Largest wave number elsewhere, times the smaller section side.
    double highest_wave_far = 4.;
    /// Smallest ratio of the largest to the smallest wave number.
    double min_wave_ratio = 2.;
    /// Tolerance of Warping::basis() near interactions. For N > reference_waves
    /// wave numbers, it is multiplied by (reference_waves / N)^2.
    double near_tolerance = 3e-2;
    double far_tolerance  = 1e-2; ///< Tolerance of Warping::basis() elsewhere.
    /// Number of wave numbers for which near_tolerance was found.
    unsigned int reference_waves = 6;
    /// Length below which the component of a thermal load vector of unit length
    /// orthogonal to the other thermal load vectors counts as zero.
    double heat_tolerance = 1e-3;
    /// Parameters of find_interactions().
    InteractionRules interactions = {};
    /// Distance from an interaction within which nodes have its section
    /// functions, as a multiple of the smaller section side.
    double influence_length = 2.;
    /// Distance from a clamp without boundary-layer modes within which nodes
    /// have its section functions, as a multiple of the larger section side.
    double influence_length_of_clamp = 1.5;
    /// Cache of boundary-layer modes, shared by the models of one scene.
    std::shared_ptr<BoundaryLayerModes> ends =
      std::make_shared<BoundaryLayerModes>();
    /// Parameters of plan(), which chooses the model of each body.
    PlanRules plan = {};
    /// Names of bodies that could be solved only with all section functions.
    std::vector<std::string> unsolved = {};
  };

  /// Range of a beam's axis in which a probe, line or cut requests stresses.
  struct StressRange
  {
    /// Number of the body in Bodies.
    unsigned int body = 0;
    double begin = 0.; ///< Start of the range along the body's axis [length].
    double end   = 0.; ///< End of the range along the body's axis [length].
  };

  /// Returns axial ranges of @p bodies with @p probes, @p lines and @p cuts.
  std::vector<StressRange>
  stress_ranges(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts);

  /// Replaces bodies of the theories SV and SV-N, and those with `Theories`, by
  /// bodies with the section functions that loads, supports and contacts excite
  /// (doc/theory/saint-venant-fields.md). @p bodies are those of make_bodies()
  /// for @p descriptions, with all section functions at all nodes. Names,
  /// sections, axes and positions are unchanged. Supports, loads and @p
  /// contacts refer to the old bodies and must be created again.
  ///
  /// All nodes have the rigid displacements, Saint-Venant warpings, and section
  /// functions for heat and weight under @p gravity (scene axes, length / s^2).
  /// - Nodes near interactions also have the responses (SectionResponse) to
  ///   their section load vectors, harmonic along y with N wave numbers.
  /// - Nodes elsewhere also have the responses to LocalInteraction::smooth of
  ///   all interactions and, in bodies with inertia, to inertial forces,
  ///   harmonic and constant along y.
  /// - Nodes near clamps and heated free ends also have boundary-layer modes.
  /// In segments of `Theories`, nodes of SV have rigid displacements and
  /// warpings only, and nodes of LE-q have section functions up to degree q. If
  /// stresses are @p requested in an element, each of its nodes has the
  /// functions of all, as the node with the fewest limits the accuracy.
  ///
  /// Returns notes for the user. If @p why is not null, sets it to the reason
  /// for the section functions of each body of SV or SV-N. Throws NumericsError
  /// if section matrices cannot be factorized. Collective if @p bodies are.
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

  /// Returns true if choose_fields() would replace any of the bodies: if any
  /// has the theory SV or SV-N, or different `Theories` along its axis.
  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions);
} // namespace lamella

#endif
