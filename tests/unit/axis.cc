// SPDX-License-Identifier: LGPL-2.1-or-later

// The axis: its matrices by hand, graded meshes, weights of nodes, places of
// points.

#include "entries.h"

#include <lamella/axis/axis.h>
#include <lamella/axis/parameters.h>
#include <lamella/base/exceptions.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(axis)

using namespace lamella;

namespace
{
  AxisMesh
  mesh_of(const double                     length,
          const unsigned int               degree,
          const std::vector<unsigned int> &elements,
          const std::vector<double>       &breaks            = {},
          const bool                       equidistant_nodes = false)
  {
    AxisMesh mesh;
    mesh.length            = length;
    mesh.degree            = degree;
    mesh.elements          = elements;
    mesh.breaks            = breaks;
    mesh.equidistant_nodes = equidistant_nodes;
    return mesh;
  }



  using Rows = std::vector<std::vector<double>>;

  /// Compares @p A with @p factor times @p rows.
  void
  check_matrix(const Matrix      &A,
               const double       factor,
               const Rows        &rows,
               const std::string &name)
  {
    double largest = 0.;
    for (const std::vector<double> &row : rows)
      for (const double entry : row)
        largest = std::max(largest, std::abs(factor * entry));
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < rows.size(); ++j)
        BOOST_TEST(std::abs(A.el(i, j) - factor * rows[i][j]) < 1e-14 * largest,
                   name << "(" << i << ", " << j << ") = " << A.el(i, j)
                        << ", not " << factor * rows[i][j]);
  }



  /// f^T A g for functions given by their values at the nodes.
  double
  form(const Matrix &A, const Vector &f, const Vector &g)
  {
    Vector product(f.size());
    A.vmult(product, g);
    return f * product;
  }
} // namespace

BOOST_AUTO_TEST_CASE(one_linear_element)
{
  // N_1 = 1 - y/h, N_2 = y/h with h = 0.7.
  const double h = 0.7;
  for (const bool equidistant : {false, true})
    {
      const Axis axis(mesh_of(h, 1, {1}, {}, equidistant));
      check_matrix(axis.A(0, 0), h / 6., {{2., 1.}, {1., 2.}}, "A_NN");
      check_matrix(axis.A(0, 1), 0.5, {{-1., 1.}, {-1., 1.}}, "A_NdN");
      check_matrix(axis.A(1, 0), 0.5, {{-1., -1.}, {1., 1.}}, "A_dNN");
      check_matrix(axis.A(1, 1), 1. / h, {{1., -1.}, {-1., 1.}}, "A_dNdN");
    }
}



BOOST_AUTO_TEST_CASE(one_quadratic_element)
{
  // Nodes at 0, h/2, h; with s = 2 y/h - 1: N = s(s-1)/2, 1 - s^2, s(s+1)/2.
  const double h = 0.7;
  for (const bool equidistant : {false, true})
    {
      const Axis axis(mesh_of(h, 2, {1}, {}, equidistant));
      check_matrix(axis.A(0, 0),
                   h / 30.,
                   {{4., 2., -1.}, {2., 16., 2.}, {-1., 2., 4.}},
                   "A_NN");
      check_matrix(axis.A(0, 1),
                   1. / 6.,
                   {{-3., 4., -1.}, {-4., 0., 4.}, {1., -4., 3.}},
                   "A_NdN");
      check_matrix(axis.A(1, 1),
                   1. / (3. * h),
                   {{7., -8., 1.}, {-8., 16., -8.}, {1., -8., 7.}},
                   "A_dNdN");
    }
}



BOOST_AUTO_TEST_CASE(one_cubic_element_with_equidistant_nodes)
{
  // The 4-node element of the literature: h/1680 and 1/(40 h).
  const double h = 0.7;
  const Axis   axis(mesh_of(h, 3, {1}, {}, true));
  check_matrix(axis.A(0, 0),
               h / 1680.,
               {{128., 99., -36., 19.},
                {99., 648., -81., -36.},
                {-36., -81., 648., 99.},
                {19., -36., 99., 128.}},
               "A_NN");
  check_matrix(axis.A(1, 1),
               1. / (40. * h),
               {{148., -189., 54., -13.},
                {-189., 432., -297., 54.},
                {54., -297., 432., -189.},
                {-13., 54., -189., 148.}},
               "A_dNdN");
}



