// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `contact`: search, pairing, and the contact law. It owns the gap
// constraints with their geometry, rigid obstacles, penalties and other
// enforcements, the contact traction, and checks of the pairing. It formulates
// the contact problem and never solves it (`solve` does).

#ifndef lamella_contact_gap_constraints_h
#define lamella_contact_gap_constraints_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/slave_surface.h>

#include <deal.II/base/array_view.h>

#include <boost/iterator/indirect_iterator.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class ContactSides;

  /// Relative displacement of two facing points along a normal or tangent, or a
  /// weighted average: a linear functional of the DoFs of both bodies.
  struct ContactConstraint
  {
    /// Functional of the first body, with negative weights, then that of the
    /// second, with positive weights. An obstacle has one under a Force only.
    std::vector<BodyFunctional> parts;
    /// Index of the load history that multiplies the motion of an obstacle.
    unsigned int history = 0;

    /// Returns the displacement of the second side relative to the first along
    /// the normal or tangent [length]; @p u has one block per body.
    double
    jump(const BlockVector &u) const
    {
      double sum = 0.;
      for (const BodyFunctional &part : parts)
        sum += part(u);
      return sum;
    }

    /// Adds the force @p factor times the transposed functional to @p f.
    void
    add_to(BlockVector &f, const double factor) const
    {
      for (const BodyFunctional &part : parts)
        part.add_to(f, factor);
    }
  };

  /// Slip of two facing points along a tangent t at load factor f,
  ///   s(u, f) = t . (u_2(X_2) - u_1(X_1)) + s_init + f s_rate,
  /// averaged with the weights of the gap constraint. It is measured from the
  /// undeformed bodies, or for finite motion from the beginning of the load
  /// step. The shear force acts on the second side along t.
  struct SlipConstraint : ContactConstraint
  {
    /// Unit tangent, scene axes.
    dealii::Tensor<1, 3> tangent;
    /// Slip due to the motion of an obstacle at load factor 1 [length].
    double rate = 0.;
    /// Constant that makes slip() exact at the last linearization [length].
    double initial = 0.;

    /// Returns the slip [length] at displacements @p u, load factor @p factor.
    double
    slip(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial + factor.of(history) * rate;
    }
  };

  /// Linearized gap function of two facing points, at load factor t,
  ///   g(u, t) = n . (u_2(X_2) - u_1(X_1)) + g_init + t g_rate,
  /// or its weighted average (Eq. 16 of Nagaraj et al. 2020). The first term is
  /// a row b of the constraint matrix times the DoFs of both bodies. Gap g and
  /// contact force lambda satisfy the Hertz-Signorini-Moreau conditions
  ///   g >= 0,  lambda >= 0,  g lambda = 0,
  /// which `penalty` regularizes (enforcement.h). lambda [force] is positive in
  /// compression and loads the bodies with lambda b^T: lambda n on the second
  /// side, -lambda n on the first.
  struct GapConstraint : ContactConstraint
  {
    /// (Weighted mean) gap of the undeformed bodies along the normal [length].
    double initial_gap = 0.;
    /// Gap due to the motion of an obstacle at load factor 1 [length].
    double      gap_rate    = 0.;
    Enforcement enforcement = Enforcement::penalty; ///< Multiplier or penalty.
    /// Penalty parameter [force / length], not zero (row_penalty()).
    double penalty = 0.;

    double friction = 0.; ///< Coulomb friction coefficient.
    /// Compliance of the adhesive of tied points in normal and in tangential
    /// direction, t / (E A) and t / (G A) [length / force]; zero without.
    std::array<double, 2> adhesive = {};
    /// Slips along two tangents; empty without friction and ties.
    std::vector<SlipConstraint> slips = {};
    /// Number of the slave node in MeshSurface::grid_nodes(). It identifies the
    /// material point when the surfaces are paired anew.
    unsigned int slave_node = 0;

    /// Returns true if the constraint is always active and bilateral, as are
    /// its slips.
    bool
    is_tied() const
    {
      return enforcement == Enforcement::tied;
    }

    /// Returns the gap at @p u and @p factor [length]; negative if penetrating.
    double
    gap(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial_gap + factor.of(history) * gap_rate;
    }
  };

  /// Discretized contact of one ContactPair: gap constraints, contact points
  /// and weights, created from the undeformed bodies by make_interface(). In
  /// linear kinematics the initially facing points remain paired. For finite
  /// motion, MovingContacts pairs the surfaces anew and updates the
  /// constraints. rows[k] and points[k] belong together. Every process has all
  /// constraints.
  struct ContactInterface
  {
    /// Contact point of a constraint, for output, in scene axes.
    struct Point
    {
      /// Undeformed point on the first surface.
      dealii::Point<3> first,
        second; ///< Opposite point on the second surface, undeformed.
      /// Normal, outward from the first side, along which the force acts on the
      /// second side. For weighted gaps, its average.
      dealii::Tensor<1, 3> normal;
      /// Tributary area [length^2]: the smaller one of a node pair, or that of
      /// a slave node, or the integral of a multiplier function over the facing
      /// area.
      double area = 0.;
      /// Angle between the normals of the two surfaces [rad]; 0 if parallel.
      double angle = 0.;
      /// Point spacing [length], the root of the full tributary area.
      double spacing = 0.;
      /// Location of the slave node in its body.
      Location node = {};
    };
    std::string name; ///< Name in `subsection Contact NAME`.
    /// Discretization of the gaps, chosen if the scene has `auto`.
    Discretization discretization = Discretization::undefined;
    /// Index of the first body in the scene.
    unsigned int first_body = 0;
    /// Index of the second body in the scene; empty for a rigid obstacle.
    std::optional<unsigned int> second_body;
    /// Rigid obstacle; null if the second side is a body.
    std::shared_ptr<const Obstacle> obstacle;
    /// Name of the second body or the obstacle, for messages and reports.
    std::string second_name;
    /// True if the second surface is the slave, false if the first is.
    bool points_on_second = false;
    /// Name of the slave surface.
    std::string slave_surface;
    /// Number of nodes of the first surface that have no constraint since they
    /// face no point of the second (`node to node`: no node).
    unsigned int unpaired = 0;
    /// Number of nodes of the second surface that face no point of the first.
    unsigned int unpaired_second = 0;
    /// Number of unpaired nodes of `node to node` that face the second surface.
    unsigned int nonmatching_nodes = 0;
    /// Number of unpaired nodes of `node to node` that face the first surface.
    unsigned int nonmatching_nodes_second = 0;
    /// Gap constraints: one per node pair, or one per slave node with a
    /// projection onto the other surface.
    std::vector<GapConstraint> rows;
    std::vector<Point>         points; ///< Contact point of each constraint.
    ConstraintGeometry first, ///< Points and weights on the first surface.
      second;                 ///< Points and weights on the second surface.
    /// Slave surface with the functions of the constraints, never null.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of `surface to surface`; empty for other contacts.
    std::vector<GapPoint> sampled;
    /// Messages about this pairing for the user, one sentence each.
    std::vector<std::string> notes;

    /// Returns true for tied surfaces.
    bool
    is_tied() const
    {
      return !rows.empty() && rows.front().is_tied();
    }
  };

  /// Returns the undeformed position of the slave node of @p point or, if this
  /// node is unknown, the position on the first surface.
  inline const dealii::Point<3> &
  place_of(const ContactInterface::Point &point)
  {
    return point.node.places.empty() ? point.first : point.node.position;
  }

  /// View of the gap constraints of several contacts, numbered from 0, contact
  /// by contact. These numbers are also the rows of the constraint matrix and
  /// of contact force vectors. The constraints must not change their addresses.
  class GapConstraints
  {
  public:
    /// Creates an empty view, for size(), empty() and the iterators only.
    GapConstraints() = default;
    /// Views the constraints of @p contacts, which must not be renumbered.
    GapConstraints(const std::vector<ContactInterface> &contacts);
    /// Views the constraints @p all as those of a single contact, number 0.
    GapConstraints(const std::vector<GapConstraint> &all);
    /// Deleted for temporaries, which would not outlive the view.
    GapConstraints(std::vector<ContactInterface> &&contacts) = delete;
    GapConstraints(std::vector<GapConstraint> &&rows)        = delete;

    /// Returns the number of gap constraints of all contacts.
    unsigned int
    size() const
    {
      return rows.size();
    }

    /// Returns true if no contact has a gap constraint.
    bool
    empty() const
    {
      return rows.empty();
    }

    /// Returns gap constraint number @p row, below size(); not checked.
    const GapConstraint &
    operator[](const unsigned int row) const
    {
      return *rows[row];
    }

    /// Returns the index of the slip of constraint @p row along its tangent
    /// number @p tangent (0 or 1) in a list of all gaps, then all slips.
    unsigned int
    slip(const unsigned int row, const unsigned int tangent) const
    {
      return size() + 2 * row + tangent;
    }

    /// Returns the index of the constraint to which entry @p number belongs in
    /// a list of all gaps, then all slips (two per constraint).
    unsigned int
    row_of(const unsigned int number) const
    {
      return number < size() ? number : (number - size()) / 2;
    }

    /// Returns the functional of entry @p number in a list of all gaps, then
    /// all slips (two per constraint).
    const ContactConstraint &
    constraint(const unsigned int number) const
    {
      if (number < size())
        return *rows[number];
      return rows[row_of(number)]->slips[(number - size()) % 2];
    }

    /// Returns true if any contact has friction.
    bool
    has_friction() const;

    /// Returns true if any constraint has slips: contacts with friction, ties.
    bool
    has_slips() const;

    /// Returns @p some constraints (ascending) and all ties, ascending.
    std::vector<unsigned int>
    with_ties(const std::vector<unsigned int> &some) const;

    /// Returns an iterator to the first gap constraint.
    auto
    begin() const
    {
      return boost::make_indirect_iterator(rows.begin());
    }

    /// Returns an iterator past the last gap constraint.
    auto
    end() const
    {
      return boost::make_indirect_iterator(rows.end());
    }

    /// Returns the contact of constraint @p row and the constraint's number in
    /// it.
    std::pair<unsigned int, unsigned int>
    contact_of_row(const unsigned int row) const;

    /// Returns the material point of constraint @p row: the index of its
    /// contact and GapConstraint::slave_node.
    std::pair<unsigned int, unsigned int>
    material_point(const unsigned int row) const
    {
      return {contact_of_row(row).first, rows[row]->slave_node};
    }

    /// Returns the entries for @p contact of @p values, one per constraint.
    template <typename T>
    dealii::ArrayView<const T>
    of_contact(const unsigned int contact, const std::vector<T> &values) const
    {
      if (values.empty())
        return {values.data(), 0};
      AssertDimension(values.size(), size());
      return {values.data() + firsts[contact],
              firsts[contact + 1] - firsts[contact]};
    }

    /// Returns the constraints among @p some that belong to @p contact, as
    /// numbers within that contact.
    std::vector<unsigned int>
    local_rows_of(const unsigned int               contact,
                  const std::vector<unsigned int> &some) const;

  private:
    std::vector<const GapConstraint *> rows;
    /// First constraint of each contact, and one past the last.
    std::vector<unsigned int> firsts;
  };

  /// Returns the displacement of @p obstacle along the vector @p direction as a
  /// functional of its DoF; empty if its motion is prescribed or there are only
  /// @p n_bodies bodies, without it (temporary models).
  std::vector<BodyFunctional>
  guided_part(const Obstacle             &obstacle,
              const dealii::Tensor<1, 3> &direction,
              const unsigned int          n_bodies);

  /// Returns the default search distance [length]: twice Body::size() of the
  /// smaller body, or of the first body for an obstacle.
  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies);

  /// Returns the search distance that the scene gives for @p contact, or the
  /// default one [length]. Throws InputError if a surface does not exist.
  double
  search_radius_of(const ContactPair &contact, const Bodies &bodies);

  /// Creates the gap constraints of @p contact on the undeformed @p bodies:
  ///   1. surfaces with normals and search trees (MeshSurface);
  ///   2. `automatic` discretization: `node to node` if every node that faces
  ///      the other surface faces one of its nodes, else `surface to surface`;
  ///   3. `automatic` slave side: the side with more grid cells where the two
  ///      face each other (count_facing_cells()), if equal the first body;
  ///   4. gaps, normals, areas and weights: pair_node_to_node(),
  ///      pair_node_to_surface() or weighted_gaps();
  ///   5. functionals of the DoFs with these weights; penalty parameters;
  ///   6. overlaps treated as Overclosure; gaps within rounding set to zero.
  ///
  /// Throws InputError if a surface does not exist, if no points face each
  /// other within the search distance (the message gives the nearest distance),
  /// if the surfaces face away from each other or overlap by more than the
  /// depth of the cells, and for any overlap under Overclosure::refuse. Points
  /// with larger overlap have no constraint if they are on the far side of
  /// their own body (the upper half of a roller).
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);

  /// Creates the interface as make_interface() does, but with @p search_radius
  /// [length] as search distance. The surfaces must exist.
  ContactInterface
  make_interface_within(const ContactPair &contact,
                        const Bodies      &bodies,
                        const double       search_radius);

  /// Creates the interface between the surfaces @p sides with the search
  /// distance @p search_radius [length]. Checks overlap if undeformed.
  ContactInterface
  make_interface_within(const ContactSides &sides, const double search_radius);

  /// Returns the discretization of contact between the surfaces @p sides. For
  /// `automatic` it is node to node if every node that faces the other surface
  /// within @p search_radius faces one of its nodes, else surface to surface.
  Discretization
  choose_discretization(const ContactSides &sides, const double search_radius);

  /// Returns the gaps of node-to-node contact, one per pair of nodes at most @p
  /// search_radius apart (pair_node_to_node()), with the smaller of both
  /// tributary areas. Stores in @p interface how many nodes have no partner.
  Gaps
  node_to_node(const ContactSides &sides,
               const double        search_radius,
               ContactInterface   &interface);
} // namespace lamella

#endif
