// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/interface_solver.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

// Primal-dual interior point method for contact with Coulomb friction (Nocedal
// and Wright, Numerical Optimization, Springer 2006, Ch. 16 and 19). Each step:
// 1. evaluate(): bounds b = mu lambda_n of the iterate, residuals;
// 2. stiffness(): D of each point, one symmetric factorization;
// 3. direction() with sigma = 0 (predictor), which gives sigma, and again with
//    sigma and the second-order term (corrector);
// 4. longest_step(): both keep s, lambda_n, gamma and b - |lambda_t| positive.
//
// Elimination of s and lambda_n from v_n = s, s lambda_n = sigma gives
//   D_n = lambda_n / (s + d lambda_n),
// and of gamma and lambda_t from the tangential equations, with w = b^2 -
// |lambda_t|^2,
//   D_t = ((gamma + d) 1 + (2 gamma / w) lambda_t lambda_t^T)^-1.
// Lengths are scaled by the root of InterfacePoints::stiffness, and forces by
// its inverse, so that normal and tangential direction, and points of different
// compliance, are commensurable.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    double
    mean(const std::vector<double> &values)
    {
      return values.empty() ?
               0. :
               std::accumulate(values.begin(), values.end(), 0.) /
                 values.size();
    }



    // A few points with a small bound have products far above the others.
    double
    median(std::vector<double> values)
    {
      if (values.empty())
        return 0.;
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    }



    Tensor<1, 2>
    shear_of(const Tensor<1, 3> &force)
    {
      return Tensor<1, 2>({force[1], force[2]});
    }



    /// Newton direction of the unknowns of all points.
    struct Direction
    {
      PointVectors        force;
      std::vector<double> slack, gamma;
    };



    class InteriorPoint
    {
    public:
      InteriorPoint(InterfaceSystem               &system,
                    const InterfacePoints         &points,
                    const InteriorPointParameters &parameters)
        : system(system)
        , points(points)
        , parameters(parameters)
        , n(points.law.size())
        , has_shear(n, false)
      {
        for (const auto &[normal, tangential] : points.stiffness)
          unit.push_back(Tensor<1, 3>(
            {std::sqrt(normal), std::sqrt(tangential), std::sqrt(tangential)}));
      }

      PointVectors
      solve(const Monitor &monitor)
      {
        // Rounding errors of the products end their decrease.
        constexpr double slow = 0.5, small = arithmetic::rounding_of_solutions;
        constexpr unsigned int patience = 5;
        begin();
        unsigned int idle  = 0;
        double       least = 1.;
        for (unsigned int k = 0;
             force_scale > 0. && k < parameters.max_iterations;
             ++k)
          {
            evaluate(k == 0);
            const double left = normal_product / (length_scale * force_scale);
            idle  = left < small && left > slow * least ? idle + 1 : 0;
            least = std::min(least, left);
            if (left <= parameters.tolerance || idle == patience)
              break;
            step();
            monitor(round());
          }
        complete();
        return unscaled(force);
      }

    private:
      /// Returns true for tied points.
      bool
      holds(const unsigned int i) const
      {
        return points.law[i]->is_bilateral();
      }

      /// Returns the spring of point @p i at the starting point, and its force
      /// at the gap and slips @p v.
      // Springs of stiffness k, a fraction of the local stiffness of the
      // bodies, push penetrating points apart with k max(0, -v_n).
      std::pair<SymmetricTensor<2, 3>, Tensor<1, 3>>
      first_spring(const unsigned int i, const Tensor<1, 3> &v) const
      {
        if (holds(i))
          return {stiffness_of_tie(i), -(stiffness_of_tie(i) * v)};
        std::pair<SymmetricTensor<2, 3>, Tensor<1, 3>> spring;
        for (unsigned int c = 0; c < 3; ++c)
          {
            spring.first[c][c] = points.spring[i] / (unit[i][0] * unit[i][0]);
            spring.second[c]   = points.about[i][c] / unit[i][c];
          }
        spring.second[0] += spring.first[0][0] * std::max(0., -v[0]);
        return spring;
      }

      /// Sets the starting point: all points connected by soft springs.
      void
      begin()
      {
        PointVectors   pushed(n);
        PointStiffness springs(n);
        PointVectors   v = gaps();
        for (unsigned int i = 0; i < n; ++i)
          std::tie(springs[i], pushed[i]) = first_spring(i, v[i]);
        factorize(springs);
        const PointVectors moved = solution(pushed);
        system.advance(1.);
        v = gaps();
        force.assign(n, {});
        for (unsigned int i = 0; i < n; ++i)
          {
            force[i] = pushed[i] - springs[i] * moved[i];
            if (holds(i))
              continue;
            length_scale = std::max(length_scale, std::abs(v[i][0]));
            force_scale  = std::max(force_scale, force[i][0]);
          }
        for (unsigned int i = 0; i < n; ++i)
          {
            const double least = parameters.first_gap * length_scale;
            if (!holds(i))
              force[i] =
                Tensor<1, 3>({parameters.first_force * force_scale, 0., 0.});
            slack.push_back(std::max(v[i][0], least));
            gamma.push_back(least / force[i][0]);
          }
      }

      /// Updates the bounds, removes opening points from the tangential
      /// problem, and evaluates the residuals.
      // Points that open leave the tangential problem: their small bounds would
      // shorten all steps.
      void
      evaluate(const bool is_first)
      {
        constexpr double   least = arithmetic::rounding;
        const double       last  = normal_product;
        const PointVectors v     = gaps();
        residual.assign(n, {});
        bound.assign(n, 0.);
        room.assign(n, 0.);
        std::vector<double> normal, shear;
        for (unsigned int i = 0; i < n; ++i)
          {
            if (holds(i))
              {
                residual[i] = v[i] + invert(stiffness_of_tie(i)) * force[i];
                continue;
              }
            const bool had_shear = has_shear[i];
            has_shear[i] =
              points.n_slips[i] > 0 &&
              (is_first || force[i][0] * length_scale >
                             parameters.opening * slack[i] * force_scale);
            bound[i] =
              std::max(points.law[i]->bound(unit[i][0] * force[i]).value /
                         unit[i][1],
                       least * force_scale);
            if (!has_shear[i])
              {
                force[i] -= tangential_part(force[i]);
                gamma[i] = last / bound[i];
              }
            else
              follow_bound(i, inside * bound[i], had_shear || is_first, v[i]);
            room[i] =
              bound[i] * bound[i] - tangential_part(force[i]).norm_square();
            Tensor<1, 3> lengths = v[i];
            for (unsigned int c = 0; c < 3; ++c)
              lengths[c] += compliance(i, c) * force[i][c];
            residual[i][0] = lengths[0] - slack[i];
            normal.push_back(slack[i] * force[i][0]);
            if (has_shear[i])
              {
                residual[i] += tangential_part(lengths + gamma[i] * force[i]);
                shear.push_back(gamma[i] * room[i] / bound[i]);
              }
          }
        normal_product = mean(normal);
        shear_product  = median(shear);
      }

      /// Limits the shear force of point @p i to @p most; it opposes the slip
      /// in
      /// @p v if the point had no shear force before.
      // gamma lambda_t = -v_t stays where the bound decreases below the shear
      // force, as the slip does: this makes the last steps superlinear.
      void
      follow_bound(const unsigned int          i,
                   const double                most,
                   const bool                  had_shear,
                   const dealii::Tensor<1, 3> &v)
      {
        const double size = tangential_norm(force[i]),
                     slip = tangential_norm(v);
        if (!had_shear && slip > 0.)
          {
            force[i] -= tangential_part(force[i] + most / slip * v);
            gamma[i] = slip / most;
          }
        else if (size > most)
          {
            force[i] += (most / size - 1.) * tangential_part(force[i]);
            gamma[i] *= size / most;
          }
      }

      /// Returns gaps and slips of the iterate less InterfacePoints::shift.
      PointVectors
      gaps() const
      {
        PointVectors v = system.lengths();
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            v[i][c] = (v[i][c] - points.shift[i][c]) * unit[i][c];
        return v;
      }

      /// Calls InterfaceSystem::factorize() for the stiffness @p D, and
      /// solve().
      void
      factorize(PointStiffness D)
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b <= a; ++b)
              D[i][a][b] *= unit[i][a] * unit[i][b];
        system.factorize(D);
      }

      PointVectors
      solution(const PointVectors &force)
      {
        return unscaled(system.solve(unscaled(force)));
      }

      /// Returns the forces @p scaled, without scale.
      PointVectors
      unscaled(PointVectors scaled) const
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            scaled[i][c] *= unit[i][c];
        return scaled;
      }

      /// Returns the scaled stiffness of the tied point @p i: a penalty, as the
      /// forces are a starting point only.
      SymmetricTensor<2, 3>
      stiffness_of_tie(const unsigned int i) const
      {
        constexpr double      compliance_of_tie = 1e-3;
        SymmetricTensor<2, 3> D;
        for (unsigned int c = 0; c < 3; ++c)
          D[c][c] = 1. / (compliance_of_tie + compliance(i, c));
        return D;
      }

      PointStiffness
      stiffness() const
      {
        PointStiffness D(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            if (holds(i))
              {
                D[i] = stiffness_of_tie(i);
                continue;
              }
            const double d = compliance(i, 0), lambda = force[i][0];
            D[i][0][0] = lambda / (slack[i] + d * lambda);
            if (!has_shear[i])
              continue;
            const Tensor<1, 2>          shear  = shear_of(force[i]);
            const SymmetricTensor<2, 2> across = invert(
              (gamma[i] + compliance(i, 1)) * unit_symmetric_tensor<2>() +
              2. * gamma[i] / room[i] *
                symmetrize(outer_product(shear, shear)));
            for (unsigned int a = 0; a < points.n_slips[i]; ++a)
              for (unsigned int b = 0; b <= a; ++b)
                D[i][1 + a][1 + b] = across[a][b];
          }
        return D;
      }

      /// Products to which a Newton direction leads, and second-order terms of
      /// the normal products (empty: none).
      struct Target
      {
        double              normal, shear;
        std::vector<double> correction;
      };

      /// Returns the change of the force of point @p i towards @p target if gap
      /// and slips do not change; @p q is that of the tangential equations.
      Tensor<1, 3>
      change_at_rest(const unsigned int           i,
                     const SymmetricTensor<2, 3> &D,
                     const Target                &target,
                     const double                 q) const
      {
        if (holds(i))
          return -(D * residual[i]);
        Tensor<1, 3> change;
        if (has_shear[i])
          change = -(D * tangential_part(residual[i] + q * force[i]));
        const double lambda = force[i][0], s = slack[i];
        change[0] = (target.normal - s * lambda - lambda * residual[i][0] -
                     (target.correction.empty() ? 0. : target.correction[i])) /
                    (s + compliance(i, 0) * lambda);
        return change;
      }

      /// Returns the Newton direction to @p target.
      // The forces follow from the change w of gap and slips by
      //   dlambda_n = (sigma - s lambda_n - lambda_n (v_n - s)) / (s + d
      //               lambda_n) - D_n w_n,
      //   dlambda_t = -D_t (v_t + gamma lambda_t + q lambda_t + w_t),
      //   q         = (sigma b - gamma w) / w.
      Direction
      direction(const PointStiffness &D, const Target &target)
      {
        Direction           step;
        std::vector<double> q(n, 0.);
        PointVectors        next = force;
        for (unsigned int i = 0; i < n; ++i)
          {
            if (has_shear[i])
              q[i] = target.shear * bound[i] / room[i] - gamma[i];
            step.force.push_back(change_at_rest(i, D[i], target, q[i]));
            next[i] += step.force[i];
          }
        const PointVectors w = solution(next);
        for (unsigned int i = 0; i < n; ++i)
          {
            step.force[i] -= D[i] * w[i];
            step.slack.push_back(
              holds(i) ?
                0. :
                w[i][0] + compliance(i, 0) * step.force[i][0] + residual[i][0]);
            step.gamma.push_back(
              has_shear[i] ?
                q[i] + 2. * gamma[i] / room[i] *
                         (shear_of(force[i]) * shear_of(step.force[i])) :
                0.);
          }
        return step;
      }

      /// Returns the largest step up to 1 that stays within the feasible set.
      // |lambda_t + t dlambda_t| < b is a quadratic inequality in t.
      double
      longest_step(const Direction &step) const
      {
        double     longest = 1. / parameters.to_boundary;
        const auto limit   = [&](const double x, const double change) {
          if (change < 0.)
            longest = std::min(longest, -x / change);
        };
        for (unsigned int i = 0; i < n; ++i)
          {
            if (holds(i))
              continue;
            limit(force[i][0], step.force[i][0]);
            limit(slack[i], step.slack[i]);
            limit(gamma[i], step.gamma[i]);
            const Tensor<1, 2> change = shear_of(step.force[i]);
            const double       a      = change.norm_square(),
                         b            = shear_of(force[i]) * change;
            if (a > 0. && has_shear[i])
              longest =
                std::min(longest, (-b + std::sqrt(b * b + a * room[i])) / a);
          }
        return parameters.to_boundary * longest;
      }

      /// Takes one step of Mehrotra's method.
      // Mehrotra's predictor and corrector with one factorization. The
      // second-order term is used for normal products only.
      void
      step()
      {
        constexpr double short_step = 0.1, least_sigma = 1e-4, blocked = 0.05;
        const PointStiffness D = stiffness();
        factorize(D);
        const Direction     predictor = direction(D, {0., 0., {}});
        const double        reach     = longest_step(predictor);
        std::vector<double> products, correction;
        for (unsigned int i = 0; i < n; ++i)
          {
            if (holds(i))
              {
                if (reach > short_step)
                  correction.push_back(0.);
                continue;
              }
            products.push_back((slack[i] + reach * predictor.slack[i]) *
                               (force[i][0] + reach * predictor.force[i][0]));
            if (reach > short_step)
              correction.push_back(reach * reach * predictor.slack[i] *
                                   predictor.force[i][0]);
          }
        const double sigma =
          reach > blocked ?
            std::max(std::pow(mean(products) / normal_product, 3),
                     least_sigma) :
            0.5;
        const Direction corrector = direction(
          D, {sigma * normal_product, sigma * shear_product, correction});
        const double length = longest_step(corrector);
        system.advance(length);
        for (unsigned int i = 0; i < n; ++i)
          {
            force[i] += length * corrector.force[i];
            slack[i] += length * corrector.slack[i];
            gamma[i] += length * corrector.gamma[i];
          }
      }

      /// Returns the scaled compliance of point @p i in component @p c.
      double
      compliance(const unsigned int i, const unsigned int c) const
      {
        return points.compliance[i][c] * unit[i][c] * unit[i][c];
      }
      bool
      is_closed(const unsigned int i) const
      {
        return holds(i) || force[i][0] * length_scale > slack[i] * force_scale;
      }
      /// Completes the states of the last iterate: open points get no force,
      /// slipping points the shear force of the bound, from which all iterates
      /// keep a small distance.
      // Newton's method takes a slipping point with less than its bound for a
      // sticking one if its slip is small.
      void
      complete()
      {
        for (unsigned int i = 0; i < n; ++i)
          if (!is_closed(i))
            force[i] = {};
          else if (has_shear[i] &&
                   tangential_norm(force[i]) > inside * inside * bound[i])
            force[i] += (bound[i] / tangential_norm(force[i]) - 1.) *
                        tangential_part(force[i]);
      }

      Round
      round() const
      {
        Round result;
        for (unsigned int i = 0; i < n; ++i)
          result.active += is_closed(i);
        result.counts = false;
        result.changed.push_back(0);
        result.violation = (normal_product + shear_product) / force_scale;
        return result;
      }

      /// Largest shear force of an iterate over its bound.
      static constexpr double inside = 0.995;

      InterfaceSystem              &system;
      const InterfacePoints        &points;
      const InteriorPointParameters parameters;
      const unsigned int            n;
      /// Root of the stiffness of each point, to which lengths and inverse
      /// forces are scaled.
      std::vector<Tensor<1, 3>> unit;
      /// Length and force scale of the scaled problem.
      double length_scale = 0., force_scale = 0.;

      // ---- the iterate
      PointVectors force;
      /// Slack s and multiplier gamma of each point.
      std::vector<double> slack, gamma;

      // ---- derived from it by evaluate()
      /// True for points with a tangential problem.
      std::vector<bool> has_shear;
      /// Bound b of the shear force, and w = b^2 - |lambda_t|^2.
      std::vector<double> bound, room;
      /// Residuals v_n - s and v_t + gamma lambda_t.
      PointVectors residual;
      /// Mean of the products s lambda_n, and median of gamma w / b.
      double normal_product = 0., shear_product = 0.;
    };
  } // namespace



  PointVectors
  solve_by_interior_point(InterfaceSystem               &system,
                          const InterfacePoints         &points,
                          const Monitor                 &monitor,
                          const InteriorPointParameters &parameters)
  {
    return InteriorPoint(system, points, parameters).solve(monitor);
  }
} // namespace lamella
