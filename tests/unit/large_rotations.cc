// SPDX-License-Identifier: LGPL-2.1-or-later

// Beams that turn by any angle: the derivative of their forces, rigid turns,
// small loads, and what is known of a cantilever that bends round.

#include "finite_rotation_fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/second_order.h>
#include <lamella/body/total_lagrangian_beam.h>
#include <lamella/body/total_lagrangian_solid.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/material/material.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/nonlinear_solver.h>

#include <deal.II/physics/transformations.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(large_rotations)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const Laminate two_plies = rectangle(1., 0.4, {30., -60.});

  template <class Kind>
  std::unique_ptr<Kind>
  beam(const unsigned int degree)
  {
    return std::make_unique<Kind>("b",
                                  make_section(two_plies,
                                               nine_constants(),
                                               degree),
                                  make_axis(3., 2),
                                  Placement());
  }

  AxisMesh
  two_elements()
  {
    AxisMesh axis;
    axis.length   = 3.;
    axis.elements = {2};
    return axis;
  }

  /// Of hexahedra of degree 2, sheared with a ply each.
  template <class Kind>
  std::unique_ptr<Kind>
  solid()
  {
    return std::make_unique<Kind>(
      "s",
      make_section_mesh(two_plies, {{"material", nine_constants()}}),
      two_elements(),
      Placement(),
      2);
  }

  /// The displacement (@p A - 1) x of @p body.
  Vector
  affine(const Body &body, const Tensor<2, 3> &A)
  {
    const auto moved = [&A](const Point<3> &x) {
      return A * Tensor<1, 3>(x) - Tensor<1, 3>(x);
    };
    if (body.is_nodal())
      {
        Vector u(body.n_dofs());
        for (DofIndex dof = 0; dof < u.size(); ++dof)
          u[dof] = moved(body.dof(dof).position)[dof % 3];
        return u;
      }
    // Surfaces fix all that a beam has.
    const auto         rows = prescribe_on_surface(body, moved);
    const RowReduction reduction(body, 0, rows, {"all"});
    return reduction.particular();
  }

  Vector
  forces(const Body &body, const Vector &u)
  {
    Vector f(u.size());
    body.add_internal_forces(u, f);
    return f;
  }
} // namespace



namespace
{
  void
  check_derivatives(const Body &turning)
  {
    const Body  *body      = &turning;
    const Vector u         = random_vector(body->n_dofs(), 0.2, 1),
                 w         = random_vector(body->n_dofs(), 1., 2);
    constexpr double h     = 1e-5;
    Vector           ahead = u, back = u;
    ahead.add(h, w);
    back.add(-h, w);
    Vector difference = forces(*body, ahead);
    difference -= forces(*body, back);
    difference /= 2. * h;
    Vector derivative(u.size());
    body->add_tangent_forces(u, w, derivative);
    const double size = difference.l2_norm();
    difference -= derivative;
    BOOST_TEST(difference.l2_norm() < 1e-8 * size);

    // The forces are the derivative of the energy.
    const double work =
      (body->deformation(ahead).energy - body->deformation(back).energy) /
      (2. * h);
    BOOST_TEST(std::abs(work - forces(*body, u) * w) <
               1e-7 * std::abs(forces(*body, u) * w));
  }

  /// Forces of a body that turns at small displacements are those of a linear
  /// one.
  void
  check_start(const Body &turning, const Body &with_linear_rotations)
  {
    const Vector w = random_vector(turning.n_dofs(), 1., 3);
    Vector       linear(w.size()), tangent(w.size());
    with_linear_rotations.add_internal_forces(w, linear);
    turning.add_tangent_forces(Vector(w.size()), w, tangent);
    const double size = linear.l2_norm();
    linear -= tangent;
    BOOST_TEST(linear.l2_norm() < 1e-12 * size);
  }

