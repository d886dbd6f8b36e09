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

#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/mpi_session.h>
#include <lamella/body/beam.h>
#include <lamella/material/layup.h>
#include <lamella/material/library.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_response.h>
#include <lamella/section/warping.h>
#include <lamella/shape/laminate.h>
#include <lamella/solve/contact_solver.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <fstream>
#include <iostream>
#include <numeric>
#include <sstream>

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  // The coupon of prm/flexure_test.prm, in millimetres and newtons.
  constexpr double width = 13., ply = 0.125;
  // A short piece of it, clamped at its start; the nose presses at y = nose
  // with 10 N on each millimetre of its line.
  constexpr double length = 40., nose = 32., force = 10.;
  // The shortest axis element under the nose.
  constexpr double element = 0.5;
} // namespace



class FieldsOfASection
{
public:
  FieldsOfASection();
  void
  run();

private:
  void
  print_constants() const;

  std::vector<Vector>
  hats() const;
  std::vector<std::vector<Vector>>
  responses(const std::vector<Vector> &loads,
            const std::vector<double> &waves) const;
  FieldColumns
  basis(const std::vector<std::vector<Vector>> &responses,
        const double                            tolerance) const;
  double
  worst_miss(const std::vector<std::vector<Vector>> &others,
             const FieldColumns                     &basis) const;
  void
  print_convergence() const;

  using Lists = std::vector<std::vector<unsigned int>>;
  Lists
  lists_by_hand(const FieldSpace  &space,
                const unsigned int n_nose,
                const bool         to_nose,
                const bool         to_clamp) const;
  void
  bend(const std::string &name, std::unique_ptr<Beam> beam);
  void
  print_beams();

  void
  draw(const std::string &name, const Vector &plane, const Vector &axial);
  void
  draw_fields();

  Materials                          materials;
  Laminate                           laminate;
  std::shared_ptr<const SectionMesh> mesh;
  std::shared_ptr<const Section>     section;
  std::shared_ptr<const Axis>        axis;

  // The six Saint-Venant states and their warpings, and what compares fields.
  std::unique_ptr<const SaintVenant> states;
  std::unique_ptr<const Warping>     warping;
  FieldColumns                       warpings;

  dealii::TableHandler beams;
  std::ofstream        csv{"step-8.csv"};
};



// The section as the scene describes it: a layup code, a material of the
// library, one cell a ply and six across. Its matrices S_pq in LE-2 are all
// that the rest is made of.
FieldsOfASection::FieldsOfASection()
{
  const Units units = Units::parse({"Units", "mm, N"});
  materials         = {{"carbon", library_material("IM7-8552", units)}};

  const auto         angles = parse_layup({"Layup", "[0/45/-45/90]4s"});
  const unsigned int n      = angles.size();
  laminate                  = {width,
                               angles,
                               std::vector<double>(n, ply),
                               std::vector<std::string>(n, "carbon"),
                               /*cells_per_ply=*/{1},
                               /*cells_across=*/{6}};
  mesh                      = make_section_mesh(laminate, materials);
  section = make_section(mesh, Theory::parse({"Theory", "LE-2"}));

  AxisMesh description;
  description.length   = length;
  description.breaks   = {1., 4., 28., nose - 1., nose + 1., 36.};
  description.elements = {1, 1, 2, 1, 4, 1, 1};
  axis                 = std::make_shared<Axis>(description);
}



