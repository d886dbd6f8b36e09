// SPDX-License-Identifier: LGPL-2.1-or-later

// Every force is the derivative of an energy and every tangent that of a force,
// by central differences about a random state: of all kinds of bodies and
// theories, of rows and samples, of loads, and of all kinds of gap rows. What
// is linear passes to rounding.

#include "contact_fixtures.h"

#include <lamella/adapt/node_fields.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/second_order.h>
#include <lamella/solve/structure.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(derivatives)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double length = 6., width = 2., height = 1.;
  // Of what it is compared with.
  constexpr double rounding = 1e-8;

  SectionMeshes
  meshes()
  {
    Material material =
      EngineeringConstants{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};
    material.expansion = Tensor<1, 3>({1e-3, 3e-2, 2e-2});
    material.density   = 2.;
    return {{"strip",
             make_section_mesh(rectangle(width, height, {30., -45.}, 2),
                               {{"material", material}})}};
  }



  BodyDescription
  description(const std::string &theory,
              const std::string &name   = "beam",
              const Point<3>    &origin = {},
              const unsigned int n      = 3)
  {
    BodyDescription body;
    body.name                 = name;
    body.section              = "strip";
    body.theory               = Theory::parse({"Theory", theory});
    body.theory.section_order = 2;
    body.axis.length          = length;
    body.axis.elements        = {theory.rfind("SV", 0) == 0 ? 12 : n};
    body.placement.origin     = origin;
    return body;
  }



  const std::vector<std::string> theories{"EBBT",
                                          "TBT",
                                          "TE-1",
                                          "TE-3",
                                          "LE-1",
                                          "LE-3",
                                          "SV-4",
                                          "solid-1",
                                          "solid-2"};



  /// One body of @p theory, clamped at its start if it chooses its fields.
  Bodies
  made(const std::string &theory)
  {
    const std::vector<BodyDescription> descriptions{description(theory)};
    Bodies bodies = make_bodies(descriptions, meshes());
    if (has_fields_to_choose(descriptions))
      choose_fields(bodies, descriptions, {clamp("start")}, {}, {});
    return bodies;
  }



  /// K @p d out of the blocks that solvers assemble.
  Vector
  times_stiffness(const Body &body, const Vector &d)
  {
    Vector result(d.size());
    stiffness_terms(body).for_each_block(
      true, [&](const StiffnessBlock &block) {
        for (std::size_t i = 0; i < block.rows.size(); ++i)
          for (std::size_t j = 0; j < block.columns.size(); ++j)
            result[block.rows[i]] +=
              block.values[i * block.columns.size() + j] * d[block.columns[j]];
      });
    return result;
  }



  Vector
  forces(const Body &body, const Vector &u)
  {
    Vector f(u.size());
    body.add_internal_forces(u, f);
    return f;
  }



  /// The central difference of @p f at @p u along @p d.
  template <typename Function>
  auto
  difference(const Function &f, const Vector &u, const Vector &d)
  {
    constexpr double h   = 0.25;
    Vector           low = u, high = u;
    low.add(-h, d);
    high.add(h, d);
    auto result = f(high);
    result -= f(low);
    result *= 1. / (2. * h);
    return result;
  }



  double
  off(Vector a, const Vector &b)
  {
    a -= b;
    return a.l2_norm() / b.l2_norm();
  }
  /// Where a body moves as a whole, every gap opens or closes by its normal:
  /// the derivatives of rows whose weights sum to one, whatever they average.
  void
  opens_with_bodies(const ContactInterface &made, const Bodies &bodies)
  {
    BlockVector u(
      std::vector<dealii::types::global_dof_index>{bodies[0]->n_dofs(),
                                                   bodies[1]->n_dofs()});
    for (const unsigned int body : {0, 1})
      for (unsigned int axis = 0; axis < 3; ++axis)
        {
          u             = 0.;
          u.block(body) = bodies[body]->rigid_motions(undisplaced)[axis];
          for (unsigned int k = 0; k < made.rows.size(); ++k)
            {
              const double along = made.points[k].normal[axis];
              BOOST_TEST(std::abs(made.rows[k].jump(u) -
                                  (body == 1 ? along : -along)) < rounding);
            }
        }
  }
} // namespace

