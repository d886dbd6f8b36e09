// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/block_pattern.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace lamella
{
  using dealii::types::blas_int;

  namespace
  {
    /// Blocks @p some from @p begin to @p end, the middle one last.
    void
    dissect(const std::vector<unsigned int> &some,
            const std::size_t                begin,
            const std::size_t                end,
            std::vector<unsigned int>       &order)
    {
      if (begin >= end)
        return;
      const std::size_t middle = (begin + end) / 2;
      dissect(some, begin, middle, order);
      dissect(some, middle + 1, end, order);
      order.push_back(some[middle]);
    }



    /// The blocks of @p n in the order in which they are eliminated.
    std::vector<unsigned int>
    elimination_order(const unsigned int                            n,
                      const std::vector<std::vector<unsigned int>> &cliques)
    {
      std::vector<unsigned int> count(n, 0), order, between;
      for (const auto &clique : cliques)
        for (const unsigned int g : clique)
          ++count[g];
      for (unsigned int g = 0; g < n; ++g)
        (count[g] <= 1 ? order : between).push_back(g);
      if (between.empty())
        return order;
      dissect(between, 1, between.size() - 1, order);
      order.push_back(between.front());
      if (between.size() > 1)
        order.push_back(between.back());
      return order;
    }



    /// For each block, by elimination order, the later ones in its column of L.
    std::vector<std::set<unsigned int>>
    eliminate(const std::vector<unsigned int>              &place,
              const std::vector<std::vector<unsigned int>> &cliques)
    {
      std::vector<std::set<unsigned int>> below(place.size());
      for (const auto &clique : cliques)
        for (const unsigned int g : clique)
          for (const unsigned int h : clique)
            if (place[h] > place[g])
              below[place[g]].insert(place[h]);
      for (std::set<unsigned int> &column : below)
        if (!column.empty())
          below[*column.begin()].insert(std::next(column.begin()),
                                        column.end());
      return below;
    }
  } // namespace



  BlockPattern::BlockPattern(const StiffnessTerms &terms,
                             const DenseBlocks    &blocks,
                             const Constraints    &constraints)
    : block_of(terms.n_dofs)
  {
    const unsigned int n = blocks.first.size() - 1;
    for (unsigned int g = 0; g < n; ++g)
      std::fill(block_of.begin() + blocks.first[g],
                block_of.begin() + blocks.first[g + 1],
                g);
    const auto                cliques = cliques_of(terms, blocks, constraints);
    const auto                order   = elimination_order(n, cliques);
    std::vector<unsigned int> place(n);
    for (unsigned int s = 0; s < n; ++s)
      place[order[s]] = s;
    for (unsigned int &g : block_of)
      g = place[g];

    number_columns(blocks, order);
    first_row   = {0};
    first_entry = {0};
    for (const auto &below : eliminate(place, cliques))
      add_column(below);
  }



  std::vector<std::vector<unsigned int>>
  BlockPattern::cliques_of(const StiffnessTerms &terms,
                           const DenseBlocks    &blocks,
                           const Constraints    &constraints) const
  {
    // A constrained DoF stands for those that it is a combination of.
    std::vector<std::set<unsigned int>> stands_for(blocks.first.size() - 1);
    for (const auto &line : constraints.get_lines())
      for (const auto &[dof, weight] : line.entries)
        stands_for[block_of[line.index]].insert(block_of[dof]);
    std::vector<std::vector<unsigned int>> cliques;
    const auto add = [&](const std::set<unsigned int> &members) {
      std::set<unsigned int> all = members;
      for (const unsigned int g : members)
        all.insert(stands_for[g].begin(), stands_for[g].end());
      cliques.emplace_back(all.begin(), all.end());
    };
    for (const auto &clique : blocks.cliques)
      add({clique.begin(), clique.end()});
    for (const auto &[spring, stiffness] : terms.springs)
      {
        std::set<unsigned int> touched;
        for (const auto &[dof, weight] : spring.entries())
          touched.insert(block_of[dof]);
        add(touched);
      }
    return cliques;
  }



  void
  BlockPattern::number_columns(const DenseBlocks               &blocks,
                               const std::vector<unsigned int> &order)
  {
    column = {0};
    for (const unsigned int g : order)
      {
        first_dof.push_back(blocks.first[g]);
        column.push_back(column.back() + blocks.first[g + 1] - blocks.first[g]);
        for (DofIndex dof = blocks.first[g]; dof < blocks.first[g + 1]; ++dof)
          permutation.push_back(dof);
      }
  }



  void
  BlockPattern::add_rows_of(const unsigned int block)
  {
    for (std::int64_t i = column[block]; i < column[block + 1]; ++i)
      row.push_back(i);
  }



  template <typename Blocks>
  void
  BlockPattern::add_column(const Blocks &below)
  {
    const unsigned int s = parts.size();
    parts.emplace_back();
    add_rows_of(s);
    for (const unsigned int t : below)
      {
        parts[s].push_back({t, blas_int(row.size() - first_row[s])});
        add_rows_of(t);
      }
    first_row.push_back(row.size());
    first_entry.push_back(first_entry[s] + std::int64_t(height(s)) * width(s));
  }
} // namespace lamella