BOOST_AUTO_TEST_CASE(integrals_of_polynomials)
{
  // On unequal elements, for functions that the elements hold exactly:
  // with L = 2, int y^2 = 8/3, int (y)' (y)' = 2, int y (y)' = 2; from degree 2
  // on int y^2 (y^2)' = 8 and int (2 y)^2 = 32/3; of degree 3 int y^3 y^3 =
  // 128/7, int y^3 (y^2)' = 64/5, int (3 y^2)^2 = 288/5.
  for (const unsigned int degree : {1, 2, 3})
    for (const bool equidistant : {false, true})
      {
        const Axis axis(mesh_of(2., degree, {2, 3}, {0.5}, equidistant));
        const auto n = axis.n_nodes();
        Vector     one(n), y(n), y2(n), y3(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            one[i] = 1.;
            y[i]   = axis.nodes()[i];
            y2[i]  = y[i] * y[i];
            y3[i]  = y[i] * y2[i];
          }
        BOOST_TEST(std::abs(form(axis.A(0, 0), one, one) - 2.) < 1e-13);
        BOOST_TEST(std::abs(form(axis.A(0, 0), y, y) - 8. / 3.) < 1e-13);
        BOOST_TEST(std::abs(form(axis.A(0, 1), y, y) - 2.) < 1e-13);
        BOOST_TEST(std::abs(form(axis.A(1, 1), y, y) - 2.) < 1e-13);
        BOOST_TEST(std::abs(form(axis.A(0, 1), y, one)) < 1e-13);
        // int (y)' 1 is the length.
        BOOST_TEST(std::abs(form(axis.A(1, 0), y, one) - 2.) < 1e-13);
        if (degree > 1)
          {
            BOOST_TEST(std::abs(form(axis.A(0, 1), y2, y2) - 8.) < 1e-12);
            BOOST_TEST(std::abs(form(axis.A(1, 1), y2, y2) - 32. / 3.) < 1e-12);
          }
        if (degree > 2)
          {
            BOOST_TEST(std::abs(form(axis.A(0, 0), y3, y3) - 128. / 7.) <
                       1e-12);
            BOOST_TEST(std::abs(form(axis.A(0, 1), y3, y2) - 64. / 5.) < 1e-12);
            BOOST_TEST(std::abs(form(axis.A(1, 1), y3, y3) - 288. / 5.) <
                       1e-12);
          }
      }
}



BOOST_AUTO_TEST_CASE(sums_over_rows_and_columns)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const bool equidistant : {false, true})
      {
        const Axis axis(mesh_of(2., degree, {2, 3}, {0.5}, equidistant));
        const unsigned int n       = axis.n_nodes();
        const auto         weights = axis.node_weights();
        for (unsigned int i = 0; i < n; ++i)
          {
            double rows[4] = {0., 0., 0., 0.}, columns[4] = {0., 0., 0., 0.};
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int pq = 0; pq < 4; ++pq)
                {
                  rows[pq] += axis.A(pq / 2, pq % 2).el(i, j);
                  columns[pq] += axis.A(pq / 2, pq % 2).el(j, i);
                }
            // int N_i, int N_i 1' = 0 and int N_i' = N_i(L) - N_i(0).
            const double ends = i == 0 ? -1. : i == n - 1 ? 1. : 0.;
            BOOST_TEST(std::abs(rows[0] - weights[i]) < 1e-14);
            BOOST_TEST(std::abs(rows[1]) < 1e-13);
            BOOST_TEST(std::abs(columns[1] - ends) < 1e-13);
            BOOST_TEST(std::abs(rows[2] - ends) < 1e-13);
            BOOST_TEST(std::abs(columns[2]) < 1e-13);
            BOOST_TEST(std::abs(rows[3]) < 1e-12);
            for (unsigned int j = 0; j < n; ++j)
              BOOST_TEST(std::abs(axis.A(0, 1).el(i, j) -
                                  axis.A(1, 0).el(j, i)) < 1e-14);
          }
      }
}



