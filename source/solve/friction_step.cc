// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/friction_step.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

// Coulomb friction in one load step: backward Euler for the slip (implicit
// return mapping; Wriggers, Computational Contact Mechanics, Springer 2006, Ch.
// 10), with slips relative to the end of the previous step. Forces are scene
// vectors in the state, and components (n, t_1, t_2) in problems.
// Dissipation per step: mu (lambda_n,0 + lambda_n,1) / 2 |v|, nonnegative.
// With the slip s_0 at the end of the previous step, v = s + a lambda_t - s_0,
// and a the penalty's compliance, which acts in both directions.
namespace lamella
{
  using namespace dealii;

  std::vector<Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state)
  {
    std::vector<Tensor<1, 3>> forces(rows.size());
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const Tensor<1, 2> shear =
          along_tangents(rows[r], state.friction.shear[r]);
        forces[r] = Tensor<1, 3>({state.force[r], shear[0], shear[1]});
      }
    return forces;
  }



  // v = s(u) + a lambda_t - s_0: elastic slip does not dissipate.
  Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor)
  {
    return slip_of(row, state.u, factor) +
           along_tangents(row,
                          law_compliance(row, true) * state.friction.shear[r] -
                            state.friction.before[r]);
  }



  // Slips without the elastic part: the strategy adds a lambda_t itself.
  void
  add_friction(const GapConstraints &rows,
               const State          &state,
               const LoadFactor     &factor,
               ContactProblem       &problem)
  {
    problem.first_forces = forces_by_rows(rows, state);
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        problem.shear.push_back(
          along_tangents(rows[r], state.friction.shear[r]));
        problem.slip.push_back(
          slip_of(rows[r], state.u, factor) -
          along_tangents(rows[r], state.friction.before[r]));
      }
  }



  // Shear forces and directions are stored as scene vectors, without a frame.
  void
  store_forces(const GapConstraints  &rows,
               const ContactSolution &found,
               State                 &state)
  {
    state.force  = found.force;
    state.active = found.active;
    if (state.friction.empty())
      return;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        state.friction.shear[r]     = in_scene(rows[r], found.shear[r]);
        state.friction.direction[r] = found.direction.empty() ?
                                        Tensor<1, 3>() :
                                        in_scene(rows[r], found.direction[r]);
      }
  }



  // A sticking row has equations for its gap and both slips, a slipping one for
  // its gap only, with the force direction n + mu e.
  ActiveConstraints
  active_equations(const GapConstraints &rows, const State &state)
  {
    ActiveConstraints closed(state.active);
    for (const unsigned int r : state.active)
      if (!rows[r].slips.empty())
        {
          const Tensor<1, 2> e =
            along_tangents(rows[r], state.friction.direction[r]);
          if (e.norm() > 0.)
            closed.sliding.emplace_back(r, rows[r].friction * e);
          else
            for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
              closed.numbers.push_back(rows.slip(r, a));
        }
    return closed;
  }



  // The shear force of a slipping row is mu lambda_n e after the update.
  void
  add_forces(const GapConstraints    &rows,
             const ActiveConstraints &closed,
             const Vector            &dlambda,
             State                   &state)
  {
    for (unsigned int i = 0; i < closed.numbers.size(); ++i)
      {
        const unsigned int number = closed.numbers[i], r = rows.row_of(number);
        if (number == r)
          state.force[r] += dlambda[i];
        else
          state.friction.shear[r] +=
            dlambda[i] * rows[r].slips[number - rows.slip(r, 0)].tangent;
      }
    for (const auto &[r, along] : closed.sliding)
      state.friction.shear[r] = in_scene(rows[r], state.force[r] * along);
  }



  // Slip along -e, with the direction e of the shear force: v + |v| e = 0. An
  // angle whose cosine rounds to 1 changes no dissipation; directions that
  // solve_interface() finds have errors of this size.
  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor)
  {
    const Tensor<1, 2> v = slip_in_step(row, r, state, factor),
                       e = along_tangents(row, state.friction.direction[r]);
    const double angle   = std::sqrt(std::numeric_limits<double>::epsilon()),
                 error   = (v + v.norm() * e).norm();
    return e.norm() > 0. && error <= angle * v.norm() ? 0. : error;
  }



  namespace
  {
    /// Adds a slip of the length @p slid under the @p mean normal force with
    /// the @p friction coefficient to @p point; returns the dissipation.
    double
    add_loss(const double     friction,
             const double     mean,
             const double     slid,
             FrictionHistory &point)
    {
      const double lost = friction * mean * slid;
      point.length += slid;
      point.dissipated += lost;
      return lost;
    }



    /// Ends the step of points whose constraint was dropped when surfaces were
    /// paired anew: they had slipped up to then. @p friction has the friction
    /// coefficient of each contact that touches.
    void
    end_dropped_points(const GapConstraints                 &rows,
                       const std::map<unsigned int, double> &friction,
                       FrictionState                        &of)
    {
      std::set<std::pair<unsigned int, unsigned int>> constrained;
      for (unsigned int r = 0; r < rows.size(); ++r)
        constrained.insert(rows.material_point(r));
      for (auto &[point, history] : of.history)
        if (history.is_dropped = constrained.count(point) == 0;
            history.is_dropped && history.force != 0.)
          {
            if (const auto mu = friction.find(point.first);
                mu != friction.end())
              add_loss(mu->second, 0.5 * history.force, history.slid, history);
            history.force = 0.;
            history.shear = Tensor<1, 2>();
          }
    }
  } // namespace



  // Energy balance of the step by the trapezoidal rule: the defect path_gap is
  // the contact work less dissipation, of second order in the step.
  void
  end_step(const GapConstraints &rows,
           const LoadFactor     &factor,
           const bool            moves,
           State                &state)
  {
    FrictionState &of = state.friction;
    if (of.empty())
      return;
    std::map<unsigned int, double> touching;
    for (const unsigned int r : state.active)
      touching[rows.contact_of_row(r).first] = rows[r].friction;
    if (moves)
      end_dropped_points(rows, touching, of);
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        FrictionHistory   &point = of.history[rows.material_point(r)];
        const Tensor<1, 2> slip  = slip_in_step(rows[r], r, state, factor),
                           shear = along_tangents(rows[r], of.shear[r]);
        const double mean        = 0.5 * (point.force + state.force[r]);
        // Points that a moving contact zone leaves have slipped, too; in one
        // that opens, most of the displacement is without contact.
        const bool slips = of.direction[r].norm() > 0. ||
                           (moves && state.force[r] == 0. && mean > 0. &&
                            touching.count(rows.contact_of_row(r).first) > 0);
        const double lost =
          add_loss(rows[r].friction, mean, slips ? slip.norm() : 0., point);
        const double gap = rows[r].gap(state.u, factor) +
                           law_compliance(rows[r]) * state.force[r];
        of.path_gap -=
          mean * (gap - point.gap) + 0.5 * (shear + point.shear) * slip + lost;
        point.force = state.force[r];
        point.shear = shear;
        point.gap   = gap;
        // Slips of moving contacts are measured from the beginning of a step.
        of.before[r] = law_compliance(rows[r], true) * of.shear[r];
        if (!moves)
          of.before[r] += in_scene(rows[r], slip_of(rows[r], state.u, factor));
      }
    for (auto &[point, history] : of.history)
      history.slid = 0.;
  }
} // namespace lamella