BOOST_AUTO_TEST_CASE(of_energies_and_forces)
{
  for (const std::string &theory : theories)
    BOOST_TEST_CONTEXT(theory)
    {
      const Bodies bodies = made(theory);
      const Body  &body   = *bodies[0];
      const Vector u = any_displacement(body, 1), d = any_displacement(body, 2);
      const double work = forces(body, u) * d;
      const double change =
        difference([&](const Vector &v) { return body.deformation(v).energy; },
                   u,
                   d);
      BOOST_TEST(std::abs(change - work) <
                 rounding * body.deformation(u).energy);
      const Vector of_forces =
        difference([&](const Vector &v) { return forces(body, v); }, u, d);
      BOOST_TEST(off(of_forces, times_stiffness(body, d)) < rounding);
    }
}



BOOST_AUTO_TEST_CASE(of_geometric_forces)
{
  // Those of a quadratic form: symmetric, and linear.
  for (const std::string &theory : theories)
    BOOST_TEST_CONTEXT(theory)
    {
      const Bodies bodies = made(theory);
      const Body  &body   = *bodies[0];
      const auto   state  = body.second_order(any_displacement(body, 1));
      state->solve(any_displacement(body, 4));
      const auto geometric = [&](const Vector &v) {
        Vector f(v.size());
        state->add_geometric_forces(v, f);
        return f;
      };
      const Vector v = any_displacement(body, 2), w = any_displacement(body, 3);
      const Vector of_v = geometric(v), of_w = geometric(w);
      BOOST_TEST(std::abs(of_v * w - of_w * v) <
                 rounding * of_v.l2_norm() * w.l2_norm());
      BOOST_TEST(off(difference(geometric, v, w), of_w) < rounding);
    }
}



BOOST_AUTO_TEST_CASE(of_samples)
{
  for (const std::string &theory : theories)
    BOOST_TEST_CONTEXT(theory)
    {
      Bodies bodies = made(theory);
      // Affine then: stresses have a part that no displacement makes.
      if (theory != "TE-1")
        bodies[0]->heat([](const Point<3> &x) { return 1. + x[0] * x[2]; });
      const Body  &body = *bodies[0];
      const Vector u = any_displacement(body, 1), d = any_displacement(body, 2);
      const Location at   = body.locate({{0.3, 2.2, 0.7}})[0].at(0);
      const auto     rows = [&](const Quantity quantity) {
        return body.rows({at}, undisplaced, quantity)[0];
      };
      const auto check = [&](const Quantity quantity, const auto &entry) {
        const auto all     = rows(quantity);
        double     largest = 0.;
        for (const LinearFunctional &row : all)
          largest = std::max(largest, std::abs(row(d) - row.constant()));
        for (unsigned int c = 0; c < all.size(); ++c)
          {
            const double change = difference(
              [&](const Vector &v) { return entry(body.sample(at, v), c); },
              u,
              d);
            BOOST_TEST(std::abs(change - (all[c](d) - all[c].constant())) <
                       rounding * largest);
            BOOST_TEST(std::abs(entry(body.sample(at, u), c) - all[c](u)) <
                       rounding * largest);
          }
      };
      check(Quantity::displacement,
            [](const FieldSample &s, const unsigned int c) {
              return s.displacement[c];
            });
      check(Quantity::strain, [](const FieldSample &s, const unsigned int c) {
        return s.strain[c];
      });
      check(Quantity::stress, [](const FieldSample &s, const unsigned int c) {
        return s.stress[c];
      });
    }
}



