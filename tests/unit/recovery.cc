// SPDX-License-Identifier: LGPL-2.1-or-later

// Recovered stresses. What a fit must do is seen on bodies whose stresses are
// given functions of position, with jumps between elements if wanted: a
// polynomial of the fit's degree comes back as it is, on straight and on curved
// cells, along edges of larger elements, and every ply keeps its own. What it
// is good for is seen on the exact solution of rates.cc: on the surface
// stresses of elements converge with h^p, recovered ones with h^(p+1).

#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/recover/recovery.h>
#include <lamella/shape/shapes.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/grid/grid_generator.h>

#include <boost/test/unit_test.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(recovery)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  using StressField = std::function<
    double(const Point<3> &x, unsigned int cell, unsigned int ply)>;

  /// A beam whose sigma_xx is a given function in each element; the number of
  /// elements asked is counted.
  class GivenStress : public Beam
  {
  public:
    GivenStress(std::shared_ptr<const Section> section,
                std::shared_ptr<const Axis>    axis,
                const StressField             &field)
      : Beam("given", section, axis, Placement())
      , field(field)
      , degrees(Beam::cells().recovery_degrees)
    {}

    FieldSample
    sample(const Location &location, const Vector &) const override
    {
      FieldSample result;
      for (const Location::Place &place : location.places)
        {
          const unsigned int ply =
            section().cell_ply(place.cell % section().n_cells());
          result.stress[0] +=
            field(position(place), place.cell, ply) / location.places.size();
          requested.insert(place.cell);
        }
      result.ply_stress[1] = 2. * result.stress[0];
      result.strain[2]     = 3. * result.stress[0];
      return result;
    }

    Cells
    cells() const override
    {
      Cells all            = Beam::cells();
      all.recovery_degrees = degrees;
      return all;
    }

    StressField                    field;
    std::array<unsigned int, 3>    degrees;
    mutable std::set<unsigned int> requested;
  };



  /// The largest error of recovered values against @p exact at @p points, of
  /// every ply there.
  double
  largest_error(const GivenStress           &body,
                const std::vector<Point<3>> &points,
                const StressValues           kind,
                const StressField           &exact)
  {
    const Vector   u(body.n_dofs());
    StressRecovery recovery(body, u, kind);
    double         error = 0.;
    for (const auto &locations : body.locate(points))
      {
        BOOST_REQUIRE(!locations.empty());
        for (const Location &where : locations)
          {
            const FieldSample sample = recovery.sample(where);
            const double      wanted = exact(where.position, 0, where.ply);
            error                    = std::max({error,
                                                 std::abs(sample.stress[0] - wanted),
                                                 std::abs(sample.ply_stress[1] / 2. - wanted),
                                                 std::abs(sample.strain[2] / 3. - wanted)});
          }
      }
    return error;
  }



  /// Points of the box [0, a] x [0, b] x [0, c], its sides among them.
  std::vector<Point<3>>
  grid(const double a, const double b, const double c)
  {
    std::vector<Point<3>> points;
    for (const double x : {0., 0.21, 0.5, 0.73, 1.})
      for (const double y : {0., 0.17, 0.5, 0.88, 1.})
        for (const double z : {0., 0.31, 0.5, 0.93, 1.})
          points.emplace_back(a * x, b * y, c * z);
    return points;
  }



  /// Corners, points on edges and points inside of all elements.
  std::vector<Location::Place>
  sample_element_points(const GivenStress &body)
  {
    std::vector<Location::Place> places;
    const unsigned int n = body.section().n_cells() * body.axis().n_cells();
    for (unsigned int cell = 0; cell < n; ++cell)
      for (const double s : {0., 0.3, 1.})
        for (const double t : {0., 0.6, 1.})
          places.push_back({cell, {s, 0.4, t}});
    return places;
  }



  std::vector<Point<3>>
  positions(const Body &body, const std::vector<Location::Place> &places)
  {
    std::vector<Point<3>> result;
    for (const Location::Place &place : places)
      result.push_back(body.position(place));
    return result;
  }



  /// Elements of @p body, made to jump: what is recovered is the same in all
  /// that hold one of @p places.
  void
  check_continuity(GivenStress                        &body,
                   const std::vector<Location::Place> &places)
  {
    body.field = [](const Point<3> &x, const unsigned int cell, unsigned int) {
      return x[0] * x[1] + std::sin(3. * cell);
    };
    const Vector u(body.n_dofs());
    for (const StressValues kind :
         {StressValues::nodal, StressValues::recovered})
      {
        StressRecovery recovery(body, u, kind);
        double         jump = 0., jump_of_elements = 0.;
        unsigned int   n_shared = 0;
        for (const Location::Place &place : places)
          {
            const Point<3> x   = body.position(place);
            const Location all = body.locate({x}).at(0).at(0);
            n_shared += all.places.size() > 1;
            const auto difference = [&](const Location::Place &other) {
              jump =
                std::max(jump,
                         std::abs(recovery.sample({x, 0, {place}}).stress[0] -
                                  recovery.sample({x, 0, {other}}).stress[0]));
              jump_of_elements =
                std::max(jump_of_elements,
                         std::abs(body.sample({x, 0, {place}}, u).stress[0] -
                                  body.sample({x, 0, {other}}, u).stress[0]));
            };
            for (const Location::Place &other : all.places)
              difference(other);
          }
        BOOST_TEST(n_shared > 3u);
        BOOST_TEST(jump_of_elements > 1.);
        BOOST_TEST(jump < 1e-9);
      }
  }



  double
  power(const double x, const unsigned int n)
  {
    return std::pow(x, n);
  }



  const EngineeringConstants steel = EngineeringConstants::isotropic(1., 0.3);
} // namespace