// The first idea. Far from its ends and from whatever loads it a bar deforms in
// six ways only: it is stretched, twisted, bent and sheared in two planes. How
// the section *warps* in each, in its plane and out of it, follows from one
// factorisation of S_00 and six right-hand sides. A beam whose nodes carry the
// six rigid motions of the section and these six warpings, each with an
// amplitude of its own, is the theory SV: 12 fields, whatever the section.
//
// The work of the six states on each other is the section's 6 x 6 stiffness,
// out of which come the constants that engineers calculate with. Lamination
// theory knows two of them. It can be asked for the torsion of a thin strip,
// too, 4 b / d_66, and is wrong by a factor here: the coupon is three times as
// wide as thick and soft in the shear between its plies.
void
FieldsOfASection::print_constants() const
{
  const SectionConstants constants =
    section_constants(states->compliance(), section->element().centre());
  const LaminateStiffness flat =
    laminate_stiffness(laminate.plies(materials), laminate.width);
  const Tensor<2, 3>   d = invert(flat.D);
  dealii::TableHandler table;
  const auto           add = [&](const std::string &name,
                       const double       of_states,
                       const double       of_laminate) {
    table.add_value("constant", name);
    table.add_value("Saint-Venant", of_states);
    table.add_value("lamination theory", of_laminate);
    table.add_value("ratio", of_laminate / of_states);
  };
  add("EA [N]", constants.EA, flat.EA);
  add("EI flat [N mm^2]", constants.EI[1], flat.EI);
  add("EI edgewise [N mm^2]", constants.EI[0], flat.EA * width * width / 12.);
  add("GJ [N mm^2]", constants.GJ, 4. * width / d[2][2]);
  for (const char *column : {"Saint-Venant", "lamination theory"})
    {
      table.set_precision(column, 5);
      table.set_scientific(column, true);
    }
  table.set_precision("ratio", 4);
  std::cout << "Fields of the section in LE-2: " << section->n_fields()
            << "\nSaint-Venant warpings: " << warpings.n() << "\n\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// What the nose may do to the section, as section load vectors
//
//   f_alpha = int over the top of  -p(x) e_z . Phi_alpha  dx.
//
// Where it will touch is the result of a contact analysis, so there is a vector
// for each hat function p between the nodes at the top, thirteen of them; they
// sum to 1. A load that is known needs its own vector only: the line of force
// of the beam below is the sum of all hats.
std::vector<Vector>
FieldsOfASection::hats() const
{
  const CrossSectionElement &element = section->element();
  std::vector<double>        nodes;
  for (const EdgePoint &point : element.edge_points("top"))
    nodes.push_back(point.position[0]);
  std::sort(nodes.begin(), nodes.end());
  const double spacing = nodes[1] - nodes[0];

  std::vector<Vector>        loads(nodes.size(), Vector(section->n_fields()));
  const dealii::QIterated<1> rule(dealii::QGauss<1>(3), /*n_copies=*/2);
  for (const auto &[cell, face] : element.boundary_faces("top"))
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const EdgePoint edge = element.edge_point(cell, face, rule.point(q)[0]);
        const SectionPoint point = section->evaluate(edge.cell, edge.unit);
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            const double hat =
              1. - std::abs(edge.position[0] - nodes[j]) / spacing;
            if (hat > 0.)
              for (unsigned int a = 0; a < point.value.size(); ++a)
                loads[j][(*point.fields)[a]] +=
                  -hat * point.value[a][2] * edge.weight * rule.weight(q);
          }
      }
  return loads;
}



namespace
{
  /// @p n wave numbers from @p first to @p last in equal ratios.
  std::vector<double>
  wave_numbers(const double first, const double last, const unsigned int n)
  {
    std::vector<double> k;
    for (unsigned int i = 0; i < n; ++i)
      k.push_back(first * std::pow(last / first, i / (n - 1.)));
    return k;
  }



  Vector
  sum_of(const std::vector<Vector> &vectors)
  {
    Vector sum(vectors[0].size());
    for (const Vector &one : vectors)
      sum += one;
    return sum;
  }



  /// @p n of them from long waves, 0.25 over the width, to the shortest that
  /// the axis can show, 10 over its shortest element.
  std::vector<double>
  of_the_axis(const unsigned int n)
  {
    return wave_numbers(0.25 / width, 10. / element, n);
  }
} // namespace



