// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `contact`: search, pairing, and the contact law. It owns the gap
// rows with their geometry, rigid obstacles, penalties and other enforcements,
// the traction of the row forces, and checks of the pairing. It formulates the
// contact problem; `solve` determines the active set.

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

  /// Relative displacement of a pair of points along a direction, or a mean.
  struct ContactConstraint
  {
    /// Parts, one per deformable body: -sum w . u_1, then +sum v . u_2.
    std::vector<BodyFunctional> parts;
    /// Load history that multiplies the motion of an obstacle.
    unsigned int history = 0;

    /// Returns the relative displacement u_2 - u_1 along the direction
    /// [length]; @p u has a block per body.
    double
    jump(const BlockVector &u) const
    {
      double sum = 0.;
      for (const BodyFunctional &part : parts)
        sum += part(u);
      return sum;
    }

    /// Adds @p factor (the contact force) times the transposed row to @p f.
    void
    add_to(BlockVector &f, const double factor) const
    {
      for (const BodyFunctional &part : parts)
        part.add_to(f, factor);
    }
  };

  /// Slip of a pair of points along a tangent t at load factor f,
  ///   s(u, f) = t . (u_2(X_2) - u_1(X_1)) + s_init + f s_rate,
  /// with the weights of its gap: from the undeformed bodies, or for moving
  /// rows from the beginning of the step. lambda_t loads the second side along
  /// t.
  struct SlipConstraint : ContactConstraint
  {
    /// Tangent t, a unit vector of the scene.
    dealii::Tensor<1, 3> tangent;
    /// Slip due to the motion of a rigid obstacle at load factor 1 [length].
    double rate = 0.;
    /// Constant that makes this the slip at the state of moving rows [length].
    double initial = 0.;

    double
    slip(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial + factor.of(history) * rate;
    }
  };

  /**
   * Linearized gap function of one pair of points (Eq. 16),
   *   g(u, t) = n . (u_2(X_2) - u_1(X_1)) + g_init + t g_rate,
   * or a weighted average: a row b of the matrix B over the DoFs of the bodies
   * (with the sign of each side), a constant, and the motion of an obstacle at
   * load factor t. Each row satisfies the Hertz-Signorini-Moreau conditions
   * (Eq. 18),
   *   g >= 0,  lambda >= 0,  g lambda = 0,
   * regularized by `penalty` (enforcement.h). lambda [force] is positive in
   * compression: over the area of the row it is -p_N of the paper. It loads the
   * bodies with lambda b^T, lambda n on the second side and -lambda n on the
   * first.
   */
  struct GapConstraint : ContactConstraint
  {
    /// (X_2 - X_1) . n of the undeformed bodies (Eq. 17 with the averaged
    /// normal), or its average [length].
    double initial_gap = 0.;
    /// Gap due to the motion of a rigid obstacle at load factor 1 [length].
    double      gap_rate    = 0.;
    Enforcement enforcement = Enforcement::penalty;
    /// epsilon_N [force / length] of row_penalty(), not zero.
    double penalty = 0.;

    /// Friction coefficient mu, and with friction slips along two tangents.
    double                      friction = 0.;
    std::vector<SlipConstraint> slips    = {};

    /// Returns g at load factor @p factor [length]; negative for penetration.
    double
    gap(const BlockVector &u, const LoadFactor &factor) const
    {
      return jump(u) + initial_gap + factor.of(history) * gap_rate;
    }
  };

  /**
   * Discretized contact of one ContactPair: gap rows and their geometry,
   * created by make_interface() from the undeformed bodies. In linear
   * kinematics the initially facing points remain paired (assumptions.h checks
   * this); for finite motion Contact pairs anew and moves the rows. rows[k] and
   * points[k] belong together. Bodies are indices into Bodies; `places` refer
   * to cells of the bodies of its creation. Every process holds all of it.
   */
  struct ContactInterface
  {
    /// Position of a row for tables and pictures, scene axes.
    struct Point
    {
      /// X_1 and X_2; for `surface to surface` a slave node and what it faces.
      dealii::Point<3> first, second;
      /// Normal n of the row, outward from First: its force is lambda n on the
      /// second side. For `surface to surface` the mean of n over the area.
      dealii::Tensor<1, 3> normal;
      /// Tributary area A [length^2]: the smaller one of both nodes, that of
      /// the node, or A_i = int phi_i dA over the part facing the other side.
      double area = 0.;
      /// Angle between n_1 and -n_2 [rad], for averages at the node.
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
    /// Number of nodes of either side that face nothing (`node to node`: no
    /// node) and may pass through the other body.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// Unpaired nodes of `node to node` that face the other surface.
    unsigned int nonmatching_nodes = 0, nonmatching_nodes_second = 0;
    /// Rows, one per pair of nodes or per slave node that faces something.
    std::vector<GapConstraint> rows;
    std::vector<Point>         points;
    /// Geometry of the rows: on First weights along -n, on Second along n.
    ConstraintGeometry first, second;
    /// Slave surface with the rows' functions (ContactTraction), never null.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of `surface to surface`, from which gaps move.
    std::vector<GapPoint> sampled;
    /// Notes on this pairing for the user, one sentence each.
    std::vector<std::string> notes;
  };

  /// Returns the undeformed slave node of @p point, or its place on First.
  inline const dealii::Point<3> &
  place_of(const ContactInterface::Point &point)
  {
    return point.node.places.empty() ? point.first : point.node.position;
  }

  /// Rows of several contacts in sequence, the matrix B of all contacts,
  /// numbered from 0 contact by contact, as their forces are. A view: the rows
  /// must outlive it at fixed addresses.
  class GapConstraints
  {
  public:
    /// Creates an empty view, for size(), empty() and the iterators only.
    GapConstraints() = default;
    /// Views the rows of @p contacts, which keep their numbers.
    GapConstraints(const std::vector<ContactInterface> &contacts);
    /// Views rows without a contact; they count as contact 0.
    GapConstraints(const std::vector<GapConstraint> &rows);
    /// Deleted for temporaries, which the view would outlive.
    GapConstraints(std::vector<ContactInterface> &&contacts) = delete;
    GapConstraints(std::vector<GapConstraint> &&rows)        = delete;

    /// Returns the number of gap rows of all contacts.
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

    /// Returns @p row, which must be below size(); not checked.
    const GapConstraint &
    operator[](const unsigned int row) const
    {
      return *rows[row];
    }

    /// Returns the number of a slip of @p row, size() or above.
    unsigned int
    slip(const unsigned int row, const unsigned int tangent) const
    {
      return size() + 2 * row + tangent;
    }

    /// Returns one past the largest possible number of a gap or slip.
    unsigned int
    end_of_slips() const
    {
      return 3 * size();
    }

    /// Returns the row of the gap or slip @p number.
    unsigned int
    row_of(const unsigned int number) const
    {
      return number < size() ? number : (number - size()) / 2;
    }

    /// Returns the gap or slip @p number.
    const ContactConstraint &
    constraint(const unsigned int number) const
    {
      if (number < size())
        return *rows[number];
      return rows[row_of(number)]->slips[(number - size()) % 2];
    }

    /// Returns true if any row has friction.
    bool
    has_friction() const;

    /// Iterators over the rows, not over pointers.
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

    /// Returns the contact of @p row and its number there, by binary search.
    std::pair<unsigned int, unsigned int>
    contact_of_row(const unsigned int row) const;

    /// Returns a view of the entries of @p values that belong to @p contact.
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

    /// Returns those of @p some rows in @p contact, by their numbers there.
    std::vector<unsigned int>
    local_rows_of(const unsigned int               contact,
                  const std::vector<unsigned int> &some) const;

  private:
    std::vector<const GapConstraint *> rows;
    /// First row of each contact, and one past the last row; may be empty.
    std::vector<unsigned int> firsts;
  };

  /// Returns the default search distance [length]: twice Body::size() of the
  /// smaller body, with an obstacle that of First's body.
  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies);

  /// Returns the given or automatic search distance of @p contact [length].
  /// Throws InputError if one of its surfaces does not exist.
  double
  search_radius_of(const ContactPair &contact, const Bodies &bodies);

  /**
   * Creates the gap rows of @p contact on the undeformed @p bodies:
   *   1. surfaces with normals and search trees (MeshSurface);
   *   2. Discretization::automatic: `node to node` if every node that faces the
   *      other surface faces one of its nodes;
   *   3. the slave side by SlaveSide; `automatic`: the side with more grid
   * cells where the two face each other (count_facing_cells()), if equal the
   *      first body of the scene;
   *   4. gaps, normals, areas and weights: pair_node_to_node(),
   *      pair_node_to_surface() or weighted_gaps();
   *   5. weights times displacement rows; penalties from local stiffnesses;
   *   6. overlaps by Overclosure; gaps of rounding become zero.
   *
   * Throws InputError if a surface does not exist, if nothing faces the other
   * side within the search distance (the message gives the nearest distance of
   * nodes), if the surfaces face away from each other or the bodies overlap by
   * more than the depth of the cells, and for any overlap under
   * Overclosure::refuse. Places that overlap by more are omitted if they face
   * away through their own bodies (the upper half of a roller).
   */
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);

  /// Creates the interface as make_interface() does, with the search radius @p
  /// search_radius [length]; the names of the surfaces must be valid.
  ContactInterface
  make_interface_within(const ContactPair &contact,
                        const Bodies      &bodies,
                        const double       search_radius);

  /// Creates the interface on @p sides, without checks of overlap if displaced.
  ContactInterface
  make_interface_within(const ContactSides &sides, const double search_radius);
} // namespace lamella

#endif
