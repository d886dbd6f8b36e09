// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/recover/pressed_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Coordinates closer than this share of the contact's extent are the same.
    constexpr double same = arithmetic::same_in_element;
    // Points that a line has at least, on average.
    constexpr double least_on_line = 3.;



    /// Half way to its neighbours @p s[k - 1] and @p s[k + 1]; at the ends of
    /// the list up to the place itself.
    std::pair<double, double>
    interval_of(const std::vector<double> &s, const unsigned int k)
    {
      return {k == 0 ? s[k] : 0.5 * (s[k - 1] + s[k]),
              k + 1 == s.size() ? s[k] : 0.5 * (s[k] + s[k + 1])};
    }
  } // namespace



  unsigned int
  facing_axis(const std::vector<ContactInterface::Point> &points)
  {
    Tensor<1, 3> sum;
    for (const ContactInterface::Point &point : points)
      sum += point.area * point.normal;
    unsigned int largest = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(sum[d]) > std::abs(sum[largest]))
        largest = d;
    return largest;
  }



  std::pair<double, double>
  reach_along(const std::vector<ContactInterface::Point> &points,
              const unsigned int                          axis)
  {
    std::pair<double, double> reach{place_of(points.front())[axis],
                                    place_of(points.front())[axis]};
    for (const ContactInterface::Point &point : points)
      {
        reach.first  = std::min(reach.first, place_of(point)[axis]);
        reach.second = std::max(reach.second, place_of(point)[axis]);
      }
    return reach;
  }



  PressedPatch::PressedPatch(const std::vector<ContactRow>     &rows,
                             const std::optional<ContactStrip> &strip)
    : rows(rows)
    , strip(strip)
    , shares(rows.size(), 1.)
  {
    std::vector<ContactInterface::Point> points;
    for (const ContactRow &row : rows)
      points.push_back(row.point);
    facing = facing_axis(points);
    if (!strip)
      return;
    std::vector<unsigned int> all(rows.size());
    std::iota(all.begin(), all.end(), 0u);
    const auto          groups = by_coordinate(all, strip->axis);
    std::vector<double> s;
    for (const auto &group : groups)
      s.push_back(coordinate(group.front(), strip->axis));
    for (unsigned int k = 0; k < groups.size(); ++k)
      {
        const auto [begin, end] = interval_of(s, k);
        // All points at one place are in or out.
        const double share =
          end > begin ?
            limits(strip->axis).overlap({begin, end}) / (end - begin) :
            double(strip->from <= begin && begin <= strip->to);
        for (const unsigned int point : groups[k])
          shares[point] = share;
      }
  }



  PressedPatch::Interval
  PressedPatch::limits(const unsigned int axis) const
  {
    if (strip && strip->axis == axis)
      return {strip->from, strip->to};
    return {-std::numeric_limits<double>::max(),
            std::numeric_limits<double>::max()};
  }



  std::vector<std::vector<unsigned int>>
  PressedPatch::by_coordinate(const std::vector<unsigned int> &points,
                              const unsigned int               axis) const
  {
    std::vector<unsigned int> sorted = points;
    std::sort(sorted.begin(),
              sorted.end(),
              [&](const unsigned int a, const unsigned int b) {
                return coordinate(a, axis) < coordinate(b, axis);
              });
    const double extent =
      coordinate(sorted.back(), axis) - coordinate(sorted.front(), axis);
    std::vector<std::vector<unsigned int>> groups;
    for (const unsigned int point : sorted)
      {
        if (groups.empty() ||
            coordinate(point, axis) - coordinate(groups.back().back(), axis) >
              same * extent)
          groups.emplace_back();
        groups.back().push_back(point);
      }
    return groups;
  }



  Wrench
  PressedPatch::resultant() const
  {
    Wrench sum;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        sum.force += shares[i] * rows[i].on_second.force;
        sum.moment += shares[i] * rows[i].on_second.moment;
      }
    return sum;
  }



  double
  PressedPatch::edge(const std::vector<double> &s,
                     const std::vector<double> &force,
                     const std::vector<double> &area,
                     const double               next)
  {
    const unsigned int n = s.size();
    if (n < 4 || force[n - 1] / area[n - 1] >= force[n - 2] / area[n - 2])
      return 0.5 * (s.back() + next);
    const auto moment = [&](const double s_b) {
      double sum = 0.;
      for (unsigned int i = 0; i < n; ++i)
        sum += force[i] * std::max(0., s[i] - s_b);
      return sum;
    };
    const double far  = s[n - 1 - std::min(4u, n / 2)],
                 near = s[n - 1 - std::min(2u, n / 4)],
                 r    = std::pow(moment(far) / moment(near), 0.4);
    return std::clamp((r * near - far) / (r - 1.), s[n - 2], next);
  }



  std::vector<PressedPatch::Interval>
  PressedPatch::runs_of(const Line &line)
  {
    const unsigned int    n = line.s.size();
    std::vector<Interval> runs;
    for (unsigned int i = 0; i < n; ++i)
      {
        if (line.force[i] <= 0.)
          continue;
        unsigned int j = i;
        while (j + 1 < n && line.force[j + 1] > 0.)
          ++j;
        const auto cut = [&](const std::vector<double> &values) {
          return std::vector<double>(values.begin() + i,
                                     values.begin() + j + 1);
        };
        std::vector<double> s = cut(line.s), force = cut(line.force),
                            area = cut(line.area);
        Interval run{s.front(), s.back()};
        if (j + 1 < n)
          run.end = edge(s, force, area, line.s[j + 1]);
        if (i > 0)
          {
            // The same, looked at from the other side.
            for (std::vector<double> *list : {&s, &force, &area})
              std::reverse(list->begin(), list->end());
            for (double &place : s)
              place = -place;
            run.begin = -edge(s, force, area, -line.s[i - 1]);
          }
        runs.push_back(run);
        i = j;
      }
    return runs;
  }



  std::vector<PressedPatch::Line>
  PressedPatch::lines_along(const unsigned int axis) const
  {
    // A strip along the lines cuts their runs and not their points.
    const bool                is_along = strip && strip->axis == axis;
    std::vector<unsigned int> inside;
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (is_along || shares[i] > 0.)
        inside.push_back(i);
    std::vector<Line> lines;
    if (inside.empty())
      return lines;
    for (const auto &group : by_coordinate(inside, 3 - facing - axis))
      {
        Line line;
        for (const auto &points : by_coordinate(group, axis))
          {
            line.s.push_back(coordinate(points.front(), axis));
            line.share.push_back(is_along ? 1. : shares[points.front()]);
            line.force.push_back(0.);
            line.area.push_back(0.);
            for (const unsigned int point : points)
              {
                line.force.back() += rows[point].force;
                line.area.back() += rows[point].point.area;
              }
          }
        line.runs = runs_of(line);
        for (Interval &run : line.runs)
          run = {std::max(run.begin, limits(axis).begin),
                 std::min(run.end, limits(axis).end)};
        lines.push_back(line);
      }
    return lines;
  }



  bool
  PressedPatch::are_lines(const std::vector<Line> &lines)
  {
    double n = 0.;
    for (const Line &line : lines)
      n += line.s.size();
    return n >= least_on_line * lines.size();
  }



  double
  PressedPatch::extent(const unsigned int axis) const
  {
    Interval all{std::numeric_limits<double>::max(),
                 -std::numeric_limits<double>::max()};
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (rows[i].touches() && shares[i] > 0.)
        {
          const double half = 0.5 * std::sqrt(rows[i].point.area);
          all.begin         = std::min(all.begin, coordinate(i, axis) - half);
          all.end           = std::max(all.end, coordinate(i, axis) + half);
        }
    return all.overlap(limits(axis));
  }



  double
  PressedPatch::width(const unsigned int axis) const
  {
    if (axis == facing)
      return 0.;
    const std::vector<Line> lines = lines_along(axis);
    if (!are_lines(lines))
      return extent(axis);
    double largest = 0.;
    for (const Line &line : lines)
      {
        double sum = 0.;
        for (const Interval &run : line.runs)
          sum += std::max(0., run.end - run.begin);
        largest = std::max(largest, sum);
      }
    return largest;
  }



  double
  PressedPatch::width() const
  {
    return std::min(width((facing + 1) % 3), width((facing + 2) % 3));
  }



  double
  PressedPatch::pressed_area(const Line &line)
  {
    double area = 0.;
    for (unsigned int k = 0; k < line.s.size(); ++k)
      {
        const auto [begin, end] = interval_of(line.s, k);
        double pressed          = 0.;
        for (const Interval &run : line.runs)
          pressed += run.overlap({begin, end});
        // A line of one point presses or does not.
        const double part =
          end > begin ? pressed / (end - begin) : double(line.force[k] > 0.);
        area += line.share[k] * part * line.area[k];
      }
    return area;
  }



  double
  PressedPatch::pressure() const
  {
    const unsigned int      a = (facing + 1) % 3, b = (facing + 2) % 3;
    const std::vector<Line> lines = lines_along(width(a) <= width(b) ? a : b);
    double                  force = 0., area = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
      force += shares[i] * rows[i].force;
    if (are_lines(lines))
      for (const Line &line : lines)
        area += pressed_area(line);
    else
      for (unsigned int i = 0; i < rows.size(); ++i)
        area += rows[i].touches() ? shares[i] * rows[i].point.area : 0.;
    return area > 0. ? force / area : 0.;
  }



  double
  PressedPatch::largest_pressure() const
  {
    double largest = 0.;
    for (const ContactRow &row : rows)
      largest = std::max(largest, row.force / row.point.area);
    return largest;
  }
} // namespace lamella
