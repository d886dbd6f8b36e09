// SPDX-License-Identifier: LGPL-2.1-or-later

// What goals can be beside numbers of a point: means over boxes, against the
// integrals of a quadratic displacement by hand, and what presses of a contact,
// whose pressures are integrated with hat functions, as contact does, from
// distributions of known width.

#include "entries.h"
#include "solid_fixtures.h"

#include <lamella/contact/contact_patch.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/sampler.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/goal_parameters.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

#include <ostream>
#include <tuple>

BOOST_AUTO_TEST_SUITE(goals)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// A displacement of the second degree and its strains, which are linear.
  Tensor<1, 3>
  displacement(const Point<3> &x)
  {
    return Point<3>(x[0] * x[0] + 2. * x[1] * x[2],
                    x[0] * x[1] - x[2] * x[2],
                    x[1] * x[1] + x[0] * x[2]);
  }



  Voigt
  strain(const Point<3> &x)
  {
    Voigt e;
    e[0] = 2. * x[0];
    e[1] = x[0];
    e[2] = x[0];
    e[3] = 2. * x[2] + x[1];
    e[4] = 2. * x[1] + x[2];
    e[5] = 2. * x[1] - 2. * x[2];
    return e;
  }



  /// Of x^2 over an interval around its middle there is e^2 / 12 more than in
  /// the middle; x y and linear functions have their values there.
  Tensor<1, 3>
  mean_displacement(const Point<3> &middle, const Tensor<1, 3> &edges)
  {
    const auto more = [&](const unsigned int d) {
      return edges[d] * edges[d] / 12.;
    };
    return displacement(middle) + Point<3>(more(0), -more(2), more(1));
  }



  /// The DoFs of @p body that give displacement().
  Vector
  interpolated(Body &body)
  {
    const auto                        places = body.body_points();
    const auto                        all    = body.rows(places, undisplaced);
    std::vector<PrescribedFunctional> rows;
    for (unsigned int i = 0; i < all.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        rows.push_back({{0, all[i][c]},
                        displacement(places[i].position)[c],
                        0,
                        scene_axis(c),
                        places[i].position});
    return solve_prescribed(body, rows);
  }



  /// What a probe of the @p edges around @p middle gives.
  std::vector<FieldRow>
  rows_of_box(std::unique_ptr<Body> &body,
              const Vector          &u,
              const Point<3>        &middle,
              const Tensor<1, 3>    &edges,
              const StressValues     values = StressValues::element)
  {
    Bodies bodies;
    bodies.push_back(std::move(body));
    const std::vector<Probe> probes{{"box", 0, middle, values, {}, edges}};
    const std::vector<Line>  lines;
    const std::vector<Cut>   cuts;
    const Sampler            sampler(bodies, probes, lines, cuts);
    BlockVector              all(1);
    all.block(0) = u;
    all.collect_sizes();
    StepResults results;
    sampler.sample(all, results);
    body = std::move(bodies[0]);
    return results.probes[0];
  }



  /// The largest of what displacement and strain are off by.
  double
  off_by(const FieldRow &row, const Point<3> &middle, const Tensor<1, 3> &edges)
  {
    return std::max(
      (row.sample.displacement - mean_displacement(middle, edges)).norm(),
      (row.sample.strain - strain(middle)).norm());
  }
} // namespace

BOOST_AUTO_TEST_CASE(means_over_boxes)
{
  const auto straight = make_section_mesh(rectangle(0.7, 0.5, {20.}, 3, 2),
                                          {{"material", orthotropic}});
  Theory     taylor;
  taylor.kind  = Theory::Kind::TE;
  taylor.order = 2;
  std::vector<std::unique_ptr<Body>> bodies;
  bodies.push_back(std::make_unique<Beam>(
    "LE-2", make_section(straight, 2), make_axis(1.3, 3, 2), Placement()));
  bodies.push_back(std::make_unique<Beam>(
    "TE-2", make_section(straight, taylor), make_axis(1.3, 3, 2), Placement()));
  bodies.push_back(std::make_unique<Beam>("distorted",
                                          make_section(distorted(straight), 2),
                                          make_axis(1.3, 3, 2),
                                          Placement()));
  bodies.push_back(std::make_unique<Beam>(
    "tilted", make_section(straight, 2), make_axis(1.3, 3, 2), tilted));
  bodies.push_back(std::make_unique<Solid>(
    "solid-2", straight, axis_mesh(1.3, 3), Placement(), 2));
  bodies.push_back(std::make_unique<Solid>(
    "hanging", straight, axis_mesh(1.3, 3), Placement(), 2, around_a_corner));
  for (auto &body : bodies)
    BOOST_TEST_CONTEXT(body->name())
    {
      const Vector   u      = interpolated(*body);
      const Point<3> middle = body->center();
      for (const Point<3> &edges : {Point<3>(0.11, 0.3, 0.1),
                                    Point<3>(0.11, 0.3, 0.),
                                    Point<3>(0., 0.3, 0.),
                                    Point<3>(0., 0., 0.1)})
        for (const StressValues values :
             {StressValues::element, StressValues::recovered})
          {
            const auto rows = rows_of_box(body, u, middle, edges, values);
            for (const FieldRow &row : rows)
              BOOST_TEST(off_by(row, middle, edges) < 1e-12);
            BOOST_TEST(rows[0].ply == 0u);
            BOOST_TEST(rows[0].position.distance(middle) == 0.);
          }
    }
}



