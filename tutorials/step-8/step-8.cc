// SPDX-License-Identifier: LGPL-2.1-or-later

// step-8: the fields of a section.
//
// The section of a 32-ply coupon has 2,535 layer-wise functions (LE-2, six
// cells across), and a beam that carries all of them at every node of its axis
// pays for every one. What a scene asks of the section is far less: the six
// Saint-Venant states, and an answer to whatever presses on it. The program
// computes both as fields of the section's own, looks at them, and makes a beam
// whose nodes carry a few dozens of them, chosen by hand. `Theory = SV-6`
// chooses by itself. See README.md in this folder.

#include "../coupon.h"

#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/solve/linear_system.h>

#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <fstream>
#include <iostream>

using namespace lamella;

namespace
{
  // A short piece of the coupon, clamped at its start; the nose presses at
  // y = nose with 10 N on each millimeter of its line.
  constexpr double length = 40., nose = 32., force = 10.;
} // namespace



class FieldsOfASection
{
public:
  FieldsOfASection();
  void
  run();

private:
  FieldColumns
  answers_to(const std::vector<Vector> &loads) const;

  std::vector<std::vector<unsigned int>>
  lists_by_hand(const SectionSpace &space,
                const unsigned int  n_nose,
                const double        near_nose,
                const double        near_clamp) const;
  void
  bend(const std::string &name, std::unique_ptr<Beam> beam);
  void
  print_beams();

  const Coupon                coupon;
  std::shared_ptr<const Axis> axis;

  const SaintVenant  states;
  const Warping      warping;
  const FieldColumns warpings;

  dealii::TableHandler beams;
};



// The first idea. Far from its ends and from whatever loads it a bar deforms in
// six ways only: it is stretched, twisted, bent and sheared in two planes. How
// the section *warps* in each, in its plane and out of it, follows from one
// factorization of S_00 and six right-hand sides. A beam whose nodes carry the
// six rigid motions of the section and these six warpings, each with an
// amplitude of its own, is the theory SV: 12 fields, whatever the section.
FieldsOfASection::FieldsOfASection()
  : states(*coupon.section)
  , warping(*coupon.section)
  , warpings(saint_venant_warpings(states, warping))
{
  AxisMesh description;
  description.length   = length;
  description.breaks   = {1., 4., 28., nose - 1., nose + 1., 36.};
  description.elements = {1, 1, 2, 1, 4, 1, 1};
  axis                 = std::make_shared<Axis>(description);
}



// The second idea: near a load the section answers this load. A load that
// varies along the axis as exp(i k y) is answered by v exp(i k y) with
//
//   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
//
// a system of the section's size. A local load holds all wave numbers from 0 to
// about one over its length, v(k) is smooth, and six of them are enough
// (step-15 counts), in equal ratios from long waves, 0.25 over the width, to
// the shortest that the axis can show, 10 over its shortest element, 0.5.
FieldColumns
FieldsOfASection::answers_to(const std::vector<Vector> &loads) const
{
  const auto waves = wave_numbers(0.25 / Coupon::width, 10. / 0.5, 6);
  return basis_of(responses(*coupon.section, loads, waves),
                  warping,
                  warpings,
                  /*tolerance=*/1e-2);
}



// Which node carries what. All lists begin with the rigid motions, fields 0 to
// 5 of the section; the modes of the space are numbered behind the section's
// fields: first the warpings, then the responses to the nose, then those to the
// clamp, where they are wanted.
//
// What a load disturbs dies away within one height of the section or so, what a
// clamp disturbs in a laminate with plies at an angle within one or two widths.
// Nodes with different lists are neighbors without any treatment.
std::vector<std::vector<unsigned int>>
FieldsOfASection::lists_by_hand(const SectionSpace &space,
                                const unsigned int  n_nose,
                                const double        near_nose,
                                const double        near_clamp) const
{
  const unsigned int                     n_sv = warpings.n();
  std::vector<std::vector<unsigned int>> lists;
  for (const double y : axis->nodes())
    {
      std::vector<unsigned int> list{0, 1, 2, 3, 4, 5};
      const auto                append = [&](const unsigned int begin,
                              const unsigned int end) {
        for (unsigned int j = begin; j < end; ++j)
          list.push_back(space.first_mode() + j);
      };
      append(0, n_sv);
      if (std::abs(y - nose) <= near_nose)
        append(n_sv, n_sv + n_nose);
      if (y <= near_clamp)
        append(n_sv + n_nose, space.n_modes());
      lists.push_back(list);
    }
  return lists;
}



