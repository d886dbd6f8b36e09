// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `contact`: who may touch whom, where, and by what law. It owns
// search and pairing, the gap rows with the geometry that they were made from,
// rigid obstacles, penalties and the other enforcements, the traction that
// forces of rows are, and the checks of what pairing assumed. It describes the
// problem and never solves it: which rows carry force is found in `solve`.

#ifndef lamella_contact_gap_rows_h
#define lamella_contact_gap_rows_h

#include <lamella/contact/carrying_surface.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/row_geometry.h>

#include <deal.II/base/array_view.h>

#include <boost/iterator/indirect_iterator.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class ContactSides;

  /// What a pair of points measures of the bodies' displacements, or a weighted
  /// average of that over several pairs, along one direction.
  struct PairRow
  {
    /// One for each body that deforms. The first is First's, -sum w . u_1; the
    /// second, if any, +sum v . u_2.
    std::vector<BodyRow> parts;
    /// Which load factor the way of an obstacle is multiplied with.
    unsigned int history = 0;

    /// Along the direction u_2 - u_1 of the bodies that deform. @p u has a
    /// block for each body of the scene. [length]
    double
    opening(const BlockVector &u) const
    {
      double sum = 0.;
      for (const BodyRow &part : parts)
        sum += part(u);
      return sum;
    }

    /// f += factor times the row's transpose. With the contact force for
    /// @p factor that is the row's share of the load.
    void
    add_to(BlockVector &f, const double factor) const
    {
      for (const BodyRow &part : parts)
        part.add_to(f, factor);
    }
  };

  /**
   * The slip of a pair of points along a tangent t,
   *   s(u, f) = t . (u_2(X_2) - u_1(X_1)) + s_init + f s_rate,
   * by the same weights as its gap, at load factor f: from the undeformed
   * bodies; of rows that move (Contact) from where the step began. A force
   * lambda_t in it loads the second side along t.
   */
  struct SlipRow : PairRow
  {
    /// t, a unit vector of the scene.
    dealii::Tensor<1, 3> tangent;
    /// What a rigid obstacle that moves adds at load factor 1 [length].
    double rate = 0.;
    /// Of rows that move what makes this the slip at the state that they are
    /// of [length].
    double initial = 0.;

    double
    slip(const BlockVector &u, const LoadFactor &factor) const
    {
      return opening(u) + initial + factor.of(history) * rate;
    }
  };

  /**
   * The linearised gap function of one pair of points (Eq. 16),
   *   g(u, t) = n . (u_2(X_2) - u_1(X_1)) + g_init + t g_rate,
   * or a weighted average of such: a row b of the matrix B over the DoFs of the
   * bodies (the sign of either side is in the parts), a constant, and what an
   * obstacle's motion adds at load factor t. All lengths, scene units.
   *
   * The Hertz-Signorini-Moreau conditions (Eq. 18) hold for each row,
   *   g >= 0,  lambda >= 0,  g lambda = 0,
   * softened by `penalty` (enforcement.h). lambda [force] is positive in
   * compression: over the row's area it is -p_N of the paper. It loads the
   * bodies with lambda b^T, lambda n on the second side and -lambda n on the
   * first, so action and reaction balance.
   *
   * Nothing in `solve` knows where a row came from.
   */
  struct GapRow : PairRow
  {
    /// (X_2 - X_1) . n of the undeformed bodies (Eq. 17 with the averaged
    /// normal), or its average; negative where they overlap. [length]
    double initial_gap = 0.;
    /// What a rigid obstacle that moves adds to the gap at load factor 1. n
    /// times its displacement [length]; 0 between two bodies.
    double      gap_rate    = 0.;
    Enforcement enforcement = Enforcement::penalty;
    /// epsilon_N in force / length. From row_penalty(), never 0 in a row of
    /// make_interface().
    double penalty = 0.;

    /// mu of Coulomb's law, and with friction the slips along two tangents that
    /// are normal to n and each other.
    double               friction = 0.;
    std::vector<SlipRow> slips    = {};

    /// g at load factor @p factor. Negative: the bodies penetrate there.
    /// [length]
    double
    gap(const BlockVector &u, const LoadFactor &factor) const
    {
      return opening(u) + initial_gap + factor.of(history) * gap_rate;
    }
  };

  /**
   * The discretised contact of one ContactPair: its gap rows, which it owns,
   * and the geometry behind each, as make_interface() makes it from the
   * undeformed bodies: linear kinematics holds places apart that faced each
   * other at the start (assumptions.h checks that). Where bodies move far,
   * Contact pairs anew and moves the rows.
   *
   * rows[k] and points[k] belong together. It refers to no body: bodies are
   * numbers in Bodies; `places` name cells of the bodies that it was made from.
   * The obstacle is shared with the scene. Every process has all of it.
   */
  struct ContactInterface
  {
    /// Where a row is: what tables and pictures of contact show. Scene axes.
    struct Point
    {
      /// X_1 and X_2: of `surface to surface` a node of the carrying side and
      /// the place that it faces.
      dealii::Point<3> first, second;
      /// n of the row, outwards from First: the row's force on the second side
      /// is lambda n, on the first -lambda n. Of `surface to surface` it is the
      /// mean of n over the row's area, shorter than 1 where surfaces curve.
      dealii::Tensor<1, 3> normal;
      /// The tributary area A [length^2], by which lambda becomes a pressure:
      /// the smaller one of both nodes, that of the node, or of `surface to
      /// surface` A_i = int phi_i dA over what faces the other side.
      double area = 0.;
      /// Between the normals of the two sides (n_1 and -n_2), in rad. Of
      /// `surface to surface` at its node.
      double angle = 0.;
      /// Of the points around: the root of the area that belongs to the point
      /// on its own side, whether all of that faces the other side or a sliver.
      /// [length]
      double spacing = 0.;
      /// The node of the side that carries the points.
      Location node = {};
    };
    /// These as in the ContactPair; `automatic` is decided here.
    std::string    name;
    Discretisation discretisation = Discretisation::undefined;
    /// Number in Bodies.
    unsigned int first_body = 0;
    /// None where the second is a rigid obstacle.
    std::optional<unsigned int> second_body;
    /// That obstacle, else null.
    std::shared_ptr<const Obstacle> obstacle;
    /// Of the body or the obstacle. For messages and reports.
    std::string second_name;
    /// Whether the second side carries the points. `automatic` is decided here.
    /// Never with an obstacle or `node to node`.
    bool points_on_second = false;
    /// What the surface of that side is called.
    std::string carrying_surface;
    /// Nodes of either side that face nothing of the other: of `node to node`
    /// no node. They can pass through the other body. Of an obstacle there are
    /// none.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// Those among them that face the other surface, but none of its nodes: of
    /// `node to node` only.
    unsigned int beside_nodes = 0, beside_nodes_second = 0;
    /// One for each pair of nodes, or each node of the carrying side that faces
    /// something.
    std::vector<GapRow> rows;
    std::vector<Point>  points;
    /// What the rows were made from: on First, where weights are along -n, and
    /// on Second, where they are along n; none of an obstacle.
    RowGeometry first, second;
    /// What carries the rows, with their functions there: what their forces are
    /// a pressure on (ContactTraction). Never null in one of make_interface().
    std::shared_ptr<const CarryingSurface> surface = {};
    /// Where gaps are averaged, of `surface to surface` only: what moved gaps
    /// (Contact) are made from.
    std::vector<GapPoint> sampled;
    /// What the user should know of this pairing, a sentence each.
    std::vector<std::string> notes;
  };

  /// Where @p point of a contact is, undeformed in the scene: the node that
  /// carries it, or its place on First if it has none.
  inline const dealii::Point<3> &
  place_of(const ContactInterface::Point &point)
  {
    return point.node.places.empty() ? point.first : point.node.position;
  }

  /**
   * The rows of several contacts one after the other, as those who solve see
   * them: the matrix B of all contacts, numbered through from 0 contact by
   * contact, with a vector of forces by that number. A view that copies no row
   * (a pointer each); who owns the rows has to live longer and must not move
   * them.
   */
  class GapRows
  {
  public:
    /// No row and no contact: only size(), empty() and the iterators may be
    /// called.
    GapRows() = default;
    /// Contact number k is @p contacts[k], also where it has no row.
    GapRows(const std::vector<ContactInterface> &contacts);
    /// Rows of no contact in particular. They count as contact 0.
    GapRows(const std::vector<GapRow> &rows);
    /// Temporaries would be gone before the view is used.
    GapRows(std::vector<ContactInterface> &&contacts) = delete;
    GapRows(std::vector<GapRow> &&rows)               = delete;

    /// The number of gap rows of all contacts, so the size of a vector of
    /// forces.
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

    /// @p row below size(); not checked.
    const GapRow &
    operator[](const unsigned int row) const
    {
      return *rows[row];
    }

    /// The number of a slip: numbers from size() on are those of slips. @p row
    /// has friction, @p tangent is 0 or 1.
    unsigned int
    slip(const unsigned int row, const unsigned int tangent) const
    {
      return size() + 2 * row + tangent;
    }

    /// One past the largest number that a gap or a slip may have.
    unsigned int
    end_of_slips() const
    {
      return 3 * size();
    }

    /// The row that the gap or the slip @p number is of.
    unsigned int
    row_of(const unsigned int number) const
    {
      return number < size() ? number : (number - size()) / 2;
    }

    /// The gap or the slip @p number.
    const PairRow &
    pair_row(const unsigned int number) const
    {
      if (number < size())
        return *rows[number];
      return rows[row_of(number)]->slips[(number - size()) % 2];
    }

    /// Whether any row has friction.
    bool
    rub() const;

    /// Iterators over the rows themselves, not over pointers.
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

    /// The contact that @p row belongs to, and its number there. @p row must be
    /// below size(). A binary search in the contacts.
    std::pair<unsigned int, unsigned int>
    in_contact(const unsigned int row) const;

    /// Those of @p values, one for each row, that belong to @p contact. A view
    /// of @p values, which must have size() entries, or none, and live longer.
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

    /// Those of @p some rows that belong to @p contact, by their numbers there.
    /// Their order is kept; those of other contacts are left out.
    std::vector<unsigned int>
    among_contact(const unsigned int               contact,
                  const std::vector<unsigned int> &some) const;

  private:
    std::vector<const GapRow *> rows;
    /// The first row of each contact, and behind the last. One entry more than
    /// there are contacts; empty in a view of nothing.
    std::vector<unsigned int> firsts;
  };

  /**
   * How far apart places may lie to be paired if the scene does not say: the
   * length of the smaller body. Whatever moves by more than that is far outside
   * of linear kinematics, and rows that never close cost next to nothing.
   * (How far they may overlap is decided by the depth of the cells below, see
   * make_interface().)
   * Twice Body::size(); with an obstacle the length of First's body. [length]
   */
  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies);

  /// The search distance of @p contact, given or automatic [length]. Throws
  /// InputError if a surface of the contact does not exist.
  double
  search_reach(const ContactPair &contact, const Bodies &bodies);

  /**
   * Searches, pairs and makes the gap rows of @p contact on the undeformed
   * @p bodies: 1. the two surfaces with their normals and search trees
   * (MeshSurface); 2. what Discretisation::automatic is here: `node to node`
   * where every node that faces the other surface faces one of its nodes; 3.
   * the side that carries the points: as PointsOn says,
   * `automatic` the one with more grid cells where the two face each other
   * (cells_facing()), of equal ones the body that comes first in the scene; 4.
   * gaps, normals, areas and weights: pair_node_to_node(),
   * pair_node_to_surface() or weighted_gaps(); 5. weights times the bodies'
   * displacement rows, penalties from the local stiffnesses; 6. overlaps as
   * Overclosure says. A gap of rounding (1e-14 of the coordinates) becomes
   * zero.
   *
   * Throws InputError if a surface does not exist, if nothing faces the other
   * side within the search distance (the message gives the nearest distance of
   * nodes), if the surfaces look away from each other or the bodies lie in each
   * other by more than the cells are deep, and for any overlap under
   * Overclosure::refuse. Places behind each other by more than the cells are
   * deep are left out where they look away from each other through their own
   * bodies (the upper half of a roller).
   */
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);

  /// make_interface() with places up to @p reach [length] apart, whatever the
  /// search distance; the names of the surfaces are taken for checked. Throws
  /// InputError as make_interface() does.
  ContactInterface
  interface_within(const ContactPair &contact,
                   const Bodies      &bodies,
                   const double       reach);

  /// The same of the surfaces where @p sides stand. Of those that have moved,
  /// nobody asks how deep they lie in each other.
  ContactInterface
  interface_within(const ContactSides &sides, const double reach);
} // namespace lamella

#endif
