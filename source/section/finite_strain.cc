// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/finite_strain.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  std::array<Tensor<1, 3>, 2>
  field_derivatives(const SectionPoint &point, const unsigned int a)
  {
    // D_s Phi and the twist hold all derivatives within the section.
    const Voigt &e     = point.in_plane[a];
    const double twist = point.twist[a];
    return {{Tensor<1, 3>({e[0], e[3], 0.5 * e[4] - twist}),
             Tensor<1, 3>({0.5 * e[4] + twist, e[5], e[2]})}};
  }



  Gradient
  gradient_at(const SectionPoint &point,
              const FieldParts   &q,
              const unsigned int  k)
  {
    Gradient H;
    for (unsigned int a = 0; a < point.fields->size(); ++a)
      {
        const auto   along = field_derivatives(point, a);
        const double value = q[FieldPart::value](a, k);
        H[0] += value * along[0];
        H[1] += q[FieldPart::derivative](a, k) * point.value[a];
        H[2] += value * along[1];
      }
    return H;
  }



  Voigt
  green_strain(const Gradient &H)
  {
    const auto at = [&H](const unsigned int i, const unsigned int j) {
      return H[i][j] + H[j][i] + H[i] * H[j];
    };
    Voigt e;
    e[0] = 0.5 * at(0, 0);
    e[1] = 0.5 * at(1, 1);
    e[2] = 0.5 * at(2, 2);
    e[3] = at(0, 1);
    e[4] = at(0, 2);
    e[5] = at(1, 2);
    return e;
  }



  namespace
  {
    SymmetricTensor<2, 3>
    tensor_of(const Voigt &s, const double of_shears)
    {
      SymmetricTensor<2, 3> S;
      for (unsigned int i = 0; i < 3; ++i)
        S[i][i] = s[i];
      S[0][1] = of_shears * s[3];
      S[0][2] = of_shears * s[4];
      S[1][2] = of_shears * s[5];
      return S;
    }



    /// Where i and j stand in the order of Eq. 4.
    constexpr unsigned int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};



    /// dE / dH at H, F_j = e_j + H_j: rows are strains, columns H by rows.
    std::array<std::array<double, 9>, 6>
    strain_derivative(const Gradient &H)
    {
      Tensor<2, 3> F = H;
      for (unsigned int i = 0; i < 3; ++i)
        F[i][i] += 1.;
      std::array<std::array<double, 9>, 6> B{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          for (unsigned int c = 0; c < 3; ++c)
            {
              B[place[i][j]][3 * i + c] += i == j ? F[i][c] : F[j][c];
              if (i != j)
                B[place[i][j]][3 * j + c] += F[i][c];
            }
      return B;
    }
  } // namespace



  SymmetricTensor<2, 3>
  strain_tensor(const Voigt &strain)
  {
    return tensor_of(strain, 0.5);
  }



  Tensor<2, 3>
  stress_tensor(const Voigt &stress)
  {
    return Tensor<2, 3>(tensor_of(stress, 1.));
  }



  Voigt
  quadratic_strain(const Gradient &H)
  {
    Voigt e;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        e[place[i][j]] = (i == j ? 0.5 : 1.) * (H[i] * H[j]);
    return e;
  }



  PolarDecomposition::PolarDecomposition(const Gradient &H)
  {
    Tensor<2, 3> inverse;
    // The default method does not end for some that are nearly the unit tensor.
    for (const auto &[square, direction] :
         eigenvectors(2. * strain_tensor(green_strain(H)) +
                        unit_symmetric_tensor<3>(),
                      SymmetricTensorEigenvectorMethod::jacobi))
      {
        const Tensor<2, 3> projector = outer_product(direction, direction);
        U += std::sqrt(square) * projector;
        inverse += projector / std::sqrt(square);
      }
    R = transpose(Tensor<2, 3>(unit_symmetric_tensor<3>()) + H) * inverse;
  }



  Voigt
  PolarDecomposition::corotated_stress(const Voigt &second) const
  {
    const Tensor<2, 3> S     = stress_tensor(second),
                       sigma = U * S * U / determinant(U);
    Voigt s;
    for (unsigned int i = 0; i < 3; ++i)
      s[i] = sigma[i][i];
    s[3] = sigma[0][1];
    s[4] = sigma[0][2];
    s[5] = sigma[1][2];
    return s;
  }



  double
  angle_of(const Tensor<2, 3> &R)
  {
    // Of small angles the cosine knows nothing, of large ones the sine.
    const Tensor<1, 3> twice_sine(
      {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]});
    return std::atan2(twice_sine.norm(), trace(R) - 1.);
  }



  Stretch
  stretch_of(const Gradient &H)
  {
    Stretch result;
    result.rotation = angle_of(PolarDecomposition(H).rotation());
    const Voigt E   = green_strain(H);
    result.along    = std::abs(E[1]);
    for (const double principal : eigenvalues(strain_tensor(E)))
      result.strain = std::max(result.strain, std::abs(principal));
    return result;
  }



  Tensor<2, 3>
  first_stress(const Gradient &H, const Voigt &second)
  {
    const Tensor<2, 3> S = stress_tensor(second);
    return S + S * H;
  }



  Tensor<2, 9>
  stress_tangent(const Voigt &second)
  {
    const Tensor<2, 3> S = stress_tensor(second);
    Tensor<2, 9>       D;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int c = 0; c < 3; ++c)
          D[3 * i + c][3 * j + c] = S[i][j];
    return D;
  }



  Voigt
  predicted_strain(const Gradient &H, const Gradient &dH)
  {
    return green_strain(H) - quadratic_strain(dH);
  }



  Tensor<2, 9>
  green_tangent(const Gradient &H, const Voigt &second, const ElasticLaw &law)
  {
    const auto   B = strain_derivative(H);
    Tensor<2, 9> D = stress_tangent(second);
    for (unsigned int n = 0; n < 9; ++n)
      {
        Voigt column;
        for (unsigned int e = 0; e < 6; ++e)
          column[e] = B[e][n];
        const Voigt stress = law.stress(column);
        for (unsigned int m = 0; m < 9; ++m)
          for (unsigned int e = 0; e < 6; ++e)
            D[m][n] += B[e][m] * stress[e];
      }
    return D;
  }
} // namespace lamella
