// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/factorisation.h>
#include <lamella/solve/linearisation.h>
#include <lamella/solve/lost_digits.h>

#include <algorithm>

namespace lamella
{
  Linearisation::Linearisation(const Structure &structure, const BlockVector &u)
    : structure(structure)
    , state(u)
  {}



  Linearisation::Linearisation(const Structure   &structure,
                               const BlockVector &u,
                               const SolverKind   asked,
                               const BodyMonitor &monitor,
                               const BlockVector &correction)
    : Linearisation(structure, u)
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
            solvers.push_back(body.make_tangent_solver(
              state.block(b),
              correction.n_blocks() > 0 ? correction.block(b) : none,
              structure.reduction(b).constraints(),
              structure.spring_terms(b),
              asked,
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
  Linearisation::solve(BlockVector r) const
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
