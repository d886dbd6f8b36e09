// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_h
#define lamella_contact_contact_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_integrals.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/contact/roller_lines.h>
#include <lamella/contact/search_check.h>
#include <lamella/contact/sunk_end.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// What of a pairing does not hold in a state any more: numbers of rows, as
  /// Contact::stays_paired() finds them.
  struct StalePairing
  {
    /// Places that touch and have no row, or one with nine tenths of their area
    /// or less.
    unsigned int unseen = 0;
    /// Rows that matter and a point of which has its place opposite further
    /// than a tenth of the row's spacing from where the row has it; or whose
    /// normal has turned by more than 0.1 rad since.
    unsigned int wandered = 0;
    /// Rows that carry force and face nothing.
    unsigned int lost = 0;

    bool
    none() const
    {
      return unseen + wandered + lost == 0;
    }
  };

  /// What a Contact has come to on its way that its state does not tell: a
  /// foot stays on a facet a little beyond its side, and points are those of
  /// the last pairing. Goes over a restart.
  struct ContactMemory
  {
    /// Where it was paired: displacements and load factor; none where that was
    /// on the undeformed bodies.
    BlockVector u;
    LoadFactor  factor;
    /// The places that face each other. Empty where nothing has moved.
    std::vector<GapPoint> points;
    /// Discretization of the points; may have switched from a line.
    Discretisation discretisation = Discretisation::undefined;
  };

  /**
   * The life of a contact: who faces whom, and the gap there, in a state of the
   * bodies.
   *
   *     contact.pair(u, t)                 // a search: which points face what
   *     repeat
   *       contact.move(u, t)               // the same points, where they are
   * now
   *       ... solve with contact.rows() ...
   *     until contact.stays_paired(u, t, active).none()
   *
   * A row is the tangent plane of the gap at the state of the last move(),
   *   g(v, s) = g_0 + b . v + s g_rate,  b = dg/du,  g_0 = g(u, t) - b . u -
   * ..., so that GapRow::gap() is the gap there and all that solves needs no
   * other word for it. As it is made, a contact is paired on the undeformed
   * bodies and its rows are those of linear kinematics (make_interface()): for
   * small rotations and small sliding pair() happens once, and move() never.
   *
   * The interface belongs to a list of the scene that everybody reads; it is
   * the one that is written here. Its numbers of rows change in pair() only; so
   * views of rows outlive move(). Its points are places of the undeformed scene
   * that face each other in the state, their normals are those of the state.
   *
   * Refers to the bodies and the interface, which have to live longer.
   * Collective in nothing: every process does the same.
   */
  class Contact
  {
  public:
    /// Refers to its own parts: it stays where it is.
    Contact(const Contact &) = delete;
    Contact &
    operator=(const Contact &) = delete;

    /// Pairs the undeformed bodies into @p interface. Throws InputError as
    /// make_interface() does.
    Contact(const ContactPair &contact,
            const Bodies      &bodies,
            ContactInterface  &interface);

    /**
     * Searches anew where @p u (a block a body) has moved the surfaces, the
     * obstacle at load factor @p factor, and moves the rows there. The side
     * that carries the points and the discretisation stay. Throws InputError
     * if nothing faces the other side any more.
     */
    void
    pair(const BlockVector &u, const LoadFactor &factor);

    /**
     * The gaps, normals and rows of the state @p u at @p factor, at the
     * material points that pair() found.
     *
     * Nodes against a surface and weighted gaps have feet on the other side by
     * closest-point projection (find_foot()), which wander as far as the
     * surface goes, and b is the gradient of the gap to the last term. Pairs of
     * nodes stay pairs, with the averaged normal of the state: b leaves out the
     * normal's own turn, which the sideways offset of the two nodes multiplies
     * (stays_paired() says when that has grown). A row none of whose points has
     * a foot is open: no parts, and the reach as its gap.
     *
     * Areas and penalties stay those of the pairing.
     */
    void
    move(const BlockVector &u, const LoadFactor &factor);

    /// Has a step begin in the state @p u at @p factor, of which the rows are:
    /// slips are from here on those since it. What is paired in the step slips
    /// from where its points were then. Nothing without friction.
    void
    begin_step(const BlockVector &u, const LoadFactor &factor);

    /// What recall() goes on from.
    ContactMemory
    memory() const;

    /// Leaves all as it was when @p known was taken, at the state @p u at
    /// @p factor that the rows were of: moves from there end at the same
    /// places, to the last bit.
    void
    recall(const ContactMemory &known,
           const BlockVector   &u,
           const LoadFactor    &factor);

    const std::vector<GapRow> &
    rows() const
    {
      return interface.rows;
    }

    /// f += B^T lambda with the rows that move() would leave in the state @p u
    /// at @p factor, and their forces @p lambda, of rows that rub with the
    /// @p shear along their tangents; rows and points stay where they are. What
    /// rows without a force would be is not looked at. Whether all others have
    /// a foot.
    bool
    add_forces_at(const BlockVector                       &u,
                  const LoadFactor                        &factor,
                  const dealii::ArrayView<const double>   &lambda,
                  const std::vector<dealii::Tensor<1, 2>> &shear,
                  BlockVector                             &f) const;

    /**
     * For each row the two rows of its slip at the state of the last move(),
     *   s_a = sum_k t_a . P_k . (v_2(X_k) - v_1(X_k)),
     *   P_k = 1/A_i int phi_i psi_k (I - n n) dA,
     * along the tangents tangents_of() its normal: the mortar integrals of the
     * gap with what is across n in place of n. Two lists of parts, as those of
     * GapRow::parts.
     */
    std::vector<std::array<std::vector<BodyRow>, 2>>
    slip_rows();

    /**
     * Whether who faces whom in the state @p u at @p factor is what the rows
     * say, as far as it matters: the surfaces are searched anew where they are,
     * and rows that touch there (a gap below zero by more than 1e-9 of the
     * displacements, or in @p active, the numbers of rows that carry force,
     * ascending) must be rows here, at the same places. Costs what pair()
     * costs.
     */
    StalePairing
    stays_paired(const BlockVector               &u,
                 const LoadFactor                &factor,
                 const std::vector<unsigned int> &active);

    /// Returns whether the surface at a roller has half of the roller's
    /// curvature or more (RollerLines::curvature()), so that an arc is about to
    /// touch. The state is @p u at @p factor with active constraints @p active.
    /// False if the obstacle is no roller.
    bool
    wraps_around(const BlockVector               &u,
                 const LoadFactor                &factor,
                 const std::vector<unsigned int> &active) const;

    bool
    is_line() const
    {
      return lines != nullptr;
    }

    /// Returns whether `auto` chose the discretization.
    bool
    is_automatic() const
    {
      return undeformed.contact().is_automatic;
    }

    /// Switches from the line to a roller to contact points from the next
    /// pair() on. Returns false if the contact may not switch.
    bool
    switch_to_points();

    /// Throws NumericsError if the Search distance of a scene has left out
    /// what comes to touch: SearchCheck::check().
    void
    require_found(const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

    /// Returns the deepest end of either body in the other in the state @p u at
    /// @p factor (deepest_node()); for small rotations along undeformed
    /// normals. None against an obstacle.
    std::optional<SunkEnd>
    sunk_end(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns the deepest place of the body in a roller, at points or between
    /// them (RollerLines::deepest_in()), or of one body in the other
    /// (deepest_node()). The state is @p u at @p factor. None for line contact
    /// and against a plane.
    std::optional<SunkPlace>
    sunk_place(const BlockVector &u, const LoadFactor &factor) const;

    /// Whether a body went through a roller, or one body through the other,
    /// between two states, each a displacement at a load factor.
    bool
    goes_through(const BlockVector &before,
                 const LoadFactor  &from,
                 const BlockVector &u,
                 const LoadFactor  &to) const;

  private:
    /// Returns the sides that points are paired on: @p now for finite
    /// rotations, else the undeformed ones.
    const ContactSides &
    paired_sides(const ContactSides &now) const;
    /// Sees to it that there are points: those of the pairing, and where a row
    /// is one point, its node.
    void
    find_points();
    /// The same with integrals, those of the undeformed where nobody has moved.
    void
    find_integrals();
    /// Pairs as at the start.
    void
    pair_undeformed();
    /// Of a contact along the line of a roller, whose rows @p interface are
    /// those of nodes: keeps one a line. Nothing of all others.
    void
    keep_lines();
    /// Moves the points of lines from nodes to where the undeformed lines are
    /// nearest to the roller. For linear kinematics.
    void
    move_lines();
    /// Says of each row where its point is and what that faces, undeformed: the
    /// place opposite of the point that weighs most in it. Against an obstacle
    /// only the former.
    void
    name_places();
    /// Integrates over @p on, points of this contact or copies of them, with
    /// what those that are @p held have slid.
    std::vector<GapIntegrals>
    integrate(const ContactSides    &sides,
              const Feet             feet,
              std::vector<GapPoint> &on,
              HeldPlaces *const      held = nullptr) const;
    /// f += what @p forces on trace nodes of the carrying and of the opposing
    /// surface do where @p at has them.
    void
    add_forces_of_nodes(
      const ContactSides                                                &at,
      const std::array<std::map<unsigned int, dealii::Tensor<1, 3>>, 2> &forces,
      BlockVector &f) const;
    /// How feet are found where nothing has moved.
    Feet
    feet_at_rest() const
    {
      return undeformed.are_of_edges() ? Feet::found : Feet::kept;
    }
    /// How feet are found in a state.
    Feet
    feet() const
    {
      return interface.discretisation == Discretisation::node_to_node ?
               Feet::kept :
               Feet::found;
    }
    /// Those of the rows; null where one point is a row.
    const CarryingSurface *
    functions() const;
    /// Writes rows and points of the integrals at a state.
    void
    write(const ContactSides &sides,
          const BlockVector  &u,
          const LoadFactor   &factor);
    /// Of row @p k the constant and the rate, and the normal of its point.
    void
    set_tangent_plane(const unsigned int k,
                      const BlockVector &u,
                      const LoadFactor  &factor);
    /// Gives the rows their slips, by the integrals of their state, where
    /// @p sides stand, and of moved ones what they are there.
    void
    write_slips(const ContactSides &sides);
    /// That they are what has slid since the step began, in the state @p u at
    /// @p factor that the integrals are of.
    void
    measure_slips(const BlockVector &u, const LoadFactor &factor);
    /// Of each row the first of its points.
    std::vector<unsigned int>
    first_points() const;
    /// The tangents of a row with the normal @p n where @p sides stand:
    /// tangents_of() the normal on the undeformed; from there on they move
    /// along with the carrying surface at @p point (carried_tangents()).
    Tangents
    tangents_at(const ContactSides         &sides,
                const GapPoint             &point,
                const dealii::Tensor<1, 3> &n) const;
    /// slip_rows() along these @p tangents, with the trace of either body as
    /// @p sides have it.
    std::vector<std::array<std::vector<BodyRow>, 2>>
    slip_rows(const ContactSides          &sides,
              const std::vector<Tangents> &tangents) const;
    /// The rows on one body of all slips along the tangent number @p a.
    std::vector<BodyRow>
    slip_rows_on(const ContactSides          &sides,
                 const bool                   second,
                 const std::vector<Tangents> &tangents,
                 const unsigned int           a) const;
    /// Holds the places of the points where the step began.
    void
    hold();
    /// For each row how far the place opposite of one of its points is in @p
    /// now from where `points` has it, undeformed [length].
    std::vector<double>
    wandering(const std::vector<GapPoint> &now) const;
    /// Rows that a search on @p sides finds to have gaps below @p touching and
    /// that are not here, or with a part of their area.
    unsigned int
    count_unseen(const ContactSides &sides, const double touching) const;
    /// The weights of a side, by the numbers of its trace nodes.
    RowGeometry
    geometry(const bool second) const;

    ContactSides      undeformed;
    ContactInterface &interface;
    /// Of bodies that turn the given one counts when they are paired at first:
    /// what has moved is sought as far as any body is long.
    double      reach;
    SearchCheck search;

    /// Of a line to a roller.
    std::unique_ptr<RollerLines> lines;
    /// Where the gaps are measured. Empty until somebody moves.
    std::vector<GapPoint> points;
    /// Of the last pair(), as ContactMemory has them.
    BlockVector paired_at;
    LoadFactor  paired_factor;
    /// Of the state that the rows are of. Empty until somebody moves, or asks
    /// for slip.
    std::vector<GapIntegrals> integrals;
    /// Where the step began, and of each point the place that its slip is
    /// measured from; empty without friction, and before a step.
    BlockVector begun_at;
    LoadFactor  begun_factor;
    HeldPlaces  held;
    /// What `adjust` has taken out of the gaps of the undeformed, by the place
    /// of the node.
    std::map<std::array<double, 3>, double> taken_out;
  };

  /// The contacts of a scene, in its order; none is moved in memory.
  using Contacts = std::vector<std::unique_ptr<Contact>>;
} // namespace lamella

#endif