  /// A rigid turn, alone and of a body that is strained.
  void
  check_rigid_rotations(const Body &body)
  {
    // Something stretched and sheared, then turned as well.
    Tensor<2, 3> F({{1.02, 0.01, 0.}, {-0.03, 0.98, 0.02}, {0., 0.05, 1.01}});
    const double energy = body.deformation(affine(body, F)).energy;
    BOOST_TEST(energy > 1e-4);
    const Tensor<1, 3> axis = Tensor<1, 3>({1., 2., -1.}) / std::sqrt(6.);
    for (const double degrees : {37., 90., 180., 360.})
      {
        const Tensor<2, 3> R =
          dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
            Point<3>(axis), degrees * dealii::numbers::PI / 180.);
        const Vector rotation = affine(body, R);
        BOOST_TEST(forces(body, rotation).linfty_norm() < 1e-13);
        BOOST_TEST(std::abs(body.deformation(rotation).energy) < 1e-14);
        BOOST_TEST(std::abs(body.deformation(affine(body, R * F)).energy -
                            energy) < 1e-13);
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(tangent_is_the_derivative_of_the_forces)
{
  check_derivatives(*beam<TotalLagrangianBeam>(2));
  check_derivatives(*solid<TotalLagrangianSolid>());
}



BOOST_AUTO_TEST_CASE(heat_is_of_the_energy)
{
  const auto fields    = beam<TotalLagrangianBeam>(2);
  const auto hexahedra = solid<TotalLagrangianSolid>();
  for (Body *body : {static_cast<Body *>(fields.get()),
                     static_cast<Body *>(hexahedra.get())})
    check_heat(*body, random_vector(body->n_dofs(), 0.2, 1));
}



BOOST_AUTO_TEST_CASE(undeformed_it_is_the_linear_stiffness)
{
  check_start(*beam<TotalLagrangianBeam>(2), *beam<Beam>(2));
  check_start(*solid<TotalLagrangianSolid>(), *solid<Solid>());
}



BOOST_AUTO_TEST_CASE(a_solid_of_incompatible_modes_does_not_turn)
{
  BOOST_CHECK_THROW(
    TotalLagrangianSolid("s",
                         make_section_mesh(two_plies,
                                           {{"material", nine_constants()}}),
                         two_elements(),
                         Placement(),
                         1),
    InputError);
}



BOOST_AUTO_TEST_CASE(a_rigid_turn_is_free_and_leaves_the_energy)
{
  check_rigid_rotations(*beam<TotalLagrangianBeam>(1));
  check_rigid_rotations(*solid<TotalLagrangianSolid>());
}



BOOST_AUTO_TEST_CASE(stresses_turn_with_the_material)
{
  // Cauchy's stress of a stretched block in axes that turn with it: R^T sigma
  // R with sigma = F S F^T / det F is that of the stretch alone, and U S U /
  // det U of a stretch without shear has S_ii U_i^2 / det U.
  const auto   body = beam<TotalLagrangianBeam>(1);
  Tensor<2, 3> U;
  U[0][0]          = 1.02;
  U[1][1]          = 0.97;
  U[2][2]          = 1.01;
  const auto place = body->locate({Point<3>(0.3, 1.2, 0.1)})[0][0];
  const auto still = body->sample(place, affine(*body, U));
  for (unsigned int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(still.strain[i] - 0.5 * (U[i][i] * U[i][i] - 1.)) <
               1e-14);
  const Voigt second =
    body->section()
      .law(place.places[0].cell % body->section().n_cells(), Point<2>(0.3, 0.1))
      .stress(still.strain);
  for (unsigned int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(still.stress[i] - second[i] * U[i][i] * U[i][i] /
                                            dealii::determinant(U)) < 1e-13);
  for (const double degrees : {37., 90., 170.})
    {
      const Tensor<2, 3> R =
        dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
          Point<3>(Tensor<1, 3>({2., -1., 2.}) / 3.),
          degrees * dealii::numbers::PI / 180.);
      const auto turned = body->sample(place, affine(*body, R * U));
      BOOST_TEST((turned.stress - still.stress).norm() < 1e-12);
      BOOST_TEST((turned.ply_stress - still.ply_stress).norm() < 1e-12);
      BOOST_TEST(std::abs(body->deformation(affine(*body, R * U)).max_rotation -
                          degrees * dealii::numbers::PI / 180.) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(geometric_stiffness_is_objective)
{
  // A rotation by t about e_a moves x by t W_a x + t^2 W_a W_a x / 2 + ... and
  // leaves the energy of a stress as it is. Its terms of the second order are
  //   (W_a x) . K_G (W_b x) + f . (W_a W_b + W_b W_a) x / 2 = 0
  // with the internal forces f of that stress.
  std::vector<std::unique_ptr<Body>> bodies;
  for (const unsigned int degree : {1, 2, 3})
    bodies.push_back(beam<Beam>(degree));
  bodies.push_back(solid<Solid>());
  const auto spin = [](const unsigned int c) {
    Tensor<2, 3> W;
    W[(c + 2) % 3][(c + 1) % 3] = 1.;
    W[(c + 1) % 3][(c + 2) % 3] = -1.;
    return W;
  };
  const auto moved = [](const Body &body, const Tensor<2, 3> &W) {
    return affine(body, Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) + W);
  };
  for (const auto &body : bodies)
    BOOST_TEST_CONTEXT(body->theory())
    {
      const Vector w     = random_vector(body->n_dofs(), 0.2, 7);
      const auto   state = body->second_order(Vector(w.size()));
      state->solve(w);
      const Vector f = forces(*body, w);
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = a; b < 3; ++b)
          {
            Vector geometric(w.size());
            state->add_geometric_forces(moved(*body, spin(b)), geometric);
            const double quadratic = geometric * moved(*body, spin(a)),
                         linear = 0.5 * (f * moved(*body, spin(a) * spin(b)) +
                                         f * moved(*body, spin(b) * spin(a)));
            BOOST_TEST(std::abs(quadratic + linear) < 1e-12 * f.l1_norm());
            if (a == b)
              BOOST_TEST(std::abs(quadratic) > 1e-6 * f.l1_norm());
          }
    }
}



BOOST_AUTO_TEST_CASE(moments_are_about_where_the_body_is)
{
  // e_m x (X + u - c) is how a turn about c moves the body that has moved.
  const auto   body = beam<TotalLagrangianBeam>(2);
  const Vector u    = random_vector(body->n_dofs(), 0.2, 4);
  const auto   places =
    body->locate({Point<3>(0.1, 0.7, 0.15), Point<3>(0.9, 2.9, 0.35)});
  const auto at = [&](const Vector &v, const unsigned int k) {
    return body->sample(places[k][0], v).displacement;
  };
  const auto motions = body->rigid_motions(u);
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int c = 0; c < 3; ++c)
      {
        Tensor<1, 3> axis;
        axis[c] = 1.;
        const Tensor<1, 3> arm =
          places[k][0].position + at(u, k) - body->center();
        BOOST_TEST((at(motions[c], k) - axis).norm() < 1e-13);
        BOOST_TEST(
          (at(motions[3 + c], k) - cross_product_3d(axis, arm)).norm() < 1e-13);
      }
  // Internal forces have neither force nor moment there.
  const Vector f = forces(*body, u);
  for (const Vector &motion : motions)
    BOOST_TEST(std::abs(f * motion) < 1e-12 * f.l1_norm());
}



namespace
{
  /// A cantilever along y, L = 10, h = 0.1, b = 1, E = 1.2e6, nu = 0, under a
  /// force along z at its tip that bends it with P L^2 / (E I) = 4.
  Structure
  sze(const std::string &kind, const unsigned int elements)
  {
    std::vector<std::unique_ptr<Body>> bodies;
    const auto                         section =
      make_section(rectangle(1., 0.1),
                   EngineeringConstants::isotropic(1.2e6, 0.),
                   2);
    const auto axis = make_axis(10., elements);
    if (kind == "large")
      bodies.push_back(std::make_unique<TotalLagrangianBeam>(
        "strip", section, axis, Placement()));
    else
      bodies.push_back(
        std::make_unique<Beam>("strip", section, axis, Placement()));
    return {std::move(bodies),
            {clamp("start")},
            {traction("end", "0", "0", "40")}};
  }

