// SPDX-License-Identifier: LGPL-2.1-or-later

// Supports and loads as rows: what a set of supports leaves free, redundant and
// contradictory rows, reactions, resultants of loads.

#include "entries.h"
#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/body_solver.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/parameters.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <set>

BOOST_AUTO_TEST_SUITE(conditions)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const EngineeringConstants isotropic =
    EngineeringConstants::isotropic(10., 0.25);

  // Width, height and length of the body of most tests; its center.
  constexpr double  width = 0.2, height = 0.1, length = 2.;
  const Point<3>    center(0.1, 1., 0.05);
  constexpr double  pi         = 3.14159265358979323846;
  const std::string clamp_name = "clamp", other_name = "lift";



  Bodies
  one_beam(const Placement   &placement = Placement(),
           const double       L         = length,
           const unsigned int degree    = 2)
  {
    Bodies bodies;
    bodies.push_back(std::make_unique<Beam>(
      "beam",
      make_section(rectangle(width, height), isotropic, degree),
      make_axis(L, 2),
      placement));
    return bodies;
  }



  /// Three of anything, written {a, b, c}.
  template <typename T>
  struct Three
  {
    Three(const T &x, const T &y, const T &z)
      : values{{x, y, z}}
    {}

    std::array<T, 3> values;
  };

  using Values      = Three<std::optional<double>>;
  using Expressions = Three<Formula>;

  const std::nullopt_t free_ = std::nullopt;

  Support
  at_points(const std::vector<Point<3>> &points,
            const Values                &u    = {0., 0., 0.},
            const std::string           &name = clamp_name)
  {
    return {name, {{0, Region::Kind::point, "", points}}, u.values};
  }



  Support
  on_line(const Point<3>    &a,
          const Point<3>    &b,
          const Values      &u,
          const std::string &name = clamp_name)
  {
    return {name, {{0, Region::Kind::line, "", {a, b}}}, u.values};
  }



  Support
  on_surface(const std::string &surface,
             const Values      &u    = {0., 0., 0.},
             const std::string &name = clamp_name)
  {
    return {name, {{0, Region::Kind::surface, surface, {}}}, u.values};
  }



  std::vector<std::string>
  free_motions(const Bodies &bodies, const std::vector<Support> &supports)
  {
    std::vector<std::string> words;
    for (const FreeMotion &motion : free_rigid_motions(
           *bodies[0], 0, prescribed_functionals(supports, bodies)))
      words.push_back(motion.words);
    return words;
  }



  /// The rigid motions named in @p motions, each once.
  std::set<std::string>
  named(const std::vector<std::string> &motions)
  {
    std::set<std::string> names;
    for (const std::string kind : {"translation along ", "rotation about "})
      for (const char axis : {'x', 'y', 'z'})
        for (const std::string &motion : motions)
          if (motion.find(kind + axis) != std::string::npos)
            names.insert(kind + axis);
    return names;
  }



  using Words = std::set<std::string>;



  RowReduction
  reduction_of(const Bodies                            &bodies,
               const std::vector<PrescribedFunctional> &rows)
  {
    return RowReduction(*bodies[0], 0, rows, {clamp_name, other_name});
  }



  /// Displacements of a supported body under @p load, refined.
  Vector
  solve_loaded(Body &body, const RowReduction &reduction, const Vector &load)
  {
    const auto solver = make_solver(body, reduction.constraints());
    Vector     u      = reduction.particular();
    for (unsigned int k = 0; k < 4; ++k)
      {
        Vector r(body.n_dofs());
        body.add_internal_forces(u, r);
        r.sadd(-1., 1., load);
        reduction.constraints().condense(r);
        reduction.constraints().set_zero(r);
        solver->solve(r);
        reduction.constraints().distribute(r);
        u += r;
      }
    return u;
  }



  /// The sum of forces and their moment about the origin of the scene.
  struct Wrench
  {
    Tensor<1, 3> force, moment;

    void
    add(const Point<3> &x, const Tensor<1, 3> &f)
    {
      force += f;
      moment += cross_product_3d(Tensor<1, 3>(x), f);
    }
  };



  Wrench
  reactions(const RowReduction                      &reduction,
            const Body                              &body,
            const std::vector<PrescribedFunctional> &rows,
            const Vector                            &u,
            const Vector                            &load)
  {
    Vector residual(body.n_dofs());
    body.add_internal_forces(u, residual);
    residual -= load;
    Wrench wrench;
    for (const auto &[row, force] : reduction.multipliers(residual))
      {
        wrench.add(rows[row].position, force * rows[row].direction);
      }
    return wrench;
  }



  /// The resultant of @p f and its moment about the center of the body.
  Wrench
  resultant(const Body &body, const Vector &f)
  {
    const std::vector<Vector> motions = body.rigid_motions(undisplaced);
    Wrench                    wrench;
    for (unsigned int c = 0; c < 3; ++c)
      {
        wrench.force[c]  = f * motions[c];
        wrench.moment[c] = f * motions[3 + c];
      }
    return wrench;
  }



  Load
  force_load(const Region &region, const Expressions &force)
  {
    return {"load", {region}, force.values, ""};
  }



  Wrench
  resultant_of(const Load &load, const Bodies &bodies)
  {
    BlockVector f(1, bodies[0]->n_dofs());
    add_load(load, bodies, f);
    return resultant(*bodies[0], f.block(0));
  }



  void
  check_wrench(const Wrench       &found,
               const Tensor<1, 3> &force,
               const Tensor<1, 3> &moment,
               const double        tolerance = 1e-12)
  {
    BOOST_TEST((found.force - force).norm() <= tolerance,
               "force " << found.force << ", not " << force);
    BOOST_TEST((found.moment - moment).norm() <= tolerance,
               "moment " << found.moment << ", not " << moment);
  }
} // namespace

