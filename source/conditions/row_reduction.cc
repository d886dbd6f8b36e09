// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/row_reduction.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // A row of which less than this is left, of its largest weight at the
    // start, depends on those before: it would hold displacements that are as
    // much smaller than those of the body, and rounding grows by the inverse of
    // what is left (rows of a line that nearly is one of the mesh).
    constexpr double dependent = arithmetic::dependency_tolerance;
    // DoFs that a row eliminates have this of its largest weight or more: those
    // that depend on them are not moved by multiples of that.
    constexpr double stable = 0.1;



    /// The DoFs in @p equations, coarse levels first.
    std::vector<DofIndex>
    ordered_columns(const Body                            &body,
                    const std::vector<FunctionalEquation> &equations)
    {
      std::set<std::pair<unsigned int, DofIndex>> ordered;
      for (const auto &equation : equations)
        for (const auto &[dof, weight] : equation.entries)
          ordered.emplace(body.dof(dof).level, dof);
      std::vector<DofIndex> columns;
      for (const auto &[level, dof] : ordered)
        columns.push_back(dof);
      return columns;
    }



    /// The one of @p equations, all with an entry of @p dof, to eliminate it
    /// with: the shortest of those whose entry is within a factor of ten of the
    /// largest. Null if @p dof is small in all of them.
    FunctionalEquation *
    find_pivot(const std::vector<FunctionalEquation *> &equations,
               const DofIndex                           dof)
    {
      const auto may_eliminate = [dof](const FunctionalEquation &equation) {
        return equation.is_open() &&
               std::abs(equation.entry(dof)) > stable * equation.largest;
      };
      double largest = 0.;
      for (const FunctionalEquation *equation : equations)
        if (may_eliminate(*equation))
          largest = std::max(largest, std::abs(equation->entry(dof)));
      FunctionalEquation *best = nullptr;
      for (FunctionalEquation *equation : equations)
        if (may_eliminate(*equation) &&
            std::abs(equation->entry(dof)) >= 0.1 * largest &&
            (best == nullptr ||
             equation->entries.size() < best->entries.size()))
          best = equation;
      return best;
    }



    /// Returns the least dependent open equation, or null.
    FunctionalEquation *
    least_dependent(std::vector<FunctionalEquation> &equations)
    {
      FunctionalEquation *best = nullptr;
      for (FunctionalEquation &equation : equations)
        if (equation.is_open() &&
            (best == nullptr || equation.largest * best->at_start >
                                  best->largest * equation.at_start))
          best = &equation;
      return best;
    }



    /// Where @p entries are largest.
    DofIndex
    largest_entry(const std::map<DofIndex, double> &entries)
    {
      return std::max_element(entries.begin(),
                              entries.end(),
                              [](const auto &a, const auto &b) {
                                return std::abs(a.second) < std::abs(b.second);
                              })
        ->first;
    }



    /// Gauss and Jordan's elimination of the equations of a group.
    class GaussJordan
    {
    public:
      explicit GaussJordan(RowElimination &group)
        : group(group)
      {
        for (FunctionalEquation &equation : group.equations)
          for (const auto &[dof, weight] : equation.entries)
            users[dof].insert(&equation);
      }

      /// Coarse DoFs first, each with a row in which it is large; then those
      /// rows that had none, by their largest entries.
      void
      run(const Body &body)
      {
        for (const DofIndex dof : ordered_columns(body, group.equations))
          {
            const std::vector<FunctionalEquation *> with_dof(users[dof].begin(),
                                                             users[dof].end());
            if (FunctionalEquation *pivot = find_pivot(with_dof, dof))
              eliminate(*pivot, dof);
          }
        while (FunctionalEquation *pivot = least_dependent(group.equations))
          eliminate(*pivot, largest_entry(pivot->entries));
      }

    private:
      /// Solves @p pivot for @p dof and takes it out of all others.
      void
      eliminate(FunctionalEquation &pivot, const DofIndex dof)
      {
        pivot.pivot           = dof;
        const double diagonal = pivot.entry(dof);
        for (auto &[other, weight] : pivot.entries)
          weight /= diagonal;
        pivot.value /= diagonal;
        const std::vector<FunctionalEquation *> with_dof(users[dof].begin(),
                                                         users[dof].end());
        for (FunctionalEquation *equation : with_dof)
          if (equation != &pivot && equation->entry(dof) != 0.)
            {
              const double factor = equation->entry(dof);
              for (const DofIndex other :
                   equation->subtract(pivot, dof, factor))
                users[other].insert(equation);
            }
        group.independent.rows.push_back(pivot.number);
        group.independent.pivots.push_back(dof);
      }

      RowElimination &group;
      /// Which equations have an entry of a DoF, or once had. In their order.
      std::map<DofIndex, std::set<FunctionalEquation *>> users;
    };



    // What is left of the value of a row that depends on others is rounding
    // below this fraction of the largest value.
    constexpr double contradiction = arithmetic::dependency_tolerance;
  } // namespace



  BodyConstraints::BodyConstraints(
    const Body                              &body,
    const unsigned int                       index,
    const std::vector<PrescribedFunctional> &rows)
    : body(body)
    , prescribed(rows)
    , functionals(rows.size())
  {
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (rows[r].row.body == index)
        functionals[r] =
          body.kinematic_constraints().n_constraints() == 0 ?
            rows[r].row.row :
            rows[r].row.row.reduced(body.kinematic_constraints());
  }



  std::vector<std::vector<unsigned int>>
  BodyConstraints::groups() const
  {
    std::vector<DofIndex>     parent(body.n_dofs());
    std::vector<unsigned int> rank(body.n_dofs(), 0);
    std::iota(parent.begin(), parent.end(), 0);
    boost::disjoint_sets<unsigned int *, DofIndex *> sets(rank.data(),
                                                          parent.data());
    for (const LinearFunctional &row : functionals)
      for (const auto &[dof, weight] : row.entries())
        sets.union_set(row.entries().front().first, dof);

    std::map<DofIndex, std::vector<unsigned int>> by_root;
    for (unsigned int r = 0; r < functionals.size(); ++r)
      if (!functionals[r].entries().empty())
        by_root[sets.find_set(functionals[r].entries().front().first)]
          .push_back(r);
    std::vector<std::vector<unsigned int>> groups;
    for (auto &[root, group] : by_root)
      groups.push_back(std::move(group));
    return groups;
  }



  bool
  FunctionalEquation::is_open() const
  {
    return !has_pivot() && largest > dependent * at_start;
  }



  void
  FunctionalEquation::find_largest()
  {
    largest = 0.;
    for (const auto &[dof, weight] : entries)
      largest = std::max(largest, std::abs(weight));
  }



  double
  FunctionalEquation::entry(const DofIndex dof) const
  {
    const auto found = entries.find(dof);
    return found == entries.end() ? 0. : found->second;
  }



  std::vector<DofIndex>
  FunctionalEquation::subtract(const FunctionalEquation &other,
                               const DofIndex            eliminated,
                               const double              factor)
  {
    std::vector<DofIndex> fresh;
    for (const auto &[dof, weight] : other.entries)
      {
        const auto [place, is_new] = entries.emplace(dof, 0.);
        place->second -= factor * weight;
        if (is_new)
          fresh.push_back(dof);
        else if (place->second == 0.)
          entries.erase(place);
      }
    entries.erase(eliminated);
    value -= factor * other.value;
    find_largest();
    return fresh;
  }



  RowElimination::RowElimination(const std::vector<unsigned int> &group,
                                 const BodyConstraints           &held)
    : rows(group)
  {
    for (const unsigned int r : group)
      {
        const double value = held.prescribed[r].value;
        equations.push_back({r, {}, value});
        FunctionalEquation &equation = equations.back();
        for (const auto &[dof, weight] : held.functionals[r].entries())
          equation.entries.emplace(dof, weight / held.body.dof(dof).scale);
        equation.find_largest();
        equation.at_start = equation.largest;
        largest_value     = std::max(largest_value, std::abs(value));
      }
    GaussJordan(*this).run(held.body);
    for (FunctionalEquation &equation : equations)
      if (equation.has_pivot())
        {
          const double of_pivot = held.body.dof(equation.pivot).scale;
          for (auto &[dof, weight] : equation.entries)
            weight *= held.body.dof(dof).scale / of_pivot;
          equation.value /= of_pivot;
        }
    factorize(held.functionals);
  }



  std::optional<DofIndex>
  RowElimination::find_shift(const std::vector<unsigned int> &group,
                             const BodyConstraints           &held) const
  {
    if (group.size() != rows.size())
      return {};
    // Unsigned arithmetic: a shift downwards wraps and comes back.
    const DofIndex shift = held.functionals[group[0]].entries()[0].first -
                           held.functionals[rows[0]].entries()[0].first;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        const auto &here  = held.functionals[rows[k]].entries(),
                   &there = held.functionals[group[k]].entries();
        if (here.size() != there.size() ||
            held.prescribed[rows[k]].value != held.prescribed[group[k]].value)
          return {};
        double largest = 0.;
        for (const auto &[dof, weight] : here)
          largest = std::max(largest, std::abs(weight));
        for (unsigned int i = 0; i < here.size(); ++i)
          {
            if (here[i].first + shift != there[i].first ||
                std::abs(here[i].second - there[i].second) >
                  arithmetic::rounding_of_results * largest)
              return {};
            const DofInfo one   = held.body.dof(here[i].first),
                          other = held.body.dof(there[i].first);
            if (one.scale != other.scale || one.level != other.level)
              return {};
          }
      }
    return shift;
  }



  void
  RowElimination::apply_shift_to(const std::vector<unsigned int> &group,
                                 const DofIndex                   shift)
  {
    std::map<unsigned int, unsigned int> number;
    for (unsigned int k = 0; k < rows.size(); ++k)
      number[rows[k]] = group[k];
    rows = group;
    for (unsigned int &row : independent.rows)
      row = number.at(row);
    for (DofIndex &dof : independent.pivots)
      dof += shift;
    for (FunctionalEquation &equation : equations)
      {
        equation.number = number.at(equation.number);
        if (equation.has_pivot())
          equation.pivot += shift;
        std::map<DofIndex, double> shifted;
        for (const auto &[dof, weight] : equation.entries)
          shifted.emplace_hint(shifted.end(), dof + shift, weight);
        equation.entries = std::move(shifted);
      }
  }



  void
  RowElimination::factorize(const std::vector<LinearFunctional> &functionals)
  {
    // As sparse as the rows are: a section that is held as a whole has one row
    // a node, with entries of that node and of the rigid fields.
    const unsigned int                         n = independent.rows.size();
    std::unordered_map<DofIndex, unsigned int> column;
    for (unsigned int k = 0; k < n; ++k)
      column[independent.pivots[k]] = k;
    DynamicSparsityPattern pattern(n);
    const auto             for_each_entry = [&](const auto &use) {
      for (unsigned int k = 0; k < n; ++k)
        for (const auto &[dof, weight] :
             functionals[independent.rows[k]].entries())
          if (const auto found = column.find(dof); found != column.end())
            use(found->second, k, weight);
    };
    for_each_entry([&](const unsigned int i, const unsigned int k, double) {
      pattern.add(i, k);
    });
    SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    Matrix matrix(sparsity);
    for_each_entry([&](const unsigned int i,
                       const unsigned int k,
                       const double weight) { matrix.set(i, k, weight); });
    const auto transposed = std::make_shared<SparseDirectUMFPACK>();
    if (n > 0)
      transposed->factorize(matrix);
    independent.transposed = transposed;
  }



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