  Tensor<1, 3>
  tip(const Structure &structure, const BlockVector &u)
  {
    const Body &body = *structure.bodies()[0];
    return body
      .sample(body.locate({Point<3>(0.5, 10., 0.05)})[0][0], u.block(0))
      .displacement;
  }
} // namespace



namespace
{
  Load
  load_vector_on(const std::string &surface)
  {
    Load   load;
    Region region;
    region.kind    = Region::Kind::surface;
    region.surface = surface;
    load.name      = "l";
    load.on        = {region};
    return load;
  }

  Vector
  forces(const FollowerLoad &load, const Vector &u)
  {
    Vector f(u.size());
    load.add_forces(1., u, f);
    return f;
  }

  Vector
  stiffness_times(const FollowerLoad &load, const Vector &u, const Vector &w)
  {
    Vector f(u.size());
    load.for_each_stiffness_block(
      1., u, true, [&](const StiffnessBlock &block) {
        const unsigned int n = block.rows.size();
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            f[block.rows[i]] += block.values[i * n + j] * w[block.columns[j]];
      });
    return f;
  }

  /// By how much v K w is off half of -(v df/du w + w df/du v), over its
  /// size.
  double
  off_derivative(const FollowerLoad &load,
                 const Vector       &u,
                 const Vector       &v,
                 const Vector       &w)
  {
    const auto work = [&](const Vector &along, const Vector &of) {
      constexpr double h     = 1e-5;
      Vector           ahead = u, back = u;
      ahead.add(h, along);
      back.add(-h, along);
      return (forces(load, ahead) * of - forces(load, back) * of) / (2. * h);
    };
    const double expected = -0.5 * (work(w, v) + work(v, w));
    // The whole of it, too.
    Vector whole(u.size());
    load.add_derivative(1., u, w, whole);
    BOOST_TEST(std::abs(whole * v - work(w, v)) < 1e-6 * std::abs(work(w, v)));
    return std::abs(v * stiffness_times(load, u, w) - expected) /
           std::abs(expected);
  }
} // namespace



BOOST_AUTO_TEST_CASE(loads_that_turn_along_have_their_derivatives)
{
  const auto   body    = beam<TotalLagrangianBeam>(2);
  const Vector u       = random_vector(body->n_dofs(), 0.1, 5),
               v       = random_vector(body->n_dofs(), 1., 6),
               w       = random_vector(body->n_dofs(), 1., 7);
  Load couple          = load_vector_on("end");
  couple.couple        = Tensor<1, 3>({0.3, -0.7, 0.5});
  Load pressure        = load_vector_on("top");
  pressure.pressure    = 0.6;
  pressure.is_follower = true;
  Load varying         = pressure;
  varying.pressure     = "1 + 0.5 * y";
  for (const Load &load : {couple, pressure, varying})
    {
      const auto turning = follower_load(load, load.on.front(), *body);
      BOOST_TEST(off_derivative(*turning, u, v, w) < 1e-6);
      // At the start they are the dead ones.
      Vector start = forces(*turning, Vector(u.size())), dead_load(u.size());
      add_point_forces(*body,
                       point_forces(load, load.on.front(), *body),
                       dead_load);
      start -= dead_load;
      BOOST_TEST(start.l2_norm() < 1e-12 * dead_load.l2_norm());
    }
}



BOOST_AUTO_TEST_CASE(loads_that_turn_along_keep_what_they_promise)
{
  const auto         body = beam<TotalLagrangianBeam>(2);
  const Tensor<1, 3> axis({0.6, 0., 0.8});
  const Tensor<2, 3> R =
    dealii::Physics::Transformations::Rotations::rotation_matrix_3d(axis, 2.1);
  // Stretched by 1.2 across x, 1.1 along y, and turned.
  Tensor<2, 3> F;
  F[0][0]              = 1.2;
  F[1][1]              = 1.1;
  F[2][2]              = 0.9;
  F                    = R * F;
  const Vector u       = affine(*body, F);
  const auto   motions = body->rigid_motions(u);

  // A couple has no force, and its moment whatever has turned.
  Load couple    = load_vector_on("end");
  couple.couple  = Tensor<1, 3>({0.3, -0.7, 0.5});
  const Vector f = forces(*follower_load(couple, couple.on.front(), *body), u);
  for (unsigned int c = 0; c < 3; ++c)
    {
      BOOST_TEST(std::abs(f * motions[c]) < 1e-12);
      BOOST_TEST(f * motions[3 + c] == (*couple.couple)[c],
                 boost::test_tools::tolerance(1e-11));
    }

  // A pressure presses the area that there is, along the normal that it has:
  // 1 x 3 became 1.2 x 3.3.
  Load pressure        = load_vector_on("top");
  pressure.pressure    = 0.6;
  pressure.is_follower = true;
  const Vector p =
    forces(*follower_load(pressure, pressure.on.front(), *body), u);
  const Tensor<1, 3> force =
    -0.6 * 1.2 * 3.3 * (R * Tensor<1, 3>({0., 0., 1.}));
  for (unsigned int c = 0; c < 3; ++c)
    BOOST_TEST(std::abs(p * motions[c] - force[c]) < 1e-12);
}



BOOST_AUTO_TEST_CASE(a_pressure_that_follows_is_smooth)
{
  const auto body  = beam<TotalLagrangianBeam>(1);
  Load       load  = load_vector_on("top");
  load.pressure    = "if(y < 1.1, 1, 0)";
  load.is_follower = true;
  BOOST_CHECK_EXCEPTION(follower_load(load, load.on.front(), *body),
                        InputError,
                        [](const InputError &error) {
                          return error.path() == "Load l/Pressure";
                        });
}



BOOST_AUTO_TEST_CASE(a_cantilever_bends_round)
{
  // The elastica: 3.2894 and 6.6996; with stretch and shear 3.28951
  // and 6.70013, and 3.29000, 6.70033 by Green's strain. (The case of Sze,
  // Liu and Lo, Finite Elem. Anal. Des. 40, 2004.)
  const Structure    structure = sze("large", 16);
  NonlinearSolver    newton(structure);
  const Equilibrium  whole      = newton.advance(newton.unloaded(), 1.);
  const unsigned int iterations = whole.state.iterations;
  BOOST_TEST_MESSAGE("one step: " << iterations << " iterations, left "
                                  << whole.residual << ", w "
                                  << std::setprecision(8)
                                  << tip(structure, whole.state.u)[2]);
  BOOST_TEST(whole.cuts == 0u);
  BOOST_TEST(iterations <= 10u);
  BOOST_TEST(std::abs(-tip(structure, whole.state.u)[1] / 3.29 - 1.) < 3e-4);
  BOOST_TEST(std::abs(tip(structure, whole.state.u)[2] / 6.70033 - 1.) < 1e-4);

  // Half of the load: the elastica, u 1.6064, w 4.9346 (Mattiasson, Int. J.
  // Numer. Meth. Engng 17, 1981).
  const Equilibrium half = newton.advance(newton.unloaded(), 0.5);
  BOOST_TEST(std::abs(-tip(structure, half.state.u)[1] / 1.6064 - 1.) < 3e-4);
  BOOST_TEST(std::abs(tip(structure, half.state.u)[2] / 4.9346 - 1.) < 3e-4);
  // No path: on from there it is the same state.
  const Equilibrium on = newton.advance(half, 1.);
  BOOST_TEST(
    (tip(structure, on.state.u) - tip(structure, whole.state.u)).norm() < 1e-8);
}



BOOST_AUTO_TEST_CASE(it_comes_back_unloaded)
{
  // And a step that is too large is halved until it is not.
  const Structure     structure = sze("large", 4);
  NonlinearParameters few;
  few.max_iterations = 4;
  NonlinearSolver   newton(structure, SolverKind::automatic, few);
  const Equilibrium bent = newton.advance(newton.unloaded(), 1.),
                    back = NonlinearSolver(structure).advance(bent, 0.);
  BOOST_TEST(bent.cuts > 0u);
  BOOST_TEST(bent.factor.of_scene() == 1.);
  BOOST_TEST(std::abs(tip(structure, bent.state.u)[2] / 6.70033 - 1.) < 0.01);
  BOOST_TEST(tip(structure, back.state.u).norm() < 1e-8);
  few.max_bisections = 0;
  BOOST_CHECK_THROW(NonlinearSolver(structure, SolverKind::automatic, few)
                      .advance(newton.unloaded(), 1.),
                    NumericsError);
}



BOOST_AUTO_TEST_CASE(a_mirror_image_is_no_result)
{
  // It has no strain, no stress and a positive definite tangent.
  Tensor<2, 3> mirror(dealii::unit_symmetric_tensor<3>());
  mirror[2][2] = -1.;
  for (const bool is_solid : {false, true})
    {
      Bodies bodies;
      if (is_solid)
        bodies.push_back(solid<TotalLagrangianSolid>());
      else
        bodies.push_back(beam<TotalLagrangianBeam>(2));
      const Structure structure(std::move(bodies), {clamp("bottom")}, {});
      NonlinearSolver newton(structure);
      Equilibrium     at = newton.unloaded();
      BOOST_CHECK_NO_THROW(newton.advance(at, 1.));
      at.state.u.block(0) = affine(*structure.bodies()[0], mirror);
      BOOST_CHECK_EXCEPTION(
        newton.advance(at, 1.), NumericsError, [](const NumericsError &error) {
          return std::string(error.what()).find("solve.inverted-element") !=
                 std::string::npos;
        });
    }
}



BOOST_AUTO_TEST_CASE(small_loads_are_the_linear_answer)
{
  const Structure   large = sze("large", 8), linear = sze("linear", 8);
  NonlinearSolver   newton(large);
  const double      factor = 1e-7;
  const Equilibrium state  = newton.advance(newton.unloaded(), factor);
  const std::vector<GapConstraint> no_rows;
  const GapConstraints             none(no_rows);
  LinearSystem                     solver(linearized(linear), none);
  const State                      exact = solver.solve_free(factor);
  BOOST_TEST(std::abs(tip(large, state.state.u)[2] / tip(linear, exact.u)[2] -
                      1.) < 1e-8);
}



namespace
{
  /// A strip of 2 m between clamps with elements that grow from 2 mm at the
  /// clamps and at the middle, 8 in each quarter.
  std::shared_ptr<const Axis>
  graded_axis()
  {
    std::vector<double> quarter{0.};
    double              h = 0.002;
    for (unsigned int k = 0; k < 8; ++k, h *= std::pow(250., 1. / 7.))
      quarter.push_back(quarter.back() + h);
    AxisMesh mesh;
    mesh.length = 2.;
    mesh.degree = 3;
    for (double &y : quarter)
      y *= 0.5 / quarter.back();
    std::vector<double> ends = quarter;
    for (unsigned int k = 7; k-- > 0;)
      ends.push_back(1. - quarter[k]);
    for (unsigned int k = ends.size() - 1; k-- > 0;)
      ends.push_back(2. - ends[k]);
    mesh.breaks.assign(ends.begin() + 1, ends.end() - 1);
    mesh.elements.assign(ends.size() - 1, 1);
    return std::make_shared<Axis>(mesh);
  }