BOOST_AUTO_TEST_CASE(stresses_ply_by_ply)
{
  // Plies of 0.2, 0.1 and 0.2; the box has 0.05, 0.1 and 0.15 of them. A linear
  // strain has its mean in the middle of each part.
  const Laminate laminate{0.7,
                          {0., 60., 0.},
                          {0.2, 0.1, 0.2},
                          {"material", "material", "material"},
                          {1},
                          {2}};
  const auto     section = make_section(laminate, orthotropic, 2);
  const auto stress_in = [&section](const unsigned int ply, const Point<3> &x) {
    unsigned int cell = 0;
    while (section->cell_ply(cell) != ply)
      ++cell;
    return section->law(cell, {x[0], x[2]}).stress(strain(x));
  };
  std::unique_ptr<Body> body =
    std::make_unique<Beam>("beam", section, make_axis(1.3, 2, 2), Placement());
  const Vector   u = interpolated(*body);
  const Point<3> middle(0.35, 0.6, 0.3), edges(0.4, 0.5, 0.3);
  const auto     rows = rows_of_box(body, u, middle, edges);
  BOOST_TEST(rows.size() == 1u);
  BOOST_TEST(rows[0].ply == several_plies);
  Voigt stress;
  for (const auto &[ply, z, share] :
       std::vector<std::tuple<unsigned int, double, double>>{
         {0, 0.175, 1. / 6.}, {1, 0.25, 2. / 6.}, {2, 0.375, 3. / 6.}})
    stress += share * stress_in(ply, {middle[0], middle[1], z});
  BOOST_TEST((rows[0].sample.stress - stress).norm() < 1e-10 * stress.norm());

  // In an interface either side has its own, the lower ply first.
  const Point<3> between(0.35, 0.6, 0.2), flat(0.4, 0.5, 0.);
  const auto     sides = rows_of_box(body, u, between, flat);
  BOOST_TEST(sides.size() == 2u);
  for (const unsigned int ply : {0, 1})
    {
      const Voigt of_ply = stress_in(ply, between);
      BOOST_TEST(sides[ply].ply == ply);
      BOOST_TEST((sides[ply].sample.stress - of_ply).norm() <
                 1e-11 * of_ply.norm());
    }
}



BOOST_AUTO_TEST_CASE(boxes_outside)
{
  std::unique_ptr<Body> body = std::make_unique<Beam>(
    "beam", make_section(one_material(), 2), make_axis(1.3, 2, 2), Placement());
  const Vector u(body->n_dofs());
  for (const Point<3> &edges :
       {Point<3>(0.8, 0.1, 0.1), Point<3>(0., 1.4, 0.), Point<3>(0., 0., 0.51)})
    BOOST_CHECK_EXCEPTION(
      box_points(*body, {0.35, 0.65, 0.25}, edges, "Probe p"),
      InputError,
      [](const InputError &error) { return error.path() == "Probe p/Box"; });
  // All of the body is in the body.
  BOOST_TEST(
    rows_of_box(body, u, {0.35, 0.65, 0.25}, Point<3>(0.7, 1.3, 0.5)).size() ==
    1u);
  // Nor is what is hollow.
  const Beam tube(
    "tube",
    make_section(make_section_mesh(ThinWalled{ShapeKind::box,
                                              0.7,
                                              0.5,
                                              {0.1, 0.1},
                                              {0.1, 0.1},
                                              1,
                                              1,
                                              OrientedMaterial{"carbon", 0.}},
                                   {{"carbon", orthotropic}}),
                 1),
    make_axis(1., 1, 1),
    Placement());
  BOOST_CHECK_THROW(
    box_points(tube, {0.35, 0.5, 0.05}, Point<3>(0., 0., 0.2), "Probe p"),
    InputError);
}



