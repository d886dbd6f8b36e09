// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_h
#define lamella_contact_contact_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/cylinder_contact_lines.h>
#include <lamella/contact/end_penetration.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/gap_integrals.h>
#include <lamella/contact/search_check.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Row counts by which a pairing is invalid in a state (pairing_is_valid()).
  struct PairingChange
  {
    /// Points in contact without a row, or with at most 90 % of their area.
    unsigned int missing_constraints = 0;
    /// Relevant rows with a projection off the stored one by more than a tenth
    /// of the row spacing, or a normal rotated by more than 0.1 rad.
    unsigned int drifted = 0;
    /// Rows with a force and without a projection.
    unsigned int lost = 0;

    bool
    none() const
    {
      return missing_constraints + drifted + lost == 0;
    }
  };

  /// History of a Contact beside the state, for a restart: projections may
  /// remain slightly beyond their facets, and points are those of the last
  /// pairing.
  struct ContactHistory
  {
    /// Displacements and load factor of the last pairing; empty if undeformed.
    BlockVector u;
    LoadFactor  factor;
    /// Paired points. Empty if nothing has moved.
    std::vector<GapPoint> points;
    /// Discretization of the points; may have switched from a line.
    Discretization discretization = Discretization::undefined;
  };

  /**
   * A contact with its pairing and gaps, in a state of the bodies.
   *
   *     contact.pair(u, t)          // search: pairs of facing points
   *     repeat
   *       contact.move(u, t)        // current positions of these points
   *       ... solve with contact.rows() ...
   *     until contact.pairing_is_valid(u, t, active).none()
   *
   * A row is the tangent plane of the gap at the state of the last move(),
   *   g(v, s) = g_0 + b . v + s g_rate,  b = dg/du,
   * so that GapConstraint::gap() is the gap there. Initially, the undeformed
   * bodies are paired with the rows of linear kinematics (make_interface()).
   * For small rotations and small sliding, pair() is called once and move()
   * never.
   *
   * Row numbers change in pair() only, so views of rows remain valid after
   * move(). Points are undeformed positions of places that face each other in
   * the state; normals are current. Refers to the bodies and modifies the
   * interface in a list of the scene. Every process does the same.
   */
  class Contact
  {
  public:
    /// Not copyable or movable, since it refers to its own parts.
    Contact(const Contact &) = delete;
    Contact &
    operator=(const Contact &) = delete;

    /// Pairs the undeformed bodies. Throws InputError as make_interface() does.
    Contact(const ContactPair &contact,
            const Bodies      &bodies,
            ContactInterface  &interface);

    /// Searches for pairs at the displacements @p u, with the obstacle at load
    /// factor @p factor, and moves the rows there. The slave side and the
    /// discretization are kept. Throws InputError if nothing is paired.
    void
    pair(const BlockVector &u, const LoadFactor &factor);

    /**
     * Updates gaps, normals and rows to the state @p u at @p factor, at the
     * material points of pair(). Areas and penalties remain.
     *
     * Nodes against a surface and weighted gaps use closest-point projections
     * onto the whole other surface, and b is the exact gradient of the gap.
     * Node pairs keep their partners, with the current averaged normal; b then
     * omits the rotation of the normal times the tangential offset of the
     * nodes, which pairing_is_valid() bounds. A row without any projection is
     * open: no parts, and the search radius as its gap.
     */
    void
    move(const BlockVector &u, const LoadFactor &factor);

    /// Begins a step in the state @p u at @p factor of the rows: slips are
    /// measured from here, those of later points from their pairing.
    void
    begin_step(const BlockVector &u, const LoadFactor &factor);

    /// Returns the history for restore().
    ContactHistory
    memory() const;

    /// Restores the contact with the history @p known in the state @p u at @p
    /// factor of its rows. Subsequent moves are bitwise identical.
    void
    restore(const ContactHistory &known,
            const BlockVector    &u,
            const LoadFactor     &factor);

    const std::vector<GapConstraint> &
    rows() const
    {
      return interface.rows;
    }

    /// Adds B^T lambda to @p f, with the rows that move() would give in the
    /// state @p u at @p factor, their forces @p lambda, and with friction the
    /// @p shear along their tangents. The stored rows and points are unchanged.
    /// Returns true if all rows with a force have a projection.
    bool
    add_forces_at(const BlockVector                       &u,
                  const LoadFactor                        &factor,
                  const dealii::ArrayView<const double>   &lambda,
                  const std::vector<dealii::Tensor<1, 2>> &shear,
                  BlockVector                             &f) const;

    /// Returns the two slip rows of each row at the state of the last move(),
    ///   s_a = sum_k t_a . P_k . (v_2(X_k) - v_1(X_k)),
    ///   P_k = 1/A_i int phi_i psi_k (I - n n) dA,
    /// along the tangents_of() its normal: the mortar integrals of the gap with
    /// the tangential projection in place of n. Each is a list of parts.
    std::vector<std::array<std::vector<BodyFunctional>, 2>>
    slip_constraints();

    /// Checks the pairing in the state @p u at @p factor: surfaces are searched
    /// again, and rows in contact must exist here at the same places. A row is
    /// in contact if its gap is below zero by more than 1e-9 of the
    /// displacements, or if it is in @p active, the ascending numbers of rows
    /// with a force.
    PairingChange
    pairing_is_valid(const BlockVector               &u,
                     const LoadFactor                &factor,
                     const std::vector<unsigned int> &active);

    /// Returns true if the surface at a roller has half of the roller's
    /// curvature or more (CylinderContactLines::curvature()), so that an arc is
    /// about to form in the state @p u at @p factor with active rows @p active.
    bool
    wraps_around(const BlockVector               &u,
                 const LoadFactor                &factor,
                 const std::vector<unsigned int> &active) const;

    bool
    is_line() const
    {
      return lines != nullptr;
    }

    /// Returns true if `auto` chose the discretization.
    bool
    is_automatic() const
    {
      return undeformed.contact().is_automatic;
    }

    /// Switches from the line on a roller to points from the next pair() on.
    /// Returns false if the contact may not switch.
    bool
    switch_to_points();

    /// Throws NumericsError if the Search distance of a scene has excluded an
    /// active place (SearchCheck::check()).
    void
    require_found(const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

    /// Returns the deepest end of either body in the other at @p u and @p
    /// factor (deepest_node()), for small rotations along undeformed normals.
    std::optional<EndPenetration>
    end_penetration(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns the deepest place of the body in a roller, also between points
    /// (CylinderContactLines::deepest_in()), or of one body in the other
    /// (deepest_node()), at @p u and @p factor. Empty for lines and planes.
    std::optional<CylinderPenetration>
    cylinder_penetration(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns true if a body passed through the roller or the other body
    /// between two states, each a displacement at a load factor.
    bool
    passes_through(const BlockVector &before,
                   const LoadFactor  &from,
                   const BlockVector &u,
                   const LoadFactor  &to) const;

  private:
    /// Returns the sides for pairing: @p now at finite rotations.
    const ContactSides &
    paired_sides(const ContactSides &now) const;
    /// Creates missing points: those of the pairing, or of each one-point row.
    void
    find_points();
    /// Creates points and integrals if missing, undeformed unless moved.
    void
    find_integrals();
    /// Pairs the undeformed bodies.
    void
    pair_undeformed();
    /// Keeps one of the nodal rows @p interface per line in line contact.
    void
    reduce_to_lines();
    /// Moves the points of lines next to the roller, for small rotations.
    void
    update_lines();
    /// Sets the undeformed position of each row, and of its opposite place at
    /// the point of largest weight.
    void
    set_constraint_positions();
    /// Returns the integrals over points @p on, with slips from @p held.
    std::vector<GapIntegrals>
    integrate(const ContactSides        &sides,
              const MasterPoints         master_points,
              std::vector<GapPoint>     &on,
              SlipReferencePoints *const held = nullptr) const;
    /// Adds the effect of @p forces on trace nodes of both sides @p at to @p f.
    void
    add_forces_of_nodes(
      const ContactSides                                                &at,
      const std::array<std::map<unsigned int, dealii::Tensor<1, 3>>, 2> &forces,
      BlockVector &f) const;
    /// Returns the projection mode without motion.
    MasterPoints
    master_points_at_rest() const
    {
      return undeformed.is_edge_contact() ? MasterPoints::projected :
                                            MasterPoints::paired;
    }
    /// Returns the projection mode in a state.
    MasterPoints
    master_points() const
    {
      return interface.discretization == Discretization::node_to_node ?
               MasterPoints::paired :
               MasterPoints::projected;
    }
    /// Returns the surface functions of the rows; null for one-point rows.
    const SlaveSurface *
    functions() const;
    /// Writes rows and points from the integrals at a state.
    void
    write(const ContactSides &sides,
          const BlockVector  &u,
          const LoadFactor   &factor);
    /// Sets constant and rate of row @p k, and the normal of its point.
    void
    set_tangent_plane(const unsigned int k,
                      const BlockVector &u,
                      const LoadFactor  &factor);
    /// Sets the slip rows from the integrals at @p sides.
    void
    assemble_slips(const ContactSides &sides);
    /// Makes the slips relative to the beginning of the step.
    void
    offset_slips(const BlockVector &u, const LoadFactor &factor);
    /// Returns the first point of each row.
    std::vector<unsigned int>
    first_points() const;
    /// Returns the tangents of a row with normal @p n on @p sides:
    /// tangents_of() it if undeformed, else convected with @p point
    /// (convected_tangents()).
    Tangents
    tangents_at(const ContactSides         &sides,
                const GapPoint             &point,
                const dealii::Tensor<1, 3> &n) const;
    /// Returns slip_constraints() along @p tangents on @p sides.
    std::vector<std::array<std::vector<BodyFunctional>, 2>>
    slip_constraints(const ContactSides          &sides,
                     const std::vector<Tangents> &tangents) const;
    /// Returns the parts on one body of all slips along tangent number @p a.
    std::vector<BodyFunctional>
    slip_constraints_on(const ContactSides          &sides,
                        const bool                   second,
                        const std::vector<Tangents> &tangents,
                        const unsigned int           a) const;
    /// Stores the reference points of the slips at the beginning of the step.
    void
    hold();
    /// Returns for each row the undeformed distance [length] between
    /// projections in @p now and in `points`.
    std::vector<double>
    projection_drift(const std::vector<GapPoint> &now) const;
    /// Returns the number of rows on @p sides with gaps below @p touching that
    /// are missing here or have part of their area only.
    unsigned int
    count_missing_constraints(const ContactSides &sides,
                              const double        touching) const;
    /// Returns the weights of a side, by the numbers of its trace nodes.
    ConstraintGeometry
    geometry(const bool second) const;

    ContactSides      undeformed;
    ContactInterface &interface;
    /// Search radius. At finite rotations the given one applies to the first
    /// pairing only, later ones use the length of the longest body.
    double      search_radius;
    SearchCheck search;

    /// Lines of a contact with a roller.
    std::unique_ptr<CylinderContactLines> lines;
    /// Points where gaps are measured. Empty before any motion.
    std::vector<GapPoint> points;
    /// State of the last pair(), as in ContactHistory.
    BlockVector pairing_u;
    LoadFactor  pairing_factor;
    /// Integrals of the state of the rows. Empty before motion or use of slips.
    std::vector<GapIntegrals> integrals;
    /// State at the beginning of the step, and slip references; else empty.
    BlockVector         step_begin_u;
    LoadFactor          step_begin_factor;
    SlipReferencePoints held;
    /// Initial overlap removed from the gaps by `adjust`, by node position.
    std::map<std::array<double, 3>, double> removed_overlap;
  };

  /// Contacts of a scene, in order, at fixed addresses.
  using Contacts = std::vector<std::unique_ptr<Contact>>;
} // namespace lamella

#endif
