// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/compliance.h>

namespace lamella
{
  Compliance::Compliance(const Structure           &structure,
                         const std::vector<GapRow> &rows)
    : structure(structure)
    , rows(rows)
    , columns(structure.bodies().size())
  {}



  void
  Compliance::include(const std::vector<unsigned int> &wanted)
  {
    for (unsigned int b = 0; b < columns.size(); ++b)
      {
        std::vector<std::pair<unsigned int, Row>> fresh;
        for (const unsigned int r : wanted)
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

    for (const unsigned int r : wanted)
      if (place.count(r) == 0)
        {
          place[r] = known_rows.size();
          known_rows.push_back(r);
          entries.emplace_back();
          for (const unsigned int other : known_rows)
            entries.back().push_back(product(r, other));
        }
  }



  double
  Compliance::product(const unsigned int row_i, const unsigned int row_j) const
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



  double
  Compliance::operator()(const unsigned int i, const unsigned int j) const
  {
    const unsigned int p = place.at(i), q = place.at(j);
    return entries[std::max(p, q)][std::min(p, q)];
  }



  BlockVector
  Compliance::displacement(const std::vector<unsigned int> &of,
                           const std::vector<double>       &lambda) const
  {
    BlockVector u = structure.zero();
    for (unsigned int b = 0; b < columns.size(); ++b)
      {
        for (unsigned int i = 0; i < of.size(); ++i)
          if (const auto found = columns[b].column.find(of[i]);
              found != columns[b].column.end())
            u.block(b).add(lambda[i], columns[b].y[found->second]);
        structure.bodies()[b]->factorisation().backward(u.block(b));
        structure.reduction(b).constraints().distribute(u.block(b));
      }
    return u;
  }
} // namespace lamella
