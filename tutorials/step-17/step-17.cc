// SPDX-License-Identifier: LGPL-2.1-or-later

// step-17: natural frequencies by six theories, compared with elasticity.
//
// The program computes bending modes of laminated beams whose ends have no
// deflection. These modes are sines along the beam, also those of elasticity.
// Their exact frequencies therefore follow from ordinary differential equations
// through the plies. See README.md in this folder.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/estimate/comparison.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>

using namespace lamella;
using dealii::numbers::PI;

namespace
{
  constexpr const char *file   = STEP_17_SCENE;
  constexpr double      height = 20.;

  // Plies of equal thickness.
  struct Layup
  {
    std::string         code;
    std::vector<double> angles;
  };
} // namespace



class FrequenciesOfTheories
{
public:
  void
  run();

private:
  double
  traction_determinant(const double k, const double omega) const;
  double
  exact_frequency(const double k) const;
  void
  compute(const std::string &theory, const unsigned int slenderness);

  Layup                layup;
  Material             ply;
  dealii::TableHandler table;
  std::ofstream        csv{"step-17.csv"};
  // Of error and error bar, over all modes of a theory.
  std::map<std::string, double> largest_ratio;
};



// In a narrow beam (plane stress) with simply supported ends, k = n pi / L,
//
//   u_y = U(z) cos(k y),   u_z = W(z) sin(k y),
//   s_yz = T(z) cos(k y),  s_zz = N(z) sin(k y).
//
// With Hooke's law, s_yy = (-k E U + nu N) sin(k y), and the equations of
// motion, v = (U, W, T, N) satisfies v' = A v in a ply of the thickness h. So
// v(top) = exp(A h) ... exp(A h) v(bottom), one factor for each ply. At both
// faces T = N = 0, which is possible with U and W not zero if a determinant
// vanishes.
double
FrequenciesOfTheories::traction_determinant(const double k,
                                            const double omega) const
{
  const EngineeringConstants &c       = ply.elastic;
  const double                inertia = *ply.density * omega * omega;
  const double                h       = height / layup.angles.size();

  dealii::FullMatrix<double> from_bottom(dealii::IdentityMatrix(4)), sum(4, 4);
  for (const double angle : layup.angles)
    {
      const bool   along = angle == 0.;
      const double E     = along ? c.E1 : c.E2;
      const double G     = along ? c.G13 : c.G23;
      const double nu    = along ? c.nu13 : c.nu23;

      dealii::FullMatrix<double> A(4, 4), product(4, 4);
      A(0, 1) = -k;
      A(0, 2) = 1. / G;
      A(1, 0) = k * nu;
      A(1, 3) = 1. / c.E3 - nu * nu / E;
      A(2, 0) = k * k * E - inertia;
      A(2, 3) = -k * nu;
      A(3, 1) = -inertia;
      A(3, 2) = k;
      // The power series of the exponential, times `from_bottom`.
      dealii::FullMatrix<double> term = from_bottom;
      for (unsigned int i = 1; i <= 60; ++i)
        {
          A.mmult(product, term);
          term.equ(h / i, product);
          from_bottom.add(1., term);
        }
    }
  return from_bottom(2, 0) * from_bottom(3, 1) -
         from_bottom(2, 1) * from_bottom(3, 0);
}



// The lowest frequency [Hz] of the wave number @p k, which is that of bending.
// Waves of bending are slower than those of shear, and all others are faster.
double
FrequenciesOfTheories::exact_frequency(const double k) const
{
  const double step = k * std::sqrt(ply.elastic.G23 / *ply.density) / 50.;
  const bool   sign = std::signbit(traction_determinant(k, 0.));
  double       low = 0., high = step;
  while (std::signbit(traction_determinant(k, high)) == sign)
    {
      low = high;
      high += step;
    }
  while (high - low > 1e-12 * high)
    {
      const double middle = 0.5 * (low + high);
      (std::signbit(traction_determinant(k, middle)) == sign ? low : high) =
        middle;
    }
  return high / (2. * PI);
}



// One run, and three of its modes: the first ones of the kind `bending about
// x`. The goals of a scene with Find = modes are the frequencies of all modes.
void
FrequenciesOfTheories::compute(const std::string &theory,
                               const unsigned int slenderness)
{
  const double length = slenderness * height;
  std::ostream quiet(nullptr);
  const Scene  scene =
    read_scene(SceneText::read(file,
                               {"Theory=" + theory,
                                "Modes=12",
                                "Goals/Error bars=true",
                                "Section strip/Layup=" + layup.code,
                                "Section strip/Ply thickness=" +
                                  to_text(height / layup.angles.size(), 17),
                                "Body beam/Length=" + to_text(length, 17),
                                "Body beam/Kinematics/Axis elements=16",
                                "Body beam/Kinematics/Axis element=B4"}));
  Simulation                        simulation(scene, quiet);
  const auto                       &results = simulation.solve();
  ModelCache                        cache;
  std::map<std::string, GoalResult> goals;
  for (const GoalResult &goal : error_bars_of(simulation, quiet, cache).goals)
    goals.insert({goal.name, goal});

  const std::string beam =
    layup.code + ", L/h = " + std::to_string(slenderness);
  table.add_value("beam, theory", beam + ", " + theory);
  table.add_value("DoFs", results.n_dofs());
  unsigned int n = 0;
  for (const Mode &mode : results.natural_modes->modes)
    if (mode.kind() == "bending about x" && n < 3)
      {
        ++n;
        const double exact = exact_frequency(n * PI / length);
        const double error = mode.value / exact - 1.;
        const double bar =
          goals.at("mode-" + std::to_string(mode.number) + ": frequency").bar /
          exact;
        const std::string number = std::to_string(n);
        table.add_value("error " + number + ", %", to_text(100. * error, 3));
        table.add_value("bar " + number + ", %", to_text(100. * bar, 3));
        csv << layup.code << "," << slenderness << "," << theory << ","
            << results.n_dofs() << "," << n << "," << mode.value << "," << exact
            << "," << error << "," << bar << "\n";
        largest_ratio[theory] =
          std::max(largest_ratio[theory], std::abs(error) / bar);
      }
}



void
FrequenciesOfTheories::run()
{
  ply = read_scene(SceneText::read(file, {})).materials.at("ply");
  csv << "layup,slenderness,theory,dofs,mode,frequency,exact,error,bar\n";
  for (const Layup &one :
       {Layup{"0/90/0", {0., 90., 0.}}, Layup{"0/90", {0., 90.}}})
    for (const unsigned int slenderness : {5, 20})
      {
        layup = one;
        for (unsigned int n = 1; n <= 3; ++n)
          {
            const double length = slenderness * height;
            std::cout << "exact omega L^2/h sqrt(rho/E2), " << layup.code
                      << ", L/h = " << slenderness << ", mode " << n << ": "
                      << to_text(2. * PI * exact_frequency(n * PI / length) *
                                   length * length / height *
                                   std::sqrt(*ply.density / ply.elastic.E2),
                                 5)
                      << "\n";
          }
        for (const std::string theory :
             {"EBBT", "TBT", "TE-3", "LE-1", "LE-2", "SV-6"})
          compute(theory, slenderness);
      }
  for (const auto &[theory, ratio] : largest_ratio)
    std::cout << "largest error over bar, " << theory << ": "
              << to_text(ratio, 2) << "\n";
  std::cout << "\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  return run_and_report([] { FrequenciesOfTheories().run(); });
}
