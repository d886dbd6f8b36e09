// SPDX-License-Identifier: LGPL-2.1-or-later

// Beams whose sections turn (GeometricallyExactBeam): strains of a frame, the
// energy and what follows from it, points, rigid turns, and elastic lines by
// exact solutions.

#include "finite_rotation_fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/frame_strains.h>
#include <lamella/body/geometrically_exact_beam.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/shape_change.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/nonlinear_solver.h>

#include <deal.II/physics/transformations.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(rotating_sections)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  template <int n>
  Tensor<1, n>
  random_tensor(const double size, const unsigned int seed)
  {
    const Vector v = random_vector(n, size, seed);
    Tensor<1, n> t;
    for (unsigned int i = 0; i < n; ++i)
      t[i] = v[i];
    return t;
  }

  Tensor<2, 3>
  rotation(const Tensor<1, 3> &theta)
  {
    return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(theta / theta.norm()), theta.norm());
  }

  /// Its functions against central differences of their values and first
  /// derivatives along a random direction.
  template <int n, typename Function>
  void
  check_derivatives(const Function &at, const Tensor<1, n> &z)
  {
    constexpr double   h     = 1e-6;
    const Tensor<1, n> along = random_tensor<n>(1., 11);
    const auto         ahead = at(z + h * along), back = at(z - h * along),
               here = at(z);
    for (unsigned int k = 0; k < here.value.size(); ++k)
      {
        BOOST_TEST(std::abs((ahead.value[k] - back.value[k]) / (2. * h) -
                            here.first[k] * along) < 1e-8);
        BOOST_TEST(
          ((ahead.first[k] - back.first[k]) / (2. * h) - here.second[k] * along)
            .norm() < 1e-7);
        BOOST_TEST((here.second[k] - transpose(here.second[k])).norm() < 1e-14);
      }
  }

  template <int n>
  Quaternion
  quaternion_in(const Tensor<1, n> &z, const unsigned int from)
  {
    Quaternion q;
    for (unsigned int a = 0; a < 4; ++a)
      q[a] = z[from + a];
    return q;
  }

  template <int n>
  Tensor<1, 3>
  vector_in(const Tensor<1, n> &z, const unsigned int from)
  {
    return Tensor<1, 3>({z[from], z[from + 1], z[from + 2]});
  }
} // namespace



BOOST_AUTO_TEST_CASE(rotations_are_those_of_their_vectors)
{
  for (const double angle : {0., 1e-9, 0.3, 2.9, 3.14})
    {
      const Tensor<1, 3> theta =
        angle * Tensor<1, 3>({2. / 3., -1. / 3., 2. / 3.});
      const Quaternion q = quaternion_of(theta);
      BOOST_TEST((rotation_vector_of(q) - theta).norm() <
                 1e-15 + 1e-14 * angle);
      BOOST_TEST((rotation_vector_of(-1. * q) - theta).norm() <
                 1e-15 + 1e-14 * angle);
      if (angle > 0.)
        BOOST_TEST((rotation_of(3. * q) - rotation(theta)).norm() < 1e-14);
    }
  // The rotation b first, then a.
  const Tensor<1, 3> a({0.3, 0.5, -0.2}), b({-0.8, 0.1, 0.4});
  BOOST_TEST(
    (rotation_of(compose_rotations(quaternion_of(a), quaternion_of(b))) -
     rotation(a) * rotation(b))
      .norm() < 1e-14);
}



