// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/solve/condensed_strategy.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  using namespace dealii;

  CondensedStrategy::CondensedStrategy(const Structure           &structure,
                                       const std::vector<GapRow> &rows)
    : structure(structure)
    , rows(rows)
    , columns(structure.bodies().size())
  {}



  void
  CondensedStrategy::add_columns(const std::vector<unsigned int> &active)
  {
    for (unsigned int b = 0; b < columns.size(); ++b)
      {
        std::vector<std::pair<unsigned int, Row>> fresh;
        for (const unsigned int r : active)
          for (const BodyRow &part : rows[r].parts)
            if (part.body == b && columns[b].column.count(r) == 0)
              fresh.emplace_back(
                r, part.row.reduced(structure.reduction(b).constraints()));
        if (fresh.empty())
          continue;

        const unsigned int n = structure.bodies()[b]->n_dofs();
        Columns            block(n, fresh.size());
        for (unsigned int k = 0; k < fresh.size(); ++k)
          for (const auto &[dof, weight] : fresh[k].second.entries())
            block(dof, k) += weight;
        structure.bodies()[b]->factorisation().forward(block);
        for (unsigned int k = 0; k < fresh.size(); ++k)
          {
            columns[b].column[fresh[k].first] = columns[b].y.size();
            columns[b].y.emplace_back(&block(0, k), &block(0, k) + n);
          }
      }

    for (const unsigned int r : active)
      if (place.count(r) == 0)
        {
          place[r] = known_rows.size();
          known_rows.push_back(r);
          compliance.emplace_back();
          for (const unsigned int other : known_rows)
            compliance.back().push_back(product(r, other));
        }
  }



  double
  CondensedStrategy::product(const unsigned int row_i,
                             const unsigned int row_j) const
  {
    double sum = 0.;
    for (const BodyColumns &body : columns)
      {
        const auto i = body.column.find(row_i), j = body.column.find(row_j);
        if (i != body.column.end() && j != body.column.end())
          sum += body.y[i->second] * body.y[j->second];
      }
    return sum;
  }



  BlockVector
  CondensedStrategy::apply_inverse(BlockVector r) const
  {
    structure.condense(r);
    for (unsigned int b = 0; b < columns.size(); ++b)
      {
        structure.bodies()[b]->factorisation().solve(r.block(b));
        structure.reduction(b).constraints().distribute(r.block(b));
      }
    return r;
  }



  void
  CondensedStrategy::solve(const std::vector<unsigned int> &active,
                           const BlockVector               *r_u,
                           const Vector                    &r_lambda,
                           BlockVector                     &du,
                           Vector                          &dlambda)
  {
    du = r_u == nullptr ? structure.zero() : apply_inverse(*r_u);
    dlambda.reinit(active.size());
    if (active.empty())
      return;

    add_columns(active);
    LAPACKFullMatrix<double> system(active.size());
    for (unsigned int i = 0; i < active.size(); ++i)
      {
        const GapRow &row = rows[active[i]];
        dlambda[i]        = r_lambda[i] - row.opening(du);
        for (unsigned int j = 0; j <= i; ++j)
          {
            const unsigned int p = place.at(active[i]), q = place.at(active[j]);
            system(i, j) = compliance[std::max(p, q)][std::min(p, q)] +
                           (i == j ? 1. / row.penalty : 0.);
            system(j, i) = system(i, j);
          }
      }
    system.set_property(LAPACKSupport::symmetric);
    try
      {
        system.compute_cholesky_factorization();
      }
    catch (const ExceptionBase &)
      {
        throw NumericsError(
          "The compliance of the active contact rows is singular: rows depend "
          "on each other, and the penalty is too hard to tell them apart. Use "
          "a softer Penalty (auto), and name each pair of surfaces once.");
      }
    system.solve(dlambda);

    for (unsigned int b = 0; b < columns.size(); ++b)
      {
        Vector y(structure.bodies()[b]->n_dofs());
        for (unsigned int i = 0; i < active.size(); ++i)
          if (const auto found = columns[b].column.find(active[i]);
              found != columns[b].column.end())
            y.add(dlambda[i], columns[b].y[found->second]);
        structure.bodies()[b]->factorisation().backward(y);
        structure.reduction(b).constraints().distribute(y);
        du.block(b) += y;
      }
  }



  double
  CondensedStrategy::condition_estimate() const
  {
    double largest = 0.;
    for (const auto &body : structure.bodies())
      largest = std::max(largest, body->factorisation().condition_estimate());
    return largest;
  }
} // namespace lamella
