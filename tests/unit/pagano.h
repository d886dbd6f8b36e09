// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_pagano_h
#define lamella_tests_unit_pagano_h

#include <lamella/material/elasticity.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lamella
{
  /**
   * Cylindrical bending of a cross-ply laminate, exact in three-dimensional
   * elasticity (Pagano, J. Compos. Mater. 3 (1969) 398-411), by state space.
   *
   * The strip spans 0 <= y <= L, its plies are stacked over 0 <= z <= h, and
   * nothing depends on x: u_x = 0. It is simply supported, u_z = sigma_yy = 0
   * at y = 0 and L, and pulled up on its top (q0 > 0 is a traction along +z,
   * Pagano's sign; as a pressure it is -q0 sin(p y)):
   *   sigma_zz(y, h) = q0 sin(p y), p = pi / L; sigma_yz(y, h) = 0; both vanish
   *   at z = 0.
   *
   * With u_y = U(z) cos(p y), u_z = W(z) sin(p y) all boundary conditions at
   * the ends hold, and sigma_yy = Y sin, sigma_zz = N sin, sigma_yz = T cos. C
   * in the body frame has no coupling of normal and shear strains for plies of
   * 0 and 90 degrees; with c_22, c_23, c_33 its entries of yy and zz, G that of
   * yz, nu = c_23 / c_33, Q = c_22 - c_23 nu, and E the amplitude of eps_yy:
   *   W' = eps_zz = N / c_33 - nu E,  Y = Q E + nu N,  U' = T / G - p W,
   * and equilibrium, sigma_yy,y + sigma_yz,z = sigma_yz,y + sigma_zz,z = 0:
   *   T' = -p Y,  N' = p T.
   *
   * Integrated as it stands, (U, W, T, N)' = A (U, W, T, N) loses digits for
   * slender strips: the bending strain is a difference of U and W that is
   * (p h)^2 times smaller, and its stresses enter T and N with two factors p h
   * more, so 1e-16 is multiplied by (L / h)^4. Therefore the strain E = -p U
   * and the curvature u_z,yy = -p^2 W are integrated instead, and everything is
   * measured in its order of magnitude in a thin plate. With a length l, a
   * modulus c, alpha = p l and zeta = z / l,
   *   E = q0/c e/alpha^2,  l u_z,yy = q0/c k/alpha^2 (amplitude),
   *   T = q0 t/alpha,      N = q0 n,
   * there follows from compatibility, eps_yy,z = gamma_yz,y - u_z,yy, and from
   * the above
   *   e' = -k - alpha^2 (c/G) t
   *   k' = alpha^2 nu e - alpha^4 (c/c_33) n
   *   t' = -(Q/c) e - alpha^2 nu n
   *   n' = t,
   * which for alpha -> 0 is lamination theory (a linear e, t the integral of
   * the stress, n that of t) and nothing degenerates: l = h. Thick strips, p h
   * > 1, decay over the length 1/p, so l = min(h, 1/p).
   *
   * Since e, k, t, n are continuous between plies, the states at all layer
   * interfaces follow from one linear system: t = n = 0 below, t = 0 and n = 1
   * on top, and state_(i+1) = exp(A_i (zeta_(i+1) - zeta_i)) state_i between.
   * Plies are divided until no exponent exceeds 1, so that growing and decaying
   * solutions are told apart: the eigenvalues of A have
   *   lambda_1^2 + lambda_2^2 = tr(A^2) / 2 = alpha^2 (Q/G - 2 nu) = b,
   *   lambda_1^2 lambda_2^2 = det(A) = alpha^4 c_22/c_33 = d,
   * so |lambda|^2 <= |b| + sqrt(d). With that, the exponential is its Taylor
   * series.
   */
  class PaganoSolution
  {
  public:
    /// Displacement and stress (order of Eq. 4).
    struct Fields
    {
      dealii::Tensor<1, 3> displacement;
      Voigt                stress;
    };

    /// @p ply in its own axes, @p angles (0 or 90 degrees) and @p thicknesses
    /// from bottom to top.
    PaganoSolution(const EngineeringConstants &ply,
                   const std::vector<double>  &angles,
                   const std::vector<double>  &thicknesses,
                   const double                length,
                   const double                q0 = 1.)
      : L(length)
      , traction(q0)
    {
      AssertDimension(angles.size(), thicknesses.size());
      for (unsigned int i = 0; i < angles.size(); ++i)
        {
          const double bottom = height();
          plies.push_back(
            {"material", angles[i], bottom, bottom + thicknesses[i], ply});
        }
      p     = dealii::numbers::PI / L;
      unit  = std::min(height(), 1. / p);
      alpha = p * unit;
      make_coefficients();
      make_layers();
      solve();
    }

    double
    length() const
    {
      return L;
    }

    double
    height() const
    {
      return plies.empty() ? 0. : plies.back().top;
    }

    /// Bottom to top.
    const std::vector<Ply> &
    stack() const
    {
      return plies;
    }

    /// At (y, z) in the ply number @p ply; z may lie on either of its faces.
    Fields
    operator()(const double y, const double z, const unsigned int ply) const
    {
      Assert(z >= plies[ply].bottom - 1e-10 * height() &&
               z <= plies[ply].top + 1e-10 * height(),
             dealii::ExcMessage("z is not in the ply"));
      // The last of the ply's layers that begins at or below z, or its first.
      const Layer *layer = nullptr;
      for (const Layer &candidate : layers)
        if (candidate.ply == ply && (layer == nullptr || candidate.bottom <= z))
          layer = &candidate;
      const State state =
        advanced(layer->state, ply, (z - layer->bottom) / unit);

      const Coefficients  &m   = coefficients[ply];
      const double         sin = std::sin(p * y), cos = std::cos(p * y);
      const double         strain = traction / (modulus * alpha * alpha);
      const double         E      = strain * state[0];
      const double         N      = traction * state[3];
      const double         eps_zz = N / m.c33 - m.nu * E;
      dealii::Tensor<1, 3> u;
      u[1] = -E / p * cos;
      u[2] = -strain * state[1] / (alpha * p) * sin;
      Voigt stress;
      stress[0] = (m.c12 * E + m.c13 * eps_zz) * sin;
      stress[1] = (m.Q * E + m.nu * N) * sin;
      stress[2] = N * sin;
      stress[5] = traction * state[2] / alpha * cos;
      return {u, stress};
    }

  private:
    /// {e, k, t, n}.
    using State = dealii::Tensor<1, 4>;

    /// Of a ply: entries of C, x, y, z being 1, 2, 3, and A.
    struct Coefficients
    {
      double               c12, c13, c22, c33, G, nu, Q;
      dealii::Tensor<2, 4> A;
    };

    /// A part of a ply with the state at its bottom.
    struct Layer
    {
      unsigned int ply;
      double       bottom, top;
      State        state;
    };

    void
    make_coefficients()
    {
      modulus = 0.;
      for (const Ply &ply : plies)
        modulus = std::max(modulus, ply.stiffness()[1][1]);
      const double a2 = alpha * alpha;
      for (const Ply &ply : plies)
        {
          const ElasticTensor C = ply.stiffness();
          for (const unsigned int i : {0, 1, 2, 5})
            for (const unsigned int j : {3, 4})
              AssertThrow(std::abs(C[i][j]) < 1e-12 * modulus,
                          dealii::ExcMessage("Plies of 0 or 90 degrees only"));
          Coefficients m;
          m.c12     = C[0][1];
          m.c13     = C[0][2];
          m.c22     = C[1][1];
          m.c33     = C[2][2];
          m.G       = C[5][5];
          m.nu      = C[1][2] / C[2][2];
          m.Q       = C[1][1] - C[1][2] * m.nu;
          m.A[0][1] = -1.;
          m.A[0][2] = -a2 * modulus / m.G;
          m.A[1][0] = a2 * m.nu;
          m.A[1][3] = -a2 * a2 * modulus / m.c33;
          m.A[2][0] = -m.Q / modulus;
          m.A[2][3] = -a2 * m.nu;
          m.A[3][2] = 1.;
          coefficients.push_back(m);
        }
    }

    void
    make_layers()
    {
      for (unsigned int i = 0; i < plies.size(); ++i)
        {
          const Coefficients &m = coefficients[i];
          const double lambda = p * std::sqrt(std::abs(m.Q / m.G - 2. * m.nu) +
                                              std::sqrt(m.c22 / m.c33));
          const double thickness = plies[i].top - plies[i].bottom;
          const unsigned int n =
            1 + static_cast<unsigned int>(lambda * thickness);
          for (unsigned int k = 0; k < n; ++k)
            layers.push_back({i,
                              plies[i].bottom + thickness * k / n,
                              plies[i].bottom + thickness * (k + 1) / n,
                              State()});
        }
    }

    /// exp(A distance) state. No exponent exceeds 1, so 30 terms are plenty
    /// (1 / 30! = 4e-33).
    State
    advanced(const State       &state,
             const unsigned int ply,
             const double       distance) const
    {
      State sum = state, term = state;
      for (unsigned int k = 1; k <= 30; ++k)
        {
          term = (distance / k) * (coefficients[ply].A * term);
          sum += term;
        }
      return sum;
    }

    /// The states from the system of all interfaces.
    void
    solve()
    {
      const unsigned int               n = layers.size();
      dealii::LAPACKFullMatrix<double> matrix(4 * n + 4);
      dealii::Vector<double>           states(4 * n + 4);
      // t and n below and on top, where only n does not vanish.
      matrix(0, 2)                 = 1.;
      matrix(1, 3)                 = 1.;
      matrix(4 * n + 2, 4 * n + 2) = 1.;
      matrix(4 * n + 3, 4 * n + 3) = 1.;
      states[4 * n + 3]            = 1.;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 4; ++c)
          {
            State start;
            start[c] = 1.;
            const State end =
              advanced(start,
                       layers[i].ply,
                       (layers[i].top - layers[i].bottom) / unit);
            for (unsigned int r = 0; r < 4; ++r)
              matrix(4 * i + 2 + r, 4 * i + c) = end[r];
            matrix(4 * i + 2 + c, 4 * i + 4 + c) = -1.;
          }
      matrix.compute_lu_factorization();
      matrix.solve(states);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < 4; ++c)
          layers[i].state[c] = states[4 * i + c];
    }

    std::vector<Ply>          plies;
    double                    L, traction;
    double                    p, unit, alpha, modulus;
    std::vector<Coefficients> coefficients;
    std::vector<Layer>        layers;
  };
} // namespace lamella

#endif