// A beam with lists is a Beam: supports, loads, solver and samples are those of
// step-1. What it says of its tip, of the imprint of the nose (how much nearer
// top and bottom come below it) and of two stresses half-way to the nose, in
// the outer ply and in the middle.
void
FieldsOfASection::bend(const std::string &name, std::unique_ptr<Beam> beam)
{
  dealii::Timer wall;
  const double  width = Coupon::width, top = coupon.laminate.height();
  Bodies        bodies;
  bodies.push_back(std::move(beam));
  const Support clamp{"clamp",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{0., 0., 0.}}};
  const Load    line{
    "nose",
    {{0, Region::Kind::line, "", {{0., nose, top}, {width, nose, top}}}},
    {{0., 0., -force}},
    ""};
  Structure structure(std::move(bodies), {clamp}, {line});
  const std::vector<GapConstraint> no_rows;
  const Vector                     u =
    LinearSystem(linearized(structure), no_rows).solve_free(1.).u.block(0);

  const Body &body   = *structure.bodies()[0];
  const auto  sample = [&](const double y, const double z) {
    return body.sample(locate_all(body, {{0.5 * width, y, z}}, "results")[0],
                       u);
  };
  const double half_ply = 0.5 * Coupon::ply;
  beams.add_value("nodes carry", name);
  beams.add_value("DoFs", body.n_dofs());
  beams.add_value("seconds", wall.wall_time());
  beams.add_value("tip", sample(length, 0.5 * top).displacement[2]);
  beams.add_value("imprint",
                  sample(nose, 0.).displacement[2] -
                    sample(nose, top).displacement[2]);
  beams.add_value("syy", sample(0.5 * nose, half_ply).stress[1]);
  beams.add_value("syz", sample(0.5 * nose, 0.5 * top - half_ply).stress[5]);
}



// A clamp answers to no load vector: it frees or holds the warping. The
// responses to the tractions of the six warpings stand in for it.
void
FieldsOfASection::print_beams()
{
  const FieldColumns  to_nose = answers_to({sum_of(coupon.hats())});
  std::vector<Vector> tractions;
  for (unsigned int j = 0; j < warpings.n(); ++j)
    tractions.push_back(warping.traction(column_of(warpings, j)));
  const FieldColumns to_clamp = answers_to(tractions);
  const auto         space =
    std::make_shared<SectionSpace>(coupon.section,
                                   beside(warpings, beside(to_nose, to_clamp)));
  std::cout << "\nResponses to the nose: " << to_nose.n()
            << "\nResponses to the clamp: " << to_clamp.n() << "\n\n";

  const double none = -1., to_height = warping.height(),
               to_width = 1.5 * Coupon::width;
  const auto with_manual_theories =
    [&](const std::string &name, const double nose_to, const double clamp_to) {
      const auto lists = lists_by_hand(*space, to_nose.n(), nose_to, clamp_to);
      bend(name,
           std::make_unique<Beam>(
             "coupon", space, axis, Placement(), lists, name));
    };
  with_manual_theories("SV", none, none);
  with_manual_theories("SV, nose", to_height, none);
  with_manual_theories("SV, clamp", none, to_width);
  with_manual_theories("SV, nose, clamp", to_height, to_width);
  bend("all fields",
       std::make_unique<Beam>("coupon", coupon.section, axis, Placement()));

  beams.set_precision("seconds", 2);
  for (const char *column : {"tip", "imprint", "syy", "syz"})
    beams.set_precision(column, 6);
  beams.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



void
FieldsOfASection::run()
{
  std::cout << "Fields of the section in LE-2: " << coupon.section->n_fields()
            << "\nSaint-Venant warpings: " << warpings.n() << "\n";
  std::ofstream csv("step-8.csv");
  coupon.draw_states(csv, states, warping);
  coupon.draw_responses(csv, "line", sum_of(coupon.hats()), warping);
  print_beams();
}



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  return run_and_report([] { FieldsOfASection().run(); });
}
