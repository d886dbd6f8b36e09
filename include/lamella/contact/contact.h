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
#include <vector>

namespace lamella
{
  /// Counts of the constraints that make the pairing of a contact invalid at
  /// the present displacements (Contact::pairing_is_valid()), by reason.
  struct PairingChange
  {
    /// Constraints in contact that a new search finds, but that the present
    /// pairing lacks or has with at most 90 % of their area.
    unsigned int missing_constraints = 0;
    /// Constraints in contact whose projection has moved by more than a tenth
    /// of the point spacing, or whose normal has rotated by more than 0.1 rad.
    unsigned int drifted = 0;
    /// Active constraints whose point has no projection on the other surface.
    unsigned int lost = 0;

    /// Returns true if the pairing is valid.
    bool
    none() const
    {
      return missing_constraints + drifted + lost == 0;
    }
  };

  /// Data of a Contact that a restart needs in addition to the State.
  struct ContactHistory
  {
    BlockVector u;      ///< Displacements at the last pairing; empty if zero.
    LoadFactor  factor; ///< Load factor at the last pairing.
    /// Slave points with projections; empty before the first Contact::move().
    std::vector<GapPoint> points;
    /// Discretization; `line to roller` may have become `surface to surface`.
    Discretization discretization = Discretization::undefined;
  };

  /// Contact between two bodies, or a body and an obstacle: pairs the facing
  /// points and updates their gap constraints to the displacements.
  ///
  ///     contact.pair(u, t)          // search: pairs of facing points
  ///     repeat
  ///       contact.move(u, t)        // current positions of these points
  ///       ... solve with contact.rows() ...
  ///     until contact.pairing_is_valid(u, t, active).none()
  ///
  /// Each constraint linearizes its gap at the state of the last move(),
  ///   g(v, s) = g_0 + b . v + s g_rate,  b = dg/du,
  /// with displacements v and load factor s; there, GapConstraint::gap() is the
  /// exact gap. Initially the undeformed bodies are paired (make_interface()).
  /// For small rotations and sliding, move() is not called.
  ///
  /// Constraint numbers change in pair() only. Contact points are stored by
  /// undeformed positions, normals are current. Keeps references to the bodies
  /// and to the interface in a list of the scene, which it modifies.
  class Contact
  {
  public:
    /// Not copyable or movable, since its members refer to each other.
    Contact(const Contact &) = delete;
    Contact &
    operator=(const Contact &) = delete;

    /// Pairs the facing points of the undeformed @p bodies and stores their gap
    /// constraints in @p interface. Throws InputError as make_interface() does.
    Contact(const ContactPair &contact,
            const Bodies      &bodies,
            ContactInterface  &interface);

    /// Searches again which points face each other at the displacements @p u
    /// and load factor @p factor (of an obstacle), and creates the constraints
    /// anew. Throws InputError if no points face each other.
    void
    pair(const BlockVector &u, const LoadFactor &factor);

    /// Updates gaps, normals and constraints to the displacements @p u at load
    /// factor @p factor, at the material points found by pair(). Areas of the
    /// points are unchanged.
    ///
    /// Node-to-surface contact and weighted gaps use closest-point projections
    /// onto the whole other surface, and the exact gradient of the gap. Node
    /// pairs use the current averaged normal. Their gradient omits the rotation
    /// of the normal times the tangential offset of the nodes, which
    /// pairing_is_valid() bounds. A constraint without any projection is open:
    /// its functional is zero, and its gap is the search radius.
    void
    move(const BlockVector &u, const LoadFactor &factor);

    /// Begins a load step at the displacements @p u and load factor @p factor
    /// of the last move(). Slips are measured from this configuration.
    void
    begin_step(const BlockVector &u, const LoadFactor &factor);

    /// Returns the data with which restore() continues this contact.
    ContactHistory
    memory() const;

    /// Restores the contact from the data @p known of memory(), and its
    /// constraints at the displacements @p u and load factor @p factor.
    /// Subsequent calls of move() give bitwise identical results.
    void
    restore(const ContactHistory &known,
            const BlockVector    &u,
            const LoadFactor     &factor);

    /// Returns the gap constraints of this contact.
    const std::vector<GapConstraint> &
    rows() const
    {
      return interface.rows;
    }

