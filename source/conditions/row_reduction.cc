// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/row_reduction.h>

#include <boost/pending/disjoint_sets.hpp>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // An entry below this fraction of its column's largest at the start is
    // rounding.
    constexpr double rank_tolerance = 1e-9;
    // So is what is left of the value of a row that depends on others, below
    // this fraction of the largest value: pivots may be small (rows of a skew
    // line), and rounding grows by their inverse.
    constexpr double contradiction = 1e-6;
    // Weights that differ by less are the same, but for the rounding of places.
    constexpr double same = 1e-12;

    /// The functionals of those of @p rows that belong to @p body, number
    /// @p index, in the DoFs that its theory leaves independent; others empty.
    std::vector<Row>
    functionals_of(const Body                       &body,
                   const unsigned int                index,
                   const std::vector<PrescribedRow> &rows)
    {
      std::vector<Row> functionals(rows.size());
      for (unsigned int r = 0; r < rows.size(); ++r)
        if (rows[r].row.body == index)
          functionals[r] =
            body.kinematic_constraints().n_constraints() == 0 ?
              rows[r].row.row :
              rows[r].row.row.reduced(body.kinematic_constraints());
      return functionals;
    }



    /// Those @p functionals of @p body that have entries, in groups that share
    /// DoFs.
    std::vector<std::vector<unsigned int>>
    groups_of_rows(const Body &body, const std::vector<Row> &functionals)
    {
      std::vector<DofIndex>     parent(body.n_dofs());
      std::vector<unsigned int> rank(body.n_dofs(), 0);
      std::iota(parent.begin(), parent.end(), 0);
      boost::disjoint_sets<unsigned int *, DofIndex *> sets(rank.data(),
                                                            parent.data());
      for (const Row &row : functionals)
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
  } // namespace



  /// A row under elimination: what is left of it and of its right-hand side.
  struct RowReduction::Equation
  {
    unsigned int               number;
    std::map<DofIndex, double> entries;
    double                     value;
    DofIndex                   pivot = numbers::invalid_dof_index;

    double
    entry(const DofIndex dof) const
    {
      const auto found = entries.find(dof);
      return found == entries.end() ? 0. : found->second;
    }

    /// Returns the DoFs that come in.
    std::vector<DofIndex>
    subtract(const Equation &other, const double factor)
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
      value -= factor * other.value;
      return fresh;
    }
  };



  namespace
  {
    /// The columns of @p equations, coarse levels first, with their scales.
    template <typename Equations>
    std::vector<std::pair<DofIndex, double>>
    ordered_columns(const Body &body, const Equations &equations)
    {
      std::map<std::pair<unsigned int, DofIndex>, double> scale;
      for (const auto &equation : equations)
        for (const auto &[dof, weight] : equation.entries)
          {
            double &s = scale[{body.dof_level(dof), dof}];
            s         = std::max(s, std::abs(weight));
          }
      std::vector<std::pair<DofIndex, double>> columns;
      for (const auto &[key, s] : scale)
        columns.emplace_back(key.second, s);
      return columns;
    }



    /// The one of @p equations, all with an entry of @p dof, to eliminate it
    /// with; null if none is above @p threshold.
    template <typename Equation>
    Equation *
    find_pivot(const std::vector<Equation *> &equations,
               const DofIndex                 dof,
               const double                   threshold)
    {
      double largest = threshold;
      for (const Equation *equation : equations)
        if (equation->pivot == numbers::invalid_dof_index)
          largest = std::max(largest, std::abs(equation->entry(dof)));
      Equation *best = nullptr;
      for (Equation *equation : equations)
        if (equation->pivot == numbers::invalid_dof_index &&
            std::abs(equation->entry(dof)) >= 0.1 * largest &&
            std::abs(equation->entry(dof)) > threshold &&
            (best == nullptr ||
             equation->entries.size() < best->entries.size()))
          best = equation;
      return best;
    }
  } // namespace



  /// The rows of a group with what their elimination left.
  struct RowReduction::Elimination
  {
    std::vector<unsigned int> rows;
    std::vector<Equation>     equations;
    double                    largest_value = 0.;
    Group                     independent;

    /// Whether the rows @p group are these but for a shift of all DoFs, which
    /// it returns: the supports of a body along its axis are, node by node.
    std::optional<DofIndex>
    shift_to(const std::vector<unsigned int>  &group,
             const std::vector<Row>           &functionals,
             const std::vector<PrescribedRow> &prescribed,
             const Body                       &body) const
    {
      if (group.size() != rows.size())
        return {};
      // Unsigned arithmetic: a shift downwards wraps and comes back.
      const DofIndex shift = functionals[group[0]].entries()[0].first -
                             functionals[rows[0]].entries()[0].first;
      for (unsigned int k = 0; k < rows.size(); ++k)
        {
          const auto &here  = functionals[rows[k]].entries(),
                     &there = functionals[group[k]].entries();
          if (here.size() != there.size() ||
              prescribed[rows[k]].value != prescribed[group[k]].value)
            return {};
          double largest = 0.;
          for (const auto &[dof, weight] : here)
            largest = std::max(largest, std::abs(weight));
          for (unsigned int i = 0; i < here.size(); ++i)
            if (here[i].first + shift != there[i].first ||
                std::abs(here[i].second - there[i].second) > same * largest ||
                body.dof_level(here[i].first) != body.dof_level(there[i].first))
              return {};
        }
      return shift;
    }

    /// Makes this the elimination of @p group, shifted by @p shift.
    void
    move_to(const std::vector<unsigned int> &group, const DofIndex shift)
    {
      std::map<unsigned int, unsigned int> number;
      for (unsigned int k = 0; k < rows.size(); ++k)
        number[rows[k]] = group[k];
      rows = group;
      for (unsigned int &row : independent.rows)
        row = number.at(row);
      for (DofIndex &dof : independent.pivots)
        dof += shift;
      for (Equation &equation : equations)
        {
          equation.number = number.at(equation.number);
          if (equation.pivot != numbers::invalid_dof_index)
            equation.pivot += shift;
          std::map<DofIndex, double> shifted;
          for (const auto &[dof, weight] : equation.entries)
            shifted.emplace_hint(shifted.end(), dof + shift, weight);
          equation.entries = std::move(shifted);
        }
    }
  };



  RowReduction::Elimination
  RowReduction::eliminate(const Body                       &body,
                          const std::vector<unsigned int>  &group,
                          const std::vector<Row>           &functionals,
                          const std::vector<PrescribedRow> &rows)
  {
    Elimination result;
    result.rows                      = group;
    std::vector<Equation> &equations = result.equations;
    for (const unsigned int r : group)
      {
        equations.push_back({r, {}, rows[r].value});
        result.largest_value =
          std::max(result.largest_value, std::abs(rows[r].value));
        for (const auto &[dof, weight] : functionals[r].entries())
          equations.back().entries.emplace(dof, weight);
      }

    // Which equations have an entry of a DoF, or once had.
    std::map<DofIndex, std::set<Equation *>> users;
    for (Equation &equation : equations)
      for (const auto &[dof, weight] : equation.entries)
        users[dof].insert(&equation);

    Group &independent = result.independent;
    for (const auto &[dof, scale] : ordered_columns(body, equations))
      {
        const std::vector<Equation *> with_dof(users[dof].begin(),
                                               users[dof].end());
        Equation *pivot = find_pivot(with_dof, dof, rank_tolerance * scale);
        if (pivot == nullptr)
          continue;
        pivot->pivot          = dof;
        const double diagonal = pivot->entry(dof);
        for (auto &[other, weight] : pivot->entries)
          weight /= diagonal;
        pivot->value /= diagonal;
        for (Equation *equation : with_dof)
          if (equation != pivot && equation->entry(dof) != 0.)
            {
              for (const DofIndex other :
                   equation->subtract(*pivot, equation->entry(dof)))
                users[other].insert(equation);
              equation->entries.erase(dof);
            }
        independent.rows.push_back(pivot->number);
        independent.pivots.push_back(dof);
      }
    factorise(independent, functionals);
    return result;
  }



  void
  RowReduction::keep(const Elimination                &elimination,
                     const Body                       &body,
                     const std::vector<PrescribedRow> &rows,
                     const std::vector<std::string>   &support_names)
  {
    for (const Equation &equation : elimination.equations)
      if (equation.pivot == numbers::invalid_dof_index)
        {
          if (std::abs(equation.value) >
              contradiction * elimination.largest_value)
            throw InputError(
              "Support " + support_names[rows[equation.number].support],
              "",
              "contradicts the other supports of body '" + body.name() +
                "' at " + to_text(rows[equation.number].position) +
                ": they prescribe different displacements of the same points",
              "Remove one of them, make them agree, or put more elements "
              "between them.");
        }
      else
        {
          homogeneous.add_line(equation.pivot);
          for (const auto &[dof, weight] : equation.entries)
            if (dof != equation.pivot && std::abs(weight) > 1e-14)
              homogeneous.add_entry(equation.pivot, dof, -weight);
          particular_solution[equation.pivot] = equation.value;
        }
    groups.push_back(elimination.independent);
  }



  void
  RowReduction::factorise(Group                  &independent,
                          const std::vector<Row> &functionals)
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



  RowReduction::RowReduction(const Body                       &body,
                             const unsigned int                index,
                             const std::vector<PrescribedRow> &rows,
                             const std::vector<std::string>   &support_names)
    : kinematic(body.kinematic_constraints())
    , particular_solution(body.n_dofs())
  {
    const std::vector<Row>     functionals = functionals_of(body, index, rows);
    std::optional<Elimination> last;
    for (const auto &group : groups_of_rows(body, functionals))
      {
        const auto shift =
          last ? last->shift_to(group, functionals, rows, body) : std::nullopt;
        if (shift)
          last->move_to(group, *shift);
        else
          last = eliminate(body, group, functionals, rows);
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
    for (const Group &group : groups)
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
    for (const Group &group : groups)
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