namespace
{
  /// Half width, and the force per length, of a pressure (1 - (s/a)^2)^(1/2).
  double
  ellipse(const double s, const double a)
  {
    return std::abs(s) < a ? std::sqrt(1. - s * s / (a * a)) : 0.;
  }



  /// The grid of @p x times @p y as a surface with hat functions; nodes and
  /// their rows are numbered along y first.
  std::shared_ptr<const SlaveSurface>
  grid_surface(const std::vector<double> &x, const std::vector<double> &y)
  {
    const Polygon square{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
    std::vector<SlaveSurface::Facet> facets;
    for (unsigned int i = 0; i + 1 < x.size(); ++i)
      for (unsigned int j = 0; j + 1 < y.size(); ++j)
        {
          const unsigned int  n = y.size(), k = i * n + j;
          SlaveSurface::Facet facet{FacetMap(1,
                                             1,
                                             {{x[i], y[j], 0.},
                                              {x[i + 1], y[j], 0.},
                                              {x[i], y[j + 1], 0.},
                                              {x[i + 1], y[j + 1], 0.}}),
                                    1,
                                    1,
                                    {k, k + n, k + 1, k + n + 1},
                                    {},
                                    {square}};
          for (const unsigned int node : facet.nodes)
            facet.rows.push_back({{node, 1.}});
          facets.push_back(facet);
        }
    return std::make_shared<const SlaveSurface>(SlaveSurface::Functions::hats,
                                                x.size() * y.size(),
                                                facets);
  }



  /// The traction of a contact with a normal along z, on a grid of @p x times
  /// @p y, with the forces of a pressure(x) by hat functions.
  ContactTraction
  pressed(const std::vector<double>                   &x,
          const std::vector<double>                   &y,
          const std::function<double(double, double)> &pressure)
  {
    // The points of the hat @p i of @p s, with their weights in its integral.
    const auto hat = [](const std::vector<double> &s,
                        const unsigned int         i,
                        const dealii::QGauss<1>   &gauss) {
      std::vector<std::pair<double, double>> points;
      for (const int side : {-1, 1})
        if (!(side < 0 && i == 0) && !(side > 0 && i + 1 == s.size()))
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              const double h = s[i + side] - s[i], t = gauss.point(q)[0];
              points.emplace_back(s[i] + t * h,
                                  gauss.weight(q) * std::abs(h) * (1. - t));
            }
      return points;
    };
    // Roots along x, straight lines along y.
    const dealii::QGauss<1>           fine(200), coarse(2);
    std::vector<ContactTraction::Row> rows;
    for (unsigned int i = 0; i < x.size(); ++i)
      for (unsigned int j = 0; j < y.size(); ++j)
        {
          ContactTraction::Row row;
          row.place  = Point<3>(x[i], y[j], 0.);
          row.normal = Point<3>(0., 0., -1.);
          for (const auto &[s, in_x] : hat(x, i, fine))
            for (const auto &[r, in_y] : hat(y, j, coarse))
              {
                const double share = in_x * in_y,
                             force = share * pressure(s, r);
                row.area += share;
                row.force += force;
                row.moment +=
                  cross_product_3d(Point<3>(s, r, 0.), force * row.normal);
              }
          rows.push_back(row);
        }
    return ContactTraction(grid_surface(x, y), rows);
  }



  std::vector<double>
  grid(const double begin, const double end, const unsigned int n)
  {
    std::vector<double> s;
    for (unsigned int i = 0; i <= n; ++i)
      s.push_back(begin + (end - begin) * i / n);
    return s;
  }
} // namespace



