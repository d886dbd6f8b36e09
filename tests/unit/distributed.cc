// SPDX-License-Identifier: LGPL-2.1-or-later

// The stiffness that processes share and its two solvers, here on one process,
// against the serial one. tests/mpi runs them on several.

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/body/body_solver.h>
#include <lamella/linear/stiffness_matrix.h>

#include "fixtures.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>

BOOST_AUTO_TEST_SUITE(distributed)

using namespace lamella;

namespace
{
  // Nodes of a grid of n x n x n; springs between neighbors, stiffer upwards.
  constexpr unsigned int n = 12, n_nodes = n * n * n;

  double
  stiffness_between(const unsigned int node, const unsigned int direction)
  {
    return 1. + 0.3 * direction + 0.1 * (node % 7);
  }



  /// Discrete Laplacian, a block for each pair of neighbors.
  StiffnessTerms
  grid_of_springs(const double scale = 1.)
  {
    StiffnessTerms terms;
    terms.n_dofs         = n_nodes;
    terms.owned          = dealii::complete_index_set(n_nodes);
    terms.for_each_block = [scale](const bool with_values, const auto &use) {
      const std::array<unsigned int, 3> step{{1, n, n * n}};
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int d = 0; d < 3; ++d)
          if (i / step[d] % n + 1 < n)
            {
              const double   k = scale * stiffness_between(i, d);
              StiffnessBlock block;
              block.rows = block.columns = {i, i + step[d]};
              block.columns_ascend       = true;
              if (with_values)
                block.values = {k, -k, -k, k};
              use(block);
            }
    };
    LinearFunctional mean;
    for (unsigned int i = 0; i < n; ++i)
      mean.add(17 * i + 5, 0.2 + i);
    terms.springs = {{mean, 0.7}};
    return terms;
  }



  /// One side held, and ties: to several, to one, to a held one, to nothing.
  Constraints
  ties()
  {
    Constraints constraints;
    for (unsigned int i = 0; i < n_nodes; i += n)
      constraints.add_line(i);
    const auto tie = [&](const unsigned int                              dof,
                         const std::vector<std::pair<DofIndex, double>> &to) {
      constraints.add_line(dof);
      constraints.add_entries(dof, to);
    };
    tie(7, {{3, 0.4}, {8, 0.6}});
    tie(500, {{501, -1.5}});
    tie(900, {{901, 0.5}, {n, 0.5}, {1700, 0.25}});
    tie(1111, {});
    constraints.close();
    return constraints;
  }



  std::map<std::pair<DofIndex, DofIndex>, double>
  entries_of(const StiffnessMatrix &matrix)
  {
    std::map<std::pair<DofIndex, DofIndex>, double> entries;
    matrix.for_each_entry(
      [&](const DofIndex row, const DofIndex column, const double value) {
        if (value != 0.)
          entries[{row, column}] = value;
      });
    return entries;
  }



  std::vector<LinearFunctional>
  some_rows(const Constraints &constraints)
  {
    std::vector<LinearFunctional> rows;
    for (unsigned int k = 0; k < 5; ++k)
      {
        LinearFunctional row;
        for (unsigned int i = 3 * k + 1; i < n_nodes; i += 311)
          row.add(i, std::cos(1. + i));
        rows.push_back(row.reduced(constraints));
      }
    return rows;
  }



  double
  largest_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    BOOST_TEST_REQUIRE(a.size() == b.size());
    double largest = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
  }
} // namespace

BOOST_AUTO_TEST_CASE(condensed_as_the_serial_one)
{
  const Constraints constraints = ties();
  const auto        serial = assemble_serial(grid_of_springs(), constraints),
             shared        = assemble_distributed(grid_of_springs(),
                                           constraints,
                                           SolverKind::mumps);
  const auto expected = entries_of(*serial), found = entries_of(*shared);
  double     off = 0.;
  for (const auto &[place, value] : expected)
    {
      const auto entry = found.find(place);
      if (constraints.is_constrained(place.first))
        BOOST_TEST((place.first == place.second && value > 0.));
      else if (std::abs(value) > 1e-13)
        off =
          std::max(off,
                   entry == found.end() ? 1. : std::abs(entry->second - value));
    }
  BOOST_TEST(off < 1e-13);
  for (const auto &[place, value] : found)
    if (constraints.is_constrained(place.first) ||
        constraints.is_constrained(place.second))
      BOOST_TEST((place.first == place.second && value > 0.));
    else if (std::abs(value) > 1e-13)
      BOOST_TEST(expected.count(place) == 1);
  const Vector diagonal = shared->diagonal();
  for (const auto &[place, value] : found)
    if (place.first == place.second)
      BOOST_TEST(diagonal[place.first] == value);
}



