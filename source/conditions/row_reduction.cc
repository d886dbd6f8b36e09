// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/row_reduction.h>

#include <cmath>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // What is left of the value of a row that depends on others is rounding
    // below this fraction of the largest value.
    constexpr double contradiction = arithmetic::dependency_tolerance;
  } // namespace



  void
  RowReduction::keep(const RowElimination                    &elimination,
                     const Body                              &body,
                     const std::vector<PrescribedFunctional> &rows,
                     const std::vector<std::string>          &support_names)
  {
    for (const FunctionalEquation &equation : elimination.equations)
      if (!equation.has_pivot())
        {
          if (std::abs(equation.value) >
              contradiction * elimination.largest_value)
            throw InputError(
              "Support " + support_names[rows[equation.number].support],
              "",
              "conditions.contradicting-supports: supports of body '" +
                body.name() + "' contradict each other at " +
                to_text(rows[equation.number].position) +
                ", with different displacements of the same points",
              "Remove one of these supports, make their displacements and "
              "Factors equal, or use more elements between them.");
        }
      else
        {
          homogeneous.add_line(equation.pivot);
          for (const auto &[dof, weight] : equation.entries)
            if (dof != equation.pivot &&
                std::abs(weight) > arithmetic::rounding)
              homogeneous.add_entry(equation.pivot, dof, -weight);
          particular_solution[equation.pivot] = equation.value;
        }
    groups.push_back(elimination.independent);
  }



  RowReduction::RowReduction(const Body                              &body,
                             const unsigned int                       index,
                             const std::vector<PrescribedFunctional> &rows,
                             const std::vector<std::string> &support_names)
    : kinematic(body.kinematic_constraints())
    , particular_solution(body.n_dofs())
  {
    const BodyConstraints         held(body, index, rows);
    std::optional<RowElimination> last;
    for (const auto &group : held.groups())
      {
        const auto shift = last ? last->find_shift(group, held) : std::nullopt;
        if (shift)
          last->apply_shift_to(group, *shift);
        else
          last.emplace(group, held);
        keep(*last, body, rows, support_names);
      }
    // Closing resolves DoFs that the theory ties to eliminated ones.
    homogeneous.merge(kinematic);
    homogeneous.close();
    kinematic.distribute(particular_solution);
  }



  std::vector<std::pair<unsigned int, double>>
  RowReduction::multipliers(const Vector &residual) const
  {
    // Work on the DoFs that the theory leaves independent.
    Vector independent(residual);
    kinematic.condense(independent);
    std::vector<std::pair<unsigned int, double>> forces;
    for (const IndependentRows &group : groups)
      {
        Vector mu(group.pivots.size());
        for (unsigned int k = 0; k < mu.size(); ++k)
          mu[k] = independent[group.pivots[k]];
        Vector right(mu);
        if (mu.size() > 0)
          group.transposed->vmult(mu, right);
        for (unsigned int k = 0; k < mu.size(); ++k)
          forces.emplace_back(group.rows[k], mu[k]);
      }
    return forces;
  }



  Vector
  RowReduction::influence(
    const std::function<double(const unsigned int)> &weight) const
  {
    Vector result(particular_solution.size());
    for (const IndependentRows &group : groups)
      {
        Vector weights(group.rows.size()), moved(group.rows.size());
        for (unsigned int k = 0; k < weights.size(); ++k)
          weights[k] = weight(group.rows[k]);
        if (weights.all_zero())
          continue;
        group.transposed->Tvmult(moved, weights);
        for (unsigned int k = 0; k < moved.size(); ++k)
          result[group.pivots[k]] = moved[k];
      }
    kinematic.distribute(result);
    return result;
  }
} // namespace lamella
