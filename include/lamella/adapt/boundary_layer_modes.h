// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_boundary_layer_modes_h
#define lamella_adapt_boundary_layer_modes_h

#include <lamella/adapt/local_interactions.h>
#include <lamella/body/beam.h>
#include <lamella/conditions/support.h>
#include <lamella/section/saint_venant.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Parameters of boundary_layer_modes() (doc/theory/saint-venant-fields.md).
  struct BoundaryLayerRules
  {
    /// Length of the end segment, as a multiple of the larger section side.
    double length = 8.;
    /// Smallest element length at the constrained end, as a multiple of the
    /// smaller section side; equal to GradingRules::clamp. Shorter elements are
    /// not more accurate, since stresses are singular at corners.
    double shortest_element = 0.15;
    /// Largest element length at the constrained end, as a multiple of the
    /// smaller section side.
    double longest_element = 0.5;
    /// Distances from the constrained end at which the zones of modes begin, as
    /// multiples of the larger section side, ascending.
    std::vector<double> zones{0., 1., 3.};
    /// Length by which the modes of a zone extend into the next zone, as a
    /// multiple of the larger section side.
    double overlap = 0.5;
    /// Amplitude below which modes are omitted; Saint-Venant states have 1.
    double tolerance = 1e-3;
    /// Modes end where they are below this fraction of their maximum.
    double rest = 1e-2;
    /// Largest number of DoFs of an end segment; above it there are no modes.
    double max_dofs = 1e5;
    /// Distance from a constrained section, as a multiple of the larger section
    /// side, within which stresses require modes of the section's full degree.
    double sampled = 1.;
  };

  /// A cross section that is constrained as a whole, e.g. by a clamp, with the
  /// direction in which the body continues from the section. A free end is a
  /// constrained section without constraints.
  struct ConstrainedSection
  {
    /// Functionals r(u) = 0 of the amplitudes u of section functions.
    std::vector<LinearFunctional> rows;
    /// True if the body continues in direction +y from here, false for -y.
    bool extends_forward = true;
    /// Length of the axis element adjacent to the section [length].
    double                   element = 0.;
    std::string              body; ///< Name of the body.
    std::vector<std::string> by;   ///< Names of constraining interactions.
    /// True if stresses are requested near the section, within
    /// BoundaryLayerRules::sampled.
    bool is_sampled = false;

    /// Returns true if @p other has an element of the same length, to rounding.
    bool
    has_same_element_length(const ConstrainedSection &other) const;
  };

  /// Returns the constrained section at the position of interaction number @p t
  /// of @p interactions, on a body with @p axis, once for each direction in
  /// which the body continues. It has the constraints of all interactions that
  /// constrain this section as a whole (LocalInteraction::constrains_section).
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
    Vector answer;   ///< Displacement, amplitudes of the section functions.
    Vector traction; ///< End traction r, conjugate to these amplitudes.
    /// Computes the displacement and the end traction for the constant thermal
    /// load @p heat of the section with the Saint-Venant states @p states.
    HeatedSection(const SaintVenant              &states,
                  const Beam::SectionThermalLoad &heat);
  };

  /// Returns true if @p a and @p b have equal constraints, directions in which
  /// the body continues, and element lengths, to rounding.
  bool
  alike(const ConstrainedSection &a, const ConstrainedSection &b);

  /// Boundary-layer modes for the axis nodes near a constrained or free end.
  struct BoundaryLayerZone
  {
    /// Modes, one per column, as amplitudes of the section functions.
    FieldColumns fields;
    /// Largest distance from the end of nodes with these modes [length].
    double influence_length = 0.;
    /// True if the modes were converted from a lower degree by embedded().
    bool is_embedded = false;
  };

  /// Returns the axis element length at the constrained end of a segment: @p
  /// held.element, clipped to the smallest and largest length in @p rules.
  double
  first_element(const Section            &section,
                const ConstrainedSection &held,
                const BoundaryLayerRules &rules);

  /// Computes boundary-layer modes: fields that decay with the distance from an
  /// end at which the whole section is constrained
  /// (doc/theory/saint-venant-fields.md). A short end segment of the body with
  /// all section functions is constrained by @p held and loaded at its other
  /// end by the tractions of the six Saint-Venant states @p states, which cause
  /// no boundary layer there. The loads are combined so that they do no work on
  /// rigid motions that @p held leaves free, and that the section forces s at
  /// the constrained end are orthonormal, s_i^T C s_j = delta_ij, section
  /// compliance C.
  ///
  /// The displacements u_i at node i, less their rigid parts and Saint-Venant
  /// @p warpings, are multiplied by sqrt(int N_i dy / H) with the shape
  /// function N_i and the smaller section side H, and reduced to a basis by
  /// proper orthogonal decomposition in the metric of @p warping. Each zone of
  /// nodes has its own basis, since few modes reach far from the end. Modes of
  /// an inner zone are independent of those of outer zones.
  ///
  /// Each entry of @p heat adds a load case, its constant thermal load without
  /// end traction. The solution less the displacement of HeatedSection is
  /// scaled to the energy of a Saint-Venant state along H. Sections whose
  /// constraints leave rigid motions free have no thermal loads.
  ///
  /// Returns the zones, outermost first, without empty zones. Returns none if
  /// no load acts on the segment or if it has too many DoFs. Throws
  /// NumericsError if the stiffness is not positive definite. Collective.
  std::vector<BoundaryLayerZone>
  boundary_layer_modes(const std::shared_ptr<const Section> &section,
                       const SaintVenant                    &states,
                       const Warping                        &warping,
                       const FieldColumns                   &warpings,
                       const ConstrainedSection             &held,
                       const std::vector<HeatedSection>     &heat  = {},
                       const BoundaryLayerRules             &rules = {});

  /// Returns an upper bound of the number of nodes of all end segments that are
  /// solved for @p beam, to estimate cost; mirrored() may replace solutions.
  unsigned int
  nodes_of_pieces(const Beam                          &beam,
                  const std::vector<LocalInteraction> &interactions,
                  const BoundaryLayerRules            &rules = {});

  /// Returns the boundary-layer modes of an equal support at the other end: @p
  /// zones mirrored along the axis (u_y changes its sign). Returns no zones
  /// unless @p section (e.g. cross plies) and constraint @p held are symmetric.
  std::vector<BoundaryLayerZone>
  mirrored(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &section,
           const ConstrainedSection             &held);

  /// Returns the rigid motions of the segment @p piece that @p rows leave free.
  std::vector<Vector>
  free_motions(const Beam                              &piece,
               const std::vector<PrescribedFunctional> &rows);

  /// Returns the section load vectors that load the end segment @p piece in
  /// boundary_layer_modes(): tractions of Saint-Venant states at the axis node
  /// @p far_node, at the signed distance @p arm along y from the constrained
  /// end. They do no work on the free rigid motions @p motions. Their section
  /// forces at the constrained end are orthonormal in the section compliance.
  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions);

  /// Returns true if the boundary-layer modes @p zones are accurate enough near
  /// the constrained section @p held. Modes of a lower degree
  /// (BoundaryLayerZone::is_embedded) are not if stresses are requested there.
  bool
  are_sufficient(const std::vector<BoundaryLayerZone> &zones,
                 const ConstrainedSection             &held);

  /// Converts the boundary-layer modes @p zones from the section functions of
  /// @p from to those of @p section, which has the same cells and a higher
  /// degree. Removes parts that its Saint-Venant @p warpings contain.
  std::vector<BoundaryLayerZone>
  embedded(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &from,
           const Section                        &section,
           const Warping                        &warping,
           const FieldColumns                   &warpings,
           const BoundaryLayerRules             &rules = {});

  /// Cache of boundary-layer modes for all models of one scene. A section of
  /// higher degree (LE-4) reuses the modes of a lower degree (LE-3) if no
  /// stresses are requested near the end (ConstrainedSection::is_sampled),
  /// since the degree then matters little and modes are expensive.
  class BoundaryLayerModes
  {
  public:
    /// Constructs an empty cache of modes for the parameters @p rules.
    explicit BoundaryLayerModes(const BoundaryLayerRules &rules = {});

    /// Returns the boundary-layer modes of the constrained section @p held.
    /// Reuses cached modes of an equal section with equal constraints, or else
    /// those of a lower degree (embedded()), or else calls
    /// boundary_layer_modes(). Collective.
    std::vector<BoundaryLayerZone>
    zones(const std::shared_ptr<const Section> &section,
          const SaintVenant                    &states,
          const Warping                        &warping,
          const FieldColumns                   &warpings,
          const ConstrainedSection             &held,
          const std::vector<HeatedSection>     &heat = {});

    /// Returns the parameters with which the modes are computed.
    const BoundaryLayerRules &
    limits() const
    {
      return rules;
    }

    /// Returns the number of end segments of beams that were solved for modes.
    std::size_t
    n_pieces_solved() const
    {
      return n_pieces;
    }

  private:
    struct CachedEndFields
    {
      std::shared_ptr<const Section> section;
      FieldColumns                   warpings;
      /// Constraint for which the modes were computed.
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
    };

    /// Returns the index in `known` of the highest degree below that of @p
    /// section for equal body, cells and constraints; known.size() if there is
    /// none.
    std::size_t
    poorer(const Section &section, const ConstrainedSection &held) const;

    BoundaryLayerRules           rules;
    std::vector<CachedEndFields> known;
    std::size_t                  n_pieces = 0;
  };
} // namespace lamella

#endif