BOOST_AUTO_TEST_CASE(solvers_agree)
{
  const Constraints constraints = ties();
  Vector            one(n_nodes);
  one                 = 1.;
  const auto serial   = assemble_serial(grid_of_springs(), constraints),
             factored = assemble_distributed(grid_of_springs(),
                                             constraints,
                                             SolverKind::mumps),
             iterated = assemble_distributed(grid_of_springs(),
                                             constraints,
                                             SolverKind::cg,
                                             {one});
  const auto exact    = serial->factorize("the grid");
  for (const auto &[matrix, tolerance] :
       {std::make_pair(factored.get(), 1e-13),
        std::make_pair(iterated.get(), 1e-10)})
    {
      double     announced = 0.;
      const auto solver =
        matrix->factorize("the grid", [&](const FactorSize &size) {
          announced = size.non_zeros;
        });
      Vector x(n_nodes), y;
      for (unsigned int i = 0; i < n_nodes; ++i)
        x[i] = constraints.is_constrained(i) ? 0. : std::sin(3. * i);
      y = x;
      exact->solve(y);
      solver->solve(x);
      x -= y;
      BOOST_TEST(x.linfty_norm() < tolerance * y.linfty_norm());

      // Rows in two portions: those before meet those after.
      const auto rows      = some_rows(constraints);
      const auto known     = exact->solved_rows(),
                 requested = solver->solved_rows();
      known->append({rows.begin(), rows.begin() + 2});
      requested->append({rows.begin(), rows.begin() + 2});
      known->append({rows.begin() + 2, rows.end()});
      requested->append({rows.begin() + 2, rows.end()});
      requested->append({});
      BOOST_TEST(requested->size() == rows.size());
      for (const unsigned int first : {0, 2, 5})
        BOOST_TEST(largest_difference(known->products(first),
                                      requested->products(first)) <
                   100. * tolerance);
      const std::vector<double> lambda{1., 0., -2., 0.5, 3.};
      x = requested->displacement(lambda);
      y = known->displacement(lambda);
      x -= y;
      BOOST_TEST(x.linfty_norm() < 10. * tolerance * y.linfty_norm());

      const SolverStatistics taken = solver->statistics();
      BOOST_TEST(taken.solutions >= 7);
      if (taken.kind == SolverKind::mumps)
        BOOST_TEST(std::abs(announced / taken.non_zeros - 1.) < 0.3);
      else
        BOOST_TEST((taken.max_iterations_per_solve > 3 &&
                    taken.max_iterations_per_solve < 40));
    }
}



BOOST_AUTO_TEST_CASE(not_positive)
{
  const Constraints constraints = ties();
  const auto        matrix =
    assemble_distributed(grid_of_springs(-1.), constraints, SolverKind::mumps);
  BOOST_CHECK_EXCEPTION(matrix->factorize("body 'grid'"),
                        NumericsError,
                        [](const NumericsError &error) {
                          const std::string message = error.what();
                          return message.find("body 'grid'") !=
                                   std::string::npos &&
                                 message.find("not positive definite") !=
                                   std::string::npos;
                        });
  // What the monitor throws ends it before memory is spent.
  const auto good =
    assemble_distributed(grid_of_springs(), constraints, SolverKind::mumps);
  BOOST_CHECK_THROW(good->factorize("body 'grid'",
                                    [](const FactorSize &) {
                                      throw InputError("too large");
                                    }),
                    InputError);
}



BOOST_AUTO_TEST_CASE(entries_of_a_beam)
{
  const auto section =
    lamella::make_section(rectangle(0.3, 0.2, {0., 90.}, 2),
                          EngineeringConstants::isotropic(2e5, 0.3),
                          2);
  Beam        beam("beam", section, make_axis(2., 5), Placement());
  double      count = 0.;
  Constraints none;
  none.close();
  assembled_stiffness(beam, none)->for_each_entry([&count](auto, auto, auto) {
    ++count;
  });
  BOOST_TEST(beam.stiffness_entries() == count);
}



BOOST_AUTO_TEST_CASE(memory)
{
  BOOST_TEST(to_bytes({"Memory limit", "auto"}) == 0.);
  BOOST_TEST(to_bytes({"Memory limit", " 2.5 GB"}) == 2.5e9);
  BOOST_TEST(to_bytes({"Memory limit", "800 MB"}) == 8e8);
  for (const char *text : {"2", "GB", "-1 GB", "2 GB more", "0 MB", ""})
    BOOST_CHECK_THROW(to_bytes({"Memory limit", text}), InputError);
  BOOST_TEST(resident_memory() > 1e6);
  BOOST_TEST(peak_memory() >= resident_memory());
  BOOST_TEST(available_memory() > 1e6);
  BOOST_TEST(available_memory() < 1e15);
  BOOST_TEST(available_memory(1e15) < 1e15);
  BOOST_TEST(available_memory(1e15) > 0.9e15);
  BOOST_TEST(available_memory(1.) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