BOOST_AUTO_TEST_CASE(nothing_held)
{
  const auto free = free_motions(one_beam(), {});
  BOOST_TEST(free.size() == 6);
  BOOST_TEST((named(free) == Words{"translation along x",
                                   "translation along y",
                                   "translation along z",
                                   "rotation about x",
                                   "rotation about y",
                                   "rotation about z"}));
  // Each motion by itself, not a mixture of several.
  for (const std::string &motion : free)
    BOOST_TEST(motion.find(" with ") == std::string::npos, motion);
}



BOOST_AUTO_TEST_CASE(held_at_one_point)
{
  // The three rotations about it; about the center they are pure.
  const auto at_center = free_motions(one_beam(), {at_points({center})});
  BOOST_TEST(at_center.size() == 3);
  BOOST_TEST(
    (named(at_center) ==
     Words{"rotation about x", "rotation about y", "rotation about z"}));

  // At a corner each turn drags translations along, but it is one turn: to be
  // told of all three at once helps nobody.
  const auto at_corner = free_motions(one_beam(), {at_points({Point<3>()})});
  BOOST_TEST(at_corner.size() == 3);
  for (const std::string axis : {"x", "y", "z"})
    {
      unsigned int times = 0;
      for (const std::string &motion : at_corner)
        times += motion.find("rotation about " + axis) != std::string::npos;
      BOOST_TEST(times == 1,
                 "a turn about " << axis << " is in " << times
                                 << " of the three motions");
    }
}



BOOST_AUTO_TEST_CASE(held_along_a_line)
{
  // u_z = 0 on a line across the start: neither up nor about y; it may slide in
  // x and y, spin about z and tilt about the line (that is: about x, with a
  // translation along z, since rotations are about the center).
  const Support line =
    on_line({0., 0., 0.}, {width, 0., 0.}, {free_, free_, 0.});
  const auto tilt = free_motions(one_beam(), {line});
  BOOST_TEST(tilt.size() == 4);
  BOOST_TEST((named(tilt) == Words{"translation along x",
                                   "translation along y",
                                   "translation along z",
                                   "rotation about x",
                                   "rotation about z"}));

  // With the other end as well it cannot tilt.
  const Support other =
    on_line({0., length, 0.}, {width, length, 0.}, {free_, free_, 0.});
  const auto slide = free_motions(one_beam(), {line, other});
  BOOST_TEST(slide.size() == 3);
  BOOST_TEST(
    (named(slide) ==
     Words{"translation along x", "translation along y", "rotation about z"}));

  // A point of the start held in x and y leaves the spin about it, and held in
  // x at the end, too, nothing.
  const Support pin  = at_points({Point<3>()}, {0., 0., free_});
  const auto    spin = free_motions(one_beam(), {line, other, pin});
  BOOST_TEST(spin.size() == 1);
  BOOST_TEST(named(spin).count("rotation about z") == 1);
  BOOST_TEST(named(spin).count("rotation about x") == 0);
  BOOST_TEST(named(spin).count("rotation about y") == 0);
  BOOST_TEST(named(spin).count("translation along z") == 0);
  const Support guide = at_points({{0., length, 0.}}, {0., free_, free_});
  BOOST_TEST(free_motions(one_beam(), {line, other, pin, guide}).empty());
}



