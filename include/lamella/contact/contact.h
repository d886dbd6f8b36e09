// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_h
#define lamella_contact_contact_h

#include <lamella/contact/constraint_assembly.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/cylinder_contact_lines.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/gap_integrals.h>
#include <lamella/contact/pass_through.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Pairing of a contact. A restart needs it in addition to the State, but for
  /// `lines` and `step_begin`, which Contact::restore() creates again.
  struct ContactHistory
  {
    BlockVector u;      ///< Displacements at the last pairing; empty if zero.
    LoadFactor  factor; ///< Load factor at the last pairing.
    /// Slave points with projections; empty before Contact::evaluate().
    std::vector<GapPoint> points;
    /// Discretization; `line to roller` may become `surface to surface`.
    Discretization discretization = Discretization::undefined;
    /// Lines of a contact with a roller; null for other contacts.
    std::shared_ptr<const CylinderContactLines> lines = {};
    /// Beginning of the load step, from which slips are measured.
    SlipReference step_begin = {};
  };

  /// Contact between two bodies, or a body and an obstacle. It pairs the facing
  /// points and evaluates their gap constraints at given displacements.
  ///
  ///     interface = contact.pair(u, t, history)  // search facing points
  ///     repeat
  ///       interface = contact.evaluate(u, t, interface, history)
  ///       ... solve with interface.rows ...
  ///     until contact.count_missing_constraints(u, t, interface) == 0
  ///
  /// Constraints are linearized at the displacements u and load factor t,
  ///   g(v, s) = g_0 + b . v + s g_rate,  b = dg/du,
  /// with displacements v and load factor s; there, GapConstraint::gap() is the
  /// exact gap. Initially the undeformed bodies are paired (make_interface()).
  /// For small rotations and sliding, these constraints stay.
  ///
  /// A Contact is constant. Constraints and pairing are values that belong to
  /// the caller. Constraint numbers change in pair() only. Contact points are
  /// stored by undeformed positions, normals are current. Keeps references to
  /// the bodies.
  class Contact
  {
  public:
    /// Not copyable or movable, since its members refer to each other.
    Contact(const Contact &) = delete;
    Contact &
    operator=(const Contact &) = delete;

    /// Pairs the facing points of the undeformed @p bodies and stores their gap
    /// constraints in @p interface, their pairing in @p history. Throws
    /// InputError as make_interface() does.
    Contact(const ContactPair &contact,
            const Bodies      &bodies,
            ContactInterface  &interface,
            ContactHistory    &history);

    /// Searches which points face each other at the displacements @p u and load
    /// factor @p factor (of an obstacle), by the discretization of @p history.
    /// Returns their constraints, and stores the pairing in @p history. Throws
    /// InputError if no points face each other.
    ContactInterface
    pair(const BlockVector &u,
         const LoadFactor  &factor,
         ContactHistory    &history) const;

    /// Returns the constraints @p interface with gaps, normals and gradients at
    /// the displacements @p u and load factor @p factor, at the material points
    /// of @p history, whose projections are updated. Areas of the points are
    /// unchanged.
    ///
    /// Node-to-surface contact and weighted gaps use closest-point projections
    /// onto the whole other surface, and the exact gradient of the gap. Node
    /// pairs use the current averaged normal. Their gradient omits the rotation
    /// of the normal times the tangential offset of the nodes. A constraint
    /// without any projection is open: its functional is zero, and its gap is
    /// the search radius.
    ContactInterface
    evaluate(const BlockVector &u,
             const LoadFactor  &factor,
             ContactInterface   interface,
             ContactHistory    &history) const;

    /// Begins a load step at the displacements @p u and load factor @p factor
    /// at which @p interface was evaluated. Slips are measured from there.
    void
    begin_step(const BlockVector &u,
               const LoadFactor  &factor,
               ContactHistory    &history,
               ContactInterface  &interface) const;

    /// Returns the constraints at the displacements @p u and load factor @p
    /// factor with the pairing @p known, and stores that in @p history.
    /// Subsequent calls of evaluate() give bitwise identical results.
    ContactInterface
    restore(const ContactHistory &known,
            const BlockVector    &u,
            const LoadFactor     &factor,
            ContactHistory       &history) const;

    /// Returns evaluate() for those constraints of @p interface that have a
    /// force in @p forces; others need not be valid.
    ContactInterface
    evaluate_loaded(const BlockVector                     &u,
                    const LoadFactor                      &factor,
                    ContactInterface                       interface,
                    ContactHistory                         history,
                    const dealii::ArrayView<const double> &forces) const;

    /// Returns how many constraints in contact a new search of the surfaces
    /// finds at the displacements @p u and load factor @p factor that are
    /// missing in @p interface or have at most 90 % of the area. In contact are
    /// gaps below -1e-9 times the largest DoF of @p u.
    unsigned int
    count_missing_constraints(const BlockVector      &u,
                              const LoadFactor       &factor,
                              const ContactInterface &interface) const;

    /// Returns true if contact with a roller over an arc is about to form: the
    /// surface at the constraints @p active has at least half of the roller's
    /// curvature at the displacements @p u and load factor @p factor.
    bool
    wraps_around(const BlockVector               &u,
                 const LoadFactor                &factor,
                 const ContactInterface          &interface,
                 const std::vector<unsigned int> &active) const;

    /// Returns the parameters, with the slave side chosen for the undeformed
    /// bodies.
    const ContactPair &
    parameters() const
    {
      return undeformed.contact();
    }

    /// Returns the end node of either body that penetrates the other most at @p
    /// u and @p factor, for small rotations along undeformed normals, or empty.
    std::optional<EndPenetration>
    end_penetration(const BlockVector &u, const LoadFactor &factor) const;

    /// Returns the deepest penetration at @p u and load factor @p factor, also
    /// of points between contact points, into a roller or the other body. Empty
    /// for line contact and planes, and if there is none.
    std::optional<CylinderPenetration>
    cylinder_penetration(const BlockVector      &u,
                         const LoadFactor       &factor,
                         const ContactInterface &interface) const;

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
    /// Returns the contact points of @p interface: integration points, or one
    /// per nodal constraint.
    std::vector<GapPoint>
    points_of(const ContactInterface &interface) const;
    /// Returns the constraints of the undeformed bodies; resets @p history.
    ContactInterface
    pair_undeformed(ContactHistory &history) const;
    /// For line contact, keeps one constraint on each contact line.
    void
    reduce_to_lines(ContactInterface &interface, ContactHistory &history) const;
    /// Returns the mortar integrals of all constraints on @p sides over the
    /// contact points @p on, with slips from @p reference, if any.
    std::vector<GapIntegrals>
    integrate(const ContactInterface    &interface,
              const ContactSides        &sides,
              const MasterPoints         master_points,
              std::vector<GapPoint>     &on,
              const SlipReference *const reference = nullptr) const;
    /// Returns the choice of points opposite slave points on deformed bodies.
    static MasterPoints
    master_points(const ContactInterface &interface)
    {
      return interface.discretization == Discretization::node_to_node ?
               MasterPoints::paired :
               MasterPoints::projected;
    }
    /// Stores the reference points from which slips of the step are measured.
    void
    hold(const ContactInterface &interface, ContactHistory &history) const;

    ContactSides undeformed;
    /// Search radius. At finite rotations the scene's search distance applies
    /// to the first pairing; later pairings use the length of the longest body.
    double search_radius;
    /// Initial overlap removed from the gaps by `adjust`, by node position.
    GapOffsets removed_overlap;
  };

  /// Contacts of a scene in their order there, at constant addresses.
  using Contacts = std::vector<std::unique_ptr<const Contact>>;
} // namespace lamella

#endif
