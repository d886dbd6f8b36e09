// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `contact`: search, pairing, and the contact law. It owns the gap
// rows with their geometry, rigid obstacles, penalties and other
// enforcements, the traction of the row forces, and checks of the pairing.
// It formulates the contact problem; `solve` determines the active set. It
// does not solve it.

#ifndef lamella_contact_gap_constraints_h
#define lamella_contact_gap_constraints_h

#include <lamella/contact/constraint_geometry.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/slave_surface.h>

#include <deal.II/base/array_view.h>

#include <boost/iterator/indirect_iterator.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class ContactSides;

  /// Relative displacement of two facing points along a normal or tangent, or
  /// its weighted average: a linear functional of the DoFs of both bodies.
  struct ContactConstraint
  {
    /// Functional of the first body, -sum w_j . u_1(X_j), then, unless it is an
    /// obstacle, of the second, sum v_k . u_2(X_k), with weights w and v.
    std::vector<BodyFunctional> parts;
    /// Number of the load history that multiplies the motion of an obstacle.
    unsigned int history = 0;

    /// Returns the relative displacement u_2 - u_1 along the direction
    /// [length]; @p u has one block per body.
    double
    jump(const BlockVector &u) const
    {
      double sum = 0.;
      for (const BodyFunctional &part : parts)
        sum += part(u);
      return sum;
    }

    /// Adds the transposed functional times the force @p factor to @p f.
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
  /// undeformed bodies, or for moving contacts from the beginning of the load
  /// step. The shear force lambda_t acts on the second side along t.
  struct SlipConstraint : ContactConstraint
  {
    /// Tangent t, a unit vector in scene axes.
    dealii::Tensor<1, 3> tangent;
    /// s_rate: slip due to the motion of an obstacle at load factor 1 [length].
    double rate = 0.;
    /// s_init: makes slip() exact at the state of a moving contact [length].
    double initial = 0.;

    double
    slip(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial + factor.of(history) * rate;
    }
  };

  /// Linearized gap function of two facing points (Eq. 16),
  ///   g(u, t) = n . (u_2(X_2) - u_1(X_1)) + g_init + t g_rate,
  /// or its weighted average, at load factor t. The first term is a row b of
  /// the constraint matrix B times the DoFs of both bodies. Gap g and contact
  /// force lambda satisfy the Hertz-Signorini-Moreau conditions (Eq. 18),
  ///   g >= 0,  lambda >= 0,  g lambda = 0,
  /// which `penalty` regularizes (enforcement.h). lambda [force] is positive in
  /// compression and loads the bodies with lambda b^T: lambda n on the second
  /// side, -lambda n on the first.
  struct GapConstraint : ContactConstraint
  {
    /// g_init: (X_2 - X_1) . n of the undeformed bodies (Eq. 17 with the
    /// averaged normal), or its weighted average [length].
    double initial_gap = 0.;
    /// g_rate: gap due to the motion of an obstacle at load factor 1 [length].
    double      gap_rate    = 0.;
    Enforcement enforcement = Enforcement::penalty;
    /// Penalty parameter [force / length], not zero (row_penalty()).
    double penalty = 0.;

    /// Friction coefficient; if positive, `slips` along two tangents.
    double                      friction = 0.;
    std::vector<SlipConstraint> slips    = {};

    /// Returns g at load factor @p factor [length]; negative if penetrating.
    double
    gap(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial_gap + factor.of(history) * gap_rate;
    }
  };

  /// Discretized contact of one ContactPair: gap constraints, contact points
  /// and weights, created from the undeformed bodies by make_interface(). In
  /// linear kinematics the initially facing points remain paired (assumptions.h
  /// checks this); for finite motion, Contact pairs the surfaces anew and
  /// updates the constraints. rows[k] and points[k] belong together. Bodies are
  /// given by their indices in Bodies, and points by cells of the bodies for
  /// which the interface was created. Every process has all constraints.
  struct ContactInterface
  {
    /// Contact point of a constraint, for output, in scene axes.
    struct Point
    {
      /// Facing points X_1 and X_2 (weighted gaps: a node and its opposite).
      dealii::Point<3> first, second;
      /// Normal n of the constraint, outward from the first side: the force on
      /// the second side is lambda n. For weighted gaps, its average.
      dealii::Tensor<1, 3> normal;
      /// Tributary area A [length^2]: the smaller of both nodes' areas, that of
      /// the slave node, or A_i = int phi_i dA over the facing area.
      double area = 0.;
      /// Angle between the normals n_1 and -n_2 of the two surfaces [rad].
      double angle = 0.;
      /// Point spacing [length], the root of the full tributary area.
      double spacing = 0.;
      /// Node on the slave side.
      Location node = {};
    };
    /// Name and discretization of the ContactPair; `automatic` is resolved.
    std::string    name;
    Discretization discretization = Discretization::undefined;
    /// Index in Bodies.
    unsigned int first_body = 0;
    /// Index of the second body; empty for a rigid obstacle.
    std::optional<unsigned int> second_body;
    /// Rigid obstacle, or null.
    std::shared_ptr<const Obstacle> obstacle;
    /// Name of the second body or the obstacle, for messages and reports.
    std::string second_name;
    /// True if the second side is the slave (never for `node to node`).
    bool points_on_second = false;
    /// Name of the slave surface.
    std::string slave_surface;
    /// Number of nodes of each surface without a contact constraint, since they
    /// face no part of the other surface (`node to node`: no node of it).
    unsigned int unpaired = 0, unpaired_second = 0;
    /// Number of unpaired nodes of `node to node` that face the other surface.
    unsigned int nonmatching_nodes = 0, nonmatching_nodes_second = 0;
    /// Gap constraints, one per node pair or facing slave node.
    std::vector<GapConstraint> rows;
    std::vector<Point>         points;
    /// Points and weights of the constraints on the first and second side.
    ConstraintGeometry first, second;
    /// Slave surface with the functions phi_i of the constraints, never null.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of `surface to surface`, where gaps are measured.
    std::vector<GapPoint> sampled;
    /// Messages about this pairing for the user, one sentence each.
    std::vector<std::string> notes;
  };

  /// Returns the undeformed position of the slave node of the contact point
  /// @p point, if known, else its position on the first surface.
  inline const dealii::Point<3> &
  place_of(const ContactInterface::Point &point)
  {
    return point.node.places.empty() ? point.first : point.node.position;
  }

  /// View of the gap constraints of several contacts, numbered consecutively
  /// from 0, contact by contact. These numbers are also the rows of the
  /// constraint matrix B and of contact force vectors. The constraints must
  /// outlive the view at constant addresses.
  class GapConstraints
  {
  public:
    /// Creates an empty view, for size(), empty() and the iterators only.
    GapConstraints() = default;
    /// Views the gap constraints of @p contacts, which must not be renumbered.
    GapConstraints(const std::vector<ContactInterface> &contacts);
    /// Views constraints without an interface; they count as contact 0.
    GapConstraints(const std::vector<GapConstraint> &rows);
    /// Deleted for temporaries, which would not outlive the view.
    GapConstraints(std::vector<ContactInterface> &&contacts) = delete;
    GapConstraints(std::vector<GapConstraint> &&rows)        = delete;

    /// Returns the number of gap constraints of all contacts.
    unsigned int
    size() const
    {
      return rows.size();
    }

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

    /// Returns the number, following those of the gaps, of the slip of
    /// constraint @p row along its tangent @p tangent (0 or 1).
    unsigned int
    slip(const unsigned int row, const unsigned int tangent) const
    {
      return size() + 2 * row + tangent;
    }

    /// Returns one more than the largest possible number of a gap or slip.
    unsigned int
    end_of_slips() const
    {
      return 3 * size();
    }

    /// Returns the constraint number to which gap or slip @p number belongs.
    unsigned int
    row_of(const unsigned int number) const
    {
      return number < size() ? number : (number - size()) / 2;
    }

    /// Returns the functional of the gap or slip @p number.
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

    /// Iterators over the constraints, not over pointers.
    auto
    begin() const
    {
      return boost::make_indirect_iterator(rows.begin());
    }

    auto
    end() const
    {
      return boost::make_indirect_iterator(rows.end());
    }

    /// Returns the contact of constraint @p row, and its number within it.
    std::pair<unsigned int, unsigned int>
    contact_of_row(const unsigned int row) const;

    /// Returns a view of the entries of @p values for contact @p contact.
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

    /// Returns the constraints among @p some that belong to contact @p contact,
    /// numbered within that contact.
    std::vector<unsigned int>
    local_rows_of(const unsigned int               contact,
                  const std::vector<unsigned int> &some) const;

  private:
    std::vector<const GapConstraint *> rows;
    /// First constraint of each contact, and one past the last; may be empty.
    std::vector<unsigned int> firsts;
  };

  /// Returns the default search distance [length]: twice Body::size() of the
  /// smaller body, or with an obstacle of the first body.
  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies);

  /// Returns the scene's search distance of @p contact, or the automatic one
  /// [length]. Throws InputError if a surface does not exist.
  double
  search_radius_of(const ContactPair &contact, const Bodies &bodies);

  /// Creates the gap constraints of @p contact on the undeformed @p bodies:
  ///   1. surfaces with normals and search trees (MeshSurface);
  ///   2. `automatic` discretization: `node to node` if every node that faces
  /// the other surface faces one of its nodes, else `surface to surface`;
  ///   3. `automatic` slave side: the side with more grid cells where the two
  ///      face each other (count_facing_cells()), if equal the first body;
  ///   4. gaps, normals, areas and weights: pair_node_to_node(),
  ///      pair_node_to_surface() or weighted_gaps();
  ///   5. weights times displacement rows; penalties from local stiffnesses;
  ///   6. overlaps by Overclosure; gaps within rounding become zero.
  ///
  /// Throws InputError if a surface does not exist, if no points face each
  /// other within the search distance (the message gives the nearest distance
  /// of nodes), if the surfaces face away from each other or the bodies overlap
  /// by more than the depth of the cells, and for any overlap under
  /// Overclosure::refuse. Points that overlap by more are omitted if they face
  /// away through their own body (the upper half of a roller).
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);

  /// Creates the interface as make_interface() does, with @p search_radius in
  /// place of the search distance [length]. The surfaces must exist.
  ContactInterface
  make_interface_within(const ContactPair &contact,
                        const Bodies      &bodies,
                        const double       search_radius);

  /// Creates the interface between the surfaces @p sides within
  /// @p search_radius. Checks the overlap of undeformed ones.
  ContactInterface
  make_interface_within(const ContactSides &sides, const double search_radius);
} // namespace lamella

#endif