BOOST_AUTO_TEST_CASE(polynomials_of_the_degree_come_back)
{
  // The top degree in each coordinate, in one product: of the tensor space.
  for (const auto &[p, q] : {std::make_pair(1, 3),
                             std::make_pair(2, 1),
                             std::make_pair(2, 3),
                             std::make_pair(3, 2),
                             std::make_pair(4, 1)})
    {
      const StressField field =
        [p, q](const Point<3> &x, unsigned int, unsigned int) {
          return 1. +
                 power(x[0], p) * power(x[1] - 0.4, q) * power(x[2] + 0.2, p) -
                 3. * x[0] * x[2];
        };
      const GivenStress body(make_section(rectangle(1., 0.5, {0.}, 3, 2),
                                          steel,
                                          p),
                             make_axis(2., 3, q),
                             field);
      BOOST_TEST(
        largest_error(body, grid(1., 2., 0.5), StressValues::recovered, field) <
        1e-12);
    }
}



BOOST_AUTO_TEST_CASE(one_layer_fixes_one_degree_less_across_it)
{
  const StressField through =
    [](const Point<3> &x, unsigned int, unsigned int) {
      return power(x[0], 2) * power(x[1], 3) * (1. + x[2]);
    };
  const GivenStress body(make_section(rectangle(1., 0.1, {0.}, 3, 1), steel, 2),
                         make_axis(2., 3, 3),
                         through);
  BOOST_TEST(
    largest_error(body, grid(1., 2., 0.1), StressValues::recovered, through) <
    1e-12);

  // z^2 is seen at the two Gauss points only, and comes back as the line
  // through them: off by (z - z_1) (z_2 - z), h^2 / 6 at the surface.
  const StressField square = [](const Point<3> &x, unsigned int, unsigned int) {
    return x[2] * x[2];
  };
  const GivenStress other(make_section(rectangle(1., 0.1, {0.}, 3, 1),
                                       steel,
                                       2),
                          make_axis(2., 3, 3),
                          square);
  BOOST_TEST(largest_error(other,
                           grid(1., 2., 0.1),
                           StressValues::recovered,
                           square) == 0.01 / 6.,
             boost::test_tools::tolerance(1e-9));
}