// The second idea: near a load the section answers this load. A load that
// varies along the axis as exp(i k y) is answered by v exp(i k y) with
//
//   ( S_00 + i k (S_01 - S_10) + k^2 S_11 ) v = f,
//
// a system of the section's size. A local load holds all wave numbers from 0 to
// about one over its length, v(k) is smooth, and a few of them are enough: from
// long waves to the shortest that the axis can show, in equal ratios.
//
// Real and imaginary part are fields of their own. SectionResponse factorises
// once for each wave number, for all loads.
std::vector<std::vector<Vector>>
FieldsOfASection::responses(const std::vector<Vector> &loads,
                            const std::vector<double> &waves) const
{
  const SectionResponse            response(*section);
  std::vector<std::vector<Vector>> result;
  for (const double k : waves)
    for (std::vector<Vector> &parts : response.at(k, loads))
      result.push_back(std::move(parts));
  return result;
}



// All of them together nearly depend on each other. Warping::basis() takes the
// rigid motions and the Saint-Venant warpings out, scales what is left to unit
// norm, and keeps the combinations that are independent by more than the
// tolerance.
FieldColumns
FieldsOfASection::basis(const std::vector<std::vector<Vector>> &responses,
                        const double                            tolerance) const
{
  std::vector<Vector> snapshots;
  for (const std::vector<Vector> &parts : responses)
    snapshots.insert(snapshots.end(), parts.begin(), parts.end());
  return warping->basis(snapshots, warpings, warpings, tolerance);
}



namespace
{
  /// The norm of what no combination of @p fields gives of a response, both
  /// @p parts together. The fields are orthonormal in the norm's matrix M,
  /// @p metrics are M times the fields.
  double
  norm_without(const std::vector<Vector> &parts,
               const FieldColumns        &fields,
               const FieldColumns        &metrics,
               const Warping             &warping)
  {
    double square = 0.;
    for (Vector v : parts)
      {
        warping.remove_rigid(v);
        for (unsigned int j = 0; j < fields.n(); ++j)
          v.add(-(column_of(metrics, j) * v), column_of(fields, j));
        square += v * warping.metric(v);
      }
    return std::sqrt(square);
  }
} // namespace



// How good are they? Responses at wave numbers that were not asked for: what no
// combination of the fields gives of them, over what SV alone leaves, the
// largest over all loads and wave numbers.
double
FieldsOfASection::worst_miss(const std::vector<std::vector<Vector>> &others,
                             const FieldColumns &basis) const
{
  constexpr double   independent = 1e-7;
  const FieldColumns sv =
    orthonormal(warpings, warping->metric(warpings), independent);
  // The basis is orthonormal and free of the warpings.
  const FieldColumns all         = beside(sv, basis),
                     all_metrics = warping->metric(all),
                     sv_metrics  = warping->metric(sv);
  double worst                   = 0.;
  for (const std::vector<Vector> &parts : others)
    worst = std::max(worst,
                     norm_without(parts, all, all_metrics, *warping) /
                       norm_without(parts, sv, sv_metrics, *warping));
  return worst;
}



void
FieldsOfASection::print_convergence() const
{
  const std::vector<Vector> every = hats(), line{sum_of(every)};
  // In between.
  const auto waves          = wave_numbers(0.3 / width, 9. / element, 9);
  const auto others         = responses(line, waves),
             others_of_hats = responses(every, waves);

  dealii::TableHandler table;
  const auto           add = [&](const std::string                      &name,
                       const std::vector<std::vector<Vector>> &of,
                       const double                            tolerance,
                       const std::vector<std::vector<Vector>> &tests) {
    const FieldColumns fields = basis(of, tolerance);
    std::ostringstream words;
    words << name << ", " << tolerance;
    table.add_value("responses, tolerance", words.str());
    table.add_value("snapshots", 2 * unsigned(of.size()));
    table.add_value("fields kept", fields.n());
    table.add_value("worst miss", worst_miss(tests, fields));
  };
  for (const unsigned int n : {2, 4, 6, 8, 12})
    add("line, " + std::to_string(n) + " waves",
        responses(line, of_the_axis(n)),
        1e-4,
        others);
  const auto six = responses(every, of_the_axis(6));
  for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 0.001})
    add("hats, 6 waves", six, tolerance, others_of_hats);
  table.set_precision("worst miss", 3);
  std::cout << "\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// Which node carries what. All lists begin with the rigid motions, fields 0 to
