// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_h
#define lamella_contact_contact_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/cylinder_contact_lines.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/gap_integrals.h>
#include <lamella/contact/mesh_surface.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Contact points on the current surfaces of a contact, with the mortar
  /// integrals over them, from which constraints are assembled.
  struct EvaluatedPoints
  {
    const ContactSides &undeformed,             ///< Undeformed surfaces.
      &sides;                                   ///< Current surfaces.
    const std::vector<GapPoint>     &points;    ///< Points and projections.
    const std::vector<GapIntegrals> &integrals; ///< One per constraint.
  };

  /// Gap that is added to the gap of a constraint [length], by the number of
  /// its slave node, which pairings do not change.
  using GapOffsets = std::map<unsigned int, double>;

  /// Returns the multiplier functions of @p interface; null for constraints of
  /// single points.
  inline const SlaveSurface *
  functions_of(const ContactInterface &interface)
  {
    return interface.discretization == Discretization::surface_to_surface ?
             interface.surface.get() :
             nullptr;
  }

  /// Sets positions, normals and functionals of the gap constraints of @p
  /// interface, such that GapConstraint::gap() is the gap of @p at plus its
  /// offset in @p offsets at the displacements @p u and load factor @p factor.
  /// Constraints without a projection have the gap @p open [length].
  void
  set_gaps(const EvaluatedPoints &at,
           const BlockVector     &u,
           const LoadFactor      &factor,
           const double           open,
           const GapOffsets      &offsets,
           ContactInterface      &interface);

  /// Sets two slip functionals of each constraint i of @p interface, one for
  /// each unit tangent t_a of its normal n, each with a functional per body:
  ///   s_a = sum_k t_a . P_k . (v_2(X_k) - v_1(X_k)),
  ///   P_k = 1/A_i int phi_i psi_k (I - n n) dA,
  /// with trace functions psi_k, multiplier functions phi_i of integral A_i,
  /// and displacements v_1 and v_2 of the two sides.
  void
  set_slips(const EvaluatedPoints &at, ContactInterface &interface);

  /// Sets SlipConstraint::initial so that the slips of @p interface at @p u and
  /// @p factor are the slip increments of @p integrals.
  void
  offset_slips(const std::vector<GapIntegrals> &integrals,
               const BlockVector               &u,
               const LoadFactor                &factor,
               ContactInterface                &interface);

  /// A node of a body that penetrates the surface of the other body.
  struct EndPenetration
  {
    /// True for a node of the second body, false for one of the first.
    bool   second = false;
    double depth  = 0., ///< Penetration [length].
      cell = 0.; ///< Depth of the penetrated cell along its normal [length].
    /// Closest-point projection of the node onto the other surface.
    MeshSurface::FacetPoint at = {};
  };

  /// Returns the node of either body with the deepest penetration into the
  /// other surface in the configuration @p now; empty if none penetrates. If @p
  /// of_ends is true, only nodes at body ends are considered, since they have
  /// no constraint if a surface slides over them. Projections are at most @p
  /// search_radius away [length]. @p paired are the surfaces that were paired.
  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends);

  /// A surface and a rigid roller (cylinder) in one equilibrium state.
  struct SurfaceAndRoller
  {
    const MeshSurface &surface; ///< Surface of the body, deformed.
    const Obstacle    &roller;  ///< Roller at its current position.
  };

  /// Returns true if a surface passed through a rigid cylinder between two
  /// equilibrium states, so that the later state has neither contact nor a
  /// negative gap. With the vector r from the cylinder axis to a point of the
  /// surface and the outward normal n, the function tests if at some point the
  /// axis
  ///   was ahead (r . n < 0) and is behind (r . n > 0),
  /// and if the straight line between both vectors r, projected along the axis,
  /// comes closer to it than the radius. Sampled points are half a radius
  /// apart, but at least a fortieth of a facet. Both states must have the same
  /// facets. Returns false for a plane.
  bool
  passes_through(const SurfaceAndRoller &before, const SurfaceAndRoller &after);

  /// Returns true if one of two bodies passed through the other between two
  /// equilibrium states. This is so if a surface node that was outside the
  /// other body, or overlapped by at most the element depth, now overlaps by
  /// more, so that pairing ignores it (exceeds_cell_depth()). A node that moved
  /// around a body end also counts if it has a projection in both states.
  bool
  passes_through(const ContactSides &before, const ContactSides &after);

  /// Returns true if the motion between the states reaches the smallest element
  /// depth, so that passes_through() must be called.
  bool
  may_pass_through(const ContactSides &before, const ContactSides &after);

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