BOOST_AUTO_TEST_CASE(graded_mesh)
{
  // 0.9 in 6, 0.2 in 8, 0.9 in 6 elements: 0.15, 0.025, 0.15.
  const Axis axis(mesh_of(2., 3, {6, 8, 6}, {0.9, 1.1}));
  BOOST_TEST(axis.n_cells() == 20);
  BOOST_TEST(axis.n_nodes() == 61);
  BOOST_TEST(axis.degree() == 3);
  BOOST_TEST(axis.length() == 2.);
  for (unsigned int cell = 0; cell < 20; ++cell)
    {
      const double size  = cell < 6 || cell >= 14 ? 0.15 : 0.025;
      const double begin = cell <= 6  ? 0.15 * cell :
                           cell <= 14 ? 0.9 + 0.025 * (cell - 6) :
                                        1.1 + 0.15 * (cell - 14);
      BOOST_TEST(std::abs(axis.cell_begin(cell) - begin) < 1e-14);
      BOOST_TEST(std::abs(axis.cell_end(cell) - begin - size) < 1e-14);
      // The end nodes of a cell come first in the order of N.
      const auto &nodes = axis.nodes_of_cell(cell);
      BOOST_TEST(nodes.size() == 4);
      BOOST_TEST(std::abs(axis.nodes()[nodes[0]] - begin) < 1e-14);
      BOOST_TEST(*std::min_element(nodes.begin(), nodes.end()) == 3 * cell);
      BOOST_TEST(*std::max_element(nodes.begin(), nodes.end()) == 3 * cell + 3);
    }
  for (unsigned int i = 0; i + 1 < axis.n_nodes(); ++i)
    BOOST_TEST(axis.nodes()[i] < axis.nodes()[i + 1]);
  BOOST_TEST(axis.nodes().front() == 0.);
  BOOST_TEST(std::abs(axis.nodes().back() - 2.) < 1e-14);
  double sum = 0.;
  for (const double w : axis.node_weights())
    sum += w;
  BOOST_TEST(std::abs(sum - 2.) < 1e-13);
}



BOOST_AUTO_TEST_CASE(nodes_and_their_weights)
{
  // Two B4 of length 3. Gauss-Lobatto: +-1/sqrt(5) of the half length about the
  // middle, weights 1/12 and 5/12 of the length (Lobatto's rule integrates
  // cubics); equidistant: thirds, 1/8 and 3/8 (Newton's rule).
  for (const bool equidistant : {false, true})
    {
      const Axis   axis(mesh_of(6., 3, {2}, {}, equidistant));
      const double inner        = equidistant ? 1. : 1.5 - 1.5 / std::sqrt(5.);
      const double end_weight   = 3. * (equidistant ? 1. / 8. : 1. / 12.),
                   inner_weight = 3. * (equidistant ? 3. / 8. : 5. / 12.);
      const std::vector<double> places{
        0., inner, 3. - inner, 3., 3. + inner, 6. - inner, 6.};
      const std::vector<double> due{end_weight,
                                    inner_weight,
                                    inner_weight,
                                    2. * end_weight,
                                    inner_weight,
                                    inner_weight,
                                    end_weight};
      const auto                weights = axis.node_weights();
      BOOST_TEST_REQUIRE(axis.n_nodes() == 7);
      for (unsigned int i = 0; i < 7; ++i)
        {
          BOOST_TEST(std::abs(axis.nodes()[i] - places[i]) < 1e-14);
          BOOST_TEST(std::abs(weights[i] - due[i]) < 1e-14);
        }
    }

  // B2: h/2 at the ends, h inside; B3 Simpson's 1/6, 4/6, 2/6.
  const auto b2 = Axis(mesh_of(6., 1, {2})).node_weights();
  BOOST_TEST(std::abs(b2[0] - 1.5) < 1e-14);
  BOOST_TEST(std::abs(b2[1] - 3.) < 1e-14);
  const auto b3 = Axis(mesh_of(6., 2, {2})).node_weights();
  BOOST_TEST(std::abs(b3[0] - 0.5) < 1e-14);
  BOOST_TEST(std::abs(b3[1] - 2.) < 1e-14);
  BOOST_TEST(std::abs(b3[2] - 1.) < 1e-14);
}