BOOST_AUTO_TEST_CASE(strains_of_a_frame)
{
  const Tensor<1, 11> z = random_tensor<11>(0.8, 3) + [] {
    Tensor<1, 11> one;
    one[0] = 1.;
    return one;
  }();
  const auto at = [](const Tensor<1, 11> &x) {
    return frame_strains(quaternion_in(x, 0),
                         quaternion_in(x, 4),
                         vector_in(x, 8));
  };
  check_derivatives<11>(at, z);
  // Gamma = R^T (e_y + r') - e_y and R' = R [kappa], with the tilt of fibers.
  const Quaternion   Q = quaternion_in(z, 0), dQ = quaternion_in(z, 4);
  const Tensor<2, 3> R = rotation_of(Q);
  const Tensor<1, 3> e_y({0., 1., 0.});
  Tensor<1, 3>       gamma = transpose(R) * (e_y + vector_in(z, 8)) - e_y;
  gamma[1] += 0.5 * (gamma[0] * gamma[0] + gamma[2] * gamma[2]);
  constexpr double   h = 1e-6;
  const Tensor<2, 3> dR =
    (rotation_of(Q + h * dQ) - rotation_of(Q - h * dQ)) / (2. * h);
  const Tensor<2, 3> kappa = transpose(R) * dR;
  const auto         e     = at(z);
  for (unsigned int c = 0; c < 3; ++c)
    BOOST_TEST(std::abs(e.value[c] - gamma[c]) < 1e-14);
  const double twist = kappa[0][2];
  BOOST_TEST(std::abs(e.value[3] - (kappa[2][1] - twist * gamma[0])) < 1e-9);
  BOOST_TEST(std::abs(e.value[4] - twist) < 1e-9);
  BOOST_TEST(std::abs(e.value[5] - (kappa[1][0] - twist * gamma[2])) < 1e-9);
  BOOST_TEST(std::abs(e.value[6] - twist * twist / 2.) < 1e-9);
  // A quaternion of another length is the same rotation.
  const auto scaled = frame_strains(2. * Q, 2. * dQ, vector_in(z, 8));
  for (unsigned int k = 0; k < e.value.size(); ++k)
    BOOST_TEST(std::abs(scaled.value[k] - e.value[k]) < 1e-14);

  check_derivatives<7>(
    [](const Tensor<1, 7> &x) {
      return rotated_vector(quaternion_in(x, 0), vector_in(x, 4));
    },
    random_tensor<7>(0.7, 5));
}



namespace
{
  /// With Saint-Venant's fields of LE-@p degree.
  template <class Kind>
  std::unique_ptr<Kind>
  saint_venant_beam(std::shared_ptr<const Section> section,
                    std::shared_ptr<const Axis>    axis,
                    const Placement               &placement = {})
  {
    const auto space = std::make_shared<SectionSpace>(
      section, saint_venant_warpings(SaintVenant(*section), Warping(*section)));
    std::vector<unsigned int> list;
    for (unsigned int alpha = 0; alpha < RigidField::n_all; ++alpha)
      list.push_back(alpha);
    for (unsigned int j = 0; j < space->n_modes(); ++j)
      list.push_back(space->first_mode() + j);
    return std::make_unique<Kind>(
      "b",
      space,
      axis,
      placement,
      std::vector<std::vector<unsigned int>>(axis->n_nodes(), list),
      "SV");
  }

  Placement
  oblique_placement()
  {
    return Placement::from_directions(Point<3>(0.4, -0.2, 0.7),
                                      Tensor<1, 3>({0.6, 0.64, 0.48}),
                                      Tensor<1, 3>({-0.2, 0.1, 1.}));
  }

  std::unique_ptr<GeometricallyExactBeam>
  coupled(const Placement &placement = oblique_placement())
  {
    return saint_venant_beam<GeometricallyExactBeam>(
      make_section(rectangle(1., 0.4, {30., -60.}), nine_constants(), 2),
      make_axis(3., 2),
      placement);
  }

  Vector
  forces(const Body &body, const Vector &u)
  {
    Vector f(u.size());
    body.add_internal_forces(u, f);
    return f;
  }

  /// @p u changed by @p h times @p w.
  Vector
  along(const Body &body, const Vector &u, const double h, const Vector &w)
  {
    Vector change = w;
    change *= h;
    return body.retract(u, change);
  }

  /// A state that turns by about a radian.
  Vector
  some_state(const Body &body, const unsigned int seed = 1)
  {
    return body.retract(random_vector(body.n_dofs(), 0.3, seed),
                        random_vector(body.n_dofs(), 0.2, seed + 1));
  }
} // namespace



BOOST_AUTO_TEST_CASE(forces_and_tangent_follow_from_the_energy)
{
  const auto       body = coupled();
  const Vector     u    = some_state(*body);
  constexpr double h    = 1e-5;
  for (const unsigned int seed : {3, 4, 5})
    {
      const Vector w     = random_vector(body->n_dofs(), 1., seed);
      const Vector ahead = along(*body, u, h, w), back = along(*body, u, -h, w);
      const double work = forces(*body, u) * w;
      BOOST_TEST(std::abs((body->deformation(ahead).energy -
                           body->deformation(back).energy) /
                            (2. * h) -
                          work) < 1e-8 * std::abs(work));
      // Along the geodesic of the spins w.
      const double second =
        (forces(*body, ahead) * w - forces(*body, back) * w) / (2. * h);
      Vector Kw(w.size());
      body->add_tangent_forces(u, w, Kw);
      BOOST_TEST(std::abs(Kw * w - second) < 1e-7 * std::abs(second));
    }
}



BOOST_AUTO_TEST_CASE(heat_is_of_the_energy)
{
  const auto body = coupled();
  check_heat(*body, some_state(*body));
}



