// SPDX-License-Identifier: LGPL-2.1-or-later

// What makes the tangent of Newton's method definite, and whether a state
// stands without it.

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
    /// What is tried in turn until the tangent is definite: the share of the
    /// penalty that leaning rows have, and by how much stabilizing springs are
    /// regularization_factor than asked for.
    struct AidTrial
    {
      double shift = 0., regularization_factor = 1.;
    };



    std::vector<AidTrial>
    trials(const bool may_lean, const bool has_springs)
    {
      // As little as makes it definite.
      std::vector<AidTrial> all{{}};
      if (may_lean)
        all.insert(all.end(), {{1e-3, 1.}, {0.5, 1.}});
      if (has_springs)
        all.insert(all.end(), {{0., 1e2}, {0., 1e3}, {0., 1e4}, {0., 1e5}});
      return all;
    }



    /// The stabilizing springs of all bodies, as many times as @p share.
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



  TangentOperator
  Newton::tangent(const State       &state,
                  const BlockVector &correction,
                  const LoadFactor  &to,
                  Regularization    &regularization) const
  {
    // A row that leans has a spring for its gap, and its slip would hang on
    // what that bears.
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
    /// The root of k times r of each stabilizing spring, as a load.
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



    /// The numbers of modes that make the energy of @p A, made symmetric,
    /// least, and that energy: its first eigenpair.
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



    /// What loads and contact forces of @p state at @p to are in all.
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



    /// What each of @p loads moves bodies by about the state that @p about is
    /// of, with the @p rows of @p state that bear a force held.
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



  bool
  Newton::check_supports(const State &state, const LoadFactor &to) const
  {
    const double pressing = size_of_forces(structure, state, to);
    if (contacts.rows().has_friction() || pressing == 0.)
      return false;
    // What is carried along has rounding for stresses.
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
    const auto [least, share] = least_of(energy);
    BlockVector way           = structure.zero();
    for (unsigned int i = 0; i < modes.size(); ++i)
      way.add(share[i], modes[i]);
    const double length = length_of(way);
    if (least < -parameters.instability_share * pressing / structure.size() *
                  length * length)
      throw NumericsError(
        "solve.unstable-body: Only stabilizing springs prevent a body from "
        "turning over or sliding away under its loads. Add a Support.");
    return true;
  }
} // namespace lamella
