// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/material/elasticity.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>
#include <utility>

namespace lamella
{
  namespace
  {
    /// The two axes of each place of the Voigt order.
    constexpr std::array<std::pair<unsigned int, unsigned int>, 6> voigt_axes{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  } // namespace



  Triad
  unit_triad()
  {
    Triad triad;
    for (unsigned int d = 0; d < 3; ++d)
      triad[d][d] = 1.;
    return triad;
  }



  EngineeringConstants
  EngineeringConstants::isotropic(const double E, const double nu)
  {
    // No factor 2 (1 + nu) may vanish here: violated_condition() speaks first.
    const double G = E / (2. * (1. + nu));
    return {E, E, E, G, G, G, nu, nu, nu};
  }



  std::string
  EngineeringConstants::violated_condition() const
  {
    const std::array<std::pair<const char *, double>, 6> moduli{{{"E1", E1},
                                                                 {"E2", E2},
                                                                 {"E3", E3},
                                                                 {"G12", G12},
                                                                 {"G13", G13},
                                                                 {"G23", G23}}};
    for (const auto &[name, value] : moduli)
      if (!(value > 0.))
        return std::string(name) + " = " + to_text(value) + " must be positive";

    struct Pair
    {
      const char *nu, *ratio;
      double      value, E_i, E_j;
    };
    for (const Pair &pair : {Pair{"nu12", "E1 / E2", nu12, E1, E2},
                             Pair{"nu13", "E1 / E3", nu13, E1, E3},
                             Pair{"nu23", "E2 / E3", nu23, E2, E3}})
      if (!(pair.value * pair.value < pair.E_i / pair.E_j))
        return std::string(pair.nu) +
               "^2 = " + to_text(pair.value * pair.value) + " must be below " +
               pair.ratio + " = " + to_text(pair.E_i / pair.E_j);

    const double nu21 = nu12 * E2 / E1, nu31 = nu13 * E3 / E1,
                 nu32 = nu23 * E3 / E2;
    const double determinant =
      1. - nu12 * nu21 - nu23 * nu32 - nu13 * nu31 - 2. * nu21 * nu32 * nu13;
    if (!(determinant > 0.))
      return "1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 = " +
             to_text(determinant) + " must be positive";
    return "";
  }



  ElasticTensor
  EngineeringConstants::stiffness() const
  {
    dealii::Tensor<2, 3> compliance;
    compliance[0][0] = 1. / E1;
    compliance[1][1] = 1. / E2;
    compliance[2][2] = 1. / E3;
    compliance[0][1] = compliance[1][0] = -nu12 / E1;
    compliance[0][2] = compliance[2][0] = -nu13 / E1;
    compliance[1][2] = compliance[2][1] = -nu23 / E2;
    const dealii::Tensor<2, 3> normal   = invert(compliance);

    ElasticTensor C;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        C[i][j] = 0.5 * (normal[i][j] + normal[j][i]);
    C[3][3] = G12;
    C[4][4] = G13;
    C[5][5] = G23;
    return C;
  }



  ElasticTensor
  strain_rotation(const Triad &triad)
  {
    // epsilon'_kl = e_k . epsilon e_l; factors are for engineering shear.
    ElasticTensor T;
    for (unsigned int r = 0; r < 6; ++r)
      for (unsigned int c = 0; c < 6; ++c)
        {
          const auto [k, l] = voigt_axes[r];
          const auto [p, q] = voigt_axes[c];
          const double sum =
            triad[k][p] * triad[l][q] + triad[k][q] * triad[l][p];
          T[r][c] = (r < 3 ? 0.5 : 1.) * sum;
        }
    return T;
  }



  ElasticTensor
  rotated(const ElasticTensor &local, const Triad &triad)
  {
    const ElasticTensor T = strain_rotation(triad);
    return transpose(T) * local * T;
  }



  Triad
  ply_axes(const double degrees)
  {
    double sine   = std::sin(degrees * dealii::numbers::PI / 180.);
    double cosine = std::cos(degrees * dealii::numbers::PI / 180.);
    // A right angle must be one exactly: a cross-ply then has exact zeros, and
    // its stiffness matrix a third of the entries.
    constexpr double rounding = 1e-15;
    if (std::abs(sine) < rounding)
      sine = 0.;
    if (std::abs(cosine) < rounding)
      cosine = 0.;
    Triad axes;
    axes[0][0] = sine;
    axes[0][1] = cosine;
    axes[1][0] = -cosine;
    axes[1][1] = sine;
    axes[2][2] = 1.;
    return axes;
  }



  Triad
  ply_axes(const double degrees, const dealii::Tensor<1, 2> &normal)
  {
    // In the axes t, y, n of the ply's plane.
    const Triad in_plane = ply_axes(degrees);
    Triad       axes;
    for (unsigned int k = 0; k < 2; ++k)
      {
        axes[k][0] = in_plane[k][0] * normal[1];
        axes[k][1] = in_plane[k][1];
        // No zero of a sign, for files' sake.
        axes[k][2] = 0. - in_plane[k][0] * normal[0];
      }
    axes[2][0] = normal[0];
    axes[2][2] = normal[1];
    return axes;
  }
} // namespace lamella