BOOST_AUTO_TEST_CASE(held_along_two_points)
{
  // Two pinned points on a line along the axis through the center: a spin about
  // that axis is what is left, purely.
  const auto free =
    free_motions(one_beam(),
                 {at_points({{0.1, 0., 0.05}, {0.1, length, 0.05}})});
  BOOST_TEST_REQUIRE(free.size() == 1);
  BOOST_TEST(free[0] == "rotation about y");
}



BOOST_AUTO_TEST_CASE(names_are_in_scene_axes)
{
  // Along the scene's x, u_z = 0 on the face x = 0, 0 <= y <= 0.2: that holds
  // the roll about x; tilting about y with a translation along z is free.
  const Placement along_x = Placement::from_directions({0., 0., 0.},
                                                       Point<3>(1., 0., 0.),
                                                       Point<3>(0., 0., 1.));
  const auto      free =
    free_motions(one_beam(along_x), {on_surface("start", {free_, free_, 0.})});
  BOOST_TEST(free.size() == 4);
  BOOST_TEST((named(free) == Words{"translation along x",
                                   "translation along y",
                                   "translation along z",
                                   "rotation about y",
                                   "rotation about z"}));
}



BOOST_AUTO_TEST_CASE(a_clamped_end_holds_a_hair)
{
  // L/h = 1e6: the rotations are held by a face of 1e-6 of the length.
  BOOST_TEST(
    free_motions(one_beam(Placement(), 1e5), {on_surface("start")}).empty());
}



BOOST_AUTO_TEST_CASE(rows_of_another_body_do_not_hold)
{
  Bodies bodies = one_beam();
  bodies.push_back(std::move(one_beam()[0]));
  const auto rows = prescribed_functionals({on_surface("start")}, bodies);
  BOOST_TEST(free_rigid_motions(*bodies[0], 0, rows).empty());
  BOOST_TEST(free_rigid_motions(*bodies[1], 1, rows).size() == 6);
  // Nor do they reduce anything there.
  BOOST_TEST(RowReduction(*bodies[1], 1, rows, {clamp_name})
               .constraints()
               .n_constraints() == 0);
}



BOOST_AUTO_TEST_CASE(a_clamped_face_takes_all_fields_of_its_node)
{
  // One L9: 9 nodes of 3 components on the face, all independent: the 27 fields
  // of the first axis node, numbers 0 to 26. Said twice it is the same.
  const Bodies  bodies = one_beam();
  const Support clamp  = on_surface("start");
  for (const std::vector<Support> &supports :
       {std::vector<Support>{clamp}, std::vector<Support>{clamp, clamp}})
    {
      const auto rows      = prescribed_functionals(supports, bodies);
      const auto reduction = reduction_of(bodies, rows);
      BOOST_TEST(rows.size() == 27 * supports.size());
      BOOST_TEST(reduction.constraints().n_constraints() == 27);
      for (DofIndex dof = 0; dof < 27; ++dof)
        BOOST_TEST(reduction.constraints().is_constrained(dof));
      BOOST_TEST(reduction.multipliers(Vector(bodies[0]->n_dofs())).size() ==
                 27);
    }
}



BOOST_AUTO_TEST_CASE(rows_of_a_poor_basis_depend_on_each_other)
{
  // A node with the nine linear fields only: on its face 27 rows of rank nine,
  // on a line across the width u_c = t_c + x s_c, nine rows of rank six.
  const auto section = make_section(rectangle(width, height), isotropic, 2);
  const auto axis    = make_axis(length, 1, 1);
  std::vector<unsigned int> linear(9);
  std::iota(linear.begin(), linear.end(), 0);
  Bodies bodies;
  bodies.push_back(
    std::make_unique<Beam>("poor",
                           section,
                           axis,
                           Placement(),
                           std::vector<std::vector<unsigned int>>(2, linear)));

  for (const auto &[support, n_rows, rank] :
       {std::make_tuple(on_surface("start"), 27u, 9u),
        std::make_tuple(
          on_line({0., 0., height}, {width, 0., height}, {0., 0., 0.}),
          9u,
          6u)})
    {
      // The values of a rigid motion, which no redundancy contradicts.
      auto rows = prescribed_functionals({support}, bodies);
      if (n_rows == 9)
        {
          // Points of the line: the degree of the section or of the axis, two.
          BOOST_TEST(rows.size() == n_rows);
        }
      for (PrescribedFunctional &row : rows)
        {
          const Tensor<1, 3> u =
            Point<3>(0.1, 0.2, 0.3) +
            cross_product_3d(Point<3>(1., -2., 3.), Tensor<1, 3>(row.position));
          row.value = u * row.direction;
        }
      const auto reduction = reduction_of(bodies, rows);
      BOOST_TEST(reduction.constraints().n_constraints() == rank);
      for (const PrescribedFunctional &row : rows)
        BOOST_TEST(std::abs(row.row.row(reduction.particular()) - row.value) <
                   1e-12);
    }
}



