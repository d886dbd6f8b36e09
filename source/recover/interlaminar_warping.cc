// SPDX-License-Identifier: LGPL-2.1-or-later

// Integrals through a column, and the correction by warping due to shear.

#include <lamella/recover/interlaminar.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>
#include <functional>
#include <optional>

namespace lamella
{
  using namespace dealii;

  EquilibriumStress::Profile
  EquilibriumStress::integral(const std::vector<Layer>  &layers,
                              const Profile             &f,
                              const std::vector<double> &start) const
  {
    const unsigned int n = nodes.size();
    Profile            result(f.size());
    unsigned int       at = 0;
    for (double value : start)
      for (const Layer &layer : layers)
        {
          for (unsigned int i = 0; i < n; ++i)
            {
              result[at + i] = value;
              for (unsigned int j = 0; j < n; ++j)
                result[at + i] +=
                  (layer.top - layer.bottom) * integrate(i, j) * f[at + j];
            }
          value = result[at + n - 1];
          at += n;
        }
    return result;
  }



  EquilibriumStress::Profile
  EquilibriumStress::plane_stress(const std::vector<Layer> &layers,
                                  const Profile            &displacement) const
  {
    const unsigned int n = nodes.size(), size = n * layers.size();
    Profile            stress(2 * size);
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = k * n; i < (k + 1) * n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int b = 0; b < 2; ++b)
            stress[c * size + i] +=
              plane_stiffness[layers[k].ply][c][b] * displacement[b * size + i];
    return stress;
  }



  std::array<double, 4>
  EquilibriumStress::resultants(const std::vector<Layer> &layers,
                                const Profile            &stress) const
  {
    const unsigned int    n = nodes.size(), size = n * layers.size();
    std::array<double, 4> all{};
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const double force = (layers[k].top - layers[k].bottom) *
                                 node_weights[i] * stress[c * size + k * n + i];
            all[c] += force;
            all[2 + c] += force * height(layers[k], i) / box.size[2];
          }
    return all;
  }



  EquilibriumStress::Profile
  EquilibriumStress::without_resultants(const std::vector<Layer> &layers,
                                        Profile                   stress) const
  {
    const unsigned int     n = nodes.size(), size = n * layers.size();
    std::vector<Profile>   linear;
    FullMatrix<double>     system(4, 4);
    dealii::Vector<double> wanted(4), amounts(4);
    const auto             of_e = resultants(layers, stress);
    for (unsigned int m = 0; m < 4; ++m)
      {
        Profile motion(2 * size);
        for (unsigned int k = 0; k < layers.size(); ++k)
          for (unsigned int i = 0; i < n; ++i)
            motion[m % 2 * size + k * n + i] =
              m < 2 ? 1. : height(layers[k], i) / box.size[2];
        linear.push_back(plane_stress(layers, motion));
        const auto own = resultants(layers, linear[m]);
        for (unsigned int r = 0; r < 4; ++r)
          system(r, m) = own[r];
        wanted[m] = -of_e[m];
      }
    system.gauss_jordan();
    system.vmult(amounts, wanted);
    for (unsigned int m = 0; m < 4; ++m)
      stress.add(amounts[m], linear[m]);
    return stress;
  }



  EquilibriumStress::Profile
  EquilibriumStress::warped(const std::vector<Layer> &layers,
                            const Profile            &shear,
                            const Profile            &strain) const
  {
    const unsigned int n = nodes.size(), size = n * layers.size();
    Profile            rate(2 * size);
    for (unsigned int k = 0; k < layers.size(); ++k)
      for (unsigned int i = k * n; i < (k + 1) * n; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const Tensor<1, 2> S = shear_compliance[layers[k].ply][c];
            rate[c * size + i] =
              S[0] * shear[i] + S[1] * shear[size + i] - strain[c * size + i];
          }
    Profile stress = without_resultants(
      layers, plane_stress(layers, integral(layers, rate, {0., 0.})));
    stress *= -1.;
    return integral(layers, stress, {0., 0.});
  }



  namespace
  {
    /// delta - c P delta, for a solver.
    struct ShearWarping
    {
      std::function<Vector(const Vector &)> of;
      double                                ratio;

      void
      vmult(Vector &to, const Vector &from) const
      {
        to = of(from);
        to.sadd(-ratio, 1., from);
      }

      /// The delta of which it makes @p right; none after some tens of steps.
      std::optional<Vector>
      inverse(const Vector &right) const
      {
        constexpr double       tolerance  = 1e-8;
        constexpr unsigned int most_steps = 60;
        SolverControl          control(most_steps, tolerance * right.l2_norm());
        SolverGMRES<Vector>    solver(control);
        Vector                 delta = right;
        try
          {
            if (right.l2_norm() > 0.)
              solver.solve(*this, delta, right, PreconditionIdentity());
          }
        catch (const SolverControl::NoConvergence &)
          {
            return std::nullopt;
          }
        return delta;
      }
    };
  } // namespace



  std::array<EquilibriumStress::Profile, 2>
  EquilibriumStress::correction(const std::vector<Layer>     &layers,
                                const std::array<Profile, 4> &shear,
                                const std::array<Profile, 2> &strain) const
  {
    constexpr double largest_share = 0.5;

    const Profile          none(shear[0].size());
    std::array<Profile, 2> result{{none, none}};
    // tau and tau' alike, in one unit.
    const double H     = box.size[2];
    const double scale = shear[0] * shear[0] + H * H * (shear[1] * shear[1]);
    if (scale == 0.)
      return result;
    const double ratio =
      (shear[2] * shear[0] + H * H * (shear[3] * shear[1])) / scale;
    const ShearWarping operation{[&](const Vector &of) {
                                   return warped(layers, of, none);
                                 },
                                 ratio};
    double             share = 0.;
    for (unsigned int m = 0; m < 2; ++m)
      {
        const std::optional<Vector> delta =
          operation.inverse(warped(layers, shear[m + 2], strain[m]));
        if (!delta)
          return {{none, none}};
        result[m] = *delta;
        share += std::pow(H, 2. * m) * (result[m] * result[m]) / scale;
      }
    if (!(share <= largest_share * largest_share))
      return {{none, none}};
    return result;
  }
} // namespace lamella
