// SPDX-License-Identifier: LGPL-2.1-or-later

// What touches a beam as its section sees it, the fields that its nodes get for
// it, and axes that grade themselves.

#include "fixtures.h"

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/adapt/graded_axis.h>
#include <lamella/adapt/node_fields.h>
#include <lamella/body/body_solver.h>
#include <lamella/section/warping.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

#include <map>
#include <numeric>

BOOST_AUTO_TEST_SUITE(adapt)

using namespace lamella;
using dealii::Point;

namespace
{
  const EngineeringConstants
                   orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};
  constexpr double length = 20., width = 2., height = 1.;

  SectionMeshes
  meshes(const unsigned int across = 4)
  {
    Material material  = orthotropic;
    material.expansion = dealii::Tensor<1, 3>({0., 3e-5, 3e-5});
    const auto made    = [&](const std::vector<double> &layup) {
      return make_section_mesh(rectangle(width, height, layup, across),
                               {{"material", material}});
    };
    return {{"strip", made({0., 90., 0.})},
            {"coupled", made({45., -45., 0.})},
            {"plain", made({0.})}};
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
         const std::vector<Load>    &loads,
         const FieldRules           &rules = {})
  {
    Bodies bodies = make_bodies({body}, meshes());
    choose_fields(bodies, {body}, supports, loads, {}, {}, rules);
    return bodies;
  }



  /// Where tractions of the warpings stand in for them.
  FieldRules
  without_boundary_layer_modes()
  {
    BoundaryLayerRules ends;
    ends.max_dofs = 0.;
    FieldRules rules;
    rules.ends = std::make_shared<BoundaryLayerModes>(ends);
    return rules;
  }



  /// An axis of B4 that is graded to both of its ends.
  BodyDescription
  graded(const std::string &theory, const std::string &section)
  {
    BodyDescription body = description(theory);
    body.section         = section;
    body.axis.breaks =
      graded_breaks(length, {{0., 0.15 * height}, {length, 0.15 * height}});
    body.axis.elements.assign(body.axis.breaks.size() + 1, 1);
    return body;
  }



  /// Of a short beam of the section @p name what end fields are made of.
  struct End
  {
    explicit End(const std::string &name, const std::string &theory = "LE-2")
      : bodies(make_bodies({graded(theory, name)}, meshes()))
      , beam(dynamic_cast<const Beam &>(*bodies[0]))
      , section(beam.fields().shared_section())
      , states(*section)
      , warping(*section)
      , warpings(saint_venant_warpings(states, warping))
    {}

    /// The sections that @p supports hold, at the start and at the end.
    std::vector<ConstrainedSection>
    held(const std::vector<Support> &supports) const
    {
      const auto interactions =
        find_interactions(beam, 0, bodies, supports, {}, {});
      std::vector<ConstrainedSection> result;
      for (unsigned int t = 0; t < interactions.size(); ++t)
        for (const ConstrainedSection &one :
             constrained_sections(interactions, t, beam.axis()))
          result.push_back(one);
      return result;
    }

    std::vector<BoundaryLayerZone>
    zones(const ConstrainedSection &held) const
    {
      return boundary_layer_modes(section, states, warping, warpings, held);
    }

    Bodies                         bodies;
    const Beam                    &beam;
    std::shared_ptr<const Section> section;
    SaintVenant                    states;
    Warping                        warping;
    FieldColumns                   warpings;
  };



  /// The columns of all of @p zones.
  FieldColumns
  fields_of(const std::vector<BoundaryLayerZone> &zones)
  {
    FieldColumns fields;
    for (const BoundaryLayerZone &zone : zones)
      fields = beside(fields, zone.fields);
    return fields;
  }



  /// The largest entry of a^T M b, M the metric of @p warping.
  double
  largest_product(const Warping      &warping,
                  const FieldColumns &a,
                  const FieldColumns &b)
  {
    FieldColumns product(a.n(), b.n());
    a.Tmmult(product, warping.metric(b));
    return product.linfty_norm() / std::max(a.n(), b.n());
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

BOOST_AUTO_TEST_CASE(heated_ends)
{
  const auto heat_of = [](const End &end, const double across) {
    end.bodies[0]->heat(
      [=](const Point<3> &x) { return 1. + across * x[0] * x[0]; });
    return HeatedSection(end.states,
                         end.beam.section_thermal_load(0.5 * length));
  };
  // What is left of a section that would expand freely is nothing.
  const End strip("strip", "LE-2"), coupled("coupled", "LE-2");
  for (const End *end : {&strip, &coupled})
    {
      const HeatedSection heat = heat_of(*end, 0.3);
      BOOST_TEST(heat.traction.linfty_norm() > 0.);
      // No section force: none on rigid fields.
      for (unsigned int a = 0; a < 6; ++a)
        BOOST_TEST(std::abs(heat.traction[a]) <
                   1e-10 * heat.traction.linfty_norm());
    }
  const End plain("plain", "LE-2");
  BOOST_TEST(heat_of(plain, 0.).traction.linfty_norm() == 0.);
  BOOST_TEST(heat_of(plain, 0.3).traction.linfty_norm() > 0.);

  // Two ends that nothing holds, one that a support does.
  const auto interactions = find_interactions(
    strip.beam,
    0,
    strip.bodies,
    {{"clamp", {{0, Region::Kind::surface, "start", {}}}, {{0., 0., 0.}}}},
    {},
    {});
  const auto free = heated_free_ends(strip.beam, interactions);
  BOOST_REQUIRE(free.size() == 1);
  BOOST_TEST(free[0].begin == length);
  BOOST_TEST(heated_free_ends(strip.beam, {}).size() == 2);
}



BOOST_AUTO_TEST_CASE(touches_are_load_vectors_of_the_section)
{
  const Bodies  bodies = make_bodies({description("SV-6")}, meshes());
  const Beam   &beam   = beam_of(bodies);
  const Support point{"point",
                      {{0, Region::Kind::point, "", {{1., 5., 0.}}}},
                      {{0., {}, 0.}}};
  const auto    interactions =
    find_interactions(beam, 0, bodies, {clamp(), point}, {patch()}, {});
  // The clamps at both ends are two.
  BOOST_REQUIRE(interactions.size() == 4);
  for (const unsigned int k : {0, 1})
    {
      BOOST_TEST(interactions[k].constrains_section);
      BOOST_TEST(interactions[k].begin == (k == 0 ? 0. : length));
      BOOST_TEST(interactions[k].end == interactions[k].begin);
      BOOST_TEST(std::abs(interactions[k].element - length / 24.) < 1e-12);
    }
  BOOST_TEST(interactions[2].name == "support point");
  BOOST_TEST(interactions[2].loads.size() == 2);
  BOOST_TEST(std::abs(interactions[2].begin - 5.) < 1e-12);
  // The pressure is the same at all x: one vector, on the elements from 10 to
  // 11.67.
  BOOST_TEST(interactions[3].loads.size() == 1);
  BOOST_TEST(std::abs(interactions[3].begin - 10.) < 1e-12);
  BOOST_TEST(std::abs(interactions[3].end - 35. / 3.) < 1e-12);
  // Its work on a translation along z is its resultant per work of the vector
  // on itself: of all fields only those of z have a part in it.
  const Vector &f = interactions[3].loads[0];
  BOOST_TEST(std::abs(f[RigidField::translation_x]) < 1e-12);
  BOOST_TEST(std::abs(f[RigidField::translation_z]) > 0.1);
}



BOOST_AUTO_TEST_CASE(what_could_not_be_solved_keeps_all_fields)
{
  // Of a name that is not the body's nothing is meant.
  const unsigned int all =
    fields_at(beam_of(make_bodies({description("LE-2")}, meshes())), 5.);
  for (const std::string name : {"other", "beam"})
    {
      const BodyDescription body   = description("SV-6");
      Bodies                bodies = make_bodies({body}, meshes());
      FieldRules            rules;
      rules.unsolved = {name};
      const auto notes =
        choose_fields(bodies, {body}, {clamp()}, {patch()}, {}, {}, rules);
      BOOST_TEST((fields_at(beam_of(bodies), 5.) == all) == (name == "beam"));
      BOOST_REQUIRE(notes.size() == (name == "beam" ? 1 : 0));
      if (name == "beam")
        BOOST_TEST(notes[0].find("could not be solved") != std::string::npos);
    }
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
                  stress_ranges(bodies, probes, {}, {}));
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


namespace
{
  /// Pieces of @p theories of LE-2 and its fields that end at @p breaks.
  BodyDescription
  with_manual_theories(const std::vector<std::string> &theories,
                       const std::vector<double>      &breaks)
  {
    BodyDescription body = description("SV");
    body.pieces.theories.clear();
    for (const std::string &name : theories)
      {
        body.pieces.theories.push_back(Theory::parse({"Theories", name}));
        body.pieces.theories.back().section_order = 2;
      }
    body.pieces.breaks = breaks;
    body.theory        = body.pieces.leading();
    return body;
  }
} // namespace

BOOST_AUTO_TEST_CASE(energies_are_nested)
{
  // Under given loads the energy grows with the space. SV is in SV-N and these
  // are in all fields of the section, so that lists by hand have their places,
  // too. SV-3, SV-6 and SV-10 share SV only, the wave numbers in between being
  // others: that they ascend is no theorem but what more of them are for. SV-6
  // is within a ten thousandth of LE-2.
  const auto energy = [](const BodyDescription &body) {
    Bodies bodies = chosen(body, {clamp()}, {patch()});
    return solve_linear(std::move(bodies[0]), {clamp()}, {patch()})
      .strain_energy();
  };
  const std::vector<double>     inner{8., 13.}, outer{3., 17.};
  std::map<std::string, double> of;
  for (const char *theory : {"SV", "SV-3", "SV-6", "SV-10", "LE-2"})
    of[theory] = energy(description(theory));
  of["SV, LE-2, SV"] =
    energy(with_manual_theories({"SV", "LE-2", "SV"}, inner));
  of["SV-6, LE-2, SV-6"] =
    energy(with_manual_theories({"SV-6", "LE-2", "SV-6"}, inner));
  of["LE-2, SV-6, LE-2"] =
    energy(with_manual_theories({"LE-2", "SV-6", "LE-2"}, outer));
  const double all = of["LE-2"];
  for (const std::vector<std::string> &hierarchy :
       {std::vector<std::string>{"SV", "SV-3", "SV-6", "SV-10", "LE-2"},
        {"SV", "SV, LE-2, SV", "SV-6, LE-2, SV-6", "LE-2"},
        {"SV-6", "LE-2, SV-6, LE-2", "LE-2"}})
    for (unsigned int k = 1; k < hierarchy.size(); ++k)
      BOOST_TEST(of[hierarchy[k - 1]] < of[hierarchy[k]] * (1. + 1e-10),
                 hierarchy[k - 1] << " in " << hierarchy[k]);
  for (const auto &[name, value] : of)
    BOOST_TEST_MESSAGE(name << " is short of LE-2 by " << 1. - value / all);
  BOOST_TEST(of["SV-6"] > 0.9999 * all);
  BOOST_TEST(of["SV"] < 0.999 * all);
}



BOOST_AUTO_TEST_CASE(responses_stay_near_what_they_answer)
{
  const Bodies sv = chosen(description("SV"), {clamp()}, {patch()});
  for (unsigned int node = 0; node < beam_of(sv).axis().n_nodes(); ++node)
    BOOST_TEST(beam_of(sv).dofs().fields(node).size() == 12);

  // Those to tractions: end fields have reaches of their own.
  const Bodies       six  = chosen(description("SV-6"),
                            {clamp()},
                            {patch()},
                            without_boundary_layer_modes());
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



BOOST_AUTO_TEST_CASE(end_fields_are_new_and_nested)
{
  // Orthonormal, free of warpings and of rigid fields; the outermost zone comes
  // first.
  const End  end("coupled");
  const auto held = end.held({clamp()});
  BOOST_REQUIRE(held.size() == 2);
  BOOST_TEST(held[0].extends_forward);
  BOOST_TEST(!held[1].extends_forward);
  const auto zones = end.zones(held[0]);
  BOOST_REQUIRE(zones.size() > 1);
  for (unsigned int z = 1; z < zones.size(); ++z)
    BOOST_TEST(zones[z].influence_length <= zones[z - 1].influence_length);
  const FieldColumns fields = fields_of(zones);
  BOOST_TEST_MESSAGE("end fields " << fields.n() << ", reach "
                                   << zones[0].influence_length);
  BOOST_TEST(fields.n() > 6);
  BOOST_TEST(largest_product(end.warping, end.warpings, fields) < 1e-9);
  FieldColumns product(fields.n(), fields.n());
  fields.Tmmult(product, end.warping.metric(fields));
  for (unsigned int j = 0; j < fields.n(); ++j)
    for (unsigned int k = 0; k < fields.n(); ++k)
      BOOST_TEST(std::abs(product(j, k) - (j == k ? 1. : 0.)) < 1e-6);
  for (unsigned int j = 0; j < fields.n(); ++j)
    {
      Vector field = column_of(fields, j), before = field;
      end.warping.remove_rigid(field);
      before -= field;
      BOOST_TEST(before.linfty_norm() < 1e-8 * field.linfty_norm());
    }
}



BOOST_AUTO_TEST_CASE(end_fields_are_made_once)
{
  // For sections with the same matrices, held alike; and a halved axis finds
  // those of the axis that `auto` makes.
  const End          end("strip"), again("strip"), other("coupled");
  BoundaryLayerModes ends;
  const auto zones = [&ends](const End &of, const ConstrainedSection &held) {
    return ends.zones(of.section, of.states, of.warping, of.warpings, held);
  };
  ConstrainedSection held   = end.held({clamp()})[0];
  const auto         box    = end.section->element().bounding_box();
  const double       height = std::min(box.side_length(0), box.side_length(1));
  held.element              = 0.15 * height;
  const auto first          = zones(end, held);
  BOOST_TEST(ends.n_pieces_solved() == 1);
  held.element /= 2.;
  const auto second = zones(again, held);
  BOOST_TEST(ends.n_pieces_solved() == 1);
  BOOST_REQUIRE(first.size() == second.size());
  // And they are what the other section would have said.
  const auto fresh = again.zones(held);
  BOOST_REQUIRE(fresh.size() == second.size());
  for (unsigned int z = 0; z < fresh.size(); ++z)
    {
      BOOST_TEST(fresh[z].fields.n() == second[z].fields.n());
      BOOST_TEST(fresh[z].influence_length == second[z].influence_length);
    }

  held.element = height;
  zones(end, held);
  BOOST_TEST(ends.n_pieces_solved() == 2);
  zones(other, other.held({clamp()})[0]);
  BOOST_TEST(ends.n_pieces_solved() == 3);
  zones(end, end.held({clamp()})[1]);
  BOOST_TEST(ends.n_pieces_solved() == 4);
}



BOOST_AUTO_TEST_CASE(richer_sections_have_the_fields_of_poorer_ones)
{
  // LE-2 is in LE-3: energies of a field are the same in both, and what is
  // looked at gets a piece of its own.
  const End end("coupled"), richer("coupled", "LE-3"), other("strip", "LE-3");
  BOOST_TEST(have_same_cells(*end.section, *richer.section));
  BOOST_TEST(!have_same_cells(*end.section, *other.section));
  const ConstrainedSection held = end.held({clamp()})[0];
  // Short pieces are as good for this.
  BoundaryLayerRules rules;
  rules.length = 3.;
  BoundaryLayerModes ends(rules);
  const auto made_for = [&ends](const End &of, const ConstrainedSection &one) {
    return ends.zones(of.section, of.states, of.warping, of.warpings, one);
  };
  const auto         zones  = made_for(end, held);
  const FieldColumns fields = fields_of(zones);
  const auto         same   = embedded(fields, *end.section, *richer.section);
  for (unsigned int j = 0; j < fields.n(); ++j)
    for (const auto &[p, q] : {std::array<int, 2>{{0, 0}}, {{0, 1}}, {{1, 1}}})
      {
        const Vector one = column_of(fields, j), &three = same[j];
        const double energy = end.section->S(p, q).matrix_norm_square(one),
                     scale  = end.section->S(p, p).matrix_norm_square(one) +
                             end.section->S(q, q).matrix_norm_square(one);
        BOOST_TEST(std::abs(richer.section->S(p, q).matrix_norm_square(three) -
                            energy) < 1e-9 * scale);
      }

  ConstrainedSection enriched_factor = richer.held({clamp()})[0];
  BOOST_TEST(enriched_factor.by == std::vector<std::string>({"support clamps"}),
             boost::test_tools::per_element());
  const auto reused = made_for(richer, enriched_factor);
  BOOST_TEST(ends.n_pieces_solved() == 1);
  BOOST_REQUIRE(reused.size() == zones.size());
  for (unsigned int z = 0; z < zones.size(); ++z)
    {
      BOOST_TEST(reused[z].influence_length == zones[z].influence_length);
      BOOST_TEST(reused[z].fields.n() == zones[z].fields.n());
    }
  BOOST_TEST(
    largest_product(richer.warping, richer.warpings, fields_of(reused)) < 1e-9);
  // Once more, from what is known of it now.
  made_for(richer, enriched_factor);
  BOOST_TEST(ends.n_pieces_solved() == 1);
  // At the other end, of another section, or under somebody's eyes.
  made_for(richer, richer.held({clamp()})[1]);
  BOOST_TEST(ends.n_pieces_solved() == 2);
  made_for(other, other.held({clamp()})[0]);
  BOOST_TEST(ends.n_pieces_solved() == 3);
  enriched_factor.is_sampled = true;
  BOOST_TEST(!are_sufficient(reused, enriched_factor));
  BOOST_TEST(
    are_sufficient(made_for(richer, enriched_factor), enriched_factor));
  BOOST_TEST(ends.n_pieces_solved() == 4);
  // Once there is one it serves all.
  made_for(richer, enriched_factor);
  BOOST_TEST(ends.n_pieces_solved() == 4);
  // Another body's are not taken: its support may hold it in another way.
  const End          third("coupled", "LE-4");
  ConstrainedSection of_other = third.held({clamp()})[0];
  of_other.body               = "another";
  made_for(third, of_other);
  BOOST_TEST(ends.n_pieces_solved() == 5);
}



BOOST_AUTO_TEST_CASE(nothing_to_hold_has_no_end_fields)
{
  // What is held the way it deforms on its own is not disturbed: supports that
  // hold u_y alone leave extension and bending as they are far from ends; a
  // support that holds all of it does not.
  const End end("strip");
  Support   sliding = clamp();
  sliding.u         = {{{}, 0., {}}};
  const auto all    = end.zones(end.held({clamp()})[0]),
             along  = end.zones(end.held({sliding})[0]);
  const auto n_all = fields_of(all).n(), n_along = fields_of(along).n();
  BOOST_TEST_MESSAGE("fields of a clamp " << n_all << ", of one along y "
                                          << n_along);
  BOOST_TEST(n_along < n_all);
  // Two supports that hold one component or two each are the clamp.
  Support across  = clamp();
  across.u        = {{0., {}, 0.}};
  const auto both = end.held({sliding, across});
  BOOST_REQUIRE(both.size() == 4);
  BOOST_TEST(alike(both[0], both[2]));
  BOOST_TEST(both[0].rows.size() == end.held({clamp()})[0].rows.size());
  const FieldColumns a = fields_of(all), b = fields_of(end.zones(both[0]));
  BOOST_TEST(a.n() == b.n());
}



BOOST_AUTO_TEST_CASE(other_end_is_a_mirror_image)
{
  // Of cross plies: the fields of the second piece lie in the span of the
  // mirrored ones of the first. Angle plies are not their own mirror image.
  const End  end("strip");
  const auto held  = end.held({clamp()});
  const auto image = mirrored(end.zones(held[0]), *end.section, held[1]);
  BOOST_REQUIRE(!image.empty());
  const FieldColumns a = fields_of(image), b = fields_of(end.zones(held[1]));
  BOOST_TEST(a.n() == b.n());
  FieldColumns product(a.n(), b.n());
  a.Tmmult(product, end.warping.metric(b));
  // Strong combinations come first in each zone; all but the weakest agree.
  for (unsigned int k = 0; k < 3; ++k)
    {
      double square = 0.;
      for (unsigned int j = 0; j < a.n(); ++j)
        square += product(j, k) * product(j, k);
      BOOST_TEST(std::abs(square - 1.) < 1e-6);
    }
  // Without the change of sign they are not.
  const FieldColumns same = fields_of(end.zones(held[0]));
  same.Tmmult(product, end.warping.metric(b));
  double square = 0.;
  for (unsigned int j = 0; j < same.n(); ++j)
    square += product(j, 0) * product(j, 0);
  BOOST_TEST_MESSAGE("without the mirror " << square);

  const End  angle("coupled");
  const auto both = angle.held({clamp()});
  BOOST_TEST(mirrored(angle.zones(both[0]), *angle.section, both[1]).empty());
}



BOOST_AUTO_TEST_CASE(end_fields_against_all_fields)
{
  // A laminate that couples bending and twist, with end fields and with the
  // tractions of its warpings against all of its fields: the stresses from half
  // a height off the clamp on, over the largest there.
  const auto solve = [](const std::string &theory, const FieldRules &rules) {
    Bodies bodies =
      chosen(graded(theory, "coupled"), {clamp()}, {patch()}, rules);
    return solve_linear(std::move(bodies[0]), {clamp()}, {patch()});
  };
  const Solved full = solve("LE-2", {}), ends = solve("SV-6", {}),
               tractions = solve("SV-6", without_boundary_layer_modes());
  const auto error       = [&](const Solved &solved) {
    double worst = 0., largest = 0.;
    for (const double y : {0.5, 0.8, 1.2, 2., 3.1, 19.3})
      for (const double x : {0.3, 1.1})
        for (const double z : {0.1, 0.5, 0.9})
          {
            const Point<3> p(x, y, z);
            largest = std::max(largest, full.at(p).stress.norm());
            worst =
              std::max(worst, (solved.at(p).stress - full.at(p).stress).norm());
          }
    return worst / largest;
  };
  BOOST_TEST_MESSAGE("stress off by "
                     << error(ends) << ", tractions " << error(tractions)
                     << ", DoFs " << ends.structure->bodies()[0]->n_dofs()
                     << ", " << tractions.structure->bodies()[0]->n_dofs());
  BOOST_TEST(ends.structure->bodies()[0]->n_dofs() <
             tractions.structure->bodies()[0]->n_dofs());
  BOOST_TEST(error(ends) < 3e-3);
  BOOST_TEST(error(ends) < 0.5 * error(tractions));
  // No space within that of all fields has more energy.
  BOOST_TEST(ends.strain_energy() < full.strain_energy() * (1. + 1e-10));
  BOOST_TEST(1. - ends.strain_energy() / full.strain_energy() <
             0.5 * (1. - tractions.strain_energy() / full.strain_energy()));
}



BOOST_AUTO_TEST_CASE(ends_that_may_move)
{
  // Ends held across and free along: the piece can move rigidly, and is loaded
  // by what does no work on that.
  Support across = clamp();
  across.u       = {{0., {}, 0.}};
  const Support point{"point",
                      {{0, Region::Kind::point, "", {{1., 10., 0.5}}}},
                      {{{}, 0., {}}}};
  const auto    energy = [&](const std::string &theory) {
    Bodies bodies =
      chosen(graded(theory, "coupled"), {across, point}, {patch()});
    return solve_linear(std::move(bodies[0]), {across, point}, {patch()})
      .strain_energy();
  };
  BOOST_TEST(std::abs(energy("SV-6") / energy("LE-2") - 1.) < 1e-3);
}



BOOST_AUTO_TEST_CASE(walls_have_more_wave_numbers)
{
  // A box under an eccentric patch: its section is distorted over many of its
  // heights, and that takes wave numbers below those of a compact section.
  BodyDescription body = description("SV-6");
  body.section         = "box";
  body.axis.length     = 20.;
  ThinWalled walls;
  walls.form                       = ShapeKind::box;
  walls.width                      = 1.5;
  walls.height                     = 1.;
  walls.webs                       = {0.1, 0.1};
  walls.flanges                    = {0.1, 0.1};
  walls.cells_along_wall           = 2;
  walls.oriented_material.material = "material";
  const SectionMeshes box{
    {"box", make_section_mesh(walls, {{"material", orthotropic}})}};
  const Load eccentric{
    "patch",
    {{0, Region::Kind::surface, "top", {}}},
    {},
    "if((x > 0.9) && (x < 1.3) && (y > 9) && (y < 11), 1, 0)"};
  const auto twist = [&](const std::string &theory, const FieldRules &rules) {
    BodyDescription one      = body;
    one.theory               = Theory::parse({"Theory", theory});
    one.theory.section_order = 2;
    Bodies bodies            = make_bodies({one}, box);
    choose_fields(bodies, {one}, {clamp()}, {eccentric}, {}, {}, rules);
    const Solved solved =
      solve_linear(std::move(bodies[0]), {clamp()}, {eccentric});
    return solved.at(Point<3>(1.5, 10., 0.)).displacement[2] -
           solved.at(Point<3>(0., 10., 0.)).displacement[2];
  };
  const double full = twist("LE-2", {}), six = twist("SV-6", {});
  BOOST_TEST_MESSAGE("twist off by " << six / full - 1.);
  BOOST_TEST(std::abs(six / full - 1.) < 4e-3);
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



BOOST_AUTO_TEST_CASE(bodies_held_all_along_keep_all_fields)
{
  // The bottom has 9 nodes across, held in 3 directions at every node of the
  // axis: 27 of 189 fields. A line along an edge holds 3.
  const Support floor{"floor",
                      {{0, Region::Kind::surface, "bottom", {}}},
                      {{0., 0., 0.}}};
  const Support edge{"edge",
                     {{0,
                       Region::Kind::line,
                       "",
                       {Point<3>(0., 0., 0.), Point<3>(0., length, 0.)}}},
                     {{0., 0., 0.}}};
  for (const char *theory : {"SV-1", "SV-6"})
    {
      const BodyDescription body   = description(theory);
      Bodies                bodies = make_bodies({body}, meshes());
      const auto notes = choose_fields(bodies, {body}, {floor}, {patch()}, {});
      BOOST_TEST(beam_of(bodies).n_dofs() == 73 * 189);
      BOOST_REQUIRE(notes.size() == 1);
      BOOST_TEST(notes[0].find("27 of 189 section functions") !=
                 std::string::npos);
      bodies = make_bodies({body}, meshes());
      BOOST_TEST(choose_fields(bodies, {body}, {edge}, {patch()}, {}).empty());
    }
}



namespace
{
  /// The largest over the smallest eigenvalue of D^-1/2 K D^-1/2, D the
  /// diagonal of the condensed K, by powers and inverse powers: some per cent
  /// below the truth.
  double
  scaled_condition(const Structure &structure)
  {
    const Constraints &constraints = structure.reduction(0).constraints();
    struct Entry
    {
      DofIndex row, column;
      double   value;
    };
    std::vector<Entry> entries;
    Vector             d(structure.n_dofs());
    assembled_stiffness(*structure.bodies()[0], constraints)
      ->for_each_entry(
        [&](const DofIndex row, const DofIndex column, const double value) {
          if (value == 0. || constraints.is_constrained(row) ||
              constraints.is_constrained(column))
            return;
          entries.push_back({row, column, value});
          if (row == column)
            d[row] = 1. / std::sqrt(value);
        });
    // d vanishes where a DoF is eliminated.
    Vector start(d.size());
    for (unsigned int i = 0; i < d.size(); ++i)
      start[i] = d[i] == 0. ? 0. : 1. + 0.3 * std::sin(1. + 7. * i);
    const auto tangent = linearized(structure);
    Vector     x       = start, y(d.size());
    double     largest = 0., smallest = 0.;
    for (unsigned int k = 0; k < 8; ++k)
      {
        x /= x.l2_norm();
        y = 0.;
        for (const Entry &e : entries)
          y[e.row] += d[e.row] * e.value * d[e.column] * x[e.column];
        largest = x * y;
        x       = y;
      }
    x = start;
    for (unsigned int k = 0; k < 4; ++k)
      {
        x /= x.l2_norm();
        for (unsigned int i = 0; i < d.size(); ++i)
          y[i] = d[i] == 0. ? 0. : x[i] / d[i];
        tangent->solver(0).solve(y);
        for (unsigned int i = 0; i < d.size(); ++i)
          y[i] = d[i] == 0. ? 0. : y[i] / d[i];
        smallest = 1. / (x * y);
        x        = y;
      }
    return largest / smallest;
  }



  struct Conditioned
  {
    unsigned int dofs;
    double       condition, first_correction;
  };

  /// A cantilever under a force at its end, @p body along it.
  Conditioned
  cantilever(const BodyDescription &body, const FieldRules &rules)
  {
    const std::vector<Support> held{
      {"clamp", {{0, Region::Kind::surface, "start", {}}}, {{0., 0., 0.}}}};
    const std::vector<Load> pull{traction("end", "0", "0", "1")};
    Bodies                  bodies = make_bodies({body}, meshes(2));
    choose_fields(bodies, {body}, held, pull, {}, {}, rules);
    const Solved solved = solve_linear(std::move(bodies[0]), held, pull);
    return {unsigned(solved.structure->n_dofs()),
            scaled_condition(*solved.structure),
            solved.state.free_corrections.front()};
  }
} // namespace

BOOST_AUTO_TEST_CASE(chosen_fields_keep_the_digits)
{
  // Neither fewer fields nor lists that differ from node to node cost digits:
  // the condition of the scaled stiffness is that of LE-2 within a factor of
  // three, and the refinement has as little to mend
  // (doc/theory/saint-venant-fields.md, lines that begin with a bar).
  BOOST_TEST_MESSAGE("| fields | L/h | DoFs | condition | first correction |");
  // Others and further lists are in the document; they take their time.
  for (const double slenderness : {1000.})
    {
      const auto of = [&](BodyDescription body) {
        body.axis.length = slenderness;
        body.axis.breaks = graded_breaks(slenderness, {{0., 0.25}});
        body.axis.elements =
          std::vector<unsigned int>(body.axis.breaks.size() + 1, 1);
        return body;
      };
      const double a = 0.1 * slenderness, b = 0.6 * slenderness;
      double       le = 0.;
      for (const auto &[name, body] :
           std::vector<std::pair<std::string, BodyDescription>>{
             {"LE-2", of(description("LE-2"))},
             {"SV", of(description("SV"))},
             {"SV-6", of(description("SV-6"))},
             {"SV-6, LE-2, SV",
              of(with_manual_theories({"SV-6", "LE-2", "SV"}, {a, b}))}})
        {
          const Conditioned found = cantilever(body, {});
          BOOST_TEST_MESSAGE("| " << name << " | " << slenderness << " | "
                                  << found.dofs << " | " << found.condition
                                  << " | " << found.first_correction << " |");
          if (name == "LE-2")
            le = found.condition;
          BOOST_TEST(found.condition < 3. * le, name);
          BOOST_TEST(found.first_correction < 1e-7, name);
        }
    }
}



BOOST_AUTO_TEST_CASE(nearly_dependent_fields_are_cut)
{
  // What the tolerance lets through of nearly dependent responses costs the
  // condition of K nothing, since fields are orthonormal; it costs DoFs. (At
  // 1e-9 fields are noise that is made orthonormal, and K is not positive
  // definite any more.)
  BOOST_TEST_MESSAGE("| tolerance | DoFs | condition | first correction |");
  unsigned int before = 0;
  for (const double tolerance : {3e-2, 1e-6})
    {
      FieldRules rules;
      rules.near_tolerance = rules.far_tolerance = tolerance;
      rules.plan.max_fields_share                = 2.;
      BodyDescription   body                     = description("SV-10");
      const Conditioned found                    = cantilever(body, rules);
      BOOST_TEST_MESSAGE("| " << tolerance << " | " << found.dofs << " | "
                              << found.condition << " | "
                              << found.first_correction << " |");
      BOOST_TEST(found.dofs >= before);
      BOOST_TEST(found.condition < 1e7);
      before = found.dofs;
    }
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
  // Without places a quarter of the length each; half of that where elements
  // are twice as fine, and a tenth of a span that is loaded all along.
  BOOST_TEST(graded_breaks(100., {}).size() == 3);
  BOOST_TEST(graded_breaks(100., {}, {}, 2.).size() == 7);
  BOOST_TEST(graded_breaks(100., {}, {}, 1., {{0., 100., 100.}}).size() == 9);
}



BOOST_AUTO_TEST_CASE(axes_are_graded_to_what_touches)
{
  std::vector<BodyDescription> bodies{description("SV-6")};
  bodies[0].axis.elements          = {};
  bodies[0].axis.refinement_factor = 1.;
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
  contact.discretization = Discretization::surface_to_surface;
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
  const std::size_t coarse         = breaks.size();
  bodies[0].axis.refinement_factor = 2.;
  bodies[0].axis.breaks            = {};
  grade_axes(bodies, meshes(), {clamp()}, {}, {contact});
  BOOST_TEST(bodies[0].axis.breaks.front() < 0.09 * height);
  BOOST_TEST(bodies[0].axis.breaks.size() == 2 * coarse + 1);
}

BOOST_AUTO_TEST_SUITE_END()