BOOST_AUTO_TEST_CASE(of_loads)
{
  // Dead loads all: what is out of balance changes with the load factor by the
  // load vector, and with displacements by the stiffness alone.
  Load point, line, pressure, couple, total, warm;
  point.on    = {{0, Region::Kind::point, "", {{0.5, 3., 1.}}}};
  point.force = {{"1", "2", "3"}};
  line.on     = {{0, Region::Kind::line, "", {{0., 2., 1.}, {2., 2., 1.}}}};
  line.force  = {{"x", "1", "0"}};
  pressure.on = {{0, Region::Kind::surface, "top", {}}};
  pressure.pressure = "1 + x*y";
  couple.on         = {{0, Region::Kind::surface, "end", {}}};
  couple.couple     = Tensor<1, 3>({1., 2., 3.});
  total.on          = {{0, Region::Kind::surface, "bottom", {}}};
  total.total       = Tensor<1, 3>({3., 1., 2.});
  warm.on           = {{0, Region::Kind::body, "", {}}};
  warm.temperature  = "1 + z";
  for (const std::string theory : {"LE-2", "TE-3", "solid-2"})
    for (const Load &load : {point, line, pressure, couple, total, warm})
      BOOST_TEST_CONTEXT(theory << " load " << &load)
      {
        Bodies            bodies = made(theory);
        std::vector<Load> loads{load};
        distribute_total_forces(loads, bodies);
        const Structure structure(std::move(bodies),
                                  {clamp("start")},
                                  loads,
                                  {},
                                  Tensor<1, 3>({0., 0., -1.}));
        const Body     &body  = *structure.bodies()[0];
        const Vector    d     = any_displacement(body, 2);
        BlockVector     u     = structure.zero();
        u.block(0)            = any_displacement(body, 1);
        const auto unbalanced = [&](const Vector &v, const double t) {
          BlockVector at = u;
          at.block(0)    = v;
          return Vector(structure.residual(at, t).block(0));
        };
        Vector by_factor = unbalanced(u.block(0), 2.);
        by_factor -= unbalanced(u.block(0), 1.);
        BOOST_TEST(off(by_factor, structure.load(1.).block(0)) < 1e-6);
        Vector tangent = times_stiffness(body, d);
        tangent *= -1.;
        BOOST_TEST(
          off(difference([&](const Vector &v) { return unbalanced(v, 1.); },
                         u.block(0),
                         d),
              tangent) < rounding);
        // The work of the load on a displacement is f . d: on rigid motions
        // that of its resultant.
        const Vector shift = body.rigid_motions(undisplaced)[2];
        double       work  = 0.;
        for (const LoadResultant &resultant : structure.load_resultants())
          work += resultant.force[2];
        BOOST_TEST(std::abs(structure.load(1.).block(0) * shift - work) < 1e-6);
      }
}



BOOST_AUTO_TEST_CASE(of_gaps)
{
  const std::vector<BodyDescription> descriptions{
    description("LE-2", "upper", {0., 0., 1.02}, 3),
    description("TE-3", "lower", {}, 4)};
  ContactPair contact;
  contact.name        = "touch";
  contact.first       = {0, Region::Kind::surface, "bottom", {}};
  contact.second      = {1, Region::Kind::surface, "top", {}};
  contact.enforcement = Enforcement::penalty;
  contact.penalty     = {PenaltyKind::per_node, 1.};
  contact.tolerance   = 1.;
  for (const auto discretization : {Discretization::node_to_node,
                                    Discretization::node_to_surface,
                                    Discretization::surface_to_surface})
    for (const bool obstacle : {false, true})
      BOOST_TEST_CONTEXT(name_of(discretization)
                         << (obstacle ? ", obstacle" : ""))
      {
        if (obstacle && discretization == Discretization::node_to_node)
          continue;
        const Bodies bodies    = make_bodies(descriptions, meshes());
        contact.discretization = discretization;
        if (obstacle)
          contact.obstacle = std::make_shared<const Obstacle>(
            Obstacle{"roller",
                     Obstacle::Shape::cylinder,
                     {0., 3., -3.},
                     Tensor<1, 3>({1., 0., 0.}),
                     4.,
                     Tensor<1, 3>({0., 0., 0.1})});
        else
          contact.obstacle = nullptr;
        const ContactInterface made = make_interface(contact, bodies);
        BOOST_REQUIRE(!made.rows.empty());
        BlockVector u(
          std::vector<dealii::types::global_dof_index>{bodies[0]->n_dofs(),
                                                       bodies[1]->n_dofs()});
        BlockVector d = u;
        for (unsigned int b = 0; b < 2; ++b)
          {
            u.block(b) = any_displacement(*bodies[b], b);
            d.block(b) = any_displacement(*bodies[b], b + 2);
          }
        if (!obstacle)
          opens_with_bodies(made, bodies);
        for (const GapConstraint &row : made.rows)
          {
            BlockVector low = u, high = u, force = u;
            low.add(-0.5, d);
            high.add(0.5, d);
            const double change = row.gap(high, 1.) - row.gap(low, 1.);
            BOOST_TEST(std::abs(change - row.jump(d)) < rounding);
            // What the force does to the bodies is the transpose.
            force = 0.;
            row.add_to(force, 2.);
            BOOST_TEST(std::abs(force * d - 2. * change) < rounding);
          }
      }
}

BOOST_AUTO_TEST_SUITE_END()