BOOST_AUTO_TEST_CASE(every_reduced_displacement_satisfies_the_rows)
{
  // R (G v + u_p) = d for any v, with rows that depend on each other and share
  // DoFs: a face, a line that ends in it, a point on it.
  const Placement tilted = Placement::from_directions({0.3, 0., 0.1},
                                                      Point<3>(1., 2., 0.5),
                                                      Point<3>(0., 0.2, 1.));
  const auto      bodies = one_beam(tilted);
  const auto at = [&tilted](const double x, const double y, const double z) {
    return tilted.to_scene({x, y, z});
  };
  auto rows = prescribed_functionals({on_surface("start"),
                                      on_line(at(0., 0., height),
                                              at(0., length, height),
                                              {0., free_, 0.},
                                              other_name),
                                      at_points({at(0.07, 0., 0.03)})},
                                     bodies);
  // Displacements quadratic in space, which one B4 and one L9 hold.
  for (PrescribedFunctional &row : rows)
    {
      const Point<3> x = tilted.to_body(row.position);
      const Point<3> u(0.2 + x[0] * x[2], 0.1 - x[1] * x[1], 0.3 * x[1] * x[2]);
      row.value = tilted.vector_to_scene(u) * row.direction;
    }
  const auto reduction = reduction_of(bodies, rows);
  Vector     u(bodies[0]->n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + i);
  reduction.constraints().distribute(u);
  u += reduction.particular();
  for (const PrescribedFunctional &row : rows)
    BOOST_TEST(std::abs(row.row.row(u) - row.value) < 1e-11);
  // And G v alone satisfies the rows with zero.
  u -= reduction.particular();
  for (const PrescribedFunctional &row : rows)
    BOOST_TEST(std::abs(row.row.row(u)) < 1e-11);
}



BOOST_AUTO_TEST_CASE(symmetry_of_a_turned_body)
{
  // A beam clamped at both ends under a pressure from below, and a quarter of
  // it with n . u = 0 on its planes of symmetry, both turned in space: the same
  // displacements, and reactions of a quarter.
  const Placement turned = Placement::from_directions({0.3, 0., 0.1},
                                                      Point<3>(1., 2., 0.5),
                                                      Point<3>(0., 0.2, 1.));
  const auto      solve  = [&turned](const double                share,
                               const std::vector<Support> &supports) {
    return solve_linear(
      std::make_unique<Beam>(
        "beam",
        make_section(rectangle(share * width, height), isotropic, 3),
        make_axis(share * length, share < 1. ? 2 : 4),
        turned),
      supports,
      {{"wind", {{0, Region::Kind::surface, "bottom", {}}}, {}, "1"}});
  };
  Support symmetry{"symmetry",
                   {{0, Region::Kind::surface, "end", {}},
                    {0, Region::Kind::surface, "right", {}}},
                   {}};
  symmetry.normal      = 0.;
  const Solved whole   = solve(1., {clamp("ends")});
  const Solved quarter = solve(0.5, {clamp("start"), symmetry});
  const auto   at      = turned.to_scene({0.3 * width, 0.4 * length, height});
  const auto   u = whole.at(at).displacement, v = quarter.at(at).displacement;
  BOOST_TEST(u.norm() > 0.);
  // One cell across the width, or half of it: LE-3 holds both alike but for
  // its interpolation of the edge.
  BOOST_TEST((u - v).norm() < 1e-3 * u.norm());

  const Vector f = quarter.structure->load(1.).block(0);
  Vector       residual(f);
  residual *= -1.;
  quarter.structure->bodies()[0]->add_internal_forces(quarter.state.u.block(0),
                                                      residual);
  double across = 0., up = 0.;
  for (const auto &[row, force] :
       quarter.structure->reduction(0).multipliers(residual))
    {
      const PrescribedFunctional &p = quarter.structure->prescribed()[row];
      if (p.support == 1)
        across += std::abs(force * p.direction * turned.axes[2]);
      else
        up += force * p.direction * turned.axes[2];
    }
  // Planes of symmetry carry nothing along themselves.
  BOOST_TEST(across < 1e-9 * std::abs(up));
  BOOST_TEST(std::abs(up + 0.25 * width * length) <
             1e-8 * 0.25 * width * length);
}



