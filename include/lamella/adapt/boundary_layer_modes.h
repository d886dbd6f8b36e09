// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_boundary_layer_modes_h
#define lamella_adapt_boundary_layer_modes_h

#include <lamella/adapt/local_interactions.h>
#include <lamella/section/saint_venant.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Measured constants of boundary_layer_modes(); H and B are the smaller and
  /// larger extent of the section (doc/theory/saint-venant-fields.md).
  struct BoundaryLayerRules
  {
    /// Length of the piece over B.
    double length = 8.;
    /// Limits over H of the element at the held end, else as long as the
    /// scene's. The lower one is that of `auto`: fields stay the same when such
    /// an axis is halved. Finer pieces are no better, since the strongest
    /// disturbance grows without limit at corners.
    double shortest_element = 0.15, longest_element = 0.5;
    /// Starts of the zones over B, ascending.
    std::vector<double> zones{0., 1., 3.};
    /// Overlap over B of inner fields with the next zone.
    double overlap = 0.5;
    /// Amplitude below which combinations are cut; Saint-Venant states have 1.
    double tolerance = 1e-3;
    /// Share of their largest value below which fields have decayed.
    double rest = 1e-2;
    /// Largest number of DoFs of a piece; beyond it there are no end fields.
    double max_dofs = 1e5;
    /// Distance over B of stresses that give a richer section a piece.
    double sampled = 1.;
  };

  /// Constraint of a section as a whole, and body side. A free end has no rows.
  struct ConstrainedSection
  {
    /// Rows r(u) = 0 in the fields of the section.
    std::vector<LinearFunctional> rows;
    /// True if the body continues in the direction of +y.
    bool extends_forward = true;
    /// Length of the axis element beside the section [length].
    double element = 0.;
    /// Name of the body, and of its interactions that constrain it, in order.
    std::string              body;
    std::vector<std::string> by;
    /// True if stresses are requested within BoundaryLayerRules::sampled.
    bool is_sampled = false;

    /// Returns whether the axis elements are as long, to rounding.
    bool
    has_same_element_length(const ConstrainedSection &other) const;
  };

  /// Returns the constraints of the section at interaction @p t of @p
  /// interactions (LocalInteraction::constrains_section) on a body with @p
  /// axis: the rows of all that constrain it there, once for each side of the
  /// body.
  std::vector<ConstrainedSection>
  constrained_sections(const std::vector<LocalInteraction> &interactions,
                       const unsigned int                   t,
                       const Axis                          &axis);

  /**
   * Deformation of a free section by heat that is constant along the axis,
   *   v + sum_j c_j a_j,
   * with the response v (SaintVenant::response_to_constant()) to the heat load
   * h_s on values. It leaves the end traction, with the load h_y on
   * derivatives,
   *   r = S_10 v - h_y + sum_j c_j (S_10 a_j + S_11 b_j).
   * The c_j of the six states (a_j, b_j) make the section forces of r zero.
   */
  struct HeatedSection
  {
    Vector answer, traction;
    HeatedSection(const SaintVenant              &states,
                  const Beam::SectionThermalLoad &heat);
  };

  /// Returns whether both have the same constraints, to rounding.
  bool
  alike(const ConstrainedSection &a, const ConstrainedSection &b);

  /// Fields that nodes carry up to a distance from an end.
  struct BoundaryLayerZone
  {
    FieldColumns fields;
    /// Distance from the end [length].
    double influence_length = 0.;
    /// True if the fields are those of a poorer section.
    bool is_embedded = false;
  };

  /// Returns the length of the axis element at the held end of the piece.
  double
  first_element(const Section            &section,
                const ConstrainedSection &held,
                const BoundaryLayerRules &rules);

  /**
   * Computes the end fields, which decay from an end that is constrained as a
   * whole. A short piece of the body is solved with all section fields on an
   * axis graded to the end. It is constrained by @p held and loaded at the
   * other end by the tractions S_10 a + S_11 b of the six Saint-Venant states,
   * which cause no disturbance there. The loads are combined such that the
   * section forces s at the held end are orthonormal in the compliance, s_i^T C
   * s_j = delta_ij (unit energy per length), and do no work on free rigid
   * motions.
   *
   * The displacement u_i at node i less rigid part and warpings, times
   *   sqrt( int N_i dy / H ),
   * is cut to a basis by proper orthogonal decomposition in the metric of
   * Warping: the sum of squares is the energy of the disturbance along the
   * piece, except for variation along the axis. Few fields decay slowly, so
   * there are zones: the outermost has the fields of its nodes, each inner one
   * those that nodes from its start on add to the outer zones.
   *
   * Each of @p heat adds a load: that of its response along the piece, without
   * the traction at the end. The solution less the response is the disturbance
   * of a held or free section, scaled to the energy of a state along one H. A
   * partly held section that can still move has none.
   *
   * Returns the zones, outermost first, free of rigid fields and warpings,
   * without empty zones; none if nothing can load the piece or it would be too
   * large. The axis is B4. Throws NumericsError if the stiffness is not
   * positive definite. Collective.
   */
  std::vector<BoundaryLayerZone>
  boundary_layer_modes(const std::shared_ptr<const Section> &section,
                       const SaintVenant                    &states,
                       const Warping                        &warping,
                       const FieldColumns                   &warpings,
                       const ConstrainedSection             &held,
                       const std::vector<HeatedSection>     &heat  = {},
                       const BoundaryLayerRules             &rules = {});

  /// Returns the number of nodes of the pieces that boundary_layer_modes()
  /// would solve for @p beam (all fields at all nodes) with @p interactions, an
  /// estimate of their cost, mirror images included.
  unsigned int
  nodes_of_pieces(const Beam                          &beam,
                  const std::vector<LocalInteraction> &interactions,
                  const BoundaryLayerRules            &rules = {});

  /// Returns @p zones mirrored across the axis (u_y changes its sign), for the
  /// same support at the other end. Empty unless @p section, as of cross plies,
  /// and @p held, which belongs to @p zones, are their own mirror images.
  std::vector<BoundaryLayerZone>
  mirrored(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &section,
           const ConstrainedSection             &held);
} // namespace lamella

#endif
