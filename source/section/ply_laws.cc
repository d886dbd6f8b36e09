// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/ply_laws.h>
#include <lamella/section/section_point.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// D C D with sqrt(k) in the places of the transverse shear strains.
    ElasticTensor
    with_shear_factor(ElasticTensor C, const double k)
    {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          C[i][j] *= std::sqrt((is_transverse_shear(i) ? k : 1.) *
                               (is_transverse_shear(j) ? k : 1.));
      return C;
    }
  } // namespace



  PlyLaws::PlyLaws(const std::vector<Ply> &plies, const double shear_factor)
    : plies(plies)
    , shear_factor(shear_factor)
  {
    for (unsigned int ply = 0; ply < plies.size(); ++ply)
      {
        own.push_back(plies[ply].properties.elastic.stiffness());
        constant_laws.push_back(law_with_normal(ply, plies[ply].plane.normal));
      }
  }



  bool
  PlyLaws::has_varying_laws() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const Ply &ply) {
      return bool(ply.plane.normal_at);
    });
  }



  ElasticLaw
  PlyLaws::law_with_normal(const unsigned int  ply,
                           const Tensor<1, 2> &normal) const
  {
    return ElasticLaw(
      with_shear_factor(rotated(own[ply], ply_axes(plies[ply].angle, normal)),
                        shear_factor));
  }



  PlyLaws::Harmonics
  PlyLaws::harmonics(const unsigned int ply, const Point<2> &x) const
  {
    const Tensor<1, 2> n   = plies[ply].plane.at(x);
    const double       phi = std::atan2(n[1], n[0]);
    Harmonics          result{{1.}};
    for (unsigned int m = 1; 2 * m < n_harmonics; ++m)
      {
        result[2 * m - 1] = std::cos(m * phi);
        result[2 * m]     = std::sin(m * phi);
      }
    return result;
  }



  std::array<ElasticTensor, PlyLaws::n_harmonics>
  PlyLaws::stiffness_harmonics(const unsigned int ply) const
  {
    std::array<ElasticTensor, n_harmonics> result;
    for (unsigned int s = 0; s < n_harmonics; ++s)
      {
        const double        phi = 2. * numbers::PI * s / n_harmonics;
        const ElasticTensor C =
          law_with_normal(ply, Point<2>(std::cos(phi), std::sin(phi)))
            .stiffness();
        result[0] += C / n_harmonics;
        for (unsigned int m = 1; 2 * m < n_harmonics; ++m)
          {
            result[2 * m - 1] += 2. / n_harmonics * std::cos(m * phi) * C;
            result[2 * m] += 2. / n_harmonics * std::sin(m * phi) * C;
          }
      }
    return result;
  }
} // namespace lamella