BOOST_AUTO_TEST_CASE(contradictions_are_refused_by_name)
{
  const Bodies  bodies = one_beam();
  const Support clamp  = on_surface("start");
  // Half the height of the clamped face, lifted.
  const Support lift =
    at_points({{0.05, 0., 0.05}}, {free_, free_, 1e-3}, other_name);
  // The two are supports number 0 and 1.
  const auto rows = prescribed_functionals({clamp, lift}, bodies);
  try
    {
      reduction_of(bodies, rows);
      BOOST_ERROR("the contradiction was not found");
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      BOOST_TEST(error.identifier() == "conditions.contradicting-supports");
      BOOST_TEST((message.find("Support " + clamp_name) != std::string::npos ||
                  message.find("Support " + other_name) != std::string::npos));
      BOOST_TEST(message.find("body 'beam'") != std::string::npos);
    }

  // One that agrees is none: the same point, held in place.
  const Support agrees =
    at_points({{0.05, 0., 0.05}}, {free_, free_, 0.}, other_name);
  BOOST_CHECK_NO_THROW(
    reduction_of(bodies, prescribed_functionals({clamp, agrees}, bodies)));
  // Nor one at another place.
  const Support apart =
    at_points({{0.05, 1., 0.05}}, {free_, free_, 1e-3}, other_name);
  BOOST_CHECK_NO_THROW(
    reduction_of(bodies, prescribed_functionals({clamp, apart}, bodies)));
}



BOOST_AUTO_TEST_CASE(reactions_of_a_cantilever)
{
  // A force off the axis at the tip: the clamp answers with -F, and its moment
  // about the origin is -X x F.
  const Point<3>     tip(width, length, 0.);
  const Tensor<1, 3> F = Point<3>(3e-5, -5e-5, 7e-5);
  const Load         load =
    force_load({0, Region::Kind::point, "", {tip}}, {"3e-5", "-5e-5", "7e-5"});
  for (const Placement &placement :
       {Placement(),
        Placement::from_directions({0.3, 0., 0.1},
                                   Point<3>(1., 2., 0.5),
                                   Point<3>(0., 0.2, 1.))})
    for (const unsigned int times : {1, 2})
      {
        const Bodies         bodies = one_beam(placement);
        std::vector<Support> supports(times, on_surface("start"));
        const auto           rows = prescribed_functionals(supports, bodies);
        const auto           reduction = reduction_of(bodies, rows);
        Load                 here      = load;
        const Point<3>       X         = placement.to_scene(tip);
        here.on[0].at                  = {X};
        BlockVector f(1, bodies[0]->n_dofs());
        add_load(here, bodies, f);
        const Vector u = solve_loaded(*bodies[0], reduction, f.block(0));
        const Wrench answer =
          reactions(reduction, *bodies[0], rows, u, f.block(0));
        BOOST_TEST((answer.force + F).norm() < 1e-10 * F.norm());
        BOOST_TEST(
          (answer.moment + cross_product_3d(Tensor<1, 3>(X), F)).norm() <
          1e-10 * F.norm());

        // It bends where the force pulls it, and the clamp stays.
        const auto at = [&](const Point<3> &x) {
          return bodies[0]
            ->sample(bodies[0]->locate({placement.to_scene(x)})[0][0], u)
            .displacement;
        };
        BOOST_TEST(at(tip) * F > 0.);
        BOOST_TEST(at({0.03, 0., 0.08}).norm() < 1e-14);
      }
}



BOOST_AUTO_TEST_CASE(reactions_of_a_prescribed_displacement)
{
  // Held by rows alone, statically determinate: u_z = 0 on a line at the start
  // and u_z = 0.01 on one at the end, two points against sliding. No force is
  // needed to tilt it, so all reactions vanish.
  const Bodies bodies = one_beam();
  const auto   rows   = prescribed_functionals(
    {on_line({0., 0., 0.}, {width, 0., 0.}, {free_, free_, 0.}),
         on_line({0., length, 0.}, {width, length, 0.}, {free_, free_, 0.01}),
         at_points({Point<3>()}, {0., 0., free_}),
         at_points({{0., length, 0.}}, {0., free_, free_})},
    bodies);
  const RowReduction reduction(*bodies[0], 0, rows, {"a", "b", "c", "d"});
  const Vector       no_load(bodies[0]->n_dofs());
  const Vector       u = solve_loaded(*bodies[0], reduction, no_load);
  Vector             residual(bodies[0]->n_dofs());
  bodies[0]->add_internal_forces(u, residual);
  for (const auto &[row, force] : reduction.multipliers(residual))
    BOOST_TEST(std::abs(force) < 1e-12);
  // The middle is lifted by half of it.
  const auto middle = bodies[0]->locate({{0., 1., 0.}})[0][0];
  BOOST_TEST(std::abs(bodies[0]->sample(middle, u).displacement[2] - 0.005) <
             1e-12);
}



