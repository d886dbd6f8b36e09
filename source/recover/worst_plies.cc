// SPDX-License-Identifier: LGPL-2.1-or-later

// Which rows of a sweep are nearest to failure, and what doubts there are.

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/recover/strength_sweep.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  bool
  is_before(const Point<3> &a, const Point<3> &b, const double same)
  {
    for (unsigned int c = 0; c < 3; ++c)
      if (std::abs(a[c] - b[c]) > same)
        return a[c] < b[c];
    return false;
  }



  bool
  is_worse(const PlyReserve &a, const PlyReserve &b)
  {
    // Above what solvers leave of symmetric places.
    constexpr double same = 1e-7;
    if (a.reserve.has_value() != b.reserve.has_value())
      return a.reserve.has_value();
    const double of_a = a.reserve ? *a.reserve : -a.index,
                 of_b = b.reserve ? *b.reserve : -b.index;
    if (std::abs(of_a - of_b) > same * std::max(std::abs(of_a), std::abs(of_b)))
      return of_a < of_b;
    return is_before(a.position,
                     b.position,
                     same * (a.position.norm() + b.position.norm()));
  }



  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows)
  {
    const PlyReserve *worst = nullptr;
    for (const PlyReserve &row : rows)
      if (worst == nullptr || is_worse(row, *worst))
        worst = &row;
    return worst;
  }



  namespace
  {
    /// Whether @p x is on the segment from @p a to @p b.
    bool
    is_on(const Point<3> &x,
          const Point<3> &a,
          const Point<3> &b,
          const double    near)
    {
      const Tensor<1, 3> along = b - a;
      const double       t =
        along.norm() > 0. ?
                std::clamp(((x - a) * along) / along.norm_square(), 0., 1.) :
                0.;
      return x.distance(a + t * along) <= near;
    }



    bool
    is_on_line_or_point(const Region   &region,
                        const Point<3> &x,
                        const double    near)
    {
      if (region.kind == Region::Kind::line)
        return is_on(x, region.at.front(), region.at.back(), near);
      return region.kind == Region::Kind::point &&
             std::any_of(region.at.begin(),
                         region.at.end(),
                         [&](const auto &at) {
                           return x.distance(at) <= near;
                         });
    }
  } // namespace



  std::string
  worst_reserve_warning(const std::vector<PlyReserve> &rows,
                        const std::vector<Support>    &supports,
                        const std::vector<Load>       &loads,
                        const Bodies                  &bodies)
  {
    constexpr double  much  = 0.1;
    const PlyReserve *worst = worst_of(rows);
    if (worst == nullptr || !worst->reserve)
      return "";
    const Point<3> &x = worst->position;
    const double    near =
      arithmetic::same_in_element * bodies[worst->body]->size();

    std::string why;
    for (const Load &load : loads)
      for (const Region &region : load.on)
        if (region.body == worst->body && is_on_line_or_point(region, x, near))
          why = "load " + load.name + " acts on a line or point there";
    for (const PrescribedFunctional &row :
         prescribed_functionals(supports, bodies))
      if (row.row.body == worst->body && !supports[row.support].isostatic &&
          row.position.distance(x) <= near)
        why = "support " + supports[row.support].name + " acts on that point";
    if (why.empty() && worst->stress_discrepancy > much)
      why = "the stress of the element and the recovered stress differ by " +
            to_text(100. * worst->stress_discrepancy, 2) + " % there";
    if (why.empty())
      return "";
    return "recover.stress-singular: the smallest reserve factor, " +
           to_text(*worst->reserve, 4) + " of ply " +
           std::to_string(worst->ply + 1) + " of body '" +
           bodies[worst->body]->name() + "' at " + to_text(x) +
           ", may belong to a stress singularity, where it decreases with each "
           "refinement without limit: " +
           why + ". Exclude it by Strength/Excluded boxes, or refine the mesh";
  }
} // namespace lamella
