// SPDX-License-Identifier: LGPL-2.1-or-later

// Rows seen as one list, and rows on another discretization of their bodies.

#include "contact_fixtures.h"

#include <lamella/base/exceptions.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(gap_constraints)

using namespace lamella;

namespace
{
  /// A strip on a wider one, 0.1 above it, the lower one in LE-@p degree on
  /// @p elements.
  Bodies
  two_strips(const unsigned int degree, const unsigned int elements)
  {
    const Placement &placement = placements[1];
    const auto       strip     = [](const double width) {
      return Laminate{
        width, {0., 90.}, {0.5, 0.5}, {"material", "material"}, {1}, {2}};
    };
    Bodies bodies;
    bodies.push_back(
      make_beam("upper",
                strip(1.),
                layer_wise(2),
                3.,
                2,
                Placement::from_directions(placement.to_scene({0.25, 0.4, 1.1}),
                                           placement.axes[1],
                                           placement.axes[2])));
    bodies.push_back(make_beam(
      "lower", strip(2.), layer_wise(degree), 4., elements, placement));
    return bodies;
  }



  /// The rows of @p side on the body @p index: sum_k w_rk . u(X_k), the places
  /// located anew.
  std::vector<BodyFunctional>
  rows_of(const ConstraintGeometry &side,
          const unsigned int        index,
          const Body               &body)
  {
    std::vector<Location> places;
    for (const Location &place : side.places)
      places.push_back(body.locate({place.position}).at(0).at(0));
    const auto                  u = body.rows(places, undisplaced);
    std::vector<BodyFunctional> rows;
    for (const ConstraintGeometry::Weights &weights : side.weights)
      {
        rows.push_back({index, {}});
        for (const auto &[k, w] : weights)
          for (unsigned int c = 0; c < 3; ++c)
            rows.back().row.add(u[k][c], w[c]);
        rows.back().row.compress();
      }
    return rows;
  }



  /// Those of a contact of two bodies on @p bodies, the same bodies in another
  /// discretization: the same places, weights and gaps.
  std::vector<GapConstraint>
  rows_on(const ContactInterface &contact, const Bodies &bodies)
  {
    const auto first  = rows_of(contact.first,
                               contact.first_body,
                               *bodies[contact.first_body]),
               second = rows_of(contact.second,
                                *contact.second_body,
                                *bodies[*contact.second_body]);
    std::vector<GapConstraint> rows;
    for (unsigned int r = 0; r < contact.rows.size(); ++r)
      {
        rows.push_back(contact.rows[r]);
        rows.back().parts = {first[r], second[r]};
      }
    return rows;
  }
} // namespace

BOOST_AUTO_TEST_CASE(numbered_through)
{
  std::vector<ContactInterface> contacts(3);
  contacts[0].rows.resize(2);
  contacts[2].rows.resize(3);
  const GapConstraints rows(contacts);
  BOOST_REQUIRE(rows.size() == 5);
  // A contact without rows lies between.
  const std::vector<std::pair<unsigned int, unsigned int>> place{
    {0, 0}, {0, 1}, {2, 0}, {2, 1}, {2, 2}};
  for (unsigned int r = 0; r < 5; ++r)
    {
      const auto [contact, row] = rows.contact_of_row(r);
      BOOST_TEST(contact == place[r].first);
      BOOST_TEST(row == place[r].second);
      // Seen, not copied.
      BOOST_TEST(&rows[r] == &contacts[contact].rows[row]);
    }
  const std::vector<double> forces{1., 2., 3., 4., 5.};
  BOOST_TEST(rows.of_contact(0, forces).size() == 2);
  BOOST_TEST(rows.of_contact(1, forces).size() == 0);
  BOOST_TEST(rows.of_contact(2, forces)[1] == 4.);
  const std::vector<unsigned int> active{0, 3, 4};
  BOOST_TEST((rows.local_rows_of(0, active) == std::vector<unsigned int>{0}));
  BOOST_TEST(
    (rows.local_rows_of(2, active) == std::vector<unsigned int>{1, 2}));
}



BOOST_AUTO_TEST_CASE(on_the_same_discretization)
{
  // Each discretization of a contact, made from its geometry again.
  const Bodies bodies = two_strips(2, 2);
  for (const auto kind :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    {
      const auto contact =
        make_interface(pair_of("bottom", "top", kind), bodies);
      const auto again = rows_on(contact, bodies);
      BOOST_REQUIRE(again.size() == contact.rows.size());
      BlockVector u = zero(bodies);
      for (unsigned int b = 0; b < 2; ++b)
        u.block(b) = any_displacement(*bodies[b], b);
      for (unsigned int r = 0; r < again.size(); ++r)
        {
          BOOST_TEST(again[r].gap(u, 1.) == contact.rows[r].gap(u, 1.),
                     boost::test_tools::tolerance(1e-12));
        }
    }
}



BOOST_AUTO_TEST_CASE(on_a_richer_discretization)
{
  // The same forces on cubic fields and other elements: the same resultant and
  // moment, which rigid motions measure.
  const Bodies coarse = two_strips(1, 2), fine = two_strips(3, 5);
  const auto   contact =
    make_interface(pair_of("bottom", "top", Discretization::surface_to_surface),
                   coarse);
  const auto  rows                  = rows_on(contact, fine);
  BlockVector interpolate_to_coarse = zero(coarse),
              interpolate_to_fine   = zero(fine);
  for (unsigned int r = 0; r < rows.size(); ++r)
    {
      const double force = 1. + std::sin(double(r));
      contact.rows[r].add_to(interpolate_to_coarse, force);
      rows[r].add_to(interpolate_to_fine, force);
    }
  BOOST_TEST(interpolate_to_fine.size() > 2 * interpolate_to_coarse.size());
  for (unsigned int b = 0; b < 2; ++b)
    {
      const auto rigid      = coarse[b]->rigid_motions(undisplaced),
                 rigid_fine = fine[b]->rigid_motions(undisplaced);
      double size           = 0.;
      for (unsigned int m = 0; m < 6; ++m)
        size =
          std::max(size, std::abs(rigid[m] * interpolate_to_coarse.block(b)));
      for (unsigned int m = 0; m < 6; ++m)
        BOOST_TEST(std::abs(rigid_fine[m] * interpolate_to_fine.block(b) -
                            rigid[m] * interpolate_to_coarse.block(b)) <
                   1e-12 * size);
    }
}

BOOST_AUTO_TEST_SUITE_END()