BOOST_AUTO_TEST_CASE(line_loads)
{
  // Moments are about the center (0.1, 1, 0.05): r x F with r the way from
  // there, so for F_z alone (r_y F_z, -r_x F_z, 0).
  const Bodies bodies = one_beam();
  const auto   along  = [](const double x, const double z) {
    return Region{0, Region::Kind::line, "", {{x, 0., z}, {x, length, z}}};
  };

  // int -1000 sin(pi y/2) over [0, 2] is -1000 (2/pi) 2 = -4000/pi; symmetric
  // about the middle; at x = 0, that is r_x = -0.1.
  const double F = -4000. / pi;
  check_wrench(resultant_of(force_load(along(0., 0.1),
                                       {"0", "0", "-1000*sin(pi*y/2)"}),
                            bodies),
               Point<3>(0., 0., F),
               Point<3>(0., 0.1 * F, 0.),
               1e-6);

  // int -1000 y = -2000, int -1000 y (y - 1) = -1000 (8/3 - 2) = -2000/3.
  check_wrench(resultant_of(force_load(along(0.1, 0.1), {"0", "0", "-1000*y"}),
                            bodies),
               Point<3>(0., 0., -2000.),
               Point<3>(-2000. / 3., 0., 0.),
               1e-10);

  // Across the width at y = 1.3 (inside an element), F_x = 5 per length and
  // F_y = 30 x: forces (1, 0.6, 0). r = (x - 0.1, 0.3, 0.05): the moment is
  // int (-0.05 F_y, 0.05 F_x, (x - 0.1) F_y - 0.3 F_x)
  // = (-0.03, 0.05, 30 (0.2^3/3 - 0.1 0.2^2/2) - 0.3) = (-0.03, 0.05, -0.28).
  check_wrench(resultant_of(force_load({0,
                                        Region::Kind::line,
                                        "",
                                        {{0., 1.3, 0.1}, {width, 1.3, 0.1}}},
                                       {"5", "30*x", "0"}),
                            bodies),
               Point<3>(1., 0.6, 0.),
               Point<3>(-0.03, 0.05, -0.28));
}



BOOST_AUTO_TEST_CASE(pressure)
{
  const Bodies bodies   = one_beam();
  const auto   pressure = [&bodies](const std::string &surface,
                                  const std::string &value) {
    return resultant_of(
      {"load", {{0, Region::Kind::surface, surface, {}}}, {}, value}, bodies);
  };
  // Against the outward normal: 50 on the top, 0.2 x 2, pushes down with 20.
  check_wrench(pressure("top", "50"), Point<3>(0., 0., -20.), Point<3>());
  check_wrench(pressure("bottom", "50"), Point<3>(0., 0., 20.), Point<3>());
  // The left side, 0.1 x 2, looks to -x.
  check_wrench(pressure("left", "50"), Point<3>(10., 0., 0.), Point<3>());
  check_wrench(pressure("right", "50"), Point<3>(-10., 0., 0.), Point<3>());
  // The ends, 0.2 x 0.1.
  check_wrench(pressure("start", "50"), Point<3>(0., 1., 0.), Point<3>());
  check_wrench(pressure("end", "50"), Point<3>(0., -1., 0.), Point<3>());
  check_wrench(pressure("ends", "50"), Point<3>(), Point<3>());
  // Growing along y: F_z = -0.2 int y = -0.4, about x
  // -0.2 int y (y - 1) = -0.2 2/3.
  check_wrench(pressure("top", "y"),
               Point<3>(0., 0., -0.4),
               Point<3>(-0.4 / 3., 0., 0.));
  // On one half only, by a step at the middle, which is an element's end.
  check_wrench(pressure("top", "if(y > 1, 50, 0)"),
               Point<3>(0., 0., -10.),
               Point<3>(-5., 0., 0.));
}



