// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_gap_rows_h
#define lamella_contact_gap_rows_h

#include <lamella/conditions/region.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/pairing.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  enum class Discretisation
  {
    undefined,
    node_to_node
  };

  enum class Enforcement
  {
    undefined,
    penalty
  };

  /// Two surfaces that may touch, as a scene says it.
  struct ContactPair
  {
    std::string    name;
    Region         first, second;
    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    Penalty        penalty;
    /// Of facing nodes, see pair_node_to_node().
    double tolerance = 1e-6;
  };

  /**
   * The gap of one pair of points (Eq. 16),
   *   g(u) = n . (u_2(X_2) - u_1(X_1)) + g_init,
   * a row over the DoFs of two bodies with the sign within the parts. A contact
   * force lambda >= 0 in it loads the bodies with lambda times the row's
   * transpose. Nothing in `solve` knows where it came from.
   */
  struct GapRow
  {
    std::array<BodyRow, 2> parts;
    double                 initial_gap = 0.;
    /// epsilon_N in force / length.
    double penalty = 0.;

    double
    gap(const BlockVector &u) const
    {
      return parts[0](u) + parts[1](u) + initial_gap;
    }

    /// f += factor times the row's transpose.
    void
    add_to(BlockVector &f, const double factor) const
    {
      parts[0].add_to(f, factor);
      parts[1].add_to(f, factor);
    }
  };

  /// The rows of one contact with the geometry behind each, for reports.
  struct ContactInterface
  {
    struct Point
    {
      dealii::Point<3>     first, second;
      dealii::Tensor<1, 3> normal;
      double               area = 0.;
    };
    std::string         name;
    unsigned int        first_body = 0, second_body = 0;
    unsigned int        unpaired = 0;
    std::vector<GapRow> rows;
    std::vector<Point>  points;
  };

  /**
   * Searches, pairs and makes the gap rows of @p contact. Throws InputError if
   * a surface does not exist or no points face each other (the message gives
   * the nearest distance).
   */
  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies);
} // namespace lamella

#endif
