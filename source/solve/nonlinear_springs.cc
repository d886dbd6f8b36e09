// SPDX-License-Identifier: LGPL-2.1-or-later

// Regularization of an indefinite tangent, and the stability of a state without
// it. In turn: none; active constraints against obstacles
// (ActiveConstraintShift); stabilizing springs times 10^2 to 10^5, as the
// damping of Levenberg and Marquardt, the first that has a Cholesky factor.

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/nonlinear_solver.h>
#include <lamella/solve/tangent_operator.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  namespace
  {
    /// A regularization to try: the share of the penalty that active
    /// constraints take as springs, and the factor of the stabilizing springs.
    struct AidTrial
    {
      double shift = 0., regularization_factor = 1.;
    };



    std::vector<AidTrial>
    trials(const bool may_lean, const bool has_springs)
    {
      // By increasing strength.
      std::vector<AidTrial> all{{}};
      if (may_lean)
        all.insert(all.end(), {{1e-3, 1.}, {0.5, 1.}});
      if (has_springs)
        all.insert(all.end(), {{0., 1e2}, {0., 1e3}, {0., 1e4}, {0., 1e5}});
      return all;
    }



    /// The stabilizing springs of all bodies, as many times as @p share.
    /// Stiffness terms share * s_k r_k^T r_k, added to those of the structure.
    ActiveConstraintShift::Springs
    springs_of(const Structure &structure, const double share)
    {
      ActiveConstraintShift::Springs springs(structure.bodies().size());
      for (unsigned int b = 0; b < springs.size(); ++b)
        for (const auto &[row, stiffness] : structure.spring_terms(b))
          springs[b].emplace_back(row, share * stiffness);
      return springs;
    }



    /// The rows R of check_supports(): sqrt(k) r of each spring, as a load.
    std::vector<BlockVector>
    loads_of_springs(const Structure &structure,
                     const double     regularization_factor)
    {
      std::vector<BlockVector> loads;
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        for (const auto &[row, stiffness] : structure.spring_terms(b))
          {
            loads.push_back(structure.zero());
            row.add_to(loads.back().block(b),
                       std::sqrt(regularization_factor * stiffness));
          }
      return loads;
    }



    /// Smallest eigenvalue of the symmetric part of @p A with its eigenvector.
    /// By LAPACK; the dimension is the number of springs.
    std::pair<double, Vector>
    least_of(const dealii::FullMatrix<double> &A)
    {
      constexpr double infinity = std::numeric_limits<double>::max();
      dealii::LAPACKFullMatrix<double> matrix(A.m(), A.n());
      for (unsigned int i = 0; i < A.m(); ++i)
        for (unsigned int j = 0; j < A.n(); ++j)
          matrix(i, j) = 0.5 * (A(i, j) + A(j, i));
      Vector                     values;
      dealii::FullMatrix<double> vectors;
      matrix.compute_eigenvalues_symmetric(
        -infinity, infinity, 0., values, vectors);
      Vector first(A.m());
      for (unsigned int i = 0; i < A.m(); ++i)
        first[i] = vectors(i, 0);
      return {values[0], first};
    }



    /// Displacements due to each of @p loads about the state of @p about, with
    /// the active @p rows of @p state held. Displacements K_c^-1 f with active
    /// constraints fixed.
    std::vector<BlockVector>
    answers(const TangentOperator          &about,
            const GapConstraints           &rows,
            const State                    &state,
            const std::vector<BlockVector> &loads)
    {
      std::vector<BlockVector> found;
      if (state.active.empty())
        {
          for (const BlockVector &load : loads)
            found.push_back(about.solve(load));
          return found;
        }
      const auto strategy = make_strategy(Strategy::condensed, about, rows);
      const ActiveConstraints closed = active_equations(rows, state);
      const Vector            held(closed.numbers.size());
      Vector                  forces;
      for (const BlockVector &load : loads)
        {
          found.push_back(about.of().zero());
          strategy->solve(closed, load, held, found.back(), forces);
        }
      return found;
    }
  } // namespace



  // The first regularization with a Cholesky factor is used; if all fail, the
  // last exception is rethrown. Regularized K changes the path of the
  // iteration, not its limit, since residuals are evaluated without it.
  NonlinearSolver::RegularizedTangent
  NonlinearSolver::tangent(const State       &state,
                           const BlockVector &correction,
                           const LoadFactor  &to) const
  {
    // A shifted normal force would change the friction bound mu lambda_n.
    const bool         may_lean = !contacts.rows().has_friction();
    std::exception_ptr failure;
    for (const AidTrial &trial : trials(may_lean, structure.has_springs()))
      try
        {
          RegularizedTangent about;
          about.regularization_factor = trial.regularization_factor;
          if (trial.shift > 0.)
            about.shift = std::make_unique<const ActiveConstraintShift>(
              contacts.interfaces(),
              state,
              structure.bodies().size(),
              trial.shift);
          if (about.shift && about.shift->none())
            continue;
          ActiveConstraintShift::Springs more;
          if (about.shift)
            more = about.shift->springs();
          else if (about.regularization_factor > 1.)
            more = springs_of(structure, about.regularization_factor - 1.);
          about.K = std::make_unique<const TangentOperator>(structure,
                                                            state.u,
                                                            requested,
                                                            monitor,
                                                            correction,
                                                            to,
                                                            more,
                                                            matrix_patterns);
          return about;
        }
      catch (const IllConditioned &)
        {
          failure = std::current_exception();
        }
    std::rethrow_exception(failure);
  }



  // Proximal point iteration on the rigid-body motions: offsets r_0 = r(u_k) of
  // the last iteration make the springs free of force at convergence. The rate
  // is s / (s + k), s and k the stiffness of springs and contact.
  NonlinearSolver::SpringRelease
  NonlinearSolver::spring_motion(const State &state, const LoadFactor &to) const
  {
    SpringRelease largest;
    if (!structure.has_springs())
      return largest;
    const SpringOffsets rest = structure.spring_lengths(state.u);
    for (unsigned int b = 0; b < rest.size(); ++b)
      for (unsigned int k = 0; k < rest[b].size(); ++k)
        {
          const double length =
                         std::abs(rest[b][k] -
                                  (state.rest.empty() ? 0. : state.rest[b][k])),
                       force = structure.springs(b)[k].stiffness * length;
          if (force >= largest.force)
            {
              largest.body   = b;
              largest.spring = k;
              largest.force  = force;
            }
          largest.length = std::max(largest.length, length);
        }
    double forces = std::max(structure.load(to).linfty_norm(),
                             structure.thermal_load().linfty_norm());
    for (const double lambda : state.force)
      forces = std::max(forces, std::abs(lambda));
    largest.is_done =
      largest.length <=
        parameters.spring_offset_tolerance * reference_length(state, to) ||
      largest.force <= parameters.spring_force_tolerance * forces;
    return largest;
  }



  // Energy criterion of NonlinearSolver::check_supports(): second variation of
  // the energy in the subspace V = C R^T of motions that only springs restrain;
  // it is negative for an unstable equilibrium.
  bool
  NonlinearSolver::check_supports(const State      &state,
                                  const LoadFactor &to) const
  {
    double pressing = structure.load(to, state.u).l2_norm();
    for (const double force : state.force)
      pressing += std::abs(force);
    if (contacts.rows().has_friction() || pressing == 0.)
      return false;
    // Bodies without strain have rounding for stresses: nothing to check.
    const BlockVector internal = structure.internal_forces(state.u, state.rest);
    if (is_rounding(TangentOperator(structure, state.u), internal, state.u))
      return false;
    const RegularizedTangent about = tangent(state, BlockVector(), to);
    const GapConstraints     rows =
      about.shift ? about.shift->rows() : contacts.rows();
    const auto loads = loads_of_springs(structure, about.regularization_factor);
    const auto modes = answers(*about.K, rows, state, loads);
    dealii::FullMatrix<double> G(modes.size()), energy(modes.size());
    for (unsigned int i = 0; i < modes.size(); ++i)
      for (unsigned int j = 0; j < modes.size(); ++j)
        G(i, j) = loads[i] * modes[j];
    G.mmult(energy, G);
    for (unsigned int j = 0; j < modes.size(); ++j)
      {
        const BlockVector turned =
          rotation_of_constraints(state, state.u, modes[j], to);
        for (unsigned int i = 0; i < modes.size(); ++i)
          energy(i, j) = G(i, j) - energy(i, j) - modes[i] * turned;
      }
    // Smallest eigenvalue over the squared length of its motion, compared with
    // the geometric stiffness of the contact forces, |forces| / size.
    const auto [least, share] = least_of(energy);
    BlockVector way           = structure.zero();
    for (unsigned int i = 0; i < modes.size(); ++i)
      way.add(share[i], modes[i]);
    const double length = length_of(way);
    if (least < -parameters.instability_share * pressing / structure.size() *
                  length * length)
      throw NumericsError(
        "solve.unstable-body: A body would turn over or slide away under its "
        "loads; only Stabilization prevents this. Add a Support.");
    return true;
  }



  // A rate of about 1: loads on the motion are balanced by the springs only.
  void
  NonlinearSolver::throw_unconstrained_motion(const std::string &body,
                                              const std::string &motion,
                                              const double       rate) const
  {
    const bool has_friction = contacts.rows().has_friction();
    if (motion == motion_along_force)
      throw NumericsError("solve.force-not-balanced: Obstacle '" + body +
                          "': no contact balances its Force (in each iteration "
                          "it moves " +
                          to_text(rate, 4) +
                          " times as far as in the iteration before). Point "
                          "Force towards the bodies, check the positions of "
                          "obstacle and bodies, or prescribe u.");
    throw NumericsError(
      "solve.unconstrained-motion: Body '" + body +
      "' has a rigid-body motion that no support or contact prevents (" +
      motion + ", in each iteration " + to_text(rate, 4) +
      " times as far as in the iteration before): its contacts" +
      (has_friction ? " and their friction" : "") +
      " do not balance its loads. Add a support, " +
      (has_friction ? "increase Friction, " : "") +
      (has_friction && !linear->contact_strategy().forces_are_accurate() ?
         "write Contact strategy = condensed (full may not converge where "
         "friction alone constrains a body), " :
         "") +
      "close its gaps by a prescribed displacement, or load it towards the "
      "other body.");
  }



  // With the rate q = s / (s + k) of the offsets, a share with the rate 0.1 is
  // recommended; a rate of 1 means k = 0, an unconstrained motion. After a
  // single iteration there is no rate.
  void
  NonlinearSolver::throw_not_settled(const Equilibrium   &at,
                                     const SpringRelease &released,
                                     const double         rate) const
  {
    constexpr double wanted_rate = 0.1;

    if (released.is_done || rate < arithmetic::rounding)
      throw NumericsError(
        "solve.not-converged: The contact did not converge in " +
        std::to_string(parameters.max_iterations) +
        " iterations: the relative residual of the forces is " +
        to_text(at.residual, 2) + ", the error of the contact law " +
        to_text(at.law_error, 2) + "." + describe_overlap() + " Try " +
        linear->contact_strategy().remedy() +
        ", a finer mesh at the contact edge, or larger Maximum iterations.");
    const Spring     &worst = structure.springs(released.body)[released.spring];
    const std::string name  = structure.bodies()[released.body]->name();
    if (!(rate < 0.999) || worst.motion == motion_along_force)
      throw_unconstrained_motion(name, worst.motion, rate);
    throw NumericsError(
      "solve.springs-too-stiff: The stabilizing springs of body '" + name +
      "' are too stiff compared with its contacts (" + worst.motion +
      "): the force in these springs decreases only by the factor " +
      to_text(rate, 3) + " in each iteration. Write a smaller value, Body " +
      name + "/Stabilization = " +
      to_text(worst.share * wanted_rate / (1. - wanted_rate) * (1. - rate) /
                rate,
              1) +
      ".");
  }



  // Names the first constraints that still change, and the initial overlap.
  void
  NonlinearSolver::check_rounds(const ContactStrategy           &strategy,
                                const unsigned int               rounds,
                                const std::vector<unsigned int> &changing) const
  {
    if (rounds < parameters.max_iterations)
      return;
    std::string names;
    for (unsigned int k = 0; k < changing.size() && k < 3; ++k)
      names += (k > 0 ? "; " : "") + describe(changing[k]);
    throw NumericsError(
      "solve.not-converged: The contact did not converge in " +
      std::to_string(rounds) + " iterations; " +
      std::to_string(changing.size()) + " of " +
      std::to_string(contacts.rows().size()) +
      " contact constraints still change between active and inactive (" +
      names + (changing.size() > 3 ? "; ...)" : ")") + "." +
      describe_overlap() + " Try " + strategy.remedy() +
      (linear == nullptr ? ", smaller load steps" : "") +
      ", a finer mesh at the contact edge, or larger Maximum iterations.");
  }



  std::string
  NonlinearSolver::describe_overlap() const
  {
    const GapConstraints &rows    = contacts.rows();
    unsigned int          deepest = 0;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (rows[r].initial_gap < rows[deepest].initial_gap)
        deepest = r;
    if (linear == nullptr || rows.empty() || rows[deepest].initial_gap >= 0.)
      return "";
    return " Bodies overlap at the start by up to " +
           to_text(-rows[deepest].initial_gap, 4) + " (" + describe(deepest) +
           "): use Overclosure = adjust, which subtracts the overlap from the "
           "gaps, or move them apart.";
  }
} // namespace lamella