  /// The upper strip of Sec. 4.2, alone, pressed by @p way at its middle.
  Structure
  contact_strip(const bool large, const double way)
  {
    const auto carbon =
      library_material("IM7-8552", Units::parse({"Units", "m, N"}));
    const auto section =
      make_section(rectangle(0.1, 0.003, {0., 90., 0.}), carbon, 2);
    std::vector<std::unique_ptr<Body>> bodies;
    if (large)
      bodies.push_back(std::make_unique<TotalLagrangianBeam>(
        "strip", section, graded_axis(), Placement()));
    else
      bodies.push_back(
        std::make_unique<Beam>("strip", section, graded_axis(), Placement()));
    const Support press{"press",
                        {{0,
                          Region::Kind::line,
                          "",
                          {Point<3>(0., 1., 0.003), Point<3>(0.1, 1., 0.003)}}},
                        {{{}, {}, -way}}};
    return {std::move(bodies), {clamp("start"), clamp("end"), press}, {}};
  }

  /// What presses it.
  double
  force_of(const Structure &structure, const BlockVector &u)
  {
    double sum = 0.;
    for (const auto &[row, multiplier] : structure.reduction(0).multipliers(
           structure.internal_forces(u).block(0)))
      if (structure.prescribed()[row].support == 2)
        sum -= multiplier * structure.prescribed()[row].direction[2];
    return sum;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_strip_between_clamps_is_stretched)
{
  // Pressed by 75 and 150 mm: 15.15 and 116.9 kN by C3D20R with NLGEOM.
  // Linear theory says 129 N at 150 mm.
  const Structure   structure = contact_strip(true, 0.15);
  NonlinearSolver   newton(structure);
  const Equilibrium half = newton.advance(newton.unloaded(), 0.5),
                    full = newton.advance(half, 1.);
  BOOST_TEST_MESSAGE(std::setprecision(6)
                     << "75 mm: " << force_of(structure, half.state.u) << " N, "
                     << half.state.iterations << " iterations, " << half.cuts
                     << " cuts; 150 mm: " << force_of(structure, full.state.u)
                     << " N, " << full.state.iterations << " iterations, "
                     << full.cuts << " cuts");
  BOOST_TEST(std::abs(force_of(structure, half.state.u) / 15.15e3 - 1.) < 0.01);
  BOOST_TEST(std::abs(force_of(structure, full.state.u) / 116.9e3 - 1.) < 0.01);
}



BOOST_AUTO_TEST_CASE(the_stiffening_number_is_what_large_deflections_do)
{
  // r of the linear answer is by how much it underestimates the force, to the
  // order of r^2.
  for (const double way : {1e-4, 3e-4})
    {
      const Structure large = contact_strip(true, way),
                      small = contact_strip(false, way);
      NonlinearSolver                  newton(large);
      const std::vector<GapConstraint> no_rows;
      const GapConstraints             none(no_rows);
      LinearSystem                     solver(linearized(small), none);
      const State                      state = solver.solve_free(1.);
      const double                     energy =
        small.bodies()[0]->deformation(state.u.block(0)).energy;
      const double r = beyond_linear(small, solver, state, {energy}).stiffening;
      const double more =
        force_of(large, newton.advance(newton.unloaded(), 1.).state.u) /
          force_of(small, state.u) -
        1.;
      BOOST_TEST_MESSAGE("pressed by " << way << ": r " << r
                                       << ", force more by " << more);
      BOOST_TEST(std::abs(more / r - 1.) < 2e-3 + r);
    }
}

BOOST_AUTO_TEST_SUITE_END()
