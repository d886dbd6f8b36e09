// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_end_fields_h
#define lamella_adapt_end_fields_h

#include <lamella/adapt/touch.h>
#include <lamella/section/saint_venant.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// The numbers behind end_fields(), all measured
  /// (doc/saint-venant-fields.md). H is the smaller extent of the section, B
  /// the larger one.
  struct EndFieldRules
  {
    /// Of the piece, over B.
    double length = 8.;
    /// The piece's element at its held end is as long as the scene's, but no
    /// less and no more than these times H. The least is what `auto` puts
    /// there: when such an axis is halved the fields stay, so estimates compare
    /// nested models; and finer pieces are no better, since the strongest
    /// disturbance, which reaches are told by, grows without limit at corners.
    double shortest_element = 0.15, longest_element = 0.5;
    /// Where zones begin, over B, ascending.
    std::vector<double> zones{0., 1., 3.};
    /// By how much of B inner fields go on into the next zone, since a stress
    /// in an element whose nodes differ is as poor as the poorer one.
    double overlap = 0.5;
    /// Combinations are cut below this amplitude; that of a Saint-Venant state
    /// along one H is 1.
    double tolerance = 1e-3;
    /// The end disturbs as far as the fields are more than this, of their
    /// largest.
    double rest = 1e-2;
    /// There are no end fields where the piece would have more DoFs.
    double most_dofs = 1e5;
    /// Over B: how near to an end stresses have to be asked for, if a richer
    /// section is to have a piece of its own (EndFields).
    double looked_at = 1.;
  };

  /// How a section is held as a whole, and on which side of it the body is. A
  /// free end is held by no rows.
  struct HeldSection
  {
    /// r(u) = 0 each, the DoFs of a row being the fields of the section.
    std::vector<Row> rows;
    /// Whether the body goes on from there in the direction of +y.
    bool goes_forward = true;
    /// The axis element beside it [length].
    double element = 0.;
    /// The body, and what holds it, as touches are called, in their order:
    /// what is the same in models of one scene.
    std::string              body;
    std::vector<std::string> by;
    /// Whether stresses are asked for within EndFieldRules::looked_at of it.
    bool is_looked_at = false;

    /// Whether the axis elements are, to within rounding.
    bool
    is_as_long_as(const HeldSection &other) const;
  };

  /**
   * What holds the section where the touch number @p t of @p touches does
   * (Touch::holds_section) on a body with @p axis: its rows and those of all
   * others that hold it there (supports of one component each, say). One for
   * each side that the body is on: two inside of it.
   */
  std::vector<HeldSection>
  held_sections(const std::vector<Touch> &touches,
                const unsigned int        t,
                const Axis               &axis);

  /**
   * What heat that is constant along the axis does to a body that is free: the
   * section takes the shape
   *   v + sum_j c_j a_j,
   * v its answer (SaintVenant::response_to_constant()) to the load h_s of heat
   * on values, which what holds it does not let be, and at an end the traction
   *   r = S_10 v - h_y + sum_j c_j (S_10 a_j + S_11 b_j)
   * is left, h_y the load on derivatives; with as much of the six states
   * (a_j, b_j) as frees r of section forces, since none act on a free end.
   */
  struct HeatedSection
  {
    Vector answer, traction;
    HeatedSection(const SaintVenant &states, const Beam::SectionHeat &heat);
  };

  /// Whether both hold alike, to within rounding.
  bool
  alike(const HeldSection &a, const HeldSection &b);

  /// Fields that nodes carry up to a distance from an end.
  struct EndZone
  {
    FieldColumns fields;
    /// [length].
    double reach = 0.;
    /// Whether they are those of a poorer section.
    bool is_embedded = false;
  };

  /// The axis element at the held end of the piece that end_fields() solves
  /// [length].
  double
  first_element(const Section       &section,
                const HeldSection   &held,
                const EndFieldRules &rules);

  /**
   * How the section deforms beside an end that is held as a whole, which
   * answers to no load vector: a short piece of the body is solved with all
   * fields of its section on an axis that is graded to the end, held there by
   * @p held and loaded at the other end by the tractions S_10 a + S_11 b of the
   * six Saint-Venant states, which bring no disturbance of their own. The loads
   * are combined such that the section forces s at the held end are
   * orthonormal in the compliance, s_i^T C s_j = delta_ij, unit energy per
   * length; where the end is free to move rigidly, those of them that do no
   * work on that. One factorisation serves all of them.
   *
   * What is left of the displacement u_i at node i without its rigid part and
   * the warpings, times
   *   sqrt( int N_i dy / H ),
   * is cut to a basis by proper orthogonal decomposition in the metric of
   * Warping: the sum of squares is the disturbance's energy along the piece,
   * to within what varies along the axis. Few fields die away slowly, so there
   * are zones: the outermost has the fields of the nodes there, each further
   * in what the nodes from its beginning on add to those of the ones outside.
   *
   * Of @p heat comes another load each: that of the answer all along, with the
   * traction taken off the end, so that what is left beside the answer is the
   * disturbance, of a section that is held or free; none of one that is held
   * in part and can still move. It is scaled to the energy that a state has
   * along one H.
   *
   * The zones, the outermost first, free of rigid fields and warpings; those
   * that add nothing are left out. None at all where nothing can load the
   * piece, or where it would be too large. The axis is B4. Throws
   * NumericsError if the piece's stiffness is not positive definite.
   * Collective.
   */
  std::vector<EndZone>
  end_fields(const std::shared_ptr<const Section> &section,
             const SaintVenant                    &states,
             const Warping                        &warping,
             const FieldColumns                   &warpings,
             const HeldSection                    &held,
             const std::vector<HeatedSection>     &heat  = {},
             const EndFieldRules                  &rules = {});

  /// The nodes of the pieces that end_fields() would solve for @p beam, which
  /// carries all fields at all nodes, with @p touches: what they cost is to the
  /// body's factor as these to its nodes. No piece is solved; that one end may
  /// be another one's mirror image is not looked at.
  unsigned int
  nodes_of_pieces(const Beam               &beam,
                  const std::vector<Touch> &touches,
                  const EndFieldRules      &rules = {});

  /**
   * The zones of the same support at the other end of a body, @p zones seen in
   * a mirror across the axis: u_y changes its sign. Empty unless @p section is
   * its own mirror image, as sections of isotropic and of cross plies are, and
   * @p held, too, which is how the section of @p zones is held. It spares the
   * second of two pieces.
   */
  std::vector<EndZone>
  mirrored(const std::vector<EndZone> &zones,
           const Section              &section,
           const HeldSection          &held);
} // namespace lamella

#endif
