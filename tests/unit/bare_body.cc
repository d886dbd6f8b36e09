// SPDX-License-Identifier: LGPL-2.1-or-later

// What Body makes of the few functions that each kind of body has to write is
// what beams and solids, which have shorter ways, say themselves.

#include "bare_body.h"
#include "solid_fixtures.h"

#include <lamella/body/fields.h>
#include <lamella/body/parameters.h>
#include <lamella/body/surface_topology.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(bare_body)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// A turned strip of two plies, the theory's own body and the bare one, with
  /// a displacement that is smooth nowhere.
  struct Twins
  {
    explicit Twins(const std::string &theory, const double warmth = 0.)
      : bodies(made(theory))
      , given(*bodies[0])
      , bare(given)
      , u(given.n_dofs())
    {
      std::mt19937 generator(1);
      for (double &x : u)
        x = std::uniform_real_distribution<double>(-1., 1.)(generator);
      given.kinematic_constraints().distribute(u);
      if (warmth != 0.)
        for (Body *const body : {bodies[0].get(), static_cast<Body *>(&bare)})
          body->heat([warmth](const Point<3> &) { return warmth; });
    }

    static Bodies
    made(const std::string &theory)
    {
      Material material  = orthotropic;
      material.expansion = Tensor<1, 3>({1e-3, 3e-2, 2e-2});
      material.density   = 2.5;
      BodyDescription body;
      body.name          = "strip";
      body.section       = "strip";
      body.theory        = Theory::parse({"Theory", theory});
      body.axis.length   = 6.;
      body.axis.elements = {3u};
      body.axis.degree   = 3;
      body.placement     = tilted;
      return make_bodies({body},
                         {{"strip",
                           make_section_mesh(rectangle(2., 1., {30., -45.}, 2),
                                             {{"material", material}})}});
    }

    Bodies      bodies;
    const Body &given;
    BareBody    bare;
    Vector      u;
  };

  const std::vector<std::string> theories{"LE-2", "TE-2", "solid-1", "solid-2"};

  /// How far @p a is from @p b, relative to it.
  template <typename Values>
  double
  difference(const Values &a, const Values &b)
  {
    Values d = a;
    d -= b;
    return d.norm() / (1. + b.norm());
  }

  double
  difference(const Vector &a, const Vector &b)
  {
    Vector d = a;
    d -= b;
    return d.linfty_norm() / (1. + b.linfty_norm());
  }

  double
  difference(const FieldSample &a, const FieldSample &b)
  {
    return std::max({difference(a.strain, b.strain),
                     difference(a.stress, b.stress),
                     difference(a.ply_stress, b.ply_stress),
                     std::abs(a.jump - b.jump)});
  }

  double
  difference(const double a, const double b)
  {
    return std::abs(a - b) / (1. + std::abs(b));
  }

  double
  difference(const OutputCell &a, const OutputCell &b)
  {
    BOOST_REQUIRE(a.samples.size() == b.samples.size());
    BOOST_TEST(a.ply == b.ply);
    double worst = std::max(difference(a.fiber, b.fiber),
                            difference(a.ply_normal, b.ply_normal));
    for (unsigned int k = 0; k < a.samples.size(); ++k)
      worst = std::max({worst,
                        a.positions[k].distance(b.positions[k]),
                        difference(a.samples[k], b.samples[k])});
    return worst;
  }

  /// Whether each of @p these is at one of @p those.
  template <typename Points>
  bool
  are_among(const Points &these, const Points &those)
  {
    return std::all_of(these.begin(), these.end(), [&](const auto &a) {
      return std::any_of(those.begin(), those.end(), [&](const auto &b) {
        return a.position.distance(b.position) < 1e-9;
      });
    });
  }
} // namespace

BOOST_AUTO_TEST_CASE(samples_are_those_of_rows)
{
  for (const std::string &theory : theories)
    {
      const Twins twins(theory, 3.);
      const auto  found = twins.given.locate(
        {tilted.to_scene({1., 2., 0.7}), tilted.to_scene({0.3, 2.5, 0.5})});
      for (const auto &locations : found)
        for (const Location &where : locations)
          {
            const FieldSample a = twins.bare.sample(where, twins.u),
                              b = twins.given.sample(where, twins.u);
            BOOST_TEST(difference(a, b) < 1e-11);
            BOOST_TEST(difference(a.displacement, b.displacement) < 1e-12);
          }
    }
}