BOOST_AUTO_TEST_CASE(shape_functions)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const bool equidistant : {false, true})
      {
        const Axis axis(mesh_of(2., degree, {2, 3}, {0.5}, equidistant));
        for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
          {
            // A partition of unity that holds y, with derivatives 0 and 1.
            for (const double eta : {0., 0.13, 0.5, 0.9, 1.})
              {
                const AxisPoint at = axis.evaluate(cell, eta);
                double          N = 0., dN = 0., y = 0., dy = 0.;
                for (unsigned int i = 0; i < at.N.size(); ++i)
                  {
                    const double node =
                      axis.nodes()[axis.nodes_of_cell(cell)[i]];
                    N += at.N[i];
                    dN += at.dN[i];
                    y += at.N[i] * node;
                    dy += at.dN[i] * node;
                  }
                BOOST_TEST(std::abs(N - 1.) < 1e-14);
                BOOST_TEST(std::abs(dN) < 1e-12);
                BOOST_TEST(std::abs(y - at.y) < 1e-14);
                BOOST_TEST(std::abs(dy - 1.) < 1e-12);
              }
            // One at its node, zero at the others.
            for (const unsigned int node : axis.nodes_of_cell(cell))
              {
                const double eta =
                  (axis.nodes()[node] - axis.cell_begin(cell)) /
                  (axis.cell_end(cell) - axis.cell_begin(cell));
                const AxisPoint at = axis.evaluate(cell, eta);
                for (unsigned int i = 0; i < at.N.size(); ++i)
                  BOOST_TEST(
                    std::abs(at.N[i] -
                             (axis.nodes_of_cell(cell)[i] == node ? 1. : 0.)) <
                    1e-13);
              }
          }
      }
}



BOOST_AUTO_TEST_CASE(locate)
{
  const Axis axis(mesh_of(2., 3, {2, 3}, {0.5}));
  for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
    {
      // Inside: one cell and the place in it.
      const double begin = axis.cell_begin(cell), end = axis.cell_end(cell);
      const auto   inside = axis.locate(begin + 0.3 * (end - begin), 1e-10);
      BOOST_TEST_REQUIRE(inside.size() == 1);
      BOOST_TEST(inside[0].first == cell);
      BOOST_TEST(std::abs(inside[0].second - 0.3) < 1e-13);
    }
  // A node between elements: the end of one and the beginning of the next.
  for (unsigned int cell = 0; cell + 1 < axis.n_cells(); ++cell)
    {
      const auto at = axis.locate(axis.cell_end(cell), 1e-10);
      BOOST_TEST_REQUIRE(at.size() == 2);
      BOOST_TEST(at[0].first == cell);
      BOOST_TEST(at[0].second == 1.);
      BOOST_TEST(at[1].first == cell + 1);
      BOOST_TEST(at[1].second == 0.);
    }
  // A node within an element: that element alone.
  BOOST_TEST(axis.locate(axis.nodes()[1], 1e-10).size() == 1);
  // The ends, and a little beyond.
  BOOST_TEST(axis.locate(0., 1e-10).size() == 1);
  BOOST_TEST(axis.locate(2., 1e-10).size() == 1);
  BOOST_TEST(axis.locate(-1e-11, 1e-10).size() == 1);
  BOOST_TEST(axis.locate(-1e-11, 1e-10)[0].second == 0.);
  BOOST_TEST(axis.locate(-1e-9, 1e-10).empty());
  BOOST_TEST(axis.locate(2. + 1e-9, 1e-10).empty());

  // cell_of_node() leads back to the node.
  for (unsigned int node = 0; node < axis.n_nodes(); ++node)
    {
      const auto [cell, eta] = axis.cell_of_node(node);
      BOOST_TEST(std::abs(axis.evaluate(cell, eta).y - axis.nodes()[node]) <
                 1e-14);
    }
}



