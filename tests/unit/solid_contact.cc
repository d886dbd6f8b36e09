// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact of solids with beams and with each other: the patch test, also
// through hanging nodes. Blocks as in contact_patch.cc, closed exactly:
// p = (d - g_0) E / (h_1 + h_2), a uniform uniaxial stress.

#include "contact_fixtures.h"
#include "solid_fixtures.h"

#include <lamella/body/fields.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/nonlinear_solver.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(solid_contact)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double E = 200., nu = 0.3, upper_height = 0.7, lower_height = 0.5,
                   gap = 0.01, moved = 0.03;
  constexpr double p = (moved - gap) * E / (upper_height + lower_height);

  const auto material = EngineeringConstants::isotropic(E, nu);

  std::unique_ptr<Body>
  solid_block(const std::string     &name,
              const double           height,
              const unsigned int     cells,
              const unsigned int     elements,
              const Placement       &placement,
              const unsigned int     degree,
              const SolidRefinement &refinement)
  {
    return std::make_unique<Solid>(
      name,
      make_section_mesh(rectangle(2., height, {0.}, cells),
                        {{"material", material}}),
      axis_mesh(3., elements),
      placement,
      degree,
      refinement);
  }

  /// The largest relative error of stress, and of a row's force over its area.
  std::array<double, 2>
  errors(Bodies bodies, const SlaveSide slave_side, const Placement &placement)
  {
    ContactPair contact =
      pair_of("bottom", "top", Discretization::surface_to_surface);
    contact.slave_side  = slave_side;
    contact.enforcement = Enforcement::exact;
    const std::vector<ContactInterface> contacts{
      make_interface(contact, bodies)};
    Structure    structure(std::move(bodies), walls_and_press(moved), {});
    const auto  &rows = contacts[0].rows;
    LinearSystem system(linearized(structure), rows);
    const State  state  = NonlinearSolver(system).solve(1.).state;
    const Checks checks = check_state(
      system.tangent(), contacts, walls_and_press(moved).size(), state, 1.);
    BOOST_TEST(checks.force_balance < 1e-9);
    BOOST_TEST((checks.contacts[0].force + 6. * p * placement.axes[2]).norm() <
               1e-9 * p);

    std::array<double, 2> worst{{0., 0.}};
    for (const unsigned int b : {0, 1})
      for (const OutputCell &cell :
           output_cells(*structure.bodies()[b], 2, state.u.block(b)))
        for (const FieldSample &sample : cell.samples)
          worst[0] = std::max({worst[0],
                               std::abs(sample.ply_stress[2] / -p - 1.),
                               std::abs(sample.ply_stress.norm() / p - 1.)});
    for (unsigned int k = 0; k < rows.size(); ++k)
      worst[1] =
        std::max(worst[1],
                 std::abs(state.force[k] / (contacts[0].points[k].area * p) -
                          1.));
    return worst;
  }
} // namespace

BOOST_AUTO_TEST_CASE(patch)
{
  const Placement placement =
    Placement::from_directions({0.2, -0.1, 0.4},
                               Point<3>(1., 2., 0.5),
                               Point<3>(-0.3, 0.2, 1.));
  Placement above = placement;
  above.origin    = placement.to_scene({0., 0., lower_height + gap});
  // Hanging nodes in the contact: a quarter of the face is divided.
  const SolidRefinement none, divided{0, {{{0., 0., lower_height}, 0.8, 1}}};
  for (const unsigned int degree : {1, 2})
    for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
      for (const bool beam_above : {true, false})
        for (const SolidRefinement &refinement : {none, divided})
          {
            Bodies bodies;
            bodies.push_back(
              beam_above ?
                make_beam("upper",
                          rectangle(2., upper_height, {0.}, 3),
                          layer_wise(2),
                          3.,
                          2,
                          above,
                          material) :
                solid_block("upper", upper_height, 3, 2, above, degree, none));
            bodies.push_back(solid_block(
              "lower", lower_height, 2, 3, placement, degree, refinement));
            const auto [stress, force] =
              errors(std::move(bodies), slave_side, placement);
            BOOST_TEST(stress < 1e-9);
            BOOST_TEST(force < 1e-9);
          }
}

BOOST_AUTO_TEST_SUITE_END()
