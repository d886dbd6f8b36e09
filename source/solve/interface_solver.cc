// SPDX-License-Identifier: LGPL-2.1-or-later

// Semi-smooth Newton method for contact with Coulomb friction (Alart and
// Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375; Hintermueller,
// Ito and Kunisch, SIAM J. Optim. 13 (2002) 865-888) on the natural map
//   F(lambda) = lambda - P(z),  z = lambda - D v,
// P the law's projection, v the lengths with all compliances, and D the
// stiffness of the points. With the generalized derivative G = dP/dz, which
// includes that of the shear bound, the equations of a step are
//   (1 - G + G D d) dlambda + G D dv = P(z) - lambda.
// They are not symmetric for a slipping point, as its bound depends on the
// normal force; solutions with a negative determinant lie on branches without a
// load path.

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interface_solver.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Trial traction z of a point and the response of its law.
    struct Trial
    {
      Tensor<1, 3>      z;
      Tensor<2, 3>      D; ///< Stiffness, diagonal.
      ShearBound        bound;
      InterfaceResponse response;

      /// Returns P(z) - lambda at the force @p lambda; exactly -D v if P(z) =
      /// z.
      Tensor<1, 3>
      missed(const Tensor<1, 3> &lambda) const
      {
        return (response.traction - z) + (z - lambda);
      }
    };



    /// Natural map of point @p i at the force @p lambda, with gap and slips
    /// @p v.
    Trial
    trial(const InterfacePoints &points,
          const unsigned int     i,
          const Tensor<1, 3>    &lambda,
          const Tensor<1, 3>    &v)
    {
      Trial at;
      for (unsigned int c = 0; c < 3; ++c)
        at.D[c][c] = points.stiffness[i][c == 0 ? 0 : 1];
      Tensor<1, 3> lengths = points.lengths(i, v, lambda);
      if (lambda[0] == 0. && std::abs(lengths[0]) <= points.closed)
        lengths[0] = 0.;
      at.z        = lambda - at.D * lengths;
      at.bound    = points.law[i]->bound(at.z);
      at.response = points.law[i]->evaluate(at.z, at.bound.value);
      return at;
    }



    LinearizedLaw
    linearized(const InterfacePoints &points,
               const unsigned int     i,
               const Tensor<1, 3>    &lambda,
               const Tensor<1, 3>    &v)
    {
      const Trial        at = trial(points, i, lambda, v);
      const Tensor<2, 3> one(unit_symmetric_tensor<3>()),
        G = Tensor<2, 3>(at.response.tangent) +
            outer_product(at.response.bound_derivative, at.bound.gradient);
      LinearizedLaw law;
      law.state = at.response.state;
      law.B     = G * at.D;
      law.A     = one - G;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          law.A[a][b] += law.B[a][b] * points.compliance[i][b];
      law.residual = at.missed(lambda);
      return law;
    }



    std::vector<LinearizedLaw>
    linearized(const InterfacePoints &points,
               const PointVectors    &lambda,
               const PointVectors    &v)
    {
      std::vector<LinearizedLaw> laws;
      for (unsigned int i = 0; i < lambda.size(); ++i)
        laws.push_back(linearized(points, i, lambda[i], v[i]));
      return laws;
    }



    /// Newton's method of solve_interface().
    class InterfaceNewton
    {
    public:
      InterfaceNewton(InterfaceSystem       &system,
                      const InterfacePoints &points,
                      const Monitor         &monitor,
                      const InterfaceRules  &rules)
        : system(system)
        , points(points)
        , monitor(monitor)
        , rules(rules)
      {}

      /// Applies Newton's method from the forces @p lambda and the iterate of
      /// the system, at most @p most iterations; returns the best forces.
      // Each step gives new forces, not a correction of the last ones, so it
      // can leave a wrong branch at once. The best iterate is kept, since the
      // natural map need not decrease. Further steps after convergence gain
      // digits of small forces.
      InterfaceSolution
      solve(PointVectors lambda, const unsigned int most)
      {
        InterfaceSolution best;
        best.force            = lambda;
        unsigned int polished = 0;
        for (unsigned int k = 0; k < most + polished; ++k)
          {
            const PointVectors  v = system.lengths();
            const InterfaceStep step =
              system.solve(linearized(points, lambda, v), lambda);
            if (!step.is_solved)
              break;
            const double            before = best.error;
            const InterfaceSolution now    = after(step, v);
            best.offer(now);
            const bool   is_solved = best.error < rules.tolerance;
            const double t         = is_solved || k < rules.damped_from ?
                                       1. :
                                       shortened(lambda, v, step, k);
            system.advance(t);
            for (unsigned int i = 0; i < lambda.size(); ++i)
              lambda[i] += t * (step.force[i] - lambda[i]);
            const bool betters =
              before > rules.tolerance || 10. * now.error < before;
            if (is_solved && (best.error < rules.digits || !betters ||
                              polished++ == rules.extra_iterations))
              break;
          }
        return best;
      }

      /// Applies Newton's method from the result of the interior point.
      InterfaceSolution
      after_interior_point()
      {
        unsigned int n = 0;
        system.move_to(points.about);
        const PointVectors lambda =
          solve_by_interior_point(system, points, [&](const Round &round) {
            ++n;
            if (monitor)
              monitor(round);
          });
        InterfaceSolution found = solve(lambda, rules.iterations);
        found.iterations += n;
        return found;
      }

      /// Applies Newton's method to points with decreasing compliance.
      // Continuation in the compliance: decrease it after each success of
      // Newton's method, increase it after a failure. Newton's method without
      // it is tried from each intermediate solution.
      InterfaceSolution
      by_compliance(const PointVectors &start)
      {
        constexpr unsigned tries = 8;
        InterfaceSolution  best;
        best.force          = start;
        PointVectors lambda = start;
        double       share  = rules.first_compliance;
        for (unsigned int k = 0; k < rules.max_regularized_rounds &&
                                 share <= 10. * rules.first_compliance;
             ++k)
          {
            const InterfacePoints soft = softened(points, share, lambda);
            InterfaceNewton       other(system, soft, monitor, rules);
            system.move_to(lambda);
            InterfaceSolution found = other.solve(lambda, rules.iterations);
            if (found.error > rules.solved)
              found.offer(other.after_interior_point());
            best.iterations += found.iterations;
            if (found.error > rules.solved)
              {
                share *= rules.increase_factor;
                continue;
              }
            lambda = found.force;
            system.move_to(lambda);
            best.offer(solve(lambda, tries));
            if (best.error < rules.tolerance)
              break;
            share = std::max(rules.tolerance, share * rules.decrease_factor);
          }
        return best;
      }

    private:
      /// Returns the best of several fractions of @p step from @p lambda, @p v.
      // Backtracking on the Euclidean norm of the natural map.
      double
      shortened(const PointVectors  &lambda,
                const PointVectors  &v,
                const InterfaceStep &step,
                const unsigned int   iteration) const
      {
        // Every fourth step is taken without a norm, to leave cycles.
        constexpr unsigned int blind_every = 4;
        constexpr double       blind       = 0.35;
        if (iteration % blind_every == 0)
          return blind;
        double best = 0., least = std::numeric_limits<double>::max();
        for (const double t : {1., 0.5, 0.25, 0.1, 0.03, 0.01})
          {
            double size = 0.;
            for (unsigned int i = 0; i < lambda.size(); ++i)
              {
                const Tensor<1, 3> there =
                  lambda[i] + t * (step.force[i] - lambda[i]);
                const Trial at =
                  trial(points, i, there, v[i] + t * step.change[i]);
                const Tensor<1, 3> missed = at.missed(there);
                for (unsigned int c = 0; c < 3; ++c)
                  size += missed[c] * missed[c] / at.D[c][c];
              }
            if (size < least)
              {
                least = size;
                best  = t;
              }
          }
        return best;
      }

      /// Returns and reports the solution after the full @p step from the gaps
      /// and slips @p v.
      InterfaceSolution
      after(const InterfaceStep &step, PointVectors v) const
      {
        for (unsigned int i = 0; i < v.size(); ++i)
          v[i] += step.change[i];
        const LawError    error = law_error(points, step.force, v);
        InterfaceSolution now;
        now.force      = step.force;
        now.states     = error.states;
        now.error      = error.largest;
        now.stability  = step.sign;
        now.iterations = 1;
        if (!monitor)
          return now;
        Round round;
        for (unsigned int i = 0; i < v.size(); ++i)
          {
            round.active += now.states[i] != PointState::open;
            if (!(error.of_point[i] > rules.tolerance))
              continue;
            round.changed.push_back(i);
            round.violation = std::max(round.violation, v[i].norm());
          }
        monitor(round);
        return now;
      }

      InterfaceSystem       &system;
      const InterfacePoints &points;
      const Monitor         &monitor;
      const InterfaceRules  &rules;
    };



    /// Returns the sign of the determinant of Newton's matrix at the contact
    /// forces @p force (InterfaceSolution::stability).
    int
    stability_at(InterfaceSystem       &system,
                 const InterfacePoints &points,
                 const PointVectors    &force)
    {
      system.move_to(force);
      return system.solve(linearized(points, force, system.lengths()), force)
        .sign;
    }
  } // namespace



  InterfacePoints
  softened(InterfacePoints     points,
           const double        share,
           const PointVectors &force)
  {
    for (unsigned int i = 0; i < force.size(); ++i)
      {
        const auto  &stiffness = points.stiffness[i];
        const double d         = share / std::min(stiffness[0], stiffness[1]);
        for (unsigned int c = 0; c < 3; ++c)
          points.compliance[i][c] += d;
        points.shift[i] += d * force[i];
      }
    return points;
  }



  // A force of rounding is none: points that cannot move, between supports, get
  // such forces of either sign.
  LawError
  law_error(const InterfacePoints &points,
            const PointVectors    &force,
            const PointVectors    &v)
  {
    LawError            result;
    std::vector<double> pressed;
    double              size = 0.;
    for (unsigned int i = 0; i < force.size(); ++i)
      {
        const Trial        at      = trial(points, i, force[i], v[i]);
        const Tensor<1, 3> missing = at.missed(force[i]), Dv = force[i] - at.z;
        double             largest = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double unit = std::sqrt(at.D[c][c]);
            largest           = std::max(largest, std::abs(missing[c]) / unit);
            size              = std::max(
              {size, std::abs(force[i][c]) / unit, std::abs(Dv[c]) / unit});
          }
        result.states.push_back(at.response.state);
        result.of_point.push_back(largest);
        pressed.push_back(at.z[0] / std::sqrt(at.D[0][0]));
      }
    for (unsigned int i = 0; i < force.size(); ++i)
      {
        if (pressed[i] <= arithmetic::rounding * size &&
            !points.law[i]->is_bilateral())
          result.states[i] = PointState::open;
        double &error  = result.of_point[i];
        error          = size > 0. ? error / size : 0.;
        result.largest = std::max(result.largest, error);
      }
    return result;
  }



  void
  check_law(const InterfaceSolution &found, const bool has_friction)
  {
    // Tolerance over the scale of the problem.
    constexpr double sound = 1e-6;
    if (found.error <= sound)
      return;
    const std::string error = to_text(found.error, 2);
    if (has_friction)
      throw NumericsError(
        "solve.friction-not-converged: The contact iteration with friction did "
        "not converge: Coulomb's law has the relative error " +
        error + friction_remedy);
    throw NumericsError(
      "solve.not-converged: The contact iteration did not converge: the "
      "conditions of contact have the relative error " +
      error +
      ". Try a finer mesh at the contact edge, or Enforcement = penalty.");
  }



  // Methods by increasing cost; the first below the tolerance ends the chain.
  InterfaceSolution
  solve_interface(InterfaceSystem       &system,
                  const InterfacePoints &points,
                  const PointVectors    &start,
                  const Monitor         &monitor,
                  const InterfaceRules  &rules)
  {
    InterfaceNewton   newton(system, points, monitor, rules);
    InterfaceSolution best;
    best.force       = start;
    const auto is_it = [&](const InterfaceMethod by, InterfaceSolution found) {
      found.by = by;
      best.offer(found);
      return best.error < rules.tolerance;
    };
    const bool     is_equilibrium = system.move_to(start);
    const LawError at_start       = law_error(points, start, system.lengths());
    if (is_equilibrium && largest_component(start) == 0. &&
        at_start.largest == 0.)
      {
        best.error  = 0.;
        best.states = at_start.states;
        return best;
      }
    if (is_it(InterfaceMethod::newton,
              newton.solve(start, rules.first_iterations)) ||
        is_it(InterfaceMethod::interior_point, newton.after_interior_point()))
      return best;
    is_it(InterfaceMethod::compliance, newton.by_compliance(best.force));
    return best;
  }



  // Coulomb's law on a dense compliance W, which may be singular: proximal
  // points about the last forces with a small compliance, which makes the
  // problem definite (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898).
  // They converge to a solution of the exact law. The error is that of the
  // exact law. The sign of the determinant is evaluated once more with a larger
  // compliance if it indicates instability.
  //
  // Costs: 2/3 n^3 per Newton step for n rows of closed points; about 25 n^3 /
  // 3 for the interior point method.

  InterfaceSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules)
  {
    const PointCompliance &W = problem.compliance;
    DenseInterfaceSystem   system(W,
                                problem.q,
                                problem.about.empty() ?
                                    PointVectors(problem.q.size()) :
                                    problem.about);
    const InterfacePoints  exact = system.points(problem.law);
    InterfaceSolution      best;
    best.force             = start;
    PointVectors lambda    = start;
    unsigned int idle      = 0;
    auto         costliest = InterfaceMethod::newton;
    double       share     = rules.compliance;
    for (unsigned int round = 0; round < rules.max_rounds; ++round)
      {
        InterfaceSolution found = solve_interface(
          system, softened(exact, share, lambda), lambda, {}, rules.interface);
        const double left = found.error, before = best.error;
        lambda = found.force;
        system.move_to(lambda);
        const LawError error = law_error(exact, lambda, system.lengths());
        found.error          = error.largest;
        found.states         = error.states;
        costliest = found.by = std::max(costliest, found.by);
        best.offer(found);
        idle               = found.error < before ? 0 : idle + 1;
        const bool is_slow = found.error > rules.slow * before,
                   is_last = share == rules.least_compliance;
        // Small forces gain digits after the tolerance is met.
        if (best.error < rules.interface.digits ||
            (best.error < rules.interface.tolerance && is_slow) ||
            (is_last && (left > rules.failed || idle == rules.idle)))
          break;
        if (is_slow)
          share = std::max(rules.least_compliance, rules.slow * share);
      }
    best.by = costliest;
    if (best.stability < 0)
      best.stability =
        stability_at(system,
                     softened(exact, rules.stability_compliance, best.force),
                     best.force);
    return best;
  }
} // namespace lamella
