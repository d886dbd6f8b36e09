// SPDX-License-Identifier: LGPL-2.1-or-later

// What touches a beam as its section sees it, the fields that its nodes get for
// it, and axes that grade themselves.

#include "fixtures.h"

#include <lamella/adapt/graded_axis.h>
#include <lamella/adapt/node_fields.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

#include <numeric>

using namespace lamella;
using dealii::Point;

namespace
{
  const EngineeringConstants
                   orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};
  constexpr double length = 20., width = 2., height = 1.;

  SectionMeshes
  meshes()
  {
    return {{"strip",
             make_section_mesh(rectangle(width, height, {0., 90., 0.}, 4),
                               {{"material", orthotropic}})}};
  }



  /// A beam of @p theory with 24 elements.
  BodyDescription
  description(const std::string &theory, const unsigned int section_order = 2)
  {
    BodyDescription body;
    body.name                 = "beam";
    body.section              = "strip";
    body.theory               = Theory::parse({"Theory", theory});
    body.theory.section_order = section_order;
    body.axis.length          = length;
    body.axis.elements        = {24};
    return body;
  }



  Support
  clamp()
  {
    return {"clamps", {{0, Region::Kind::surface, "ends", {}}}, {{0., 0., 0.}}};
  }



  /// A patch of pressure on the top, from y = 10 to 11.
  Load
  patch()
  {
    return {"patch",
            {{0, Region::Kind::surface, "top", {}}},
            {},
            "if((y > 10) && (y < 11), 1, 0)"};
  }



  Bodies
  chosen(const BodyDescription      &body,
         const std::vector<Support> &supports,
         const std::vector<Load>    &loads)
  {
    Bodies bodies = make_bodies({body}, meshes());
    choose_fields(bodies, {body}, supports, loads, {});
    return bodies;
  }



  const Beam &
  beam_of(const Bodies &bodies, const unsigned int number = 0)
  {
    return dynamic_cast<const Beam &>(*bodies[number]);
  }



  unsigned int
  fields_at(const Beam &beam, const double y)
  {
    for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
      if (beam.axis().nodes()[node] > y - 1e-9)
        return beam.dofs().fields(node).size();
    return 0;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(adapt)

BOOST_AUTO_TEST_CASE(touches_are_load_vectors_of_the_section)
{
  const Bodies  bodies = make_bodies({description("SV-6")}, meshes());
  const Beam   &beam   = beam_of(bodies);
  const Support point{"point",
                      {{0, Region::Kind::point, "", {{1., 5., 0.}}}},
                      {{0., {}, 0.}}};
  const auto    touches =
    find_touches(beam, 0, bodies, {clamp(), point}, {patch()}, {});
  // The clamps at both ends are two.
  BOOST_REQUIRE(touches.size() == 4);
  for (const unsigned int k : {0, 1})
    {
      BOOST_TEST(touches[k].holds_section);
      BOOST_TEST(touches[k].begin == (k == 0 ? 0. : length));
      BOOST_TEST(touches[k].end == touches[k].begin);
      BOOST_TEST(std::abs(touches[k].element - length / 24.) < 1e-12);
    }
  BOOST_TEST(touches[2].name == "support point");
  BOOST_TEST(touches[2].loads.size() == 2);
  BOOST_TEST(std::abs(touches[2].begin - 5.) < 1e-12);
  // The pressure is the same at all x: one vector, on the elements from 10 to
  // 11.67.
  BOOST_TEST(touches[3].loads.size() == 1);
  BOOST_TEST(std::abs(touches[3].begin - 10.) < 1e-12);
  BOOST_TEST(std::abs(touches[3].end - 35. / 3.) < 1e-12);
  // Its work on a translation along z is its resultant per work of the vector
  // on itself: of all fields only those of z have a part in it.
  const Vector &f = touches[3].loads[0];
  BOOST_TEST(std::abs(f[RigidField::translation_x]) < 1e-12);
  BOOST_TEST(std::abs(f[RigidField::translation_z]) > 0.1);
}



BOOST_AUTO_TEST_CASE(elements_with_probes_are_rich_as_a_whole)
{
  // The patch reaches 2 H beyond the elements it is on, from 10 to 11.67: up to
  // y = 13.67, within the element from 13.33 to 14.17.
  const auto fields = [](const std::vector<Probe> &probes) {
    const BodyDescription body   = description("SV-6");
    Bodies                bodies = make_bodies({body}, meshes());
    choose_fields(bodies,
                  {body},
                  {clamp()},
                  {patch()},
                  {},
                  stress_places(bodies, probes, {}, {}));
    const Beam               &beam = beam_of(bodies);
    std::vector<unsigned int> sizes;
    for (const unsigned int node : beam.axis().nodes_of_cell(16))
      sizes.push_back(beam.dofs().fields(node).size());
    sizes.push_back(fields_at(beam, 14.5));
    return sizes;
  };
  Probe probe;
  probe.name         = "edge";
  probe.position     = Point<3>(0.5, 14., 0.1);
  const auto without = fields({}), with = fields({probe});
  BOOST_TEST(without[0] > without[1]);
  for (unsigned int i = 0; i < 4; ++i)
    BOOST_TEST(with[i] == without[0]);
  BOOST_TEST(with[4] == without[4]);
}



BOOST_AUTO_TEST_CASE(energies_are_nested)
{
  // Under one load the energy grows with the space: SV in SV-6, SV-6 in
  // all fields of the section; SV-6 is within a ten thousandth of these.
  const auto energy = [](const std::string &theory) {
    Bodies bodies = chosen(description(theory), {clamp()}, {patch()});
    return solve_linear(std::move(bodies[0]), {clamp()}, {patch()})
      .strain_energy();
  };
  const double sv = energy("SV"), six = energy("SV-6"), all = energy("LE-2");
  BOOST_TEST_MESSAGE("energies short of LE-2's by " << 1. - sv / all << " and "
                                                    << 1. - six / all);
  BOOST_TEST(sv < six);
  BOOST_TEST(six < all * (1. + 1e-10));
  BOOST_TEST(six > 0.9999 * all);
  BOOST_TEST(sv < 0.999 * all);
}



BOOST_AUTO_TEST_CASE(responses_stay_near_what_they_answer)
{
  const Bodies sv = chosen(description("SV"), {clamp()}, {patch()});
  for (unsigned int node = 0; node < beam_of(sv).axis().n_nodes(); ++node)
    BOOST_TEST(beam_of(sv).dofs().fields(node).size() == 12);

  const Bodies       six  = chosen(description("SV-6"), {clamp()}, {patch()});
  const Beam        &beam = beam_of(six);
  const unsigned int near = fields_at(beam, 10.5), far = fields_at(beam, 5.),
                     held = fields_at(beam, 0.);
  BOOST_TEST_MESSAGE("fields near, far, at the clamp " << near << " " << far
                                                       << " " << held);
  BOOST_TEST(near > far);
  BOOST_TEST(held > far);
  BOOST_TEST(far > 12);
  BOOST_TEST(fields_at(beam, 13.4) == near);
  BOOST_TEST(fields_at(beam, 14.6) == far);
  // The deflection, and the stress below the load, against all fields.
  const auto solve = [&](const std::string &theory) {
    Bodies bodies = chosen(description(theory), {clamp()}, {patch()});
    return solve_linear(std::move(bodies[0]), {clamp()}, {patch()});
  };
  const Solved   reduced = solve("SV-6"), full = solve("LE-2");
  const Point<3> below(1., 10.5, 0.2);
  const double   scale = full.at(below).stress.norm();
  BOOST_TEST(std::abs(reduced.at(below).displacement[2] /
                        full.at(below).displacement[2] -
                      1.) < 1e-3);
  BOOST_TEST((reduced.at(below).stress - full.at(below).stress).norm() <
             5e-3 * scale);
}



BOOST_AUTO_TEST_CASE(bodies_that_are_touched_alike_share_fields)
{
  std::vector<BodyDescription> two(2, description("SV-4"));
  two[1].name      = "other";
  two[1].placement = Placement::from_directions(Point<3>(0., 0., 5.),
                                                Point<3>(0., 1., 0.),
                                                Point<3>(0., 0., 1.));
  Support both     = clamp();
  both.on.push_back(both.on[0]);
  both.on[1].body = 1;
  Bodies bodies   = make_bodies(two, meshes());
  choose_fields(bodies, two, {both}, {}, {});
  BOOST_TEST(&beam_of(bodies, 0).fields() == &beam_of(bodies, 1).fields());
  for (unsigned int node = 0; node < beam_of(bodies).axis().n_nodes(); ++node)
    BOOST_TEST(beam_of(bodies, 0).dofs().fields(node) ==
                 beam_of(bodies, 1).dofs().fields(node),
               boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(compact_bodies_keep_all_fields)
{
  BodyDescription body = description("SV-6");
  body.axis.elements   = {4};
  Bodies     bodies    = make_bodies({body}, meshes());
  const auto notes = choose_fields(bodies, {body}, {clamp()}, {patch()}, {});
  BOOST_TEST(notes.size() == 1);
  BOOST_TEST(notes[0].find("its axis has 13 nodes only") != std::string::npos);
  BOOST_TEST(beam_of(bodies).n_dofs() ==
             13 * beam_of(bodies).section().n_fields());
}



BOOST_AUTO_TEST_CASE(theories_by_hand)
{
  BodyDescription body = description("SV");
  body.pieces.theories = {Theory::parse({"Theories", "LE-2"}),
                          Theory::parse({"Theories", "SV"})};
  for (Theory &theory : body.pieces.theories)
    theory.section_order = 2;
  body.pieces.breaks = {length / 2.};
  body.theory        = body.pieces.leading();
  BOOST_TEST((body.theory.kind == Theory::Kind::SV));
  const Bodies bodies = chosen(body, {clamp()}, {patch()});
  const Beam  &beam   = beam_of(bodies);
  for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
    BOOST_TEST(beam.dofs().fields(node).size() ==
               (beam.axis().nodes()[node] < length / 2. + 1e-9 ?
                  beam.section().n_fields() :
                  12));
}



BOOST_AUTO_TEST_CASE(axes_grade_themselves)
{
  // Elements as short as the places say, which grow by less than the ratio
  // that doubles them, and none longer than a quarter of the axis.
  const std::vector<double> breaks =
    graded_breaks(100., {{0., 0.5}, {30., 0.25}});
  std::vector<double> ends{0.};
  ends.insert(ends.end(), breaks.begin(), breaks.end());
  ends.push_back(100.);
  BOOST_TEST((std::find(ends.begin(), ends.end(), 30.) != ends.end()));
  for (unsigned int k = 1; k + 1 < ends.size(); ++k)
    {
      const double left = ends[k] - ends[k - 1], right = ends[k + 1] - ends[k];
      BOOST_TEST(left > 0.);
      BOOST_TEST(left < 25. * (1. + 1e-9));
      BOOST_TEST(std::max(left, right) < 2.1 * std::min(left, right));
      if (ends[k] == 30.)
        {
          BOOST_TEST(left < 0.35);
          BOOST_TEST(right < 0.35);
        }
    }
  BOOST_TEST(ends[1] < 0.7);
  BOOST_TEST(ends[1] > 0.35);
  BOOST_TEST(ends.size() < 40);
  // Without places a quarter of the length each.
  BOOST_TEST(graded_breaks(100., {}).size() == 3);
}



BOOST_AUTO_TEST_CASE(axes_are_graded_to_what_touches)
{
  std::vector<BodyDescription> bodies{description("SV-6")};
  bodies[0].axis.elements = {};
  bodies[0].axis.fineness = 1.;
  // A cylinder above the beam that touches at y = 7.3.
  const auto roller = std::make_shared<Obstacle>();
  roller->name      = "roller";
  roller->shape     = Obstacle::Shape::cylinder;
  roller->point     = Point<3>(0., 7.3, 1.5);
  roller->direction = scene_axis(0);
  roller->radius    = 0.5;
  ContactPair contact;
  contact.name           = "press";
  contact.first          = {0, Region::Kind::surface, "top", {}};
  contact.obstacle       = roller;
  contact.discretisation = Discretisation::surface_to_surface;
  contact.enforcement    = Enforcement::exact;
  contact.penalty        = {PenaltyKind::automatic, 1e6};
  grade_axes(bodies, meshes(), {clamp()}, {}, {contact});
  const auto &breaks = bodies[0].axis.breaks;
  BOOST_TEST(bodies[0].axis.elements.size() == breaks.size() + 1);
  double nearest = length;
  for (const double y : breaks)
    nearest = std::min(nearest, std::abs(y - 7.3));
  BOOST_TEST(nearest < 0.01 * height);
  BOOST_TEST(breaks.front() < 0.18 * height);
  BOOST_TEST(breaks.front() > 0.08 * height);
  BOOST_TEST(length - breaks.back() < 0.18 * height);
  // Twice as fine.
  const std::size_t coarse = breaks.size();
  bodies[0].axis.fineness  = 2.;
  bodies[0].axis.breaks    = {};
  grade_axes(bodies, meshes(), {clamp()}, {}, {contact});
  BOOST_TEST(bodies[0].axis.breaks.front() < 0.09 * height);
  BOOST_TEST(bodies[0].axis.breaks.size() > coarse);
}

BOOST_AUTO_TEST_SUITE_END()