BOOST_AUTO_TEST_CASE(small_states_are_those_of_the_linear_beam)
{
  // Curvatures and a twist that are constant: what three Gauss points of B4
  // see as well as four. The linear beam has the same energy and forces.
  const auto section =
    make_section(rectangle(1., 0.4, {30., -60.}), nine_constants(), 2);
  const auto axis    = make_axis(3., 2);
  const auto turning = saint_venant_beam<GeometricallyExactBeam>(section, axis),
             other   = saint_venant_beam<GeometricallyExactBeam>(section, axis);
  const auto       linear = saint_venant_beam<Beam>(section, axis);
  const double     h      = section->element().reference_length();
  Vector           u(linear->n_dofs());
  constexpr double size = 1e-6;
  for (unsigned int node = 0; node < axis->n_nodes(); ++node)
    {
      const double   y                     = axis->nodes()[node];
      const DofIndex first                 = linear->dofs().first(node);
      u[first + RigidField::translation_z] = 0.5 * size * y * y;
      u[first + RigidField::slope_z]       = -h * size * y;
      u[first + RigidField::translation_x] = 0.35 * size * y * y;
      u[first + RigidField::slope_x]       = -0.7 * h * size * y;
      u[first + RigidField::rotation_y]    = 0.4 * h * size * y;
      u[first + RigidField::translation_y] = 0.2 * size * y;
      for (unsigned int k = RigidField::n_all;
           k < linear->dofs().fields(node).size();
           ++k)
        u[first + k] = 0.3 * size * (1. + 0.1 * k);
    }
  const double energy = linear->deformation(u).energy;
  BOOST_TEST(std::abs(turning->deformation(u).energy - energy) < 1e-5 * energy);
  Vector expected(u.size()), f(u.size());
  linear->add_internal_forces(u, expected);
  turning->add_tangent_forces(Vector(u.size()), u, f);
  f -= expected;
  BOOST_TEST(f.linfty_norm() < 1e-11 * expected.linfty_norm());
  // Displacements and stresses, too.
  const auto place = linear->locate({Point<3>(0.8, 1.1, 0.05)})[0][0];
  const auto a = linear->sample(place, u), b = turning->sample(place, u);
  BOOST_TEST((a.displacement - b.displacement).norm() <
             1e-5 * a.displacement.norm());
  BOOST_TEST((a.strain - b.strain).norm() < 1e-5 * a.strain.norm());
  BOOST_TEST((a.stress - b.stress).norm() < 1e-5 * a.stress.norm());
}



BOOST_AUTO_TEST_CASE(points_move_with_their_sections)
{
  const auto   body = coupled();
  const Vector u = some_state(*body), w = random_vector(u.size(), 1., 7);
  std::vector<Location>     places;
  std::vector<Tensor<1, 3>> force;
  for (const Point<3> &x : {Point<3>(0.1, 0.7, 0.15), Point<3>(0.9, 2.9, 0.35)})
    {
      places.push_back(body->locate({oblique_placement().to_scene(x)})[0][0]);
      force.push_back(random_tensor<3>(1., 20 + places.size()));
    }
  constexpr double h     = 1e-6;
  const auto       x     = body->displacements(places, u);
  const auto       ahead = body->displacements(places, along(*body, u, h, w)),
             back        = body->displacements(places, along(*body, u, -h, w));
  const auto rows        = body->rows(places, u);
  double     work = 0., second = 0.;
  const auto work_at = [&](const Vector &v) {
    const auto at  = body->rows(places, v);
    double     sum = 0.;
    for (unsigned int k = 0; k < places.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        sum += force[k][c] * at[k][c](w);
    return sum;
  };
  for (unsigned int k = 0; k < places.size(); ++k)
    {
      BOOST_TEST((body->sample(places[k], u).displacement - x[k]).norm() <
                 1e-13);
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double by = (ahead[k][c] - back[k][c]) / (2. * h);
          BOOST_TEST(std::abs(rows[k][c](w) - by) < 1e-8);
        }
    }
  second = (work_at(along(*body, u, h, w)) - work_at(along(*body, u, -h, w))) /
           (2. * h);
  body->for_each_block_of_forces(places,
                                 force,
                                 u,
                                 [&](const StiffnessBlock &block) {
                                   Vector Kw(w.size());
                                   block.add_product(w, Kw);
                                   work += Kw * w;
                                 });
  BOOST_TEST(std::abs(work - second) < 1e-7 * std::abs(second));
  // At rest they are the rows of small displacements.
  const auto unloaded = body->rows(places, Vector(u.size())),
             small    = body->rows(places, undisplaced);
  for (unsigned int k = 0; k < places.size(); ++k)
    for (unsigned int c = 0; c < 3; ++c)
      BOOST_TEST(std::abs(unloaded[k][c](w) - small[k][c](w)) < 1e-12);
}



