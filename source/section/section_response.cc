// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/hermitian.h>
#include <lamella/section/section_response.h>

namespace lamella
{
  std::vector<std::vector<Vector>>
  SectionResponse::at(const double k, const std::vector<Vector> &loads) const
  {
    // Of the larger part.
    constexpr double nothing = arithmetic::rounding_of_solutions;
    Matrix           P(section.S(0, 0).get_sparsity_pattern()),
      Q(P.get_sparsity_pattern());
    P.copy_from(section.S(0, 0));
    P.add(k * k, section.S(1, 1));
    Q.copy_from(section.S(0, 1));
    Q.add(-1., section.S(1, 0));
    Q *= k;
    const std::vector<Vector> parts =
      solve_hermitian(P, Q, loads, "a section at the wave number");
    std::vector<std::vector<Vector>> fields(loads.size());
    for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const double largest =
          std::max(parts[2 * i].linfty_norm(), parts[2 * i + 1].linfty_norm());
        for (const unsigned int part : {2 * i, 2 * i + 1})
          if (parts[part].linfty_norm() > nothing * largest)
            fields[i].push_back(parts[part]);
      }
    return fields;
  }
} // namespace lamella