BOOST_AUTO_TEST_CASE(entries_of_an_axis)
{
  const auto read = [](const double length, const Settings &settings) {
    return parsed<AxisParameters>("Body a/Kinematics", settings, length);
  };
  const AxisMesh mesh = read(2.,
                             {{"Axis element", "B3"},
                              {"Axis elements", "6, 8, 6"},
                              {"Axis breaks", "0.9, 1.1"},
                              {"Axis nodes", "equidistant"}});
  BOOST_TEST(mesh.degree == 2);
  BOOST_TEST(mesh.length == 2.);
  BOOST_TEST(mesh.equidistant_nodes);
  BOOST_TEST(mesh.elements == (std::vector<unsigned int>{6, 8, 6}),
             boost::test_tools::per_element());
  BOOST_TEST(mesh.breaks == (std::vector<double>{0.9, 1.1}),
             boost::test_tools::per_element());

  // B2 and B3 would lock, and auto is what the entry says where it is not
  // given.
  for (const auto &[element, degree] :
       {std::make_pair("B2", 1u), std::make_pair("B3", 2u)})
    {
      const AxisMesh low = read(1., {{"Axis element", element}});
      BOOST_TEST(low.degree == degree);
      BOOST_TEST(low.assumed_shear);
    }
  const AxisMesh none = read(1., {});
  BOOST_TEST(none.degree == 3);
  BOOST_TEST(!none.equidistant_nodes);
  BOOST_TEST(!none.assumed_shear);
  BOOST_TEST(none.elements == (std::vector<unsigned int>{10}),
             boost::test_tools::per_element());
  BOOST_TEST(read(1., {{"Shear strains", "assumed"}}).assumed_shear);
  BOOST_TEST(!read(1., {{"Axis element", "B2"}, {"Shear strains", "full"}})
                .assumed_shear);
  // However the number is written.
  BOOST_TEST(read(1., {{"Axis elements", "1e1"}}).elements ==
               (std::vector<unsigned int>{10}),
             boost::test_tools::per_element());

  // What is refused, and the entry that the message names.
  for (const auto &[bad, named] : std::vector<std::pair<Settings, std::string>>{
         {{{"Axis element", "B5"}}, "Axis element"},
         {{{"Axis element", "b4"}}, "Axis element"},
         {{{"Axis elements", "0"}}, "Axis elements"},
         {{{"Axis elements", "-3"}}, "Axis elements"},
         {{{"Axis elements", "2.5"}}, "Axis elements"},
         {{{"Axis elements", "100001"}}, "Axis elements"},
         {{{"Axis elements", "many"}}, "Axis elements"},
         {{{"Axis elements", ""}}, "Axis elements"},
         {{{"Axis elements", "5,"}}, "Axis elements"},
         {{{"Axis nodes", "Lobatto"}}, "Axis nodes"},
         {{{"Shear strains", "reduced"}}, "Shear strains"},
         {{{"Axis breaks", "0.5"}}, "Axis elements"},
         {{{"Axis elements", "1, 2"}}, "Axis elements"},
         {{{"Axis elements", "1, 2"}, {"Axis breaks", "2"}}, "Axis breaks"},
         {{{"Axis elements", "1, 2"}, {"Axis breaks", "0"}}, "Axis breaks"},
         {{{"Axis elements", "1, 2, 3"}, {"Axis breaks", "1.1, 0.9"}},
          "Axis breaks"},
         {{{"Axis elements", "1, 2, 3"}, {"Axis breaks", "0.9, 0.9"}},
          "Axis breaks"}})
    BOOST_CHECK_EXCEPTION(read(2., bad),
                          InputError,
                          [path = "Body a/Kinematics/" +
                                  named](const InputError &error) {
                            return error.path() == path;
                          });
}

BOOST_AUTO_TEST_SUITE_END()
