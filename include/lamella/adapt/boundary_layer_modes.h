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
  /// Measured constants of boundary_layer_modes(). H and B are the smaller and
  /// larger side of the section (doc/theory/saint-venant-fields.md).
  struct BoundaryLayerRules
  {
    /// Length of the end segment over B.
    double length = 8.;
    /// Limits over H of the length of the element at the constrained end;
    /// within these limits, the scene's element length is used. The lower limit
    /// equals the length for `auto`, so bisection of an axis does not change
    /// modes. Shorter elements are no better, since stresses are singular at
    /// corners.
    double shortest_element = 0.15, longest_element = 0.5;
    /// Distances from the end over B at which the zones begin, ascending.
    std::vector<double> zones{0., 1., 3.};
    /// Distance over B by which modes of a zone extend into the next zone.
    double overlap = 0.5;
    /// Modes with a smaller amplitude are omitted; Saint-Venant states have 1.
    double tolerance = 1e-3;
    /// Modes below this fraction of their largest value have decayed.
    double rest = 1e-2;
    /// Largest number of DoFs of an end segment; above it there are no modes.
    double max_dofs = 1e5;
    /// Distance over B within which stresses require modes of full degree.
    double sampled = 1.;
  };

  /// Constraint of a whole section, with the side on which the body continues.
  /// A free end has no rows.
  struct ConstrainedSection
  {
    /// Rows r of the constraints r(u) = 0 in the fields of the section.
    std::vector<LinearFunctional> rows;
    /// True if the body continues in the direction of +y.
    bool extends_forward = true;
    /// Length of the axis element beside the section [length].
    double element = 0.;
    /// Name of the body, and of the supports and contacts that constrain it.
    std::string              body;
    std::vector<std::string> by;
    /// True if stresses are requested within BoundaryLayerRules::sampled.
    bool is_sampled = false;

    /// Returns true if the axis elements have the same length, to rounding.
    bool
    has_same_element_length(const ConstrainedSection &other) const;
  };

  /// Returns the constraints of the section at interaction number @p t of @p
  /// interactions (LocalInteraction::constrains_section) on a body with @p
  /// axis: the rows of all interactions that constrain this section, once for
  /// each side on which the body continues.
  std::vector<ConstrainedSection>
  constrained_sections(const std::vector<LocalInteraction> &interactions,
                       const unsigned int                   t,
                       const Axis                          &axis);

  /// Deformation of a free section by a temperature that is constant along the
  /// axis,
  ///   v + sum_j c_j a_j,
  /// with the section function v from the constant thermal load h_s
  /// (SaintVenant::response_to_constant()) and the six Saint-Venant states
  /// (a_j, b_j), displacements a_j and axial derivatives b_j. With the section
  /// stiffness matrices S_10, S_11 (SaintVenant) and the thermal load h_y on
  /// axial derivatives, the end traction is
  ///   r = S_10 v - h_y + sum_j c_j (S_10 a_j + S_11 b_j).
  /// The c_j are such that the section forces of r are zero.
  struct HeatedSection
  {
    Vector answer, traction;
    HeatedSection(const SaintVenant              &states,
                  const Beam::SectionThermalLoad &heat);
  };

  /// Returns true if both sections have the same constraints, to rounding.
  bool
  alike(const ConstrainedSection &a, const ConstrainedSection &b);

  /// Boundary-layer modes of the nodes within a distance from an end.
  struct BoundaryLayerZone
  {
    FieldColumns fields;
    /// Largest distance from the end [length].
    double influence_length = 0.;
    /// True if the modes were computed for a section of lower degree.
    bool is_embedded = false;
  };

  /// Returns the axis element length at the constrained end of the segment.
  double
  first_element(const Section            &section,
                const ConstrainedSection &held,
                const BoundaryLayerRules &rules);

  /// Computes boundary-layer modes: fields that decay with the distance from an
  /// end at which the whole section is constrained. A short end segment of the
  /// body is solved with all section fields on an axis graded to the end. It is
  /// constrained by @p held and loaded at its other end by tractions S_10 a +
  /// S_11 b (section stiffness matrices S of SaintVenant) of the six
  /// Saint-Venant states (a, b), which cause no boundary layer there. The loads
  /// are combined such that the section forces s at the constrained end are
  /// orthonormal in the section compliance C, s_i^T C s_j = delta_ij, without
  /// work on free rigid motions.
  ///
  /// The displacements u_i at node i, without rigid fields and Saint-Venant
  /// warpings, are multiplied by sqrt(int N_i dy / H) with the shape function
  /// N_i and the smaller section side H, and reduced to a basis by proper
  /// orthogonal decomposition in the metric of Warping. Since few modes decay
  /// slowly, there are zones. The outermost zone has the modes of its nodes,
  /// each inner zone those that its nodes require in addition.
  ///
  /// Each entry of @p heat adds a load case: the thermal load along the segment
  /// without the end traction. The solution less the section function v
  /// (HeatedSection) is the boundary layer of a constrained or free section,
  /// scaled to the energy of a Saint-Venant state along H. A partly constrained
  /// section that can still move has none.
  ///
  /// Returns the zones, outermost first, independent of rigid fields and
  /// warpings, without empty zones. Returns none if no load acts on the segment
  /// or if it has too many DoFs. Axis elements are B4. Throws NumericsError if
  /// the stiffness is not positive definite. Collective.
  std::vector<BoundaryLayerZone>
  boundary_layer_modes(const std::shared_ptr<const Section> &section,
                       const SaintVenant                    &states,
                       const Warping                        &warping,
                       const FieldColumns                   &warpings,
                       const ConstrainedSection             &held,
                       const std::vector<HeatedSection>     &heat  = {},
                       const BoundaryLayerRules             &rules = {});

  /// Returns the total number of nodes of the end segments that
  /// boundary_layer_modes() solves for @p beam (all fields at all nodes) with
  /// @p interactions, as an estimate of its cost. Includes mirror images.
  unsigned int
  nodes_of_pieces(const Beam                          &beam,
                  const std::vector<LocalInteraction> &interactions,
                  const BoundaryLayerRules            &rules = {});

  /// Returns @p zones mirrored along the axis (u_y changes its sign), for an
  /// equal support at the other end. Empty unless @p section (such as cross
  /// plies) and the constraint @p held are symmetric.
  std::vector<BoundaryLayerZone>
  mirrored(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &section,
           const ConstrainedSection             &held);
} // namespace lamella

#endif