    /// Adds the contact forces to the load vector @p f. The constraints are
    /// those that move() would give at the displacements @p u and load factor
    /// @p factor; they are not stored. Constraint i has the normal force @p
    /// lambda[i] and, with friction, shear forces @p shear[i] along two
    /// tangents. Returns false if a constraint with a force has no projection.
    bool
    add_forces_at(const BlockVector                       &u,
                  const LoadFactor                        &factor,
                  const dealii::ArrayView<const double>   &lambda,
                  const std::vector<dealii::Tensor<1, 2>> &shear,
                  BlockVector                             &f) const;

    /// Returns two slip functionals of each constraint i at the last move(),
    /// one for each unit tangent t_a of its normal n, each with a functional
    /// per body:
    ///   s_a = sum_k t_a . P_k . (v_2(X_k) - v_1(X_k)),
    ///   P_k = 1/A_i int phi_i psi_k (I - n n) dA,
    /// with trace functions psi_k, multiplier functions phi_i of integral A_i,
    /// and displacements v_1 and v_2 of the two sides.
    std::vector<std::array<std::vector<BodyFunctional>, 2>>
    slip_constraints();

    /// Compares the pairing with a new search of the surfaces at the
    /// displacements @p u and load factor @p factor: each constraint in contact
    /// must exist with the same contact points. A constraint is in contact if
    /// its gap is below -1e-9 times the largest DoF of @p u, or if it is in @p
    /// active, the ascending numbers of constraints with a force.
    PairingChange
    pairing_is_valid(const BlockVector               &u,
                     const LoadFactor                &factor,
                     const std::vector<unsigned int> &active);

    /// Returns true if contact with a roller over an arc is about to form: the
    /// surface at the constraints @p active has at least half of the roller's
    /// curvature at the displacements @p u and load factor @p factor.
    bool
    wraps_around(const BlockVector               &u,
                 const LoadFactor                &factor,
                 const std::vector<unsigned int> &active) const;

    /// Returns true for contact along the line of a beam nearest to a roller.
    bool
    is_line() const
    {
      return lines != nullptr;
    }

    /// Returns true if the discretization was chosen by `auto`.
    bool
    is_automatic() const
    {
      return undeformed.contact().is_automatic;
    }

    /// Replaces line contact with a roller by `surface to surface` at the next
    /// pair(). Returns false if `auto` did not choose the discretization.
    bool
    switch_to_points();