// 5 of the section; the modes of the space are numbered behind the section's
// fields: first the warpings, then the responses to the nose, then those to the
// clamp, where they are wanted.
//
// What a load disturbs dies away within one height of the section or so, what a
// clamp disturbs in a laminate with plies at an angle within one or two widths.
// Nodes with different lists are neighbours without any treatment.
FieldsOfASection::Lists
FieldsOfASection::lists_by_hand(const FieldSpace  &space,
                                const unsigned int n_nose,
                                const bool         to_nose,
                                const bool         to_clamp) const
{
  const double near_nose = warping->height(), near_clamp = 1.5 * width;

  Lists lists;
  for (const double y : axis->nodes())
    {
      std::vector<unsigned int> list(6 + warpings.n());
      std::iota(list.begin(), list.begin() + 6, 0);
      std::iota(list.begin() + 6, list.end(), space.first_mode());
      const auto append = [&](const unsigned int begin,
                              const unsigned int end) {
        for (unsigned int j = begin; j < end; ++j)
          list.push_back(space.first_mode() + j);
      };
      const unsigned int first = warpings.n(), second = first + n_nose;
      if (to_nose && std::abs(y - nose) <= near_nose)
        append(first, second);
      if (to_clamp && y <= near_clamp)
        append(second, space.n_modes());
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
  Bodies        bodies;
  bodies.push_back(std::move(beam));
  const double  top = laminate.height();
  const Support clamp{"clamp",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{0., 0., 0.}}};
  const Load    line{
    "nose",
    {{0, Region::Kind::line, "", {{0., nose, top}, {width, nose, top}}}},
    {{0., 0., -force}},
    ""};
  Structure                 structure(std::move(bodies), {clamp}, {line});
  const std::vector<GapRow> no_rows;
  const Vector              u =
    ContactSolver(linearised(structure), no_rows).solve_free(1.).u.block(0);

  const Body &body   = *structure.bodies()[0];
  const auto  sample = [&](const double y, const double z) {
    return body.sample(locate_all(body, {{0.5 * width, y, z}}, "results")[0],
                       u);
  };
  beams.add_value("nodes carry", name);
  beams.add_value("DoFs", body.n_dofs());
  beams.add_value("seconds", wall.wall_time());
  beams.add_value("tip", sample(length, 0.5 * top).displacement[2]);
  beams.add_value("imprint",
                  sample(nose, 0.).displacement[2] -
                    sample(nose, top).displacement[2]);
  beams.add_value("syy", sample(0.5 * nose, 0.5 * ply).stress[1]);
  beams.add_value("syz", sample(0.5 * nose, 0.5 * top - 0.5 * ply).stress[5]);
}



