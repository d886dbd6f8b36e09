// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>
#include <functional>

namespace lamella
{
  void
  refine_at(AxisMesh           &axis,
            const double        y,
            const double        size,
            const GradingRules &rules)
  {
    const std::vector<double> lengths = element_lengths(axis);
    std::vector<double>       ends;
    double                    begin = 0., longest = size;
    for (const double length : lengths)
      {
        if (size == 0. && begin <= y && y <= begin + length)
          longest = std::max(longest, 0.5 * length);
        begin += length;
      }
    const double near = rules.rounding_allowance * longest;
    const std::function<void(double, double)> add = [&](const double a,
                                                        const double b) {
      const bool   has_y = a + near < y && y + near < b;
      const double most = longest + rules.growth * std::max({0., a - y, y - b}),
                   middle = has_y ? y : 0.5 * (a + b);
      if (has_y || b - a > (1. + arithmetic::same_in_element) * most)
        {
          add(a, middle);
          add(middle, b);
        }
      else
        ends.push_back(b);
    };
    begin = 0.;
    for (const double length : lengths)
      {
        add(begin, begin + length);
        begin += length;
      }
    ends.pop_back();
    axis.breaks = ends;
    axis.elements.assign(ends.size() + 1, 1);
  }
} // namespace lamella