BOOST_AUTO_TEST_CASE(integrals_over_the_volume)
{
  for (const std::string &theory : theories)
    BOOST_TEST_CONTEXT(theory)
    {
      const Twins    twins(theory, 2.);
      Vector         mine(twins.u.size()), due(twins.u.size());
      const Point<3> g(1., -2., 3.);
      twins.bare.add_weight(g, mine);
      twins.given.add_weight(g, due);
      BOOST_TEST(difference(mine, due) < 1e-12);
      mine = due = 0.;
      BOOST_TEST(difference(twins.bare.add_thermal_load(undisplaced, mine),
                            twins.given.add_thermal_load(undisplaced, due)) <
                 1e-11);
      BOOST_TEST(due.l2_norm() > 0.);
      BOOST_TEST(difference(mine, due) < 1e-11);

      const Deformation a = twins.bare.deformation(twins.u),
                        b = twins.given.deformation(twins.u);
      BOOST_TEST(difference(a.energy, b.energy) < 1e-11);
      BOOST_TEST(difference(a.max_rotation, b.max_rotation) < 1e-11);
    }
}



BOOST_AUTO_TEST_CASE(points_of_surfaces_and_of_the_body)
{
  for (const std::string theory : {"LE-2", "solid-1", "solid-2"})
    for (const std::string surface : {"left", "top", "end"})
      BOOST_TEST_CONTEXT(theory << ", " << surface)
      {
        const Twins twins(theory);
        const auto  a = twins.bare.surface_points(surface),
                   b  = twins.given.surface_points(surface);
        BOOST_TEST(a.size() == b.size());
        BOOST_TEST(are_among(a, b));
        for (const SurfacePoint &p : a)
          for (const SurfacePoint &q : b)
            if (p.position.distance(q.position) < 1e-9)
              {
                BOOST_TEST(std::abs(p.area - q.area) < 1e-12);
                BOOST_TEST(difference(p.normal, q.normal) < 1e-12);
                BOOST_TEST(p.corner == q.corner);
              }
        const auto fixed = twins.bare.constraint_points(surface),
                   due   = twins.given.constraint_points(surface);
        BOOST_TEST(fixed.size() == due.size());
        BOOST_TEST(are_among(fixed, due));
        BOOST_TEST(surface_facets(twins.bare, surface).size() ==
                   surface_facets(twins.given, surface).size());
        const auto mine = twins.bare.body_points(),
                   all  = twins.given.body_points();
        BOOST_TEST(are_among(mine, all));
        BOOST_TEST(are_among(all, mine));
      }
}



BOOST_AUTO_TEST_CASE(lines_through_elements)
{
  const Point<3> a = tilted.to_scene({0.2, 0.1, 0.3}),
                 b = tilted.to_scene({1.8, 5.3, 0.9}),
                 c = tilted.to_scene({0.2, 5.9, 0.3});
  for (const std::string theory : {"LE-2", "solid-2"})
    for (const Point<3> &end : {b, c})
      {
        const Twins twins(theory);
        const auto  mine = twins.bare.line_breaks(a, end),
                   due   = twins.given.line_breaks(a, end);
        BOOST_REQUIRE(mine.size() == due.size());
        BOOST_TEST(mine.size() > 3u);
        for (unsigned int k = 0; k < mine.size(); ++k)
          BOOST_TEST(std::abs(mine[k] - due[k]) < 1e-9);
        BOOST_TEST(twins.bare.line_degree(a, end) ==
                   twins.given.line_degree(a, end));
      }
}



BOOST_AUTO_TEST_CASE(cuts_and_pictures)
{
  for (const std::string &theory : theories)
    for (const double position : {0., 1.3, 2., 6., 7.})
      BOOST_TEST_CONTEXT(theory << " at " << position)
      {
        const Twins twins(theory);
        const auto  mine = twins.bare.cut(position, 2, twins.u),
                   due   = twins.given.cut(position, 2, twins.u);
        BOOST_REQUIRE(mine.size() == due.size());
        BOOST_TEST(mine.empty() == (position > 6.));
        for (unsigned int k = 0; k < mine.size(); ++k)
          BOOST_TEST(difference(mine[k], due[k]) < 1e-9);
        const auto drawn = output_cells(twins.bare, 2, twins.u),
                   all   = output_cells(twins.given, 2, twins.u);
        BOOST_REQUIRE(drawn.size() == all.size());
        for (unsigned int k = 0; k < all.size(); ++k)
          BOOST_TEST(difference(drawn[k], all[k]) < 1e-9);
      }
}



BOOST_AUTO_TEST_CASE(boxes_and_levels)
{
  const Twins twins("solid-2");
  BOOST_TEST(twins.bare.center().distance(twins.given.center()) < 1e-12);
  BOOST_TEST(twins.bare.size() > 0.5 * twins.given.size());
  BOOST_TEST(twins.bare.dof(0).level == 0u);
  BOOST_TEST(twins.bare.kinematic_constraints().n_constraints() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