// A clamp answers to no load vector: it frees or holds the warping. The
// responses to the tractions of the six warpings stand in for it.
void
FieldsOfASection::print_beams()
{
  const FieldColumns to_nose =
    basis(responses({sum_of(hats())}, of_the_axis(6)), /*tolerance=*/1e-2);
  std::vector<Vector> tractions;
  for (unsigned int j = 0; j < warpings.n(); ++j)
    tractions.push_back(warping->traction(column_of(warpings, j)));
  const FieldColumns to_clamp =
    basis(responses(tractions, of_the_axis(6)), /*tolerance=*/1e-2);
  const auto space =
    std::make_shared<FieldSpace>(section,
                                 beside(warpings, beside(to_nose, to_clamp)));
  std::cout << "\nResponses to the nose: " << to_nose.n()
            << "\nResponses to the clamp: " << to_clamp.n() << "\n\n";

  const auto by_hand =
    [&](const std::string &name, const bool nose_too, const bool clamp_too) {
      bend(name,
           std::make_unique<Beam>(
             "coupon",
             space,
             axis,
             Placement(),
             lists_by_hand(*space, to_nose.n(), nose_too, clamp_too),
             name));
    };
  by_hand("SV", false, false);
  by_hand("SV, nose", true, false);
  by_hand("SV, clamp", false, true);
  by_hand("SV, nose, clamp", true, true);
  bend("all fields",
       std::make_unique<Beam>("coupon", section, axis, Placement()));

  beams.set_precision("seconds", 2);
  for (const char *column : {"tip", "imprint", "syy", "syz"})
    beams.set_precision(column, 6);
  beams.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// Fields on a regular grid of the section for plot.py: u_x and u_z of @p plane,
// u_y of @p axial.
void
FieldsOfASection::draw(const std::string &name,
                       const Vector      &plane,
                       const Vector      &axial)
{
  constexpr unsigned int across = 24;
  const unsigned int     up     = laminate.angles.size();
  for (unsigned int j = 0; j <= up; ++j)
    for (unsigned int i = 0; i <= across; ++i)
      {
        const Point<2> x(width * i / across, ply * j);
        const auto [cell, unit]  = section->locate(x, 1e-8 * width).front();
        const SectionPoint point = section->evaluate(cell, unit);
        Tensor<1, 3>       u;
        for (unsigned int a = 0; a < point.value.size(); ++a)
          {
            const unsigned int alpha = (*point.fields)[a];
            u[0] += plane[alpha] * point.value[a][0];
            u[1] += axial[alpha] * point.value[a][1];
            u[2] += plane[alpha] * point.value[a][2];
          }
        csv << '"' << name << "\"," << x[0] << "," << x[1] << "," << u[0] << ","
            << u[1] << "," << u[2] << "\n";
      }
}



// The twelve fields of SV: six rigid motions, and what is left of the six
// states without them. Then the responses to the whole line of the nose and to
// the hat in its middle. The load is real, so sections move in their plane
// where it is largest and along the axis a quarter of a wave further: real part
// in the plane, imaginary part along the axis.
void
FieldsOfASection::draw_fields()
{
  csv << "field,x,z,ux,uy,uz\n";
  const char *rigid[] = {
    "u_x", "u_y", "u_z", "turn about z", "turn about x", "turn about y"};
  for (unsigned int r = 0; r < 6; ++r)
    {
      Vector field(section->n_fields());
      field[r] = 1.;
      draw(rigid[r], field, field);
    }
  const char *warped[] = {"extension",
                          "torsion",
                          "bending about z",
                          "bending about x",
                          "shear along x",
                          "shear along z"};
  for (unsigned int k = 0; k < 6; ++k)
    {
      Vector field = states->values()[k];
      warping->remove_rigid(field);
      draw(warped[k], field, field);
    }
  const std::vector<Vector> all = hats();
  for (const bool whole_line : {true, false})
    for (const double k : {0.2, 1., 5.})
      {
        const Vector load  = whole_line ? sum_of(all) : all[all.size() / 2];
        const auto   parts = SectionResponse(*section).at(k, {load})[0];
        Vector       plane = parts.front(), axial = parts.back();
        warping->remove_rigid(plane);
        warping->remove_rigid(axial);
        std::ostringstream name;
        name << (whole_line ? "line" : "hat") << ", k = " << k;
        draw(name.str(), plane, axial);
      }
}



void
FieldsOfASection::run()
{
  states   = std::make_unique<SaintVenant>(*section);
  warping  = std::make_unique<Warping>(*section);
  warpings = saint_venant_warpings(*states, *warping);

  print_constants();
  print_convergence();
  draw_fields();
  print_beams();
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_tell([] { FieldsOfASection().run(); });
}
