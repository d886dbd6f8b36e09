// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/penalty_matrix.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  PenaltyMatrix::PenaltyMatrix(const TangentOperator &tangent_operator,
                               const GapConstraints  &rows,
                               const Symmetry         symmetry)
    : tangent_operator(tangent_operator)
    , structure(tangent_operator.of())
    , rows(rows)
    , symmetry(symmetry)
  {
    assemble_stiffness();
  }



  Constraints
  PenaltyMatrix::constraints_of_all() const
  {
    const auto &blocks = structure.blocks();
    Constraints all;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      for (const auto &line :
           tangent_operator.reduction(b).constraints().get_lines())
        {
          const DofIndex dof = blocks.local_to_global(b, line.index);
          all.add_line(dof);
          for (const auto &[other, weight] : line.entries)
            all.add_entry(dof, blocks.local_to_global(b, other), weight);
        }
    all.close();
    return all;
  }



  namespace
  {
    using Dofs = std::vector<DofIndex>;

    /// Calls @p use(rows, columns, values) with blocks of this process's
    /// stiffness of all bodies and their springs, numbered as the scene.
    template <typename Use>
    void
    for_each_block(const TangentOperator &tangent_operator,
                   const bool             with_values,
                   const Use             &use)
    {
      const Structure &structure = tangent_operator.of();
      const auto      &blocks    = structure.blocks();
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          const auto global = [&](Dofs dofs) {
            for (DofIndex &dof : dofs)
              dof = blocks.local_to_global(b, dof);
            return dofs;
          };
          const StiffnessTerms terms = tangent_operator.terms(b);
          terms.for_each_block(with_values, [&](const StiffnessBlock &block) {
            use(global(block.rows), global(block.columns), block.values);
          });
          // All processes know all springs.
          if (is_root_process())
            for (const auto &[row, stiffness] : terms.springs)
              {
                Dofs                dofs;
                std::vector<double> values;
                for (const auto &[dof, weight] : row.entries())
                  {
                    dofs.push_back(dof);
                    for (const auto &[other, other_weight] : row.entries())
                      values.push_back(stiffness * weight * other_weight);
                  }
                use(global(dofs), global(dofs), values);
              }
        }
    }



    /// The DoFs and weights of a gap or a slip in the numbering of the scene.
    LinearFunctional
    global_row(const Structure &structure, const ContactConstraint &row)
    {
      const auto      &blocks = structure.blocks();
      LinearFunctional result;
      for (const BodyFunctional &part : row.parts)
        for (const auto &[dof, weight] : part.row.entries())
          result.add(blocks.local_to_global(part.body, dof), weight);
      result.compress();
      return result;
    }



    Dofs
    dofs_of(const LinearFunctional &row)
    {
      Dofs dofs;
      for (const auto &[dof, weight] : row.entries())
        dofs.push_back(dof);
      return dofs;
    }



    /// Those of a gap and its slips.
    Dofs
    dofs_of(const Structure &structure, const GapConstraint &row)
    {
      LinearFunctional all = global_row(structure, row);
      for (const SlipConstraint &slip : row.slips)
        for (const DofIndex dof : dofs_of(global_row(structure, slip)))
          all.add(dof, 1.);
      all.compress();
      return dofs_of(all);
    }



    /// The DoFs that remain of @p dofs, flagged in @p written.
    void
    add_free(const Constraints &constraints,
             const Dofs        &dofs,
             std::vector<bool> &written)
    {
      for (const DofIndex dof : dofs)
        if (!constraints.is_constrained(dof))
          written[dof] = true;
        else
          for (const auto &[other, weight] :
               *constraints.get_constraint_entries(dof))
            written[other] = true;
    }



    /// Those of @p owned, and those that are flagged.
    IndexSet
    sorted_union(const IndexSet &owned, const std::vector<bool> &written)
    {
      Dofs others;
      for (DofIndex i = 0; i < written.size(); ++i)
        if (written[i] && !owned.is_element(i))
          others.push_back(i);
      IndexSet result = owned;
      result.add_indices(others.begin(), others.end());
      result.compress();
      return result;
    }
  } // namespace



  void
  PenaltyMatrix::assemble_stiffness()
  {
    const DofIndex n        = structure.n_dofs();
    constraints             = constraints_of_all();
    owned                   = IndexSet(n);
    const std::uint64_t all = n;
    owned.add_range(all * this_process() / n_processes(),
                    all * (this_process() + 1) / n_processes());

    std::vector<bool> written(n, false);
    for_each_block(tangent_operator,
                   false,
                   [&](const Dofs &rows, auto &&, auto &&) {
                     add_free(constraints, rows, written);
                   });
    DynamicSparsityPattern pattern(n, n, sorted_union(owned, written));
    for_each_block(tangent_operator,
                   false,
                   [&](const Dofs &rows, const Dofs &columns, auto &&) {
                     constraints.add_entries_local_to_global(rows,
                                                             columns,
                                                             pattern,
                                                             false);
                   });
    for (const DofIndex i : owned)
      pattern.add(i, i);
    stiffness.reinit(owned, owned, pattern, communicator(), true);

    for_each_block(
      tangent_operator,
      true,
      [&](const Dofs &rows, const Dofs &columns, const auto &values) {
        constraints.distribute_local_to_global(
          FullMatrix<double>(rows.size(), columns.size(), values.data()),
          rows,
          columns,
          stiffness);
      });
    stiffness.compress(VectorOperation::add);
    fill_diagonal();
  }



  void
  PenaltyMatrix::fill_diagonal()
  {
    // Constrained DoFs get what others have at most.
    double greatest = 0.;
    for (const DofIndex i : owned)
      greatest = std::max(greatest, std::abs(stiffness.diag_element(i)));
    greatest = Utilities::MPI::max(greatest, communicator());
    diagonal.reinit(structure.n_dofs());
    for (const DofIndex i : owned)
      {
        if (constraints.is_constrained(i))
          stiffness.set(i, i, greatest > 0. ? greatest : 1.);
        diagonal[i] =
          constraints.is_constrained(i) ? greatest : stiffness.diag_element(i);
      }
    stiffness.compress(VectorOperation::insert);
    sum_over_processes(diagonal);
  }



  void
  PenaltyMatrix::extend_pattern(const std::vector<PenaltyTerm> &terms)
  {
    const std::size_t before = known.size();
    for (const PenaltyTerm &term : terms)
      known.insert(rows.row_of(term.of));
    if (factor != nullptr && known.size() == before)
      return;
    std::vector<bool> written(structure.n_dofs(), false);
    std::vector<Dofs> dofs;
    if (is_root_process())
      for (const unsigned int r : known)
        {
          dofs.push_back(dofs_of(structure, rows[r]));
          add_free(constraints, dofs.back(), written);
        }
    DynamicSparsityPattern pattern(structure.n_dofs(),
                                   structure.n_dofs(),
                                   sorted_union(owned, written));
    for_each_own_row(stiffness,
                     [&](const DofIndex      row,
                         const Dofs         &columns,
                         const double *const values) {
                       Dofs places;
                       for (unsigned int k = 0; k < columns.size(); ++k)
                         if (values[k] != 0.)
                           places.push_back(columns[k]);
                       pattern.add_entries(row, places.begin(), places.end());
                     });
    for (const Dofs &of_row : dofs)
      constraints.add_entries_local_to_global(of_row, of_row, pattern, false);
    system.reinit(owned, owned, pattern, communicator(), true);
    factor.reset();
  }



  void
  PenaltyMatrix::add_penalty(const PenaltyTerm &term)
  {
    // k^p = eps n^T n (Eq. 23), with the row in place of n.
    const LinearFunctional of = global_row(structure, rows.constraint(term.of)),
                           on = global_row(structure, rows.constraint(term.on));
    FullMatrix<double> block(of.entries().size(), on.entries().size());
    for (unsigned int i = 0; i < block.m(); ++i)
      for (unsigned int j = 0; j < block.n(); ++j)
        block(i, j) =
          of.entries()[i].second * on.entries()[j].second * term.weight;
    constraints.distribute_local_to_global(block,
                                           dofs_of(of),
                                           dofs_of(on),
                                           system);
  }



  MatrixEntries
  PenaltyMatrix::entries() const
  {
    const bool    all = symmetry == Symmetry::none;
    MatrixEntries entries;
    for_each_own_row(system,
                     [&](const DofIndex      row,
                         const Dofs         &columns,
                         const double *const values) {
                       for (unsigned int k = 0; k < columns.size(); ++k)
                         if (all || columns[k] >= row)
                           {
                             entries.rows.push_back(row + 1);
                             entries.columns.push_back(columns[k] + 1);
                             entries.values.push_back(values[k]);
                           }
                     });
    return entries;
  }



  void
  PenaltyMatrix::factorize(const std::vector<PenaltyTerm> &terms)
  {
    if (is_factorized && factorized_for == terms)
      return;
    extend_pattern(terms);
    system = 0.;
    for_each_own_row(
      stiffness,
      [&](const DofIndex row, const Dofs &columns, const double *const values) {
        system.add(row, columns.size(), columns.data(), values, true);
      });
    if (is_root_process())
      for (const PenaltyTerm &term : terms)
        add_penalty(term);
    system.compress(VectorOperation::add);

    MatrixEntries all = entries();
    is_factorized     = false;
    if (factor == nullptr)
      factor = analyze_shared(structure.n_dofs(),
                              all,
                              symmetry,
                              "the scene with its penalties");
    factor->factorize(std::move(all.values));
    factorized_for = terms;
    is_factorized  = true;
    for (const PenaltyTerm &term : terms)
      {
        if (term.of != term.on)
          continue;
        const double soft = local_compliance(term.of);
        if (soft * term.weight > largest_penalty_ratio)
          {
            largest_penalty_ratio    = soft * term.weight;
            penalty_of_largest_ratio = term.weight;
          }
      }
  }



  BlockVector
  PenaltyMatrix::solve(BlockVector f) const
  {
    Assert(is_factorized, ExcMessage("Nothing is factorized."));
    tangent_operator.condense(f);
    Vector x(f.size());
    std::copy(f.begin(), f.end(), x.begin());
    factor->solve(x);
    constraints.distribute(x);
    std::copy(x.begin(), x.end(), f.begin());
    return f;
  }



  BlockVector
  PenaltyMatrix::apply(const BlockVector &w) const
  {
    BlockVector product(w);
    product = 0.;
    for_each_own_row(stiffness,
                     [&](const DofIndex      row,
                         const Dofs         &columns,
                         const double *const values) {
                       for (unsigned int k = 0; k < columns.size(); ++k)
                         if (!constraints.is_constrained(row))
                           product[row] += values[k] * w[columns[k]];
                     });
    for (unsigned int b = 0; b < product.n_blocks(); ++b)
      sum_over_processes(product.block(b));
    return product;
  }



  std::vector<unsigned int>
  PenaltyMatrix::known_rows() const
  {
    return {known.begin(), known.end()};
  }



  void
  PenaltyMatrix::restore(const std::vector<unsigned int> &known_rows)
  {
    known.insert(known_rows.begin(), known_rows.end());
    factor.reset();
    is_factorized = false;
  }



  // ---- what the arithmetic holds

  double
  PenaltyMatrix::local_compliance(const unsigned int number) const
  {
    double                 soft = 0.;
    const LinearFunctional free =
      global_row(structure, rows.constraint(number)).reduced(constraints);
    for (const auto &[dof, weight] : free.entries())
      soft += weight * weight / diagonal[dof];
    return soft;
  }



  std::vector<std::string>
  PenaltyMatrix::warnings() const
  {
    // Rounding leaves an error of about N t eps / k (Nour-Omid and Wriggers,
    // 1987), least together with the penalty's own k / eps at k / sqrt(N t).
    const double t        = std::numeric_limits<double>::epsilon(),
                 n        = structure.n_dofs(),
                 rounding = n * t * largest_penalty_ratio;
    if (rounding < 1e-4)
      return {};
    return {
      "solve.penalty-too-large: the penalty " +
      to_text(penalty_of_largest_ratio, 3) + " is " +
      to_text(largest_penalty_ratio, 2) +
      " times the stiffness of the DoFs that it acts on, so rounding may "
      "change the results by a relative " +
      to_text(rounding, 1) + ". With " + std::to_string(structure.n_dofs()) +
      " DoFs a penalty of about " +
      to_text(penalty_of_largest_ratio / largest_penalty_ratio /
                std::sqrt(n * t),
              2) +
      " is most accurate: write this Penalty, or Contact strategy = condensed"};
  }
} // namespace lamella
