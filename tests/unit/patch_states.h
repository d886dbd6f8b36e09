// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_patch_states_h
#define lamella_tests_unit_patch_states_h

#include "fixtures.h"

#include <boost/test/unit_test.hpp>

namespace lamella
{
  /// The tensor of the Voigt strain that is 1 in @p place.
  inline dealii::Tensor<2, 3>
  unit_strain(const unsigned int place)
  {
    constexpr unsigned int axes[6][2] = {
      {0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    dealii::Tensor<2, 3> E;
    E[axes[place][0]][axes[place][1]] += 0.5;
    E[axes[place][1]][axes[place][0]] += 0.5;
    return E;
  }



  /// The six uniform states of strain, prescribed on the surface, inside of
  /// @p body; @p C_scene is its one elasticity.
  inline void
  check_patch(Body &body, const ElasticTensor &C_scene)
  {
    // All states prescribe the same rows, with other values.
    std::vector<PrescribedFunctional> rows =
      prescribe_on_surface(body, [](const dealii::Point<3> &) {
        return dealii::Tensor<1, 3>();
      });
    std::unique_ptr<LinearSolver> solver;
    for (unsigned int place = 0; place < 6; ++place)
      {
        const dealii::Tensor<2, 3> E     = unit_strain(place);
        const Field                field = [&E](const dealii::Point<3> &x) {
          return E * dealii::Tensor<1, 3>(x);
        };
        for (PrescribedFunctional &row : rows)
          row.value = field(row.position) * row.direction;
        const RowReduction reduction(body, 0, rows, {"surface"});
        if (place == 0)
          solver = make_solver(body, reduction.constraints());
        const Vector u = solve_factorized(body, *solver, reduction);

        Voigt strain;
        strain[place]      = 1.;
        const Voigt stress = C_scene * strain;
        double      worst  = 0.;
        for (const OutputCell &cell : output_cells(body, 2, u))
          for (unsigned int k = 0; k < cell.samples.size(); ++k)
            {
              const FieldSample &s = cell.samples[k];
              worst =
                std::max({worst,
                          (s.displacement - field(cell.positions[k])).norm(),
                          (s.strain - strain).norm(),
                          (s.stress - stress).norm() / stress.norm()});
            }
        BOOST_TEST(worst < 1e-10,
                   body.theory()
                     << ", strain state " << place << ": error " << worst);
      }
  }


  /// A row applied to @p u is what sample() gives, in scene and in ply axes.
  inline void
  check_rows_are_fields(const Body     &body,
                        const Location &where,
                        const Vector   &u)
  {
    const FieldSample s = body.sample(where, u);
    const auto        check =
      [&](const Quantity quantity, const Frame frame, const auto &expected) {
        const std::vector<LinearFunctional> rows =
          body.rows({where}, undisplaced, quantity, frame)[0];
        for (unsigned int c = 0; c < rows.size(); ++c)
          BOOST_TEST(std::abs(rows[c](u) - expected[c]) <
                     1e-10 * expected.norm());
      };
    check(Quantity::displacement, Frame::scene, s.displacement);
    check(Quantity::strain, Frame::scene, s.strain);
    check(Quantity::stress, Frame::scene, s.stress);
    check(Quantity::stress, Frame::ply, s.ply_stress);
  }
} // namespace lamella

#endif
