// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/linear_functional.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  void
  LinearFunctional::add(const DofIndex dof, const double weight)
  {
    if (weight != 0.)
      row.emplace_back(dof, weight);
  }



  void
  LinearFunctional::add_constant(const double value)
  {
    constant_part += value;
  }



  void
  LinearFunctional::add(const LinearFunctional &other, const double factor)
  {
    constant_part += factor * other.constant_part;
    for (const auto &[dof, weight] : other.row)
      add(dof, factor * weight);
  }



  void
  LinearFunctional::compress()
  {
    std::sort(row.begin(), row.end(), [](const Entry &a, const Entry &b) {
      return a.first < b.first;
    });
    std::vector<Entry> merged;
    for (const Entry &entry : row)
      if (!merged.empty() && merged.back().first == entry.first)
        merged.back().second += entry.second;
      else
        merged.push_back(entry);
    row = std::move(merged);
  }



  void
  LinearFunctional::drop_below(const double relative)
  {
    double largest = 0.;
    for (const Entry &entry : row)
      largest = std::max(largest, std::abs(entry.second));
    row.erase(std::remove_if(row.begin(),
                             row.end(),
                             [&](const Entry &entry) {
                               return std::abs(entry.second) <
                                      relative * largest;
                             }),
              row.end());
  }



  double
  LinearFunctional::operator()(const Vector &u) const
  {
    double sum = constant_part;
    for (const auto &[dof, weight] : row)
      sum += weight * u[dof];
    return sum;
  }



  void
  LinearFunctional::add_to(Vector &f, const double factor) const
  {
    for (const auto &[dof, weight] : row)
      f[dof] += factor * weight;
  }



  LinearFunctional
  LinearFunctional::reduced(const Constraints &constraints) const
  {
    LinearFunctional result;
    result.add_constant(constant_part);
    for (const auto &[dof, weight] : row)
      if (!constraints.is_constrained(dof))
        result.add(dof, weight);
      else
        for (const auto &[other, factor] :
             *constraints.get_constraint_entries(dof))
          result.add(other, weight * factor);
    result.compress();
    return result;
  }
} // namespace lamella
