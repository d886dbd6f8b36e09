// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/factorisation.h>
#include <lamella/solve/linearisation.h>
#include <lamella/solve/lost_digits.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>

namespace lamella
{
  Linearisation::Linearisation(const Structure   &structure,
                               const BlockVector &u,
                               const LoadFactor  &factor)
    : structure(structure)
    , state(u)
    , factor(factor)
  {}



  Linearisation::Linearisation(const Structure   &structure,
                               const BlockVector &u,
                               const SolverKind   asked,
                               const BodyMonitor &monitor,
                               const BlockVector &correction,
                               const LoadFactor  &factor)
    : Linearisation(structure, u, factor)
  {
    const Vector none;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        const Body   &body = *structure.bodies()[b];
        SolverMonitor of_body;
        if (monitor.begins)
          monitor.begins(body);
        if (monitor.assembled)
          of_body.assembled = [&] { monitor.assembled(body); };
        if (monitor.sized)
          of_body.sized = [&](const FactorSize &size) {
            monitor.sized(body, size);
          };
        of_body.advanced = monitor.advanced;
        try
          {
            solvers.push_back(make_solver(b,
                                          asked,
                                          correction.n_blocks() > 0 ?
                                            correction.block(b) :
                                            none,
                                          of_body));
          }
        catch (const NotPositiveDefinite &error)
          {
            throw LostDigits(error.what());
          }
        if (monitor.ends)
          monitor.ends(body);
      }
  }



  std::unique_ptr<LinearSolver>
  Linearisation::make_solver(const unsigned int   body,
                             const SolverKind     asked,
                             const Vector        &correction,
                             const SolverMonitor &monitor) const
  {
    const Body        &one         = *structure.bodies()[body];
    const Vector      &u           = state.block(body);
    const Constraints &constraints = structure.reduction(body).constraints();
    const auto         springs     = structure.spring_terms(body);
    if (!structure.has_turning_loads(body))
      return one.make_tangent_solver(
        u, correction, constraints, springs, asked, monitor);
    StiffnessTerms terms       = one.tangent_terms(u, correction, springs);
    const auto     of_stresses = terms.for_each_block;
    terms.for_each_block       = [&](const bool with_values, const auto &use) {
      of_stresses(with_values, use);
      structure.for_each_block_of_loads(body, factor, u, with_values, use);
    };
    return one.solver_of(terms, constraints, asked, monitor);
  }



  StiffnessTerms
  Linearisation::terms(const unsigned int body) const
  {
    return structure.bodies()[body]->tangent_terms(
      state.block(body), Vector(), structure.spring_terms(body));
  }



  BlockVector
  Linearisation::apply(const BlockVector &w) const
  {
    BlockVector f = structure.zero();
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        structure.bodies()[b]->add_tangent_forces(state.block(b),
                                                  w.block(b),
                                                  f.block(b));
        for (const Spring &spring : structure.springs(b))
          spring.row.add_to(f.block(b),
                            spring.stiffness * spring.row(w.block(b)));
      }
    return f;
  }



  const LinearSolver &
  Linearisation::solver(const unsigned int body) const
  {
    Assert(body < solvers.size(), dealii::ExcMessage("It has no solvers."));
    return *solvers[body];
  }



  BlockVector
  Linearisation::skew_part(const BlockVector &w) const
  {
    BlockVector f = structure.zero();
    structure.add_derivative_of_loads(factor, state, w, f);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      structure.for_each_block_of_loads(
        b, factor, state.block(b), true, [&](const StiffnessBlock &block) {
          block.add_product(w.block(b), f.block(b));
        });
    f *= -1.;
    return f;
  }



  BlockVector
  Linearisation::solve(BlockVector r) const
  {
    r                 = solve_symmetric(std::move(r));
    bool is_symmetric = true;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      is_symmetric &= !structure.has_turning_loads(b);
    if (is_symmetric)
      return r;
    struct
    {
      const Linearisation &K;
      void
      vmult(BlockVector &to, const BlockVector &from) const
      {
        to = K.solve_symmetric(K.skew_part(from));
        to += from;
      }
    } whole{*this};
    constexpr unsigned int most = 30;
    dealii::SolverControl  control(
      most, arithmetic::rounding_of_solutions * r.l2_norm(), false, false);
    BlockVector x = r;
    try
      {
        dealii::SolverGMRES<BlockVector>(control).solve(
          whole, x, r, dealii::PreconditionIdentity());
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return r;
      }
    return x;
  }



  BlockVector
  Linearisation::solve_symmetric(BlockVector r) const
  {
    structure.condense(r);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        solver(b).solve(r.block(b));
        structure.reduction(b).constraints().distribute(r.block(b));
      }
    return r;
  }



  double
  Linearisation::largest_stiffness(const unsigned int body) const
  {
    if (body < solvers.size())
      return solvers[body]->largest_diagonal();
    stiffest.resize(structure.bodies().size(), 0.);
    if (stiffest[body] == 0.)
      stiffest[body] =
        structure.bodies()[body]
          ->assembled_stiffness(structure.reduction(body).constraints(),
                                structure.spring_terms(body))
          ->diagonal()
          .linfty_norm();
    return stiffest[body];
  }



  double
  Linearisation::condition_estimate() const
  {
    double largest = 0.;
    for (const auto &one : solvers)
      largest = std::max(largest, one->condition_estimate());
    return largest;
  }



  std::shared_ptr<const Linearisation>
  linearised(const Structure                  &structure,
             const SolverKind                  asked,
             const Linearisation::BodyMonitor &monitor)
  {
    return std::make_shared<const Linearisation>(structure,
                                                 structure.zero(),
                                                 asked,
                                                 monitor);
  }



  std::shared_ptr<const Linearisation>
  linearised_without_solvers(const Structure &structure)
  {
    return std::make_shared<const Linearisation>(structure, structure.zero());
  }
} // namespace lamella