    /// Throws NumericsError if a point beyond the search distance of the scene
    /// is in contact at @p u and @p factor (SearchCheck::check()). @p active
    /// are the numbers of the active constraints.
    void
    require_found(const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

    /// Returns the end node of either body that penetrates the other most at @p
    /// u and @p factor, for small rotations along undeformed normals, or empty.
    std::optional<EndPenetration>
    end_penetration(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns the deepest penetration at @p u and load factor @p factor, also
    /// of points between contact points, into a roller or the other body. Empty
    /// for line contact and planes, and if there is none.
    std::optional<CylinderPenetration>
    cylinder_penetration(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns true if a body passed through the roller or the other body
    /// between displacements @p before (load factor @p from) and @p u (@p to).
    bool
    passes_through(const BlockVector &before,
                   const LoadFactor  &from,
                   const BlockVector &u,
                   const LoadFactor  &to) const;

  private:
    /// Returns the surfaces between which facing points are searched: the
    /// deformed surfaces @p now at finite rotations, else the undeformed ones.
    const ContactSides &
    paired_sides(const ContactSides &now) const;
    /// Sets `points` if empty: integration points, or one per nodal constraint.
    void
    find_points();
    /// Sets `points` and `integrals`, if empty, on the undeformed surfaces.
    void
    find_integrals();
    /// Pairs the undeformed bodies.
    void
    pair_undeformed();
    /// For line contact, keeps one constraint on each contact line.
    void
    reduce_to_lines();
    /// For small rotations, moves the point of each contact line to the
    /// position nearest to the roller axis.
    void
    update_lines();
    /// Sets the undeformed position of each constraint, and the master position
    /// opposite its contact point of largest weight.
    void
    set_constraint_positions();
    /// Returns the mortar integrals of all constraints on @p sides over the
    /// contact points @p on, with slips from @p reference, if any.
    std::vector<GapIntegrals>
    integrate(const ContactSides        &sides,
              const MasterPoints         master_points,
              std::vector<GapPoint>     &on,
              const SlipReference *const reference = nullptr) const;
    /// Adds to @p row the part of an obstacle under a given force for its
    /// displacement along the vector @p direction.
    void
    add_guided_part(const dealii::Tensor<1, 3> &direction,
                    ContactConstraint          &row) const;
    /// Adds @p forces on trace nodes of the surfaces of @p at to @p f.
    void
    add_forces_of_nodes(
      const ContactSides                                                &at,
      const std::array<std::map<unsigned int, dealii::Tensor<1, 3>>, 2> &forces,
      BlockVector &f) const;
    /// Returns the choice of points opposite slave points on undeformed bodies.
    MasterPoints
    master_points_at_rest() const
    {
      return undeformed.is_edge_contact() ? MasterPoints::projected :
                                            MasterPoints::paired;
    }
    /// Returns the choice of points opposite slave points on deformed bodies.
    MasterPoints
    master_points() const
    {
      return interface.discretization == Discretization::node_to_node ?
               MasterPoints::paired :
               MasterPoints::projected;
    }
    /// Returns the multiplier functions; null for single-point constraints.
    const SlaveSurface *
    functions() const;
    /// Updates the constraints from `integrals` on @p sides, the surfaces at
    /// the displacements @p u and load factor @p factor.
    void
    write(const ContactSides &sides,
          const BlockVector  &u,
          const LoadFactor   &factor);
    /// Sets the normal, initial_gap and gap_rate of constraint @p k so that
    /// gap() is exact at the displacements @p u and load factor @p factor.
    void
    set_tangent_plane(const unsigned int k,
                      const BlockVector &u,
                      const LoadFactor  &factor);
    /// Sets the slip functionals from the integrals on @p sides.
    void
    assemble_slips(const ContactSides &sides);
    /// Sets SlipConstraint::initial so that slips are zero when a step begins.
    void
    offset_slips(const BlockVector &u, const LoadFactor &factor);
    /// Returns the index of the first point of each constraint.
    std::vector<unsigned int>
    first_points() const;
    /// Returns the tangents for the normal @p n on @p sides. On deformed sides,
    /// they move with the facet of @p point (convected_tangents()).
    Tangents
    tangents_at(const ContactSides         &sides,
                const GapPoint             &point,
                const dealii::Tensor<1, 3> &n) const;
    /// Returns slip_constraints() along @p tangents on @p sides.
    std::vector<std::array<std::vector<BodyFunctional>, 2>>
    slip_constraints(const ContactSides          &sides,
                     const std::vector<Tangents> &tangents) const;
    /// Returns for each constraint the slip along its tangent number @p a as a
    /// functional of the DoFs of the first or @p second body.
    std::vector<BodyFunctional>
    slip_constraints_on(const ContactSides          &sides,
                        const bool                   second,
                        const std::vector<Tangents> &tangents,
                        const unsigned int           a) const;
    /// Stores the reference points from which slips of the step are measured.
    void
    hold();
    /// Returns for each constraint the undeformed distance [length] between its
    /// master points in @p now and in `points`.
    std::vector<double>
    projection_drift(const std::vector<GapPoint> &now) const;
    /// Returns how many constraints with gaps below @p touching a new search on
    /// @p sides finds that are missing here or have at most 90 % of the area.
    unsigned int
    count_missing_constraints(const ContactSides &sides,
                              const double        touching) const;
    /// Returns the weights of the constraints at the trace nodes of one side.
    ConstraintGeometry
    geometry(const bool second) const;

    ContactSides      undeformed;
    ContactInterface &interface;
    /// Search radius. At finite rotations the scene's search distance applies
    /// to the first pairing; later pairings use the length of the longest body.
    double      search_radius;
    SearchCheck search;

    /// Lines of a contact with a roller; null for other contacts.
    std::unique_ptr<CylinderContactLines> lines;
    /// Slave points with projections; empty before the first move().
    std::vector<GapPoint> points;
    /// Displacements and load factor of the last pair().
    BlockVector pairing_u;
    LoadFactor  pairing_factor;
    /// Mortar integrals at the last move(); empty before motion or slips.
    std::vector<GapIntegrals> integrals;
    /// Displacements and slip reference at the begin of the load step.
    BlockVector   step_begin_u;
    SlipReference step_begin;
    /// Initial overlap removed from the gaps by `adjust`, by node position.
    std::map<std::array<double, 3>, double> removed_overlap;
  };

  /// Contacts of a scene in their order there, at constant addresses.
  using Contacts = std::vector<std::unique_ptr<Contact>>;
} // namespace lamella

#endif
