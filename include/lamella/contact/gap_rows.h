// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_gap_rows_h
#define lamella_contact_gap_rows_h

#include <lamella/conditions/region.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/obstacle.h>
#include <lamella/contact/pairing.h>

#include <limits>
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

  /// Two surfaces that may touch, as a scene says it.
  struct ContactPair
  {
    std::string name;
    Region      first, second;
    /// A rigid obstacle in the place of `second`, if not null.
    std::shared_ptr<const Obstacle> obstacle;

    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    Overclosure    overclosure    = Overclosure::undefined;
    Penalty        penalty;
    /// Of facing nodes, see pair_node_to_node().
    double tolerance = 1e-6;
    /// Points further apart than this along the normal are not paired.
    double search_distance = std::numeric_limits<double>::infinity();
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

  /// The rows of one contact with the geometry behind each, for reports.
  struct ContactInterface
  {
    struct Point
    {
      dealii::Point<3>     first, second;
      dealii::Tensor<1, 3> normal;
      double               area = 0.;
    };
    std::string  name;
    unsigned int first_body = 0;
    /// None where the second is a rigid obstacle.
    std::optional<unsigned int> second_body;
    /// Of the body or the obstacle.
    std::string         second_name;
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