BOOST_AUTO_TEST_CASE(one_linear_layer_knows_bending)
{
  const StressField bending =
    [](const Point<3> &x, unsigned int, unsigned int) {
      return (1. + x[0]) * power(x[1], 3) * (1. + 5. * x[2]);
    };
  for (const unsigned int n_across : {1, 3})
    {
      const GivenStress body(make_section(rectangle(1., 0.1, {0.}, n_across, 1),
                                          steel,
                                          1),
                             make_axis(2., 3, 3),
                             bending);
      BOOST_TEST(largest_error(body,
                               grid(1., 2., 0.1),
                               StressValues::recovered,
                               bending) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(distorted_layers_do_not_amplify)
{
  // Two Gauss points across a layer whose upper side is not quite parallel tell
  // a parabola across it only through the distortion: rough values of size one
  // must not come back a hundred times as large.
  const dealii::QGauss<3> gauss(2);
  for (const double slope : {0., 1e-8, 1e-3, 0.02})
    {
      std::vector<PatchPoint> points;
      Tensor<2, 3>            frame;
      for (const unsigned int d : {0, 1, 2})
        frame[d][d] = 1.;
      for (const double x : {-1., 0.})
        for (const double y : {-1., 0.})
          for (const Point<3> &q : gauss.get_points())
            {
              PatchPoint point;
              point.position =
                Point<3>(x + q[0],
                         y + q[1],
                         q[2] * (1. + slope * (x + q[0]) * (y + q[1])));
              point.values[0] = points.size() % 3 - 1.;
              points.push_back(point);
            }
      const PatchFit fit(points, {frame}, {{2, 2, 2}});
      for (const double x : {-1., 0., 1.})
        for (const double z : {0., 0.5, 1.})
          BOOST_TEST(std::abs(fit({x, 0.3, z})[0]) < 10.);
    }
}



BOOST_AUTO_TEST_CASE(plies_keep_their_own)
{
  const StressField field =
    [](const Point<3> &x, unsigned int, const unsigned int ply) {
      return ply == 0 ? 5. + x[0] * x[1] :
             ply == 1 ? -7. * x[1] :
                        100. * x[0] * x[0] * x[2];
    };
  const GivenStress body(make_section(rectangle(1., 0.3, {0., 90., 0.}, 2, 2),
                                      steel,
                                      2),
                         make_axis(2., 2, 3),
                         field);
  for (const StressValues kind : {StressValues::nodal, StressValues::recovered})
    {
      BOOST_TEST(largest_error(body, grid(1., 2., 0.3), kind, field) < 1e-11);
      // On the interface both plies answer.
      BOOST_TEST(largest_error(body, {{0.4, 0.9, 0.1}}, kind, field) < 1e-11);
    }
}



BOOST_AUTO_TEST_CASE(continuous_within_a_ply)
{
  GivenStress body(make_section(rectangle(1., 0.4, {0.}, 3, 2), steel, 2),
                   make_axis(2., 3, 3),
                   {});
  auto        places = sample_element_points(body);
  for (const Location::Place &place : sample_element_points(body))
    places.push_back({place.cell, {place.unit[0], 1., place.unit[2]}});
  check_continuity(body, places);
}



BOOST_AUTO_TEST_CASE(curved_cells)
{
  // A half disc graded towards a point of its arc: three, four and five cells
  // at a corner, none of them a parallelogram.
  const auto section =
    make_section(make_section_mesh(HalfDisc{2., 70., 0.5, 4, {"material", 0.}},
                                   {{"material", steel}}),
                 2);
  const StressField quadratic =
    [](const Point<3> &x, unsigned int, unsigned int) {
      return 1. + x[0] * x[2] - 2. * x[2] * x[2] + x[0] * x[1];
    };
  GivenStress body(section, make_axis(1., 2, 3), quadratic);
  BOOST_TEST(largest_error(body,
                           positions(body, sample_element_points(body)),
                           StressValues::recovered,
                           quadratic) < 1e-11);
  check_continuity(body, sample_element_points(body));
}



BOOST_AUTO_TEST_CASE(edges_of_larger_elements)
{
  // One of four cells cut into four, then one of these: corners in the middle
  // of edges. (The body has a Taylor expansion; its recovery sees elements of
  // degree 2.)
  auto mesh = std::make_shared<SectionMesh>();
  dealii::GridGenerator::subdivided_hyper_cube(mesh->mesh, 2);
  for (unsigned int k = 0; k < 2; ++k)
    {
      mesh->mesh.last()->set_refine_flag();
      mesh->mesh.execute_coarsening_and_refinement();
      for (const auto &cell : mesh->mesh.active_cell_iterators())
        cell->set_material_id(0);
    }
  mesh->plies      = {{"material", 0., 0., 1., steel}};
  mesh->boundaries = {{0, "all"}};
  Theory theory;
  theory.kind             = Theory::Kind::TE;
  theory.order            = 1;
  const StressField field = [](const Point<3> &x, unsigned int, unsigned int) {
    return power(x[0], 2) * power(x[1], 3) * power(x[2], 2);
  };
  GivenStress body(make_section(mesh, theory), make_axis(1., 2, 3), field);
  body.degrees      = {{2, 3, 2}};
  const auto places = sample_element_points(body);
  // The place of one cell's corner in the middle of another's edge.
  const bool uneven =
    std::any_of(places.begin(), places.end(), [&](const Location::Place &p) {
      const auto all = body.locate({body.position(p)}).at(0).at(0).places;
      return std::any_of(all.begin(), all.end(), [](const Location::Place &q) {
        return std::abs(q.unit[0] - 0.5) < 1e-6 && q.unit[2] == 1.;
      });
    });
  BOOST_TEST(uneven);
  BOOST_TEST(largest_error(body,
                           positions(body, places),
                           StressValues::recovered,
                           field) < 1e-11);
  check_continuity(body, places);
}



BOOST_AUTO_TEST_CASE(only_what_is_needed)
{
  const StressField field = [](const Point<3> &x, unsigned int, unsigned int) {
    return x[0];
  };
  const GivenStress body(make_section(rectangle(1., 1., {0.}, 10, 10),
                                      steel,
                                      2),
                         make_axis(10., 40, 3),
                         field);
  const Vector      u(body.n_dofs());
  StressRecovery    recovery(body, u, StressValues::recovered);
  recovery.sample(body.locate({{0.55, 5.1, 0.55}}).at(0).at(0));
  // The element and its neighbors: all corners have full patches.
  BOOST_TEST(body.requested.size() == 27u);
}



BOOST_AUTO_TEST_CASE(one_expansion_over_the_section)
{
  // Across the section the point itself, along the axis the fit.
  Theory theory;
  theory.kind             = Theory::Kind::TE;
  theory.order            = 2;
  const StressField field = [](const Point<3> &x, unsigned int, unsigned int) {
    return std::exp(x[0]) * std::cos(x[2]) * power(x[1], 3);
  };
  const GivenStress body(
    make_section(make_section_mesh(rectangle(1., 0.5, {0., 90.}, 3, 2),
                                   {{"material", steel}}),
                 theory),
    make_axis(2., 3, 3),
    field);
  BOOST_TEST(
    largest_error(body, grid(1., 2., 0.5), StressValues::recovered, field) <
    1e-11);
}

BOOST_AUTO_TEST_SUITE_END()