BOOST_AUTO_TEST_CASE(a_rigid_turn_is_free)
{
  // On top of any state: the energy stays, forces turn, and none work.
  const auto   body   = coupled();
  const Vector u      = some_state(*body);
  const double energy = body->deformation(u).energy;
  Tensor<1, 3> theta({0.5, -0.9, 1.4});
  Vector       turned(u.size()), spin(u.size());
  const auto   motions = body->rigid_motions(u);
  for (const double angle : {0.6, pi / 2., pi, 2. * pi})
    {
      theta *= angle / theta.norm();
      const Tensor<2, 3> R = rotation(theta);
      // Turns of sections, and where their centers go.
      turned = u;
      Vector zero(u.size());
      for (unsigned int c = 0; c < 3; ++c)
        {
          zero = body->rigid_motions(Vector(u.size()))[3 + c];
          zero *= theta[c];
          spin += zero;
        }
      // A state with the same spin of all, its translations replaced.
      turned            = body->retract(u, spin);
      const auto rotate = [&](const Tensor<1, 3> &v) {
        return body->place().vector_to_body(R *
                                            body->place().vector_to_scene(v));
      };
      for (unsigned int node = 0; node < body->axis().n_nodes(); ++node)
        {
          const DofIndex first = body->dofs().first(node);
          Tensor<1, 3>   x({u[first],
                            u[first + 1] + body->axis().nodes()[node],
                            u[first + 2]});
          x = rotate(x);
          x[1] -= body->axis().nodes()[node];
          for (unsigned int c = 0; c < 3; ++c)
            turned[first + c] = x[c];
        }
      BOOST_TEST(std::abs(body->deformation(turned).energy - energy) <
                 1e-13 * energy);
      spin = 0.;
    }
  const Vector f = forces(*body, u);
  for (const Vector &motion : motions)
    BOOST_TEST(std::abs(f * motion) < 1e-12 * f.l1_norm());
}



namespace
{
  /// A cantilever along y, L = 10, h = 10 / @p slenderness, b = 1, E = 1.2e6,
  /// nu = 0, under a force along z at its tip with P L^2 / (E I) = 4; TBT or
  /// SV.
  Structure
  sze(const bool         saint_venant,
      const unsigned int elements,
      const double       slenderness,
      const unsigned int degree = 3)
  {
    const double height   = 10. / slenderness;
    const auto   material = EngineeringConstants::isotropic(1.2e6, 0.);
    const auto   mesh =
      make_section_mesh(rectangle(1., height), {{"material", material}});
    const auto axis = make_axis(10., elements, degree);
    Bodies     bodies;
    Theory     tbt;
    tbt.kind  = Theory::Kind::TBT;
    tbt.order = 1;
    if (saint_venant)
      bodies.push_back(
        saint_venant_beam<GeometricallyExactBeam>(make_section(mesh, 3), axis));
    else
      bodies.push_back(std::make_unique<GeometricallyExactBeam>(
        "b", make_section(mesh, tbt.of_rotating()), axis, Placement()));
    const std::string force = std::to_string(40. * std::pow(height / 0.1, 2));
    return {std::move(bodies),
            {clamp("start")},
            {traction("end", "0", "0", force)}};
  }

