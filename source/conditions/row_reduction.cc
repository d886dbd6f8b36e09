// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
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
    // A row of which less than this is left, of its largest weight at the
    // start, depends on those before: it would hold displacements that are as
    // much smaller than those of the body, and rounding grows by the inverse of
    // what is left (rows of a line that nearly is one of the mesh).
    constexpr double dependent = arithmetic::dependent;
    // What is left of the value of such a row is rounding below this fraction
    // of the largest value.
    constexpr double contradiction = arithmetic::dependent;
    // DoFs that a row eliminates have this of its largest weight or more: those
    // that depend on them are not moved by multiples of that.
    constexpr double stable = 0.1;

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
  /// Its entries are those of displacements, DoFs times their sizes.
  struct RowReduction::Equation
  {
    unsigned int               number;
    std::map<DofIndex, double> entries;
    double                     value;
    double                     largest = 0., at_start = 0.;
    DofIndex                   pivot = numbers::invalid_dof_index;

    /// Whether there is enough of it left to eliminate a DoF with.
    bool
    is_open() const
    {
      return pivot == numbers::invalid_dof_index &&
             largest > dependent * at_start;
    }

    void
    find_largest()
    {
      largest = 0.;
      for (const auto &[dof, weight] : entries)
        largest = std::max(largest, std::abs(weight));
    }

    double
    entry(const DofIndex dof) const
    {
      const auto found = entries.find(dof);
      return found == entries.end() ? 0. : found->second;
    }

    /// Takes @p factor times @p other off, and with it @p eliminated. Returns
    /// the DoFs that come in.
    std::vector<DofIndex>
    subtract(const Equation &other,
             const DofIndex  eliminated,
             const double    factor)
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
  };



  namespace
  {
    /// The DoFs in @p equations, coarse levels first.
    template <typename Equations>
    std::vector<DofIndex>
    ordered_columns(const Body &body, const Equations &equations)
    {
      std::set<std::pair<unsigned int, DofIndex>> ordered;
      for (const auto &equation : equations)
        for (const auto &[dof, weight] : equation.entries)
          ordered.emplace(body.dof_level(dof), dof);
      std::vector<DofIndex> columns;
      for (const auto &[level, dof] : ordered)
        columns.push_back(dof);
      return columns;
    }



    /// The one of @p equations, all with an entry of @p dof, to eliminate it
    /// with: the shortest of those whose entry is within a factor of ten of the
    /// largest. Null if @p dof is small in all of them.
    template <typename Equation>
    Equation *
    find_pivot(const std::vector<Equation *> &equations, const DofIndex dof)
    {
      const auto may_eliminate = [dof](const Equation &equation) {
        return equation.is_open() &&
               std::abs(equation.entry(dof)) > stable * equation.largest;
      };
      double largest = 0.;
      for (const Equation *equation : equations)
        if (may_eliminate(*equation))
          largest = std::max(largest, std::abs(equation->entry(dof)));
      Equation *best = nullptr;
      for (Equation *equation : equations)
        if (may_eliminate(*equation) &&
            std::abs(equation->entry(dof)) >= 0.1 * largest &&
            (best == nullptr ||
             equation->entries.size() < best->entries.size()))
          best = equation;
      return best;
    }



    /// Of the open ones among @p equations that of which most is left; null if
    /// there is none.
    template <typename Equation>
    Equation *
    least_dependent(std::vector<Equation> &equations)
    {
      Equation *best = nullptr;
      for (Equation &equation : equations)
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
             const Body                       &body,
             const std::vector<double>        &sizes) const
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
                std::abs(here[i].second - there[i].second) >
                  arithmetic::rounding_of_results * largest ||
                sizes[here[i].first] != sizes[there[i].first] ||
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



  /// Gauss and Jordan's elimination of the equations of a group.
  class RowReduction::GaussJordan
  {
  public:
    explicit GaussJordan(Elimination &group)
      : group(group)
    {
      for (Equation &equation : group.equations)
        for (const auto &[dof, weight] : equation.entries)
          users[dof].insert(&equation);
    }

    /// Coarse DoFs first, each with a row in which it is large; then those rows
    /// that had none, by their largest entries.
    void
    run(const Body &body)
    {
      for (const DofIndex dof : ordered_columns(body, group.equations))
        {
          const std::vector<Equation *> with_dof(users[dof].begin(),
                                                 users[dof].end());
          if (Equation *pivot = find_pivot(with_dof, dof))
            eliminate(*pivot, dof);
        }
      while (Equation *pivot = least_dependent(group.equations))
        eliminate(*pivot, largest_entry(pivot->entries));
    }

  private:
    /// Solves @p pivot for @p dof and takes it out of all others.
    void
    eliminate(Equation &pivot, const DofIndex dof)
    {
      pivot.pivot           = dof;
      const double diagonal = pivot.entry(dof);
      for (auto &[other, weight] : pivot.entries)
        weight /= diagonal;
      pivot.value /= diagonal;
      const std::vector<Equation *> with_dof(users[dof].begin(),
                                             users[dof].end());
      for (Equation *equation : with_dof)
        if (equation != &pivot && equation->entry(dof) != 0.)
          {
            const double factor = equation->entry(dof);
            for (const DofIndex other : equation->subtract(pivot, dof, factor))
              users[other].insert(equation);
          }
      group.independent.rows.push_back(pivot.number);
      group.independent.pivots.push_back(dof);
    }

    Elimination &group;
    /// Which equations have an entry of a DoF, or once had. In their order.
    std::map<DofIndex, std::set<Equation *>> users;
  };



  RowReduction::Elimination
  RowReduction::eliminate(const Body                       &body,
                          const std::vector<unsigned int>  &group,
                          const std::vector<Row>           &functionals,
                          const std::vector<PrescribedRow> &rows,
                          const std::vector<double>        &sizes)
  {
    Elimination result;
    result.rows = group;
    for (const unsigned int r : group)
      {
        result.equations.push_back({r, {}, rows[r].value});
        Equation &equation = result.equations.back();
        for (const auto &[dof, weight] : functionals[r].entries())
          equation.entries.emplace(dof, weight / sizes[dof]);
        equation.find_largest();
        equation.at_start = equation.largest;
        result.largest_value =
          std::max(result.largest_value, std::abs(rows[r].value));
      }
    GaussJordan(result).run(body);
    for (Equation &equation : result.equations)
      if (equation.pivot != numbers::invalid_dof_index)
        {
          for (auto &[dof, weight] : equation.entries)
            weight *= sizes[dof] / sizes[equation.pivot];
          equation.value /= sizes[equation.pivot];
        }
    factorise(result.independent, functionals);
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
            if (dof != equation.pivot &&
                std::abs(weight) > arithmetic::rounding)
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
    const std::vector<double>  sizes       = body.dof_sizes();
    std::optional<Elimination> last;
    for (const auto &group : groups_of_rows(body, functionals))
      {
        const auto shift =
          last ? last->shift_to(group, functionals, rows, body, sizes) :
                 std::nullopt;
        if (shift)
          last->move_to(group, *shift);
        else
          last = eliminate(body, group, functionals, rows, sizes);
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
