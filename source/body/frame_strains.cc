// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/frame_strains.h>

#include <boost/math/quaternion.hpp>

#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Number = boost::math::quaternion<double>;

    Number
    number(const Quaternion &q)
    {
      return Number(q[0], q[1], q[2], q[3]);
    }

    Number
    number(const Tensor<1, 3> &v)
    {
      return Number(0., v[0], v[1], v[2]);
    }

    Quaternion
    components(const Number &q)
    {
      return Quaternion({q.R_component_1(),
                         q.R_component_2(),
                         q.R_component_3(),
                         q.R_component_4()});
    }

    Number
    unit(const unsigned int a)
    {
      Quaternion q;
      q[a] = 1.;
      return number(q);
    }



    /// Coefficients of forms in the components of quaternions.
    using Form = Tensor<2, 4>;

    struct Forms
    {
      Forms()
      {
        for (unsigned int a = 0; a < 4; ++a)
          for (unsigned int b = 0; b < 4; ++b)
            {
              const Quaternion turned = components(conj(unit(a)) * unit(b));
              for (unsigned int i = 0; i < 3; ++i)
                curvature[i][a][b] = 2. * turned[1 + i];
              for (unsigned int j = 0; j < 3; ++j)
                {
                  const Quaternion v =
                    components(unit(a) * unit(1 + j) * conj(unit(b)));
                  for (unsigned int i = 0; i < 3; ++i)
                    {
                      rotation[i][j][a][b] += v[1 + i] / 2.;
                      rotation[i][j][b][a] += v[1 + i] / 2.;
                    }
                }
            }
        for (unsigned int j = 0; j < 3; ++j)
          tilt[j] = rotation[1][j];
        for (unsigned int a = 0; a < 4; ++a)
          tilt[1][a][a] -= 1.;
      }

      /// (R e_j)_i |Q|^2 = Q . rotation[i][j] Q, symmetric.
      std::array<std::array<Form, 3>, 3> rotation;
      /// kappa_i |Q|^2 = Q . curvature[i] Q'.
      std::array<Form, 3> curvature;
      /// ((R^T - 1) e_y)_j |Q|^2 = Q . tilt[j] Q, symmetric.
      std::array<Form, 3> tilt;
    };



    const Forms &
    forms()
    {
      static const Forms all;
      return all;
    }



    /// Divides the functions @p of, and derivatives up to @p order, by |Q|^2.
    template <unsigned int n_functions, int n>
    void
    divide_by_square(const Quaternion            &Q,
                     const unsigned int           order,
                     Derivatives<n_functions, n> &of)
    {
      const double square = Q.norm_square();
      Tensor<1, n> d;
      for (unsigned int a = 0; a < 4; ++a)
        d[a] = 2. * Q[a];
      for (unsigned int k = 0; k < n_functions; ++k)
        {
          of.value[k] /= square;
          if (order == 0)
            continue;
          of.first[k] = (of.first[k] - of.value[k] * d) / square;
          if (order == 1)
            continue;
          for (unsigned int a = 0; a < 4; ++a)
            of.second[k][a][a] -= 2. * of.value[k];
          of.second[k] -=
            outer_product(of.first[k], d) + outer_product(d, of.first[k]);
          of.second[k] /= square;
        }
    }



    /// Adds @p factor times the product of strains @p a and @p b to @p to, with
    /// derivatives up to @p order.
    void
    add_product(const unsigned int to,
                const double       factor,
                const unsigned int a,
                const unsigned int b,
                const unsigned int order,
                FrameStrains      &e)
    {
      e.value[to] += factor * e.value[a] * e.value[b];
      if (order > 0)
        e.first[to] +=
          factor * (e.value[a] * e.first[b] + e.value[b] * e.first[a]);
      if (order < 2)
        return;
      e.second[to] +=
        factor * (e.value[a] * e.second[b] + e.value[b] * e.second[a] +
                  outer_product(e.first[a], e.first[b]) +
                  outer_product(e.first[b], e.first[a]));
    }



    /// Places of Q' and r' among the variables of frame_strains().
    constexpr unsigned int of_dQ = 4, of_dr = 8;



    /// With what shear and twist stretch fibers by.
    FrameStrains
    add_fiber_tilt(FrameStrains e, const unsigned int order)
    {
      constexpr unsigned int G_x = 0, G_y = 1, G_z = 2, k_x = 3, k_y = 4,
                             k_z = 5, half_square_of_k_y = 6;
      add_product(G_y, 0.5, G_x, G_x, order, e);
      add_product(G_y, 0.5, G_z, G_z, order, e);
      add_product(k_x, -1., k_y, G_x, order, e);
      add_product(k_z, -1., k_y, G_z, order, e);
      add_product(half_square_of_k_y, 0.5, k_y, k_y, order, e);
      return e;
    }
  } // namespace



  Quaternion
  quaternion_of(const Tensor<1, 3> &theta)
  {
    return components(exp(0.5 * number(theta)));
  }



  Tensor<1, 3>
  rotation_vector_of(const Quaternion &q)
  {
    Tensor<1, 3> v;
    for (unsigned int i = 0; i < 3; ++i)
      v[i] = q[0] < 0. ? -q[1 + i] : q[1 + i];
    const double sine = v.norm();
    // angle / sine, which has the limit 2 at no rotation.
    return sine > 0. ? 2. * std::atan2(sine, std::abs(q[0])) / sine * v : v;
  }



  Quaternion
  compose_rotations(const Quaternion &a, const Quaternion &b)
  {
    return components(number(a) * number(b));
  }



  std::array<Tensor<1, 3>, 4>
  spin_derivative(const Quaternion &q)
  {
    std::array<Tensor<1, 3>, 4> result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Quaternion by = components(0.5 * (unit(1 + i) * number(q)));
        for (unsigned int a = 0; a < 4; ++a)
          result[a][i] = by[a];
      }
    return result;
  }



  Tensor<2, 3>
  rotation_of(const Quaternion &Q)
  {
    Tensor<2, 3> R;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        R[i][j] = Q * (forms().rotation[i][j] * Q) / Q.norm_square();
    return R;
  }



  FrameStrains
  frame_strains(const Quaternion   &Q,
                const Quaternion   &dQ,
                const Tensor<1, 3> &dr,
                const unsigned int  order)
  {
    FrameStrains e;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Form A = forms().tilt[j];
        for (unsigned int i = 0; i < 3; ++i)
          A += dr[i] * forms().rotation[i][j];
        const Quaternion AQ  = A * Q;
        e.value[j]           = Q * AQ;
        const Quaternion KdQ = forms().curvature[j] * dQ,
                         QK  = Q * forms().curvature[j];
        e.value[3 + j]       = Q * KdQ;
        for (unsigned int a = 0; a < 4 && order > 0; ++a)
          {
            e.first[j][a]             = 2. * AQ[a];
            e.first[3 + j][a]         = KdQ[a];
            e.first[3 + j][of_dQ + a] = QK[a];
            for (unsigned int b = 0; b < 4; ++b)
              {
                e.second[j][a][b]             = 2. * A[a][b];
                e.second[3 + j][a][of_dQ + b] = forms().curvature[j][a][b];
                e.second[3 + j][of_dQ + b][a] = forms().curvature[j][a][b];
              }
          }
        for (unsigned int i = 0; i < 3 && order > 0; ++i)
          {
            const Quaternion RQ   = forms().rotation[i][j] * Q;
            e.first[j][of_dr + i] = Q * RQ;
            for (unsigned int a = 0; a < 4; ++a)
              e.second[j][a][of_dr + i] = e.second[j][of_dr + i][a] =
                2. * RQ[a];
          }
      }
    divide_by_square(Q, order, e);
    return add_fiber_tilt(e, order);
  }



  RotatedVector
  rotated_vector(const Quaternion &Q, const Tensor<1, 3> &v)
  {
    constexpr unsigned int of_v = 4;
    RotatedVector          x;
    for (unsigned int i = 0; i < 3; ++i)
      {
        Form A;
        for (unsigned int j = 0; j < 3; ++j)
          {
            A += v[j] * forms().rotation[i][j];
            const Quaternion RQ  = forms().rotation[i][j] * Q;
            x.first[i][of_v + j] = Q * RQ;
            for (unsigned int a = 0; a < 4; ++a)
              x.second[i][a][of_v + j] = x.second[i][of_v + j][a] = 2. * RQ[a];
          }
        const Quaternion AQ = A * Q;
        x.value[i]          = Q * AQ;
        for (unsigned int a = 0; a < 4; ++a)
          {
            x.first[i][a] = 2. * AQ[a];
            for (unsigned int b = 0; b < 4; ++b)
              x.second[i][a][b] = 2. * A[a][b];
          }
      }
    divide_by_square(Q, 2, x);
    return x;
  }
} // namespace lamella
