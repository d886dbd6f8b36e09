// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `contact`: who may touch whom, where, and by what law. It owns
// search and pairing, the gap rows with the geometry that they were made from,
// rigid obstacles, penalties and the other enforcements, and the checks of what
// pairing assumed. It describes the problem and never solves it: which rows
// carry force is found in `solve`.

#ifndef lamella_contact_gap_rows_h
#define lamella_contact_gap_rows_h

#include <lamella/conditions/region.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/obstacle.h>
#include <lamella/contact/row_geometry.h>

#include <deal.II/base/array_view.h>

#include <boost/iterator/indirect_iterator.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  enum class Discretisation
  {
    undefined,
    node_to_node,      ///< nodes that face each other
    node_to_surface,   ///< nodes of one side against the other side's surface
    surface_to_surface ///< gaps averaged with hat functions of one side
  };

  /// What becomes of bodies that overlap from the start.
  enum class Overclosure
  {
    undefined,
    push_apart, ///< contact forces push them apart: an interference fit
    adjust,     ///< the overlap is taken out of the gaps, without strain
    refuse      ///< an error
  };

  /// Which side carries the points of `node to surface` and the hat functions
  /// of `surface to surface`.
  enum class PointsOn
  {
    undefined,
    automatic, ///< the side with the finer grid where the two face each other
    first,
    second
  };

  /// Two surfaces that may touch, as a scene says it.
  struct ContactPair
  {
    std::string name;
    Region      first, second;
    /// A rigid obstacle in the place of `second`, if not null.
    std::shared_ptr<const Obstacle> obstacle;

    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    Overclosure    overclosure    = Overclosure::push_apart;
    PointsOn       points_on      = PointsOn::automatic;
    Penalty        penalty;
    /// Of facing nodes, see pair_node_to_node().
    double tolerance = 1e-6;
    /// Places further apart than this along the normal are not paired; none
    /// for automatic_search_distance().
    std::optional<double> search_distance;
  };

  /**
   * The gap of one pair of points (Eq. 16),
   *   g(u) = n . (u_2(X_2) - u_1(X_1)) + g_init,
   * or an average of such, a row over the DoFs of the bodies with the sign
   * within the parts. A contact force lambda >= 0 in it loads the bodies with
   * lambda times the row's transpose. Nothing in `solve` knows where it came
   * from.
   */
  struct GapRow
  {
    /// One for each body that deforms.
    std::vector<BodyRow> parts;
    double               initial_gap = 0.;
    /// What a rigid obstacle that moves adds to the gap at load factor 1.
    double      gap_rate    = 0.;
    Enforcement enforcement = Enforcement::penalty;
    /// epsilon_N in force / length.
    double penalty = 0.;

    /// n . (u_2 - u_1) of the bodies that deform.
    double
    opening(const BlockVector &u) const
    {
      double sum = 0.;
      for (const BodyRow &part : parts)
        sum += part(u);
      return sum;
    }

    /// g at load factor @p factor.
    double
    gap(const BlockVector &u, const double factor) const
    {
      return opening(u) + initial_gap + factor * gap_rate;
    }

    /// f += factor times the row's transpose.
    void
    add_to(BlockVector &f, const double factor) const
    {
      for (const BodyRow &part : parts)
        part.add_to(f, factor);
    }
  };

  /// The rows of one contact, which it owns, with the geometry behind each.
  struct ContactInterface
  {
    struct Point
    {
      /// X_1 and X_2: of `surface to surface` a node of the carrying side and
      /// the place that it faces.
      dealii::Point<3> first, second;
      /// n of the row, outwards from First: the row's force on the second side
      /// is lambda n, on the first -lambda n. Of `surface to surface` it is the
      /// mean of n over the row's area, shorter than 1 where surfaces curve.
      dealii::Tensor<1, 3> normal;
      double               area = 0.;
      /// Between the normals of the two sides (n_1 and -n_2), in rad.
      double angle = 0.;
      /// Of the points around: the root of the area that belongs to the point
      /// on its own side, whether all of that faces the other side or a sliver.
      double spacing = 0.;
    };
    std::string    name;
    Discretisation discretisation = Discretisation::undefined;
    unsigned int   first_body     = 0;
    /// None where the second is a rigid obstacle.
    std::optional<unsigned int> second_body;
    /// That obstacle, else null.
    std::shared_ptr<const Obstacle> obstacle;
    /// Of the body or the obstacle.
    std::string second_name;
    /// Whether the second side carries the points.
    bool points_on_second = false;
    /// Nodes of either side that face nothing of the other: of `node to node`
    /// no node.
    unsigned int        unpaired = 0, unpaired_second = 0;
    std::vector<GapRow> rows;
    std::vector<Point>  points;
    /// What the rows were made from: on First, where weights are along -n, and
    /// on Second, where they are along n; none of an obstacle.
    RowGeometry first, second;
    /// What the user should know of this pairing, a sentence each.
    std::vector<std::string> notes;
  };

  /**
   * The rows of several contacts one after the other, as those who solve see
   * them: numbered through from 0, with a vector of forces by that number. A
   * view that copies no row; who owns the rows has to live longer.
   */
  class GapRows
  {
  public:
    GapRows() = default;
    GapRows(const std::vector<ContactInterface> &contacts);
    /// Rows of no contact in particular.
    GapRows(const std::vector<GapRow> &rows);
    GapRows(std::vector<ContactInterface> &&contacts) = delete;
    GapRows(std::vector<GapRow> &&rows)               = delete;

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

    const GapRow &
    operator[](const unsigned int row) const
    {
      return *rows[row];
    }

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

    /// The contact that @p row belongs to, and its number there.
    std::pair<unsigned int, unsigned int>
    in_contact(const unsigned int row) const;

    /// Those of @p values, one for each row, that belong to @p contact.
    dealii::ArrayView<const double>
    of_contact(const unsigned int         contact,
               const std::vector<double> &values) const;

    /// Those of @p some rows that belong to @p contact, by their numbers there.
    std::vector<unsigned int>
    of_contact(const unsigned int               contact,
               const std::vector<unsigned int> &some) const;

  private:
    std::vector<const GapRow *> rows;
    /// The first row of each contact, and behind the last.
    std::vector<unsigned int> firsts;
  };

  /**
   * How far apart places may lie to be paired if the scene does not say: the
   * length of the smaller body. Whatever moves by more than that is far outside
   * of linear kinematics, and rows that never close cost next to nothing.
   * (How far they may overlap is decided by the depth of the cells below, see
   * make_interface().)
   */
  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies);

  /**
   * Searches, pairs and makes the gap rows of @p contact. Throws InputError if
   * a surface does not exist, if nothing faces the other side (the message
   * gives the nearest distance of nodes), if the surfaces look away from each
   * other or the bodies lie in each other by more than the cells are deep.
   */
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);

  /**
   * The rows of @p contact on @p bodies, the same bodies in another
   * discretisation: the same places, weights, gaps and penalties. Throws
   * InputError if one of the places is not in the body there.
   */
  std::vector<GapRow>
  rows_on(const ContactInterface &contact, const Bodies &bodies);

  /// The same with places up to @p reach apart, whatever the Search distance.
  ContactInterface
  interface_within(const ContactPair &contact,
                   const Bodies      &bodies,
                   const double       reach);
} // namespace lamella

#endif
