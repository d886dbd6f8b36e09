// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/linear/dense_cholesky.h>
#include <lamella/solve/cone_minimum.h>

#include <algorithm>
#include <cmath>
#include <memory>

// Second-order cone program by a primal-dual interior-point method (Andersen,
// Roos and Terlaky, Math. Program. 95 (2003) 249-277). Per iteration:
// 1. Nesterov-Todd scaling T of each cone, T z = T^-1 x = lambda (Math. Oper.
//    Res. 22 (1997) 1-42);
// 2. one Cholesky factor of W + diag(T^-2);
// 3. affine direction, centering and second-order correction (Mehrotra);
// 4. a step of 0.99 of the way to the boundary of the cones.
// The optimality conditions are z = W x + q, x o z = 0, x and z in the cones.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int most_cone_steps = 60;
    /// Tolerances of x . z over the sizes of both, and of z - W x - q.
    constexpr double enough = 1e-11;
    /// Share of the way to the cones' boundary, least and longest step.
    constexpr double almost = 0.99, no_step = 1e-8, longest_step = 1e3;



    // ---- the algebra of a cone: x o y = (x . y, x_n y_t + y_n x_t)

    // det x = x_n^2 - |x_t|^2, bounded from below for divisions.
    double
    determinant(const Tensor<1, 3> &x)
    {
      const double t = tangential_norm(x);
      return std::max((x[0] - t) * (x[0] + t), arithmetic::smallest_divisor);
    }



    Tensor<1, 3>
    product(const Tensor<1, 3> &x, const Tensor<1, 3> &y)
    {
      Tensor<1, 3> result = x[0] * y + y[0] * x;
      result[0]           = x * y;
      return result;
    }



    /// Returns the y with x o y = @p right (arrow matrix of x, inverted).
    Tensor<1, 3>
    quotient(const Tensor<1, 3> &right, const Tensor<1, 3> &x)
    {
      const double along = tangential_part(x) * right;
      Tensor<1, 3> result;
      const double normal = (x[0] * right[0] - along) / determinant(x);
      result              = (right - normal * x) / x[0];
      result[0]           = normal;
      return result;
    }



    /// Returns the longest step from @p x along @p d within the cone: the
    /// smallest positive root of det(x + t d) = 0.
    double
    step_within(const Tensor<1, 3> &x, const Tensor<1, 3> &d)
    {
      // det(x + t d) = a t^2 + 2 b t + c.
      const double t = tangential_norm(d), a = (d[0] - t) * (d[0] + t),
                   c = determinant(x), b = x[0] * d[0] - tangential_part(x) * d,
                   root = b * b - a * c;
      double step       = longest_step;
      if (root >= 0. && b < 0.)
        step = std::min(step, c / (-b + std::sqrt(root)));
      else if (root >= 0. && a < 0.)
        step = std::min(step, (b + std::sqrt(root)) / -a);
      if (d[0] < 0.)
        step = std::min(step, -x[0] / d[0]);
      return step;
    }



    /// Nesterov-Todd scaling point of one cone: the symmetric T with T z = T^-1
    /// x, from the mean w of the normalized x and the reflected z.
    struct Scaling
    {
      Scaling(const Tensor<1, 3> &x, const Tensor<1, 3> &z)
      {
        const double det_x        = std::sqrt(determinant(x)),
                     det_z        = std::sqrt(determinant(z)),
                     size         = std::sqrt(det_x / det_z);
        const Tensor<1, 3> unit_x = x / det_x;
        Tensor<1, 3>       unit_z = z / det_z;
        const double       gamma  = std::sqrt((1. + unit_x * unit_z) / 2.);
        unit_z *= -1.;
        unit_z[0] *= -1.;
        const Tensor<1, 3> w = (unit_x + unit_z) / (2. * gamma);
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            {
              const bool   mixed = (c == 0) != (d == 0);
              const double entry =
                c == 0 || d == 0 ?
                  w[std::max(c, d)] :
                  (c == d ? 1. : 0.) + w[c] * w[d] / (1. + w[0]);
              T[c][d]       = size * entry;
              inverse[c][d] = (mixed ? -entry : entry) / size;
            }
      }

      Tensor<2, 3> T, inverse;
    };



    /// x in the cones and z = W x + q in their (self-)duals, or their change.
    struct ConePair
    {
      PointVectors x, z;
    };



    /// One Newton system of the method.
    class Directions
    {
    public:
      Directions(const PointCompliance &W,
                 const PointVectors    &q,
                 const ConePair        &at)
        : W(W)
        , residual(W.times(at.x))
      {
        PointCompliance sum = W;
        for (unsigned int i = 0; i < W.n_points(); ++i)
          {
            residual[i] += q[i] - at.z[i];
            scalings.emplace_back(at.x[i], at.z[i]);
            lambda.push_back(scalings[i].T * at.z[i]);
            squares.push_back(scalings[i].inverse * scalings[i].inverse);
            for (unsigned int c = 0; c < W.size(i); ++c)
              for (unsigned int d = 0; d < W.size(i); ++d)
                sum(W.first[i] + c, W.first[i] + d) += squares[i][c][d];
          }
        factor =
          std::make_unique<const DenseCholesky>(std::move(sum.matrix),
                                                W.n_rows(),
                                                "The compliance of the points");
      }

      /// Returns the direction to lambda o lambda + @p right = 0,
      /// complementarity in the scaled cones, and W x + q = z.
      ConePair
      towards(const PointVectors &right) const
      {
        ConePair d;
        for (unsigned int i = 0; i < W.n_points(); ++i)
          d.z.push_back(scalings[i].inverse * quotient(right[i], lambda[i]));
        PointVectors load = d.z;
        for (unsigned int i = 0; i < W.n_points(); ++i)
          load[i] -= residual[i];
        // With dz = T^-1 quotient(right, lambda) - T^-2 dx eliminated:
        //   (W + T^-2) dx = T^-1 quotient(right, lambda) - residual.
        std::vector<double> rows = W.by_rows(load);
        factor->solve(rows);
        d.x = W.by_points(rows);
        for (unsigned int i = 0; i < W.n_points(); ++i)
          d.z[i] -= squares[i] * d.x[i];
        return d;
      }

      /// Returns -lambda o lambda, the right side of the predictor.
      PointVectors
      affine() const
      {
        PointVectors right;
        for (const Tensor<1, 3> &point : lambda)
          right.push_back(-1. * product(point, point));
        return right;
      }

      /// Returns the second-order error of @p d, (T^-1 dx) o (T dz).
      Tensor<1, 3>
      correction(const unsigned int point, const ConePair &d) const
      {
        return product(scalings[point].inverse * d.x[point],
                       scalings[point].T * d.z[point]);
      }

      /// The largest of W x + q - z.
      double
      error() const
      {
        return largest_component(residual);
      }

    private:
      const PointCompliance               &W;
      PointVectors                         residual, lambda;
      std::vector<Scaling>                 scalings;
      std::vector<Tensor<2, 3>>            squares;
      std::unique_ptr<const DenseCholesky> factor;
    };



    /// The longest step, at most one, along @p d in all cones.
    /// Ratio test over all cones, at most a full step.
    double
    step_within(const ConePair &at, const ConePair &d, const double share)
    {
      double step = longest_step;
      for (unsigned int i = 0; i < at.x.size(); ++i)
        step = std::min(
          {step, step_within(at.x[i], d.x[i]), step_within(at.z[i], d.z[i])});
      return std::min(1., share * step);
    }



    void
    move(ConePair &at, const ConePair &d, const double step)
    {
      for (unsigned int i = 0; i < at.x.size(); ++i)
        {
          at.x[i] += step * d.x[i];
          at.z[i] += step * d.z[i];
        }
    }



    /// Starting point on the axes of all cones, scaled by |W|_1 and |q|.
    ConePair
    first_pair(const PointCompliance &W, const PointVectors &q)
    {
      double sum = 0.;
      for (unsigned int j = 0; j < W.n_rows(); ++j)
        {
          double column = 0.;
          for (unsigned int i = 0; i < W.n_rows(); ++i)
            column += std::abs(W(i, j));
          sum = std::max(sum, column);
        }
      Tensor<1, 3> center;
      center[0] = 1.;
      return {PointVectors(W.n_points(), center / sum),
              PointVectors(W.n_points(),
                           std::max(1., largest_component(q)) * center)};
    }



    /// One step of Mehrotra's method; returns its length.
    double
    cone_step(const Directions &directions, const double mean, ConePair &at)
    {
      const PointVectors affine = directions.affine();
      const ConePair     newton = directions.towards(affine);
      ConePair           there  = at;
      move(there, newton, step_within(at, newton, 1.));
      // Mehrotra's centering: (mu_aff / mu)^3 mu.
      const double n = at.x.size(),
                   left =
                     std::max(0., inner_product(there.x, there.z) / (n * mean));
      PointVectors right = affine;
      for (unsigned int i = 0; i < right.size(); ++i)
        {
          right[i] -= directions.correction(i, newton);
          right[i][0] += std::pow(left, 3) * mean;
        }
      const ConePair d      = directions.towards(right);
      const double   length = step_within(at, d, almost);
      move(at, d, length);
      return length;
    }
  } // namespace



  // The last finite iterate is the result if a factorization fails.
  PointVectors
  cone_minimum(const PointCompliance &W, const PointVectors &q)
  {
    ConePair at = first_pair(W, q);
    for (unsigned int k = 0; k < most_cone_steps; ++k)
      {
        const double mean = inner_product(at.x, at.z) / W.n_points(),
                     size =
                       std::max(largest_component(at.z), largest_component(q));
        const ConePair before = at;
        try
          {
            const Directions directions(W, q, at);
            if (mean < enough * size * largest_component(at.x) &&
                directions.error() < enough * size)
              break;
            if (cone_step(directions, mean, at) < no_step)
              break;
          }
        catch (const NumericsError &)
          {
            break;
          }
        if (!std::isfinite(inner_product(at.x, at.z)))
          return before.x;
      }
    return at.x;
  }
} // namespace lamella
