// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/contact/interface_law.h>
#include <lamella/solve/small_motions.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Relative error of solutions from which eigenvectors are computed: errors
    // of eigenvalues are its square.
    const double accurate = std::sqrt(arithmetic::rounding);
  } // namespace



  GeometricStiffness::GeometricStiffness(LinearSystem &solver,
                                         const State  &state)
  {
    const Structure &structure = solver.tangent().of();
    BlockVector      load      = structure.zero(), v;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        bodies.push_back(structure.bodies()[b]->second_order(state.u.block(b)));
        bodies[b]->add_load(load.block(b));
      }
    const ActiveConstraints held = solver.sticking_equations(state);
    Vector                  gaps(held.numbers.size()), forces;
    solver.solve_linear(held, load, gaps, v, forces);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      energies.push_back(bodies[b]->solve(v.block(b)));
  }



  BlockVector
  GeometricStiffness::operator()(const BlockVector &v) const
  {
    BlockVector f = v;
    f             = 0.;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      bodies[b]->add_geometric_forces(v.block(b), f.block(b));
    return f;
  }



  double
  GeometricStiffness::largest_short_wave_ratio() const
  {
    double largest = 0.;
    for (const auto &body : bodies)
      largest = std::max(largest, body->largest_short_wave_ratio());
    return largest;
  }



  SmallMotions::SmallMotions(LinearSystem  &system,
                             const State   &state,
                             const Operator weight,
                             const Operator prestress)
    : system(system)
    , structure(system.tangent().of())
    , rows(system.constraints())
    , closed(system.sticking_equations(state))
    , weight(weight)
    , prestress(prestress)
  {
    const double error = error_without_refinement();
    choose_refinements(error, arithmetic::rounding_of_solutions);
    remove_springs();
    choose_refinements(error, accurate);
  }



  // The relative correction of the first solution is the error of each.
  double
  SmallMotions::error_without_refinement()
  {
    const BlockVector load  = random_vector(structure.zero());
    refinements             = 0;
    const BlockVector first = solve_with_springs(load);
    refinements             = 1;
    BlockVector change      = solve_with_springs(load);
    change -= first;
    const double error = change.l2_norm() / first.l2_norm();
    if (!std::isfinite(error))
      throw NumericsError(
        "solve.not-finite: The solution is not finite. Check the loads.");
    return error;
  }



  // Every refinement multiplies the error by that of the first solution.
  void
  SmallMotions::choose_refinements(const double error, const double wanted)
  {
    constexpr double most = 5.;
    refinements =
      error <= wanted ?
        0 :
        std::min(most,
                 std::ceil(std::log(wanted) / std::log(std::min(0.5, error))) -
                   1.);
  }



  BlockVector
  SmallMotions::solve_with_springs(const BlockVector &f) const
  {
    BlockVector u, r = f;
    Vector      lambda(closed.numbers.size()), g(lambda.size());
    for (unsigned int k = 0; k <= refinements; ++k)
      {
        BlockVector du;
        Vector      dlambda;
        system.contact_strategy().solve(closed, r, g, du, dlambda);
        if (k == 0)
          u = du;
        else
          u += du;
        for (unsigned int i = 0; i < lambda.size(); ++i)
          lambda[i] += dlambda[i];
        if (k == refinements)
          break;
        // Residuals of equilibrium and of the closed constraints.
        r = system.tangent().apply(u);
        r.sadd(-1., 1., f);
        for (unsigned int i = 0; i < lambda.size(); ++i)
          {
            const unsigned int       number = closed.numbers[i];
            const ContactConstraint &row    = rows.constraint(number);
            row.add_to(r, lambda[i]);
            g[i] = -row.jump(u) - law_compliance(rows, number) * lambda[i];
          }
      }
    return u;
  }



  void
  SmallMotions::remove_springs()
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const Spring &spring : structure.springs(b))
        {
          springs.push_back({b, {}});
          springs.back().row.add(spring.row, std::sqrt(spring.stiffness));
          BlockVector load = structure.zero();
          springs.back().add_to(load, 1.);
          Z.push_back(solve_with_springs(load));
        }
    const unsigned int n = springs.size();
    correction.reinit(n, n);
    if (n == 0)
      return;
    LAPACKFullMatrix<double> G(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        G(i, j) = 0.5 * (springs[i](Z[j]) + springs[j](Z[i]));
    Vector             g;
    FullMatrix<double> q;
    G.compute_eigenvalues_symmetric(-1., 2., 0., g, q);
    for (unsigned int k = 0; k < g.size(); ++k)
      {
        // A motion that springs alone hold has G q = q.
        if (1. - g[k] > arithmetic::dependency_tolerance)
          {
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                correction(i, j) += q(i, k) * q(j, k) / (1. - g[k]);
            continue;
          }
        BlockVector motion = structure.zero();
        for (unsigned int i = 0; i < n; ++i)
          motion.add(q(i, k), Z[i]);
        add_rigid_motion(std::move(motion));
      }
  }



  // Gram-Schmidt in the inner product of M; obstacles have no mass.
  void
  SmallMotions::add_rigid_motion(BlockVector motion)
  {
    subtract_rigid_motions(motion);
    BlockVector  weighted = weight(motion);
    const double mass     = weighted * motion;
    if (!(mass > 0.))
      return;
    motion /= std::sqrt(mass);
    weighted /= std::sqrt(mass);
    rigid.push_back(std::move(motion));
    weighted_rigid.push_back(std::move(weighted));
  }



  void
  SmallMotions::subtract_rigid_motions(BlockVector &v) const
  {
    for (unsigned int i = 0; i < rigid.size(); ++i)
      v.add(-(weighted_rigid[i] * v), rigid[i]);
  }



  BlockVector
  SmallMotions::solve_without_prestress(BlockVector f) const
  {
    for (unsigned int i = 0; i < rigid.size(); ++i)
      f.add(-(rigid[i] * f), weighted_rigid[i]);
    BlockVector  u = solve_with_springs(f);
    const Vector s = [&] {
      Vector lengths(springs.size());
      for (unsigned int i = 0; i < springs.size(); ++i)
        lengths[i] = springs[i](u);
      return lengths;
    }();
    for (unsigned int i = 0; i < springs.size(); ++i)
      for (unsigned int j = 0; j < springs.size(); ++j)
        u.add(correction(i, j) * s[j], Z[i]);
    subtract_rigid_motions(u);
    return u;
  }



  // Left-preconditioned GMRES for (1 + K^-1 K_G) v = K^-1 f: eigenvalues of
  // K^-1 K_G cluster at zero, so a few iterations are enough.
  BlockVector
  SmallMotions::solve(const BlockVector &f) const
  {
    BlockVector u = solve_without_prestress(f);
    if (!prestress)
      return u;
    struct
    {
      const SmallMotions &motions;
      void
      vmult(BlockVector &to, const BlockVector &from) const
      {
        to = motions.solve_without_prestress(motions.prestress(from));
        to += from;
      }
    } whole{*this};
    constexpr unsigned int most  = 100;
    const BlockVector      right = u;
    SolverControl control(most, accurate * right.l2_norm(), false, false);
    try
      {
        SolverGMRES<BlockVector>(control,
                                 SolverGMRES<BlockVector>::AdditionalData(most))
          .solve(whole, u, right, PreconditionIdentity());
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw NumericsError(
          "solve.prestress-too-large: The stresses of the last load step are so "
          "large that natural modes with them could not be computed in linear "
          "kinematics. Use Rotations = large.");
      }
    return u;
  }



  BlockVector
  SmallMotions::times_stiffness(const BlockVector &v) const
  {
    BlockVector f = system.tangent().apply(v);
    for (const BodyFunctional &spring : springs)
      spring.add_to(f, -spring(v));
    for (const unsigned int number : closed.numbers)
      if (const double a = law_compliance(rows, number); a > 0.)
        {
          const ContactConstraint &row = rows.constraint(number);
          row.add_to(f, row.jump(v) / a);
        }
    if (prestress)
      f += prestress(v);
    return f;
  }



  double
  SmallMotions::largest_jump(const BlockVector &v) const
  {
    double largest = 0.;
    for (const unsigned int number : closed.numbers)
      largest = std::max(largest, std::abs(rows.constraint(number).jump(v)));
    return largest;
  }



  unsigned int
  SmallMotions::n_free_dofs() const
  {
    DofIndex n = structure.n_dofs(), constrained = rigid.size();
    for (const unsigned int number : closed.numbers)
      constrained += law_compliance(rows, number) == 0.;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      constrained +=
        system.tangent().reduction(b).constraints().n_constraints();
    return n > constrained ? n - constrained : 0;
  }



  MassMatrix::MassMatrix(const Structure &structure, const BlockVector &u)
    : patterns(structure.bodies().size())
    , matrices(structure.bodies().size())
  {
    for (unsigned int b = 0; b < matrices.size(); ++b)
      {
        const Body                    &body = *structure.bodies()[b];
        dealii::DynamicSparsityPattern pattern(body.n_dofs());
        body.for_each_mass_block(u.block(b),
                                 false,
                                 [&](const StiffnessBlock &block) {
                                   for (const DofIndex row : block.rows)
                                     pattern.add_entries(row,
                                                         block.columns.begin(),
                                                         block.columns.end(),
                                                         block.columns_ascend);
                                 });
        patterns[b].copy_from(pattern);
        matrices[b].reinit(patterns[b]);
        body.for_each_mass_block(
          u.block(b), true, [&](const StiffnessBlock &block) {
            for (unsigned int i = 0; i < block.rows.size(); ++i)
              matrices[b].add(block.rows[i],
                              block.columns.size(),
                              block.columns.data(),
                              &block.values[i * block.columns.size()],
                              true,
                              block.columns_ascend);
          });
      }
  }



  BlockVector
  MassMatrix::operator()(const BlockVector &v) const
  {
    BlockVector result(v);
    for (unsigned int b = 0; b < matrices.size(); ++b)
      {
        matrices[b].vmult(result.block(b), v.block(b));
        sum_over_processes(result.block(b));
      }
    return result;
  }



  std::vector<double>
  MassMatrix::energies(const BlockVector &v) const
  {
    const BlockVector   momentum = (*this)(v);
    std::vector<double> energies;
    for (unsigned int b = 0; b < matrices.size(); ++b)
      energies.push_back(0.5 * (momentum.block(b) * v.block(b)));
    return energies;
  }



  VibrationEquations::VibrationEquations(LinearSystem             &system,
                                         const State              &state,
                                         const GeometricStiffness *prestress)
    : system(system)
    , state(state)
    , prestress(prestress)
    , mass(system.tangent().of(), state.u)
    , motions(
        system,
        state,
        [this](const BlockVector &v) { return mass(v); },
        prestress == nullptr ?
          Operator() :
          [prestress](const BlockVector &v) { return (*prestress)(v); })
  {}



  std::vector<BlockVector>
  rigid_motions_about(const Structure   &structure,
                      const BlockVector &u,
                      const Point<3>    &center)
  {
    std::vector<BlockVector> motions(6, structure.zero());
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        const Body               &body = *structure.bodies()[b];
        const std::vector<Vector> own  = body.rigid_motions(u.block(b));
        const Tensor<1, 3>        arm  = body.center() - center;
        for (unsigned int m = 0; m < 3; ++m)
          {
            motions[m].block(b)     = own[m];
            motions[3 + m].block(b) = own[3 + m];
            // e_m x arm.
            const unsigned int i = (m + 1) % 3, j = (m + 2) % 3;
            motions[3 + m].block(b).add(-arm[j], own[i]);
            motions[3 + m].block(b).add(arm[i], own[j]);
          }
      }
    return motions;
  }
} // namespace lamella