BOOST_AUTO_TEST_CASE(widths_of_hertz)
{
  // The edge is wherever it is between two points: the width follows it, and
  // so does the mean pressure, pi/4 of the largest.
  for (const double h : {0.2, 0.1, 0.05})
    for (double a = 1.; a < 1. + h; a += h / 5.)
      {
        const unsigned int n = std::lround(4. / h);
        const auto         traction =
          pressed(grid(-2., 2., n),
                  grid(0., 4., 4),
                  [a](const double s, const double) { return ellipse(s, a); });
        const ContactPatch patch(traction);
        BOOST_TEST(std::abs(patch.width() - 2. * a) < 0.25 * h);
        BOOST_TEST(patch.width(0) == patch.width());
        BOOST_TEST(std::abs(patch.width(1) - 4.) < 1e-14);
        BOOST_TEST(patch.width(2) == 0.);
        BOOST_TEST(std::abs(patch.pressure() / (dealii::numbers::PI / 4.) -
                            1.) < 0.2 * h);
      }
}



BOOST_AUTO_TEST_CASE(strips_of_a_contact)
{
  // 1 + x + 2 y on 3 x 2, pressed all over.
  const auto traction =
    pressed({0., 0.5, 1.2, 2., 3.},
            {0., 0.3, 1., 1.5, 2.},
            [](const double x, const double y) { return 1. + x + 2. * y; });
  const ContactPatch all(traction);
  const auto         whole = traction.resultant();
  BOOST_TEST(std::abs(all.width(0) - 3.) < 1e-14);
  BOOST_TEST(std::abs(all.width() - 2.) < 1e-14);
  // The integral of 1 + x + 2 y is 6 (1 + 1.5 + 2).
  BOOST_TEST(std::abs(whole.force[2] + 27.) < 1e-11);
  BOOST_TEST(std::abs(all.pressure() - 4.5) < 1e-12);
  for (const unsigned int axis : {0u, 1u})
    {
      ContactTraction::Resultant sum;
      const double               ends[] = {-1., 0.3, 0.7, 1.2, 1.23, 5.};
      for (unsigned int k = 0; k < 5; ++k)
        {
          const ContactStrip strip{axis, ends[k], ends[k + 1]};
          const ContactPatch part(traction, strip);
          const auto         resultant = traction.resultant(strip);
          sum.force += resultant.force;
          sum.moment += resultant.moment;
          BOOST_TEST(part.width(axis) <= ends[k + 1] - ends[k] + 1e-14);
          BOOST_TEST(std::abs(part.width(1 - axis) - (axis == 0 ? 2. : 3.)) <
                     1e-14);
        }
      BOOST_TEST((sum.force - whole.force).norm() < 1e-12);
      BOOST_TEST((sum.moment - whole.moment).norm() < 1e-12);
    }
  // Where nothing presses there is nothing.
  auto open = traction.rows();
  for (ContactTraction::Row &row : open)
    row.force = 0.;
  const ContactTraction nothing(traction.surface(), open);
  BOOST_TEST(ContactPatch(nothing).width() == 0.);
  BOOST_TEST(ContactPatch(nothing).pressure() == 0.);
}



BOOST_AUTO_TEST_CASE(numbers_of_a_run)
{
  std::ostream        nowhere(nullptr);
  const Scene         scene = read_scene(SceneText::read(
    LAMELLA_SOURCE_DIR "/tests/bad_input/base.prm",
    {"Goals/Quantities=middle: fz | middle: fz in y 0.4 0.6 | middle: mx in x "
                     "0 0.05 | middle: pressure | middle: width | middle: width x in y 0.2 1 "
                     "| clamps: fz | tip: uz"}));
  Simulation          simulation(scene, nowhere);
  const ResultNumbers numbers(simulation.solve());
  for (const NamedQuantity &quantity : scene.goals.quantities)
    BOOST_TEST_CONTEXT(quantity.label())
    {
      BOOST_TEST(numbers.value(quantity) != 0.);
      BOOST_TEST(numbers.value(quantity) ==
                 simulation.results().quantities.at(quantity.label()));
      BOOST_TEST(std::abs(numbers.value(quantity)) <=
                 numbers.largest_of_kind(quantity) * (1. + 1e-12));
    }
  // The strips of a contact make up the contact, moments included.
  const auto sum = [&](const std::string &column, const std::string &axis) {
    double total = 0.;
    for (const std::string strip : {" -1 0.02", " 0.02 0.5", " 0.5 2"})
      {
        NamedQuantity part = scene.goals.quantities[0];
        part.column        = column;
        part.strip         = ContactStrip{axis == "y" ? 1u : 0u, 0., 0.};
        const auto ends    = Entry("", strip).items(' ');
        part.strip->from   = std::stod(ends[0]);
        part.strip->to     = std::stod(ends[1]);
        total += numbers.value(part);
      }
    return total;
  };
  for (const std::string column : {"fx", "fy", "fz", "mx", "my", "mz"})
    for (const std::string axis : {"x", "y"})
      {
        NamedQuantity whole = scene.goals.quantities[0];
        whole.column        = column;
        BOOST_TEST(std::abs(sum(column, axis) - numbers.value(whole)) <=
                   1e-12 * numbers.largest_of_kind(whole));
      }
}