BOOST_AUTO_TEST_CASE(tractions_and_point_forces)
{
  const Bodies bodies = one_beam();
  // A force per area on the end of 0.02: at r = (0, 1, 0), moment
  // (r_y F_z, 0, -r_y F_x).
  check_wrench(resultant_of(force_load({0, Region::Kind::surface, "end", {}},
                                       {"1", "2", "3"}),
                            bodies),
               Point<3>(0.02, 0.04, 0.06),
               Point<3>(0.06, 0., -0.02));

  // F = (1, 2, 3) at (0.2, 1.5, 0): r = (0.1, 0.5, -0.05), r x F =
  // (0.5 3 + 0.05 2, -0.05 1 - 0.1 3, 0.1 2 - 0.5 1) = (1.6, -0.35, -0.3).
  check_wrench(
    resultant_of(force_load({0, Region::Kind::point, "", {{0.2, 1.5, 0.}}},
                            {"1", "2", "2*y"}),
                 bodies),
    Point<3>(1., 2., 3.),
    Point<3>(1.6, -0.35, -0.3));

  // At two points, and the same on two regions: twice as much.
  const Region at{0, Region::Kind::point, "", {{0., 0., 0.}, {0., 2., 0.}}};
  check_wrench(
    resultant_of({"load", {at, at}, Expressions("0", "0", "1").values, ""},
                 bodies),
    Point<3>(0., 0., 4.),
    Point<3>(0., 0.4, 0.));
}



BOOST_AUTO_TEST_CASE(loads_as_numbers)
{
  // To the last digit, however small; std::to_string() ends at 1e-6.
  for (const double force : {1e-7, 1. / 3., -2.5e300, 0.})
    BOOST_TEST(std::stod(Formula(force).text()) == force);
  BOOST_TEST(std::stod(Formula(3).text()) == 3.);
  BOOST_TEST(Formula().empty());

  const Bodies bodies = one_beam();
  const Region at{0, Region::Kind::point, "", {{0., 0., 0.}}};
  const Wrench found =
    resultant_of({"load", {at}, {{1e-7, "2e-7", 3e-7}}, ""}, bodies);
  check_wrench(
    found,
    Point<3>(1e-7, 2e-7, 3e-7),
    resultant_of(force_load(at, {"1e-7", "2e-7", "3e-7"}), bodies).moment,
    1e-19);
  BOOST_TEST(found.force.norm() > 1e-7);
}



BOOST_AUTO_TEST_CASE(bad_loads)
{
  const Bodies bodies  = one_beam();
  const auto   refused = [&bodies](const Load                     &load,
                                 const std::vector<std::string> &says) {
    BlockVector f(1, bodies[0]->n_dofs());
    try
      {
        add_load(load, bodies, f);
        BOOST_ERROR("not refused: " + says.back());
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &fragment : says)
          BOOST_TEST((message.find(fragment) != std::string::npos),
                     "'" << message << "' does not say '" << fragment << "'");
      }
  };
  const Region tip{0, Region::Kind::point, "", {{0., length, 0.}}};
  for (const std::string expression :
       {"sin(", "q*2", "1 2", "", "3x", "2*/y", "sin(x"})
    refused(force_load(tip, {"0", "0", expression}),
            {"Load load", "'" + expression + "' is not an expression"});
  refused({"load", {{0, Region::Kind::surface, "top", {}}}, {}, "p0"},
          {"Load load/Pressure", "'p0'"});

  refused(force_load({0, Region::Kind::point, "", {{0., 2.1, 0.}}},
                     {"0", "0", "1"}),
          {"(0, 2.1, 0)", "not in body 'beam'", "(0.2, 2, 0.1)"});
  refused(
    force_load({0, Region::Kind::line, "", {{0., 1., 0.1}, {0.3, 1., 0.1}}},
               {"0", "0", "1"}),
    {"(0.3, 1, 0.1)", "not in body 'beam'"});
  refused(force_load({0, Region::Kind::surface, "topp", {}}, {"0", "0", "1"}),
          {"no surface 'topp'", "'top'"});
}



BOOST_AUTO_TEST_CASE(two_expressions_are_not_one)
{
  // A decimal comma makes two numbers of one: no pressure of 5 in silence.
  const Bodies bodies = one_beam();
  BlockVector  f(1, bodies[0]->n_dofs());
  for (const std::string pressure : {"1,5", "y, 2*y"})
    BOOST_CHECK_THROW(
      add_load({"load", {{0, Region::Kind::surface, "top", {}}}, {}, pressure},
               bodies,
               f),
      InputError);
}



