// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/dense_lu.h>
#include <lamella/solve/coulomb.h>
#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interior_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// Coulomb's law on a dense compliance, with the natural map (Alart and Curnier,
// Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375)
//   F(lambda) = lambda - P(lambda - v(lambda)),  v = q + W (lambda - about),
// P the projection onto the cone of lambda_n. Structure of the file:
// - CoulombSearch: the scaled problem, and the methods of the chain
//   (solve_in_sequence()): Newton, interior point, decreasing regularization;
// - solve_coulomb(): proximal points about the last forces with a small
//   regularization of W, which makes it definite (Rockafellar, SIAM J. Control
//   Optim. 14 (1976) 877-898), and the stability test by a determinant.
//
// The derivative of the projection for slip, with e = z_t / |z_t| and the bound
// b = mu z_n, is
//   d(b e) = mu e dz_n + (b / |z_t|) (1 - e e^T) dz_t,
// and d z = d lambda - d v gives the rows of linearize_slip(). Its matrix is
// not symmetric, as the friction bound depends on the normal force; solutions
// with a negative determinant lie on branches without a load path.
//
// Costs: 2/3 n^3 per Newton step for n rows of closed points; about 25 n^3 / 3
// for the interior point method.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Trial forces z = lambda - v of all points, with their friction bounds mu
    /// max(0, z_n) and states.
    struct Trial
    {
      PointVectors            z;
      std::vector<double>     bound;
      std::vector<PointState> states;
    };



    /// Forces after a Newton step, and the sign of its matrix's determinant.
    struct NewtonStep
    {
      bool         is_solved = false;
      PointVectors lambda;
      int          sign = 1;
    };



    /**
     * The problem with a unit diagonal, one scale for both tangents of a point,
     * and a largest q of one; and the ways to search for its solution.
     */
    class CoulombSearch
    {
    public:
      CoulombSearch(const CoulombProblem &problem, const CoulombRules &rules);

      /// Converts forces to units of this problem, and back.
      PointVectors
      scaled(const PointVectors &lambda) const;
      PointVectors
      unscaled(const PointVectors &lambda) const;

      /// CoulombSolution::error of @p lambda.
      double
      error(const PointVectors &lambda) const;

      Trial
      trial(const PointVectors &lambda) const;

      /// Returns the sign of the determinant of Newton's matrix at @p lambda.
      int
      sign_at(const PointVectors &lambda) const
      {
        return newton_step(trial(lambda), lambda).sign;
      }

      /// Applies the methods in sequence from @p start, in scaled forces.
      CoulombSolution
      solve_in_sequence(const PointVectors &start) const;

    private:
      /// Returns the problem regularized by @p soft about @p lambda.
      CoulombSearch
      softened(const double soft, const PointVectors &lambda) const;

      PointVectors
      moved(const PointVectors &lambda) const;

      /// lambda - P(lambda - v).
      PointVectors
      natural_map(const PointVectors &lambda) const;

      /// Solves the linear equations of the states of @p at, slip linearized.
      NewtonStep
      newton_step(const Trial &at, const PointVectors &lambda) const;

      /// Returns the best of several fractions of the step @p lambda - @p next.
      PointVectors
      shortened(const PointVectors &lambda,
                const PointVectors &next,
                const unsigned int  iteration) const;

      /// Applies Newton's method from @p lambda, at most @p most iterations,
      /// damped from @p damped_from on; returns the best forces.
      CoulombSolution
      newton(PointVectors       lambda,
             const unsigned int most,
             const unsigned int damped_from) const;

      CoulombSolution
      solve_by_interior_point() const;
      CoulombSolution
      by_compliance(const PointVectors &start) const;

      CoulombRules        rules;
      PointCompliance     W;
      PointVectors        q, about;
      std::vector<double> mu;
      /// Scale of the normal and of the tangential forces of each point.
      std::vector<std::array<double, 2>> unit;
    };



    // Symmetric diagonal scaling with one factor for both tangents of a point,
    // so that the cone stays circular; mu changes by the ratio of the scales.
    CoulombSearch::CoulombSearch(const CoulombProblem &problem,
                                 const CoulombRules   &rules)
      : rules(rules)
      , W(problem.compliance)
      , q(problem.q)
      , about(problem.about.empty() ? PointVectors(problem.q.size()) :
                                      problem.about)
      , mu(problem.friction)
      , unit(W.n_points())
    {
      double most = 0.;
      for (unsigned int r = 0; r < W.n_rows(); ++r)
        most = std::max(most, W(r, r));
      const auto scale_of = [&](const double diagonal) {
        return 1. / std::sqrt(std::max(diagonal, arithmetic::rounding * most));
      };
      std::vector<double> scales;
      for (unsigned int i = 0; i < W.n_points(); ++i)
        {
          double     tangents = 0.;
          const auto size     = W.size(i);
          for (unsigned int c = 1; c < size; ++c)
            tangents += W(W.first[i] + c, W.first[i] + c) / (size - 1);
          unit[i] = {{scale_of(W(W.first[i], W.first[i])),
                      size > 1 ? scale_of(tangents) : 1.}};
          for (unsigned int c = 0; c < size; ++c)
            scales.push_back(unit[i][c == 0 ? 0 : 1]);
          mu[i] *= size > 1 ? unit[i][0] / unit[i][1] : 0.;
        }
      for (unsigned int j = 0; j < W.n_rows(); ++j)
        for (unsigned int i = 0; i < W.n_rows(); ++i)
          W(i, j) *= scales[i] * scales[j];

      for (unsigned int i = 0; i < q.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          q[i][c] *= unit[i][c == 0 ? 0 : 1];
      const double size = largest_component(q) > 0. ? largest_component(q) : 1.;
      for (unsigned int i = 0; i < q.size(); ++i)
        {
          q[i] /= size;
          for (double &u : unit[i])
            u *= size;
        }
      about = scaled(about);
    }



    // Forces divide by the units that displacements multiply with.
    PointVectors
    CoulombSearch::scaled(const PointVectors &lambda) const
    {
      PointVectors result = lambda;
      for (unsigned int i = 0; i < result.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          result[i][c] /= unit[i][c == 0 ? 0 : 1];
      return result;
    }



    PointVectors
    CoulombSearch::unscaled(const PointVectors &lambda) const
    {
      PointVectors result = lambda;
      for (unsigned int i = 0; i < result.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          result[i][c] *= unit[i][c == 0 ? 0 : 1];
      return result;
    }



    // v = q + W (lambda - about).
    PointVectors
    CoulombSearch::moved(const PointVectors &lambda) const
    {
      PointVectors change = lambda;
      for (unsigned int i = 0; i < change.size(); ++i)
        change[i] -= about[i];
      PointVectors v = W.times(change);
      for (unsigned int i = 0; i < v.size(); ++i)
        v[i] += q[i];
      return v;
    }



    // States of the points by the return mapping of the trial forces z.
    Trial
    CoulombSearch::trial(const PointVectors &lambda) const
    {
      Trial at;
      at.z                 = lambda;
      const PointVectors v = moved(lambda);
      for (unsigned int i = 0; i < v.size(); ++i)
        {
          at.z[i] -= v[i];
          at.bound.push_back(mu[i] * std::max(0., at.z[i][0]));
          at.states.push_back(at.z[i][0] <= 0. ? PointState::open :
                              tangential_norm(at.z[i]) <= at.bound[i] ?
                                                 PointState::stick :
                                                 PointState::slip);
        }
      return at;
    }



    // F(lambda): the force if open, -v if sticking, and for slip the distance
    // of lambda from the projected trial force.
    PointVectors
    CoulombSearch::natural_map(const PointVectors &lambda) const
    {
      const Trial  at     = trial(lambda);
      PointVectors result = lambda;
      for (unsigned int i = 0; i < lambda.size(); ++i)
        if (at.states[i] == PointState::stick)
          result[i] -= at.z[i];
        else if (at.states[i] == PointState::slip)
          {
            Tensor<1, 3> projected =
              at.bound[i] / tangential_norm(at.z[i]) * at.z[i];
            projected[0] = at.z[i][0];
            result[i] -= projected;
          }
      return result;
    }



    // Relative residual of the natural map, the convergence criterion.
    double
    CoulombSearch::error(const PointVectors &lambda) const
    {
      return largest_component(natural_map(lambda)) /
             std::max(1., largest_component(lambda));
    }



    /// Changes in the n equations A x = b for the forces of closed points those
    /// of a slipping point, from row @p first on. Its tangential equations are
    ///   (1 - k E) lambda_t + k E v_t - mu e lambda_n = 0
    /// with the trial force z, e = z_t / |z_t|, E = 1 - e e^T and k = mu z_n /
    /// |z_t|; @p lambda is the current force.
    void
    linearize_slip(const Tensor<1, 3>  &z,
                   const double         bound,
                   const double         friction,
                   const Tensor<1, 3>  &lambda,
                   const unsigned int   first,
                   const unsigned int   size,
                   std::vector<double> &A,
                   std::vector<double> &b)
    {
      const std::size_t  n      = b.size();
      const double       length = tangential_norm(z), k = bound / length;
      const Tensor<1, 3> e      = tangential_part(z) / length;
      const auto         across = [&](double *const column) {
        double along = 0.;
        for (unsigned int c = 1; c < size; ++c)
          along += e[c] * column[first + c];
        for (unsigned int c = 1; c < size; ++c)
          column[first + c] = k * (column[first + c] - along * e[c]);
      };
      across(b.data());
      for (std::size_t j = 0; j < n; ++j)
        across(A.data() + j * n);
      for (unsigned int c = 1; c < size; ++c)
        {
          A[first * n + first + c] -= friction * e[c];
          b[first + c] += friction * e[c] * lambda[0];
          for (unsigned int d = 1; d < size; ++d)
            {
              const double own = (c == d ? 1. - k : 0.) + k * e[c] * e[d];
              A[(first + d) * n + first + c] += own;
              b[first + c] -= own * lambda[d];
            }
        }
    }



    // Open points have zero force, and sticking ones v = 0. The sign of the
    // determinant is that of det(R W C), negative for an unstable solution.
    NewtonStep
    CoulombSearch::newton_step(const Trial        &at,
                               const PointVectors &lambda) const
    {
      std::vector<unsigned int> rows;
      PointVectors              kept = lambda;
      for (unsigned int i = 0; i < W.n_points(); ++i)
        if (at.states[i] == PointState::open)
          kept[i] = {};
        else
          for (unsigned int r = W.first[i]; r < W.first[i + 1]; ++r)
            rows.push_back(r);
      const std::size_t         n = rows.size();
      const std::vector<double> v = W.by_rows(moved(kept));
      std::vector<double>       A(n * n), x(n);
      for (std::size_t j = 0; j < n; ++j)
        {
          x[j] = -v[rows[j]];
          for (std::size_t i = 0; i < n; ++i)
            A[j * n + i] = W(rows[i], rows[j]);
        }
      unsigned int first = 0;
      for (unsigned int i = 0; i < W.n_points(); ++i)
        if (at.states[i] != PointState::open)
          {
            if (at.states[i] == PointState::slip)
              linearize_slip(
                at.z[i], at.bound[i], mu[i], kept[i], first, W.size(i), A, x);
            first += W.size(i);
          }
      // The sign of the determinant costs nothing beside the factorization.
      const DenseLU factor(std::move(A), n);
      NewtonStep    step;
      step.sign = factor.sign_of_determinant();
      if (factor.is_singular())
        return step;
      factor.solve(x);
      std::vector<double> forces = W.by_rows(kept);
      for (std::size_t k = 0; k < n; ++k)
        forces[rows[k]] += x[k];
      step.lambda    = W.by_points(forces);
      step.is_solved = std::isfinite(inner_product(step.lambda, step.lambda));
      return step;
    }



    // Backtracking on the Euclidean norm of the natural map.
    PointVectors
    CoulombSearch::shortened(const PointVectors &lambda,
                             const PointVectors &next,
                             const unsigned int  iteration) const
    {
      // Every fourth step is taken without a norm, to leave cycles.
      constexpr unsigned int blind_every = 4;
      constexpr double       blind       = 0.35;
      const auto             at          = [&](const double step) {
        PointVectors result = lambda;
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] += step * (next[i] - lambda[i]);
        return result;
      };
      if (iteration % blind_every == 0)
        return at(blind);
      PointVectors best  = lambda;
      double       least = std::numeric_limits<double>::max();
      for (const double step : {1., 0.5, 0.25, 0.1, 0.03, 0.01})
        {
          const PointVectors there = at(step), map = natural_map(there);
          if (const double size = inner_product(map, map); size < least)
            {
              least = size;
              best  = there;
            }
        }
      return best;
    }



    // Newton's method in total form: each step gives new forces, not a
    // correction of the last ones, so it can leave a wrong branch at once. The
    // best iterate is kept, since the natural map need not decrease. Further
    // steps after convergence gain digits of small forces.
    CoulombSolution
    CoulombSearch::newton(PointVectors       lambda,
                          const unsigned int most,
                          const unsigned int damped_from) const
    {
      CoulombSolution best;
      best.force            = lambda;
      best.error            = std::numeric_limits<double>::max();
      unsigned int polished = 0;
      for (unsigned int k = 0; k < most + polished; ++k)
        {
          const Trial      at   = trial(lambda);
          const NewtonStep step = newton_step(at, lambda);
          ++best.iterations;
          if (!step.is_solved)
            break;
          const double before = best.error, e = error(step.lambda);
          if (e < best.error)
            {
              best.error     = e;
              best.force     = step.lambda;
              best.stability = step.sign;
            }
          if (best.error < rules.tolerance)
            {
              const bool betters = before > rules.tolerance || 10. * e < before;
              if (best.error < rules.digits ||
                  polished == rules.extra_iterations || !betters)
                break;
              ++polished;
              lambda = best.force;
              continue;
            }
          lambda =
            k < damped_from ? step.lambda : shortened(lambda, step.lambda, k);
        }
      return best;
    }



    // The points have no compliance of their own: the regularization is in W.
    CoulombSolution
    CoulombSearch::solve_by_interior_point() const
    {
      InterfacePoints points{{}, mu, std::vector<double>(W.n_points(), 0.), {}};
      for (unsigned int i = 0; i < W.n_points(); ++i)
        {
          points.n_slips.push_back(W.size(i) - 1);
          points.spring.push_back(1. / W(W.first[i], W.first[i]));
        }
      DenseInterfaceSystem system(W, q, about);
      unsigned int         n      = 0;
      const PointVectors   lambda = lamella::solve_by_interior_point(
        system, points, about, [&n](const Round &) { ++n; });
      CoulombSolution found =
        newton(lambda, rules.iterations, rules.damped_from);
      found.iterations += n;
      return found;
    }



    // Proximal term: W + soft 1, q + soft (about - lambda).
    CoulombSearch
    CoulombSearch::softened(const double soft, const PointVectors &lambda) const
    {
      CoulombSearch result = *this;
      for (unsigned int r = 0; r < W.n_rows(); ++r)
        result.W(r, r) += soft;
      for (unsigned int i = 0; i < q.size(); ++i)
        result.q[i] += soft * (about[i] - lambda[i]);
      return result;
    }



    // Continuation in the regularization: decrease it after each success of
    // Newton's method, increase it after a failure. Newton's method without
    // regularization is tried from each intermediate solution.
    CoulombSolution
    CoulombSearch::by_compliance(const PointVectors &start) const
    {
      constexpr double   least = 1e-12;
      constexpr unsigned tries = 8;
      CoulombSolution    best;
      best.force       = start;
      best.error       = std::numeric_limits<double>::max();
      const auto offer = [&](const CoulombSolution &found) {
        best.iterations += found.iterations;
        if (found.error < best.error)
          {
            best.error     = found.error;
            best.force     = found.force;
            best.stability = found.stability;
          }
      };
      PointVectors lambda = start;
      double       soft   = rules.first_compliance;
      for (unsigned int k = 0; k < rules.max_regularized_rounds &&
                               soft <= 10. * rules.first_compliance;
           ++k)
        {
          const CoulombSearch other = softened(soft, lambda);
          CoulombSolution     found =
            other.newton(lambda, rules.iterations, rules.damped_from);
          if (found.error > rules.solved)
            {
              const CoulombSolution again = other.solve_by_interior_point();
              best.iterations += found.iterations;
              if (again.error < found.error)
                found = again;
            }
          best.iterations += found.iterations;
          if (found.error > rules.solved)
            {
              soft *= rules.increase_factor;
              continue;
            }
          lambda = found.force;
          offer(newton(lambda, tries, tries));
          if (best.error < rules.tolerance)
            break;
          soft = std::max(least, soft * rules.decrease_factor);
        }
      return best;
    }



    // Methods by increasing cost; each starts from the best forces so far or
    // from zero, and the first below the tolerance ends the chain.
    CoulombSolution
    CoulombSearch::solve_in_sequence(const PointVectors &start) const
    {
      CoulombSolution best;
      best.error       = std::numeric_limits<double>::max();
      best.force       = start;
      const auto is_it = [&](const char *const      by,
                             const CoulombSolution &found) {
        const unsigned int iterations = best.iterations + found.iterations;
        if (found.error < best.error)
          {
            best    = found;
            best.by = by;
          }
        best.iterations = iterations;
        return best.error < rules.tolerance;
      };
      if (is_it("forces of before",
                newton(start, rules.first_iterations, rules.iterations)) ||
          is_it("interior point", solve_by_interior_point()))
        return best;
      is_it("compliance", by_compliance(best.force));
      return best;
    }



    /// Returns the proximal problem of @p problem with the regularization @p
    /// share of each point's largest diagonal entry, about @p lambda.
    CoulombProblem
    softened(const CoulombProblem &problem,
             const double          share,
             const PointVectors   &lambda)
    {
      CoulombProblem   soft = problem;
      PointCompliance &W    = soft.compliance;
      for (unsigned int i = 0; i < W.n_points(); ++i)
        {
          double most = 0.;
          for (unsigned int r = W.first[i]; r < W.first[i + 1]; ++r)
            most = std::max(most, W(r, r));
          for (unsigned int r = W.first[i]; r < W.first[i + 1]; ++r)
            W(r, r) += share * most;
          if (!problem.about.empty())
            soft.q[i] += share * most * problem.about[i];
          soft.q[i] -= share * most * lambda[i];
        }
      return soft;
    }
  } // namespace



  // Proximal point iteration: each round solves the problem with W + compliance
  // about the last forces, which converges to a solution of the exact law. The
  // error is that of the exact law. The sign of the determinant is evaluated
  // once more with a larger regularization if it indicates instability.
  CoulombSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules)
  {
    const CoulombSearch exact(problem, rules);
    CoulombSolution     best;
    best.force              = start;
    best.error              = std::numeric_limits<double>::max();
    PointVectors lambda     = start;
    unsigned int iterations = 0, idle = 0;
    std::string  by;
    for (unsigned int round = 0; round < rules.max_rounds; ++round)
      {
        const CoulombSearch search(softened(problem, rules.compliance, lambda),
                                   rules);
        CoulombSolution found = search.solve_in_sequence(search.scaled(lambda));
        const double    left  = found.error;
        if (round == 0)
          by = found.by;
        iterations += found.iterations;
        found.force = lambda = search.unscaled(found.force);
        found.error          = exact.error(exact.scaled(lambda));
        idle                 = found.error < best.error ? 0 : idle + 1;
        if (found.error < best.error)
          best = found;
        if (best.error < rules.tolerance || left > rules.failed ||
            idle == rules.idle)
          break;
      }
    best.by         = by;
    best.iterations = iterations;
    best.states     = exact.trial(exact.scaled(best.force)).states;
    if (best.stability < 0)
      {
        const CoulombSearch search(
          softened(problem, rules.stability_regularization, best.force), rules);
        best.stability = search.sign_at(search.scaled(best.force));
      }
    return best;
  }
} // namespace lamella