  Tensor<1, 3>
  tip(const Structure &structure, const BlockVector &u)
  {
    const Body  &body   = *structure.bodies()[0];
    const double height = body.bounding_box().side_length(2);
    return body
      .sample(body.locate({Point<3>(0.5, 10., height / 2.)})[0][0], u.block(0))
      .displacement;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_cantilever_bends_round)
{
  // Sze, Liu and Lo (2004), and the elastica with E A and G A, by shooting:
  // u = 3.28951, w = 6.70013.
  for (const bool saint_venant : {false, true})
    {
      const Structure structure = sze(saint_venant, 8, 100.);
      NonlinearSolver newton(structure);
      newton.progress = [](const std::string &line) {
        BOOST_TEST_MESSAGE(line);
      };
      const auto         end = newton.advance(newton.unloaded(), 1.);
      const Tensor<1, 3> u   = tip(structure, end.state.u);
      BOOST_TEST_MESSAGE("w " << u[2] << ", u " << u[1] << " in "
                              << end.state.iterations << " iterations");
      BOOST_TEST(std::abs(u[1] + 3.28951) < 4e-5);
      BOOST_TEST(std::abs(u[2] - 6.70013) < 7e-5);
      BOOST_TEST(end.state.iterations <= 8);
    }
}



BOOST_AUTO_TEST_CASE(slender_ones_do_not_lock)
{
  // 6.69965 at L / h = 1e3, 6.69964 from 1e4 on.
  for (const auto &[slenderness, w] : {std::make_pair(1e3, 6.69965),
                                       std::make_pair(1e4, 6.69964),
                                       std::make_pair(1e5, 6.69964)})
    {
      const Structure structure = sze(true, 8, slenderness);
      NonlinearSolver newton(structure);
      const auto      end = newton.advance(newton.unloaded(), 1.);
      BOOST_TEST_MESSAGE("w " << tip(structure, end.state.u)[2] << " in "
                              << end.state.iterations << " iterations");
      BOOST_TEST(std::abs(tip(structure, end.state.u)[2] - w) < 1e-5 * w);
    }
}



BOOST_AUTO_TEST_CASE(what_sections_do_to_their_shape)
{
  const auto stiffening = [](const Laminate &shape, const double nu) {
    const auto section =
      make_section(shape, EngineeringConstants::isotropic(1e3, nu), 3);
    const SaintVenant states(*section);
    return std::make_pair(stiffening_by_shape(states),
                          TwistStretch(states).stiffening());
  };
  // Lamb's strip at small curvatures: nu^2 (k b^2 / h)^2 / 60 of bending and as
  // much of the forces along it at their arms.
  constexpr double nu = 0.25, b = 30., h = 0.8;
  const double     lamb        = 2. * std::pow(nu * b * b / h, 2) / 60.;
  const auto [wide, of_fibers] = stiffening(rectangle(b, h, {0.}, 4), nu);
  BOOST_TEST(std::abs(wide[0] / lamb - 1.) < 0.02);
  // Wagner's: E b^5 t k^3 / 360 beside G b t^3 k / 3.
  const double wagner = 2. * (1. + nu) * std::pow(b, 4) / (120. * h * h);
  BOOST_TEST(std::abs(wide[1] / wagner - 1.) < 0.03);
  BOOST_TEST(std::abs(of_fibers / wagner - 1.) < 0.05);
  // Brazier's tube: M = E I k (1 - 3 alpha^2 / 2), alpha = k R^2 / t (1 -
  // nu^2)^(1/2).
  constexpr double R = 15., t = 0.5;
  const Tube       tube{2. * R + t, 2. * R + t, {{{"material", 0.}, t}}, 16, 1};
  const auto       section = make_section(
    make_section_mesh(tube,
                      {{"material", EngineeringConstants::isotropic(1e3, nu)}}),
    3);
  const double brazier = -1.5 * (1. - nu * nu) * std::pow(R * R / t, 2);
  BOOST_TEST(std::abs(stiffening_by_shape(SaintVenant(*section))[0] / brazier -
                      1.) < 0.03);
}



BOOST_AUTO_TEST_CASE(stretch_by_twist_about_the_torsion_center)
{
  // E (int r^4 - (int r^2)^2 / A) k^3 / 2 beside G J k, r from the torsion
  // center, 3 b^2 / (h + 6 b) behind the web of a channel, thin; b and h those
  // of the middle lines.
  constexpr double t = 2., width = 40., height = 60., nu = 0.3;
  const double     b = width - 0.5 * t, h = height - t;
  const double     e       = 3. * b * b / (h + 6. * b);
  const auto       section = make_section(
    make_section_mesh(
      ThinWalled{
        ShapeKind::channel, width, height, {t}, {t, t}, 1, 6, {"material", 0.}},
      {{"material", EngineeringConstants::isotropic(1e3, nu)}}),
    3);
  constexpr unsigned int n      = 1000;
  double                 second = 0., fourth = 0.;
  const auto             add = [&](const double length, const double square) {
    second += length * t * square;
    fourth += length * t * square * square;
  };
  for (unsigned int k = 0; k < n; ++k)
    {
      const double s = (k + 0.5) / n;
      add(h / n, e * e + std::pow(h * (s - 0.5), 2));
      add(2. * b / n, std::pow(b * s + e, 2) + h * h / 4.);
    }
  const double length = h + 2. * b,
               c      = (fourth - second * second / (length * t)) * (1. + nu) /
                   (length * t * t * t / 3.);
  const SaintVenant states(*section);
  BOOST_TEST(std::abs(TwistStretch(states).stiffening() / c - 1.) < 0.05);
  BOOST_TEST(std::abs(stiffening_by_shape(states)[1] / c - 1.) < 0.05);
}

BOOST_AUTO_TEST_SUITE_END()