BOOST_AUTO_TEST_CASE(places_as_a_scene_says_them)
{
  const std::vector<std::string> bodies{"upper", "lower"};
  const auto read = [&bodies](const std::string &on, const std::string &at) {
    return parse_regions({"Load l/On", on}, {"Load l/At", at}, bodies);
  };
  const auto regions = read("lower: line; upper : ends;", "0,0,1; 2,0,1");
  BOOST_TEST_REQUIRE(regions.size() == 2);
  BOOST_TEST(regions[0].body == 1);
  BOOST_TEST((regions[0].kind == Region::Kind::line));
  BOOST_TEST(regions[0].at.size() == 2);
  BOOST_TEST(regions[1].body == 0);
  BOOST_TEST(regions[1].surface == "ends");
  BOOST_TEST((read("upper: body", "")[0].kind == Region::Kind::body));

  for (const auto &[on, at] : std::vector<std::pair<std::string, std::string>>{
         {"", ""},                             // nowhere
         {"ends", ""},                         // of which body
         {"uper: ends", ""},                   // no such body
         {"upper: point", ""},                 // where
         {"upper: line", "0,0,1"},             // one end only
         {"upper: line", "0,0,1; 0,0,1"},      // no length
         {"upper: line", "0,0,1;1,0,1;2,0,1"}, // three ends
         {"upper: point", "0, 1"},             // two numbers
         {"upper: ends", "0,0,1"},             // nothing that uses At
         {"upper: ends; upper: ends", ""},     // twice
       })
    BOOST_CHECK_THROW(read(on, at), InputError);
}



BOOST_AUTO_TEST_CASE(entries_of_supports_and_loads)
{
  const std::string              name = "a";
  const std::vector<std::string> bodies{"upper", "lower"};
  const auto                     support = [&](Settings settings) {
    settings.emplace_back("On", "lower: ends");
    return parsed<SupportParameters>("Support a", settings, name, bodies);
  };
  const Support all = support({});
  BOOST_TEST(all.name == "a");
  BOOST_TEST(all.on.at(0).body == 1);
  BOOST_TEST((all.u[0] == 0. && all.u[1] == 0. && all.u[2] == 0.));
  const Support some = support({{"u", "free, -1e-3, free"}});
  BOOST_TEST((!some.u[0] && some.u[1] == -1e-3 && !some.u[2]));
  const Support normal = support({{"Normal displacement", "0.5"}});
  BOOST_TEST((normal.normal == 0.5 && !normal.u[0]));

  const auto load = [&](Settings settings) {
    settings.emplace_back("On", "lower: ends");
    return parsed<LoadParameters>("Load a", settings, name, bodies);
  };
  BOOST_TEST(load({{"Force", "0, if(x>1, 2, 0), z"}}).force[1].text() ==
             "if(x>1, 2, 0)");
  BOOST_TEST(load({{"Pressure", "2*x"}}).pressure.text() == "2*x");

  const auto of = [](const std::string &path) {
    return [path](const InputError &error) { return error.path() == path; };
  };
  for (const std::string u : {"0, 0", "0, 0, fixed", "free, free, free"})
    BOOST_CHECK_EXCEPTION(support({{"u", u}}), InputError, of("Support a/u"));
  for (const Settings &bad :
       {Settings{{"Normal displacement", "none"}},
        Settings{{"Normal displacement", "0"}, {"u", "0, 0, 0"}}})
    BOOST_CHECK_EXCEPTION(support(bad),
                          InputError,
                          of("Support a/Normal displacement"));
  BOOST_CHECK_EXCEPTION(load({}), InputError, of("Load a"));
  BOOST_CHECK_EXCEPTION(load({{"Force", "0, 0, 1"}, {"Pressure", "1"}}),
                        InputError,
                        of("Load a"));
  BOOST_CHECK_EXCEPTION(load({{"Force", "0, 1"}}),
                        InputError,
                        of("Load a/Force"));
}



BOOST_AUTO_TEST_CASE(what_regions_cover)
{
  const auto on = [](const std::string &surface) {
    return Region{0, Region::Kind::surface, surface, {}};
  };
  for (const bool at_start : {true, false})
    {
      BOOST_TEST(on("all").covers_end(at_start));
      BOOST_TEST(on("ends").covers_end(at_start));
      BOOST_TEST(on("start").covers_end(at_start) == at_start);
      BOOST_TEST(on("end").covers_end(at_start) != at_start);
      BOOST_TEST(!on("top").covers_end(at_start));
      // Not a surface, whatever else it is.
      BOOST_TEST(!Region({0, Region::Kind::body, "", {}}).covers_end(at_start));
    }
  BOOST_TEST(on("top").covers("top"));
  BOOST_TEST(!on("top").covers("all"));
  BOOST_TEST(!on("ends").covers("top"));
  BOOST_TEST(on("all").covers("top"));
  BOOST_TEST(on("ends").is_several_surfaces());
  BOOST_TEST(on("all").is_several_surfaces());
  BOOST_TEST(!on("start").is_several_surfaces());
}

BOOST_AUTO_TEST_SUITE_END()
