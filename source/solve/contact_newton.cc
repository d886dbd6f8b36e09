// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_newton.h>
#include <lamella/solve/sparse_interface_system.h>

#include <algorithm>
#include <cmath>

// Semi-smooth Newton method for contact with Coulomb friction on displacements
// and forces, in the form of Alart and Curnier (Comput. Methods Appl. Mech.
// Eng. 92 (1991) 353-375); linearization of the return mapping as in Wriggers,
// Computational Contact Mechanics, Springer 2006, Ch. 10. Each step:
// 1. proximal_lengths(): gaps and slips v, raised by the numerical compliance;
// 2. trial(): trial forces z = lambda - rho v and the states open, stick, slip;
// 3. step(): one factorization of K + K^p with the linearized law of each row;
// 4. violating_rows(): the natural map lambda - P(lambda - rho v) by rows.
//
// Fixed-point equation of the shear force, lambda_t = k (lambda_t - rho v_t) in
// the direction across e. With v_t = s - s_0 + d lambda_t its solution for
// lambda_t has the stiffness w of linearize_slip() with respect to s.
namespace lamella
{
  using namespace dealii;

  // Undamped steps first. A negative determinant of the final tangent indicates
  // an unstable solution (see CoulombSolution::stability).
  std::optional<ContactSolution>
  ContactNewton::solve(const ContactProblem &problem,
                       Iterate               at,
                       const Monitor        &monitor,
                       const unsigned int    max_steps)
  {
    // Full steps converge fastest; some cycle, hence shortened steps later.
    constexpr unsigned int full_steps = 8, shortened_each = 4;

    Scales scale = scales(problem, at);
    Trial  now   = trial(problem, at, scale);
    if (std::all_of(now.states.begin(),
                    now.states.end(),
                    [](const PointState s) { return s == PointState::open; }) &&
        largest_component(at.force) == 0.)
      return solution(problem, std::move(at), now);
    for (unsigned int k = 0; k < max_steps; ++k)
      {
        Iterate next = step(problem, at, now);
        if (k >= full_steps && k % shortened_each == 0)
          next = shortened(problem, at, std::move(next));
        at                = std::move(next);
        scale             = scales(problem, at);
        now               = trial(problem, at, scale);
        const Round round = violating_rows(at, now, scale);
        monitor(round);
        if (!round.changed.empty())
          continue;
        if (matrix.sign_of_determinant() < 0)
          throw_unstable();
        return solution(problem, std::move(at), now);
      }
    return {};
  }



  // Start from the forces of the previous step. Their displacements without
  // contact reaction need one solution with K alone.
  ContactNewton::Iterate
  ContactNewton::begin(const ContactProblem &problem)
  {
    Iterate at{tangent_operator.of().zero(),
               tangent_operator.of().zero(),
               PointVectors(rows.size()),
               0.};
    if (!rows.has_friction())
      for (const unsigned int r : problem.start)
        at.force[r][0] = problem.estimate[r];
    else if (!problem.first_forces.empty())
      at.force = problem.first_forces;
    if (rows.has_friction() && at.force != problem.forces())
      {
        BlockVector f = tangent_operator.of().zero();
        add_contact_forces(rows, problem, at.force, f);
        matrix.factorize({});
        at.du   = matrix.solve(std::move(f));
        at.K_du = tangent_operator.apply(at.du);
      }
    at.change = at.du.linfty_norm();
    return at;
  }



  // Rounding levels for the comparisons of trial(), and rho = |lambda| / |du|,
  // which makes forces and lengths commensurable.
  ContactNewton::Scales
  ContactNewton::scales(const ContactProblem &problem, const Iterate &at) const
  {
    // Accuracy of displacements from one solution with K + K^p, and of forces.
    constexpr double rounding = arithmetic::rounding_of_solutions;

    // Near the solution du vanishes; then rounding of the state is the scale.
    const double size   = std::max(at.du.linfty_norm(),
                                 problem.closed / arithmetic::rounding),
                 forces = largest_component(at.force);
    Scales scale;
    scale.slip_rounding = rounding * size;
    scale.closed =
      std::max(problem.closed, std::min(scale.slip_rounding, at.change));
    scale.small = rounding * forces;
    scale.rho   = size > 0. && forces > 0. ? forces / size : 1.;
    return scale;
  }



