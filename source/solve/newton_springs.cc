// SPDX-License-Identifier: LGPL-2.1-or-later

// Regularization of an indefinite tangent, and the stability of a state without
// it. In turn: none; active constraints against obstacles
// (ActiveConstraintShift); stabilizing springs times 10^2 to 10^5, as the
// damping of Levenberg and Marquardt, the first that has a Cholesky factor.

#include <lamella/base/exceptions.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/ill_conditioned.h>
#include <lamella/solve/newton.h>

#include <deal.II/lac/lapack_full_matrix.h>

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
  } // namespace



  // The first regularization with a Cholesky factor is used; if all fail, the
  // last exception is rethrown. Regularized K changes the path of the
  // iteration, not its limit, since residuals are evaluated without it.
  TangentOperator
  Newton::tangent(const State       &state,
                  const BlockVector &correction,
                  const LoadFactor  &to,
                  Regularization    &regularization) const
  {
    // A shifted normal force would change the friction bound mu lambda_n.
    const bool         may_lean = !contacts.rows().has_friction();
    std::exception_ptr failure;
    for (const AidTrial &trial : trials(may_lean, structure.has_springs()))
      try
        {
          regularization.shift.reset();
          regularization.regularization_factor = trial.regularization_factor;
          if (trial.shift > 0.)
            regularization.shift =
              std::make_unique<const ActiveConstraintShift>(
                contacts.interfaces(),
                state,
                structure.bodies().size(),
                trial.shift);
          if (regularization.shift && regularization.shift->none())
            continue;
          ActiveConstraintShift::Springs more;
          if (regularization.shift)
            more = regularization.shift->springs();
          else if (regularization.regularization_factor > 1.)
            more =
              springs_of(structure, regularization.regularization_factor - 1.);
          return TangentOperator(
            structure, state.u, requested, monitor, correction, to, more);
        }
      catch (const IllConditioned &)
        {
          failure = std::current_exception();
        }
    std::rethrow_exception(failure);
  }



  // S w = sum_k c s_k r_k^T (r_k w), c the regularization factor.
  void
  Newton::add_spring_forces(const double       regularization_factor,
                            const BlockVector &w,
                            BlockVector       &f) const
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const auto &[row, stiffness] : structure.spring_terms(b))
        row.add_to(f.block(b),
                   regularization_factor * stiffness * row(w.block(b)));
  }



  namespace
  {
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



    /// Norm of loads plus sum of the contact forces of @p state at @p to.
    double
    size_of_forces(const Structure  &structure,
                   const State      &state,
                   const LoadFactor &to)
    {
      double size = structure.load(to, state.u).l2_norm();
      for (const double force : state.force)
        size += std::abs(force);
      return size;
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



  // Energy criterion of Newton::check_supports(): second variation of the
  // energy in the subspace V = C R^T of motions that only springs restrain; it
  // is negative for an unstable equilibrium.
  bool
  Newton::check_supports(const State &state, const LoadFactor &to) const
  {
    const double pressing = size_of_forces(structure, state, to);
    if (contacts.rows().has_friction() || pressing == 0.)
      return false;
    // Bodies without strain have rounding for stresses: nothing to check.
    const BlockVector internal = structure.internal_forces(state.u, state.rest);
    if (is_rounding(TangentOperator(structure, state.u), internal, state.u))
      return false;
    Regularization        regularization;
    const TangentOperator about =
      tangent(state, BlockVector(), to, regularization);
    const GapConstraints rows =
      regularization.shift ? regularization.shift->rows() : contacts.rows();
    const auto loads =
      loads_of_springs(structure, regularization.regularization_factor);
    const auto                 modes = answers(about, rows, state, loads);
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
} // namespace lamella
