// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/main_normals.h>

#include <algorithm>

namespace lamella
{
  using dealii::Tensor;

  std::vector<MainNormal>
  main_normals(const ContactInterface &contact, const double depth)
  {
    // The cosine of 60 degrees.
    constexpr double alike = 0.5;

    std::vector<unsigned int> rows;
    for (unsigned int k = 0; k < contact.rows.size(); ++k)
      if (contact.points[k].normal.norm() > 0.)
        rows.push_back(k);
    const auto gap = [&contact](const unsigned int k) {
      return contact.rows[k].initial_gap;
    };
    std::stable_sort(rows.begin(),
                     rows.end(),
                     [&gap](const unsigned int a, const unsigned int b) {
                       return gap(a) < gap(b);
                     });
    std::vector<Tensor<1, 3>> directions;
    std::vector<MainNormal>   result;
    for (const unsigned int k : rows)
      {
        if (gap(k) > gap(rows.front()) + depth)
          break;
        const Tensor<1, 3> n =
          contact.points[k].normal / contact.points[k].normal.norm();
        auto main =
          std::find_if(directions.begin(),
                       directions.end(),
                       [&n](const Tensor<1, 3> &d) { return d * n > alike; });
        if (main == directions.end())
          main = directions.insert(directions.end(), n);
        result.push_back({k, *main});
      }
    return result;
  }
} // namespace lamella