  // Return mapping: z_n <= 0 open, |z_t| <= mu z_n stick, else slip. The
  // tangential rho = b / |v_t| prevents a stick state at a reversed slip.
  ContactNewton::Trial
  ContactNewton::trial(const ContactProblem &problem,
                       const Iterate        &at,
                       const Scales         &scale) const
  {
    Trial result;
    result.v = proximal_lengths(rows, compliance, problem, at.du);
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        result.v[r] += compliance(rows[r]) * at.force[r];
        const bool   pressed = at.force[r][0] > 0.;
        const double none    = pressed ? scale.slip_rounding : scale.closed,
                     gap =
                       std::abs(result.v[r][0]) > none ? result.v[r][0] : 0.,
                     slip_rounding = tangential_norm(result.v[r]);
        const bool   slips         = slip_rounding > scale.slip_rounding;
        Tensor<1, 3> z             = tangential_part(at.force[r]);
        z[0]                       = at.force[r][0] - scale.rho * gap;
        const double b             = rows[r].friction * std::max(0., z[0]),
                     rho           = slips && pressed && !scale.same_rho ?
                                       b / slip_rounding :
                                       scale.rho;
        if (slips)
          z -= rho * tangential_part(result.v[r]);
        result.z.push_back(z);
        result.bound.push_back(b);
        result.rho.push_back(rho);
        result.states.push_back(z[0] <= 0.              ? PointState::open :
                                tangential_norm(z) <= b ? PointState::stick :
                                                          PointState::slip);
      }
    return result;
  }



  // ---- a step

  // Slip, linearized with e = z_t / |z_t| and k = b / |z_t| < 1. Along e the
  // shear force follows mu lambda_n; across e the projection has the stiffness
  //   w = k rho / (1 - k + k rho d),
  // so the row adds (mu / d) B_e^T B_n + w B_x^T B_x to the matrix, x across e.
  void
  ContactNewton::linearize_slip(const unsigned int r,
                                const Iterate     &at,
                                const Trial       &trial,
                                Law               &law) const
  {
    const double d = compliance(rows[r]), mu = rows[r].friction,
                 length      = tangential_norm(trial.z[r]),
                 k           = trial.bound[r] / length,
                 soft        = 1. - k + k * trial.rho[r] * d,
                 across      = k * trial.rho[r] / soft;
    const Tensor<1, 3> e     = tangential_part(trial.z[r]) / length,
                       force = tangential_part(at.force[r]),
                       v     = tangential_part(trial.v[r]),
                       left  = -(1. - k) / soft * force - across * v;
    Tensor<1, 3> &change     = law.change[r];
    change += left - (left * e) * e +
              (mu * (at.force[r][0] + change[0]) - force * e) * e;
    const unsigned int n_tangents = rows[r].slips.size();
    for (unsigned int a = 0; a < n_tangents; ++a)
      {
        law.terms.push_back({rows.slip(r, a), r, mu * e[1 + a] / d});
        for (unsigned int b = 0; b < n_tangents && n_tangents > 1; ++b)
          law.terms.push_back(
            {rows.slip(r, a),
             rows.slip(r, b),
             across * ((a == b ? 1. : 0.) - e[1 + a] * e[1 + b])});
      }
  }



  // Closed rows have v = 0 with the compliance d: B_n^T B_n / d, and for
  // sticking rows B_t^T B_t / d.
  void
  ContactNewton::linearize(const unsigned int r,
                           const Iterate     &at,
                           const Trial       &trial,
                           Law               &law) const
  {
    const double d   = compliance(rows[r]);
    law.change[r][0] = -trial.v[r][0] / d;
    law.terms.push_back({r, r, 1. / d});
    if (trial.states[r] == PointState::slip)
      linearize_slip(r, at, trial, law);
    else
      for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
        {
          law.change[r][1 + a] = -trial.v[r][1 + a] / d;
          law.terms.push_back({rows.slip(r, a), rows.slip(r, a), 1. / d});
        }
  }



  // Newton system (K + K^p) du = B^T (lambda + change - lambda_state) - K du_k.
  // New forces follow from the linearized law, force -= weight B_on du.
  ContactNewton::Iterate
  ContactNewton::step(const ContactProblem &problem,
                      const Iterate        &at,
                      const Trial          &trial)
  {
    Law          law{PointVectors(rows.size()), {}};
    PointVectors force = at.force;
    BlockVector  r_u   = tangent_operator.of().zero();
    r_u -= at.K_du;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        if (trial.states[r] == PointState::open)
          law.change[r] = -at.force[r];
        else
          linearize(r, at, trial, law);
        force[r] += law.change[r];
      }
    add_contact_forces(rows, problem, force, r_u);
    matrix.factorize(law.terms);
    const BlockVector du = matrix.solve(std::move(r_u));

    Iterate next = at;
    next.du += du;
    next.change = du.linfty_norm();
    next.K_du   = tangent_operator.apply(next.du);
    for (unsigned int r = 0; r < rows.size(); ++r)
      next.force[r] += law.change[r];
    for (const PenaltyTerm &term : law.terms)
      {
        const unsigned int r = rows.row_of(term.of),
                           component =
                             term.of == r ? 0 : 1 + term.of - rows.slip(r, 0);
        next.force[r][component] -=
          term.weight * rows.constraint(term.on).jump(du);
      }
    return next;
  }



  // ---- how good it is

  // Residual of the natural map, lambda - P(z): the force itself if open.
  Tensor<1, 3>
  ContactNewton::missed(const unsigned int r,
                        const Iterate     &at,
                        const Trial       &trial)
  {
    Tensor<1, 3> result = at.force[r];
    if (trial.states[r] == PointState::open)
      return result;
    Tensor<1, 3> allowed = tangential_part(trial.z[r]);
    if (trial.states[r] == PointState::slip)
      allowed *= trial.bound[r] / tangential_norm(allowed);
    allowed[0] = trial.z[r][0];
    return result - allowed;
  }



  // Line search: the least norm of the natural map with one rho for all rows,
  // among full, half, quarter and tenth of the step.
  ContactNewton::Iterate
  ContactNewton::shortened(const ContactProblem &problem,
                           const Iterate        &from,
                           Iterate               to) const
  {
    Scales scale   = scales(problem, to);
    scale.same_rho = true;
    Iterate best   = to;
    double  least  = -1.;
    // Norms are compared with the same scales for all fractions.
    for (const double share : {1., 0.5, 0.25, 0.1})
      {
        Iterate at = from;
        at.du.sadd(1. - share, share, to.du);
        at.K_du.sadd(1. - share, share, to.K_du);
        for (unsigned int r = 0; r < rows.size(); ++r)
          at.force[r] += share * (to.force[r] - from.force[r]);
        const Trial there = trial(problem, at, scale);
        double      sum   = 0.;
        for (unsigned int r = 0; r < rows.size(); ++r)
          sum += missed(r, at, there).norm_square();
        if (least < 0. || sum < least)
          {
            least = sum;
            best  = std::move(at);
          }
      }
    return best;
  }



  // Convergence test per row, in forces; for slip rho times its rounding.
  Round
  ContactNewton::violating_rows(const Iterate &at,
                                const Trial   &trial,
                                const Scales  &scale) const
  {
    Round round;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const bool is_open = trial.states[r] == PointState::open;
        if (!is_open)
          ++round.active;
        const Tensor<1, 3> force  = missed(r, at, trial);
        const double       normal = std::abs(force[0]),
                     shear        = tangential_norm(force);
        const bool slips          = trial.states[r] == PointState::slip;
        if (normal > scale.small ||
            shear > (slips ? trial.rho[r] * scale.slip_rounding : scale.small))
          {
            round.changed.push_back(r);
            round.violation = std::max(round.violation, trial.v[r].norm());
          }
      }
    return round;
  }



  // Collects forces and directions of slip.
  ContactSolution
  ContactNewton::solution(const ContactProblem &problem,
                          Iterate               at,
                          const Trial          &trial) const
  {
    ContactSolution   result;
    std::vector<bool> moved(at.du.n_blocks(), false);
    result.force.assign(rows.size(), 0.);
    result.shear.assign(rows.size(), {});
    result.direction.assign(rows.size(), {});
    const PointVectors before = problem.forces();
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        if (trial.states[r] != PointState::open)
          {
            result.active.push_back(r);
            result.force[r] = std::max(0., at.force[r][0]);
            result.shear[r] = Tensor<1, 2>({at.force[r][1], at.force[r][2]});
          }
        const double length = result.shear[r].norm();
        if (trial.states[r] == PointState::slip && length > 0.)
          result.direction[r] = result.shear[r] / length;
        if (result.force[r] != before[r][0] ||
            result.shear[r][0] != before[r][1] ||
            result.shear[r][1] != before[r][2])
          for (const BodyFunctional &part : rows[r].parts)
            moved[part.body] = true;
      }
    // Bodies without a change of forces have only rounding in du.
    for (unsigned int b = 0; b < moved.size(); ++b)
      if (!moved[b])
        at.du.block(b) = 0.;
    result.du = std::move(at.du);
    return result;
  }
} // namespace lamella