BOOST_AUTO_TEST_CASE(how_quantities_are_written)
{
  QuantityNames names;
  names.probes.push_back({"tip", 0, {}, StressValues::element, {}});
  names.supports["clamp"] = {};
  names.contacts["nip"]   = {};
  const auto read         = [&names](const std::string &text) {
    return parse_quantity(Entry("Goals/Quantities", text), names);
  };
  const NamedQuantity strip = read("nip:  fz in  y -1.5 2e-1");
  BOOST_TEST(strip.label() == "nip: fz in y -1.5 0.2");
  BOOST_TEST(strip.strip->axis == 1u);
  BOOST_TEST(strip.strip->from == -1.5);
  BOOST_TEST(read("nip: width x in y 0 1").column == "width x");
  BOOST_TEST(!read("nip: pressure").strip);
  for (const std::string text : {"nip: fz in y 2 1",
                                 "nip: fz in y 1 1",
                                 "nip: fz in y 1",
                                 "nip: fz in w 1 2",
                                 "nip: fz in y one 2",
                                 "nip: in y 1 2",
                                 "nip: width w",
                                 "nip: pressur",
                                 "clamp: pressure",
                                 "clamp: fz in y 1 2",
                                 "tip: uz in y 1 2"})
    BOOST_CHECK_THROW(read(text), InputError);
}



BOOST_AUTO_TEST_CASE(tolerances)
{
  QuantityNames names;
  names.supports["clamp"] = {};
  const auto read         = [&names](const std::string &tolerance) {
    return parsed<GoalParameters>("Goals",
                                  {{"Quantities", "clamp: fx | clamp: fz"},
                                   {"Tolerance", tolerance}},
                                  names,
                                  std::vector<NamedQuantity>(),
                                  Units{"mm", "N", "MPa", 1e-6})
      .tolerances;
  };
  BOOST_TEST(read("1").size() == 1u);
  BOOST_TEST(read("1, 2 %")[1].size == 0.02);
  BOOST_TEST(read("1e-6%")[0].size == 1e-8);
  for (const std::string text : {"1, 2.5e2 N", "1, 250N", "1 %, 250 abs"})
    {
      BOOST_TEST(!read(text)[0].is_absolute);
      BOOST_TEST(read(text)[1].is_absolute);
      BOOST_TEST(read(text)[1].size == 250.);
    }
  for (const std::string text :
       {"0",     "-1",      "nan",   "one",   "1e-7",  "100.1", "1, 2, 3",
        "1, 0",  "1 kN",    "1 MPa", "1 mm",  "0 N",   "-1 N",  "N",
        "1 % N", "1 N | 2", "1 n",   "1 N 2", "abs 1", "1, N",  "1 N, 1 N, 1"})
    BOOST_CHECK_THROW(read(text), InputError);
}



BOOST_AUTO_TEST_CASE(units_of_quantities)
{
  const Units   units{"mm", "N", "MPa", 1e-6};
  NamedQuantity quantity;
  quantity.of = NamedQuantity::ObjectKind::probe;
  for (const auto &[column, kind, unit] :
       std::vector<std::tuple<std::string, char, std::string>>{
         {"uy", 'u', "mm"},
         {"gxz", 'e', ""},
         {"s12", 's', "MPa"},
         {"jump", 'j', ""},
         {"fz", 'f', "N"},
         {"mx", 'm', "N mm"},
         {"pressure", 'p', "MPa"},
         {"width x", 'w', "mm"}})
    {
      quantity.column = column;
      BOOST_TEST(quantity.kind() == kind);
      BOOST_TEST(quantity.unit(units) == unit);
      BOOST_TEST(quantity.unit(Units{"", "", "", 1.}).empty());
    }
  NamedQuantity measure;
  measure.of    = NamedQuantity::ObjectKind::measure;
  measure.terms = {quantity, quantity};
  BOOST_TEST(measure.unit(units) == "mm");
  measure.keeps_unit = false;
  BOOST_TEST(measure.unit(units).empty());
}

BOOST_AUTO_TEST_SUITE_END()
