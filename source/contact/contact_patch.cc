// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/contact_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Points that a line has at least, on average.
    constexpr double least_on_line = 3.;



    unsigned int
    largest_component(const Tensor<1, 3> &vector)
    {
      unsigned int largest = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(vector[d]) > std::abs(vector[largest]))
          largest = d;
      return largest;
    }



    /// Half way to its neighbors @p s[k - 1] and @p s[k + 1]; at the ends of
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
    return largest_component(sum);
  }



  std::pair<double, double>
  search_radius_along(const std::vector<ContactInterface::Point> &points,
                      const unsigned int                          axis)
  {
    std::pair<double, double> search_radius{place_of(points.front())[axis],
                                            place_of(points.front())[axis]};
    for (const ContactInterface::Point &point : points)
      {
        search_radius.first =
          std::min(search_radius.first, place_of(point)[axis]);
        search_radius.second =
          std::max(search_radius.second, place_of(point)[axis]);
      }
    return search_radius;
  }



  ContactPatch::ContactPatch(const ContactTraction             &traction,
                             const std::optional<ContactStrip> &strip)
    : traction(traction)
    , strip(strip)
    , facing(0)
    , shares(traction.shares(strip))
  {
    Tensor<1, 3> sum;
    for (const ContactTraction::Row &row : traction.rows())
      sum += row.area * row.normal;
    facing = largest_component(sum);
  }



  ContactPatch::Interval
  ContactPatch::limits(const unsigned int axis) const
  {
    if (strip && strip->axis == axis)
      return {strip->from, strip->to};
    return {-std::numeric_limits<double>::max(),
            std::numeric_limits<double>::max()};
  }



  double
  ContactPatch::edge(const std::vector<double> &s,
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



  std::vector<ContactPatch::Interval>
  ContactPatch::loaded_intervals(const Line &line)
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



  std::vector<ContactPatch::Line>
  ContactPatch::lines_along(const unsigned int axis) const
  {
    if (traction.surface() == nullptr)
      return {};
    std::vector<Line> lines;
    for (const auto &nodes : traction.surface()->lines(axis, 3 - facing - axis))
      {
        Line line;
        for (const std::vector<unsigned int> &rows : nodes)
          {
            line.s.push_back(coordinate(rows.front(), axis));
            line.share.push_back(shares[rows.front()]);
            line.force.push_back(0.);
            line.area.push_back(0.);
            for (const unsigned int row : rows)
              {
                line.force.back() += traction.rows()[row].force;
                line.area.back() += traction.rows()[row].area;
              }
          }
        line.runs = loaded_intervals(line);
        lines.push_back(line);
      }
    return lines;
  }



  bool
  ContactPatch::are_lines(const std::vector<Line> &lines)
  {
    double n = 0.;
    for (const Line &line : lines)
      n += line.s.size();
    return !lines.empty() && n >= least_on_line * lines.size();
  }



  double
  ContactPatch::extent(const unsigned int axis) const
  {
    Interval    all{std::numeric_limits<double>::max(),
                 -std::numeric_limits<double>::max()};
    const auto &rows = traction.rows();
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (rows[i].force > 0. && shares[i] > 0.)
        {
          const double half = 0.5 * std::sqrt(rows[i].area);
          all.begin         = std::min(all.begin, coordinate(i, axis) - half);
          all.end           = std::max(all.end, coordinate(i, axis) + half);
        }
    return all.overlap(limits(axis));
  }



  double
  ContactPatch::width(const unsigned int axis) const
  {
    if (axis == facing)
      return 0.;
    const std::vector<Line> lines = lines_along(axis);
    if (!are_lines(lines))
      return extent(axis);
    double largest = 0.;
    for (const Line &line : lines)
      {
        // A strip along the lines cuts their runs, one across some of them.
        if (!(strip && strip->axis == axis) &&
            *std::max_element(line.share.begin(), line.share.end()) <= 0.)
          continue;
        double sum = 0.;
        for (const Interval &run : line.runs)
          sum += limits(axis).overlap(run);
        largest = std::max(largest, sum);
      }
    return largest;
  }



  double
  ContactPatch::width() const
  {
    return std::min(width((facing + 1) % 3), width((facing + 2) % 3));
  }



  double
  ContactPatch::loaded_area(const Line &line)
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
  ContactPatch::pressure() const
  {
    const unsigned int      a = (facing + 1) % 3, b = (facing + 2) % 3;
    const std::vector<Line> lines = lines_along(width(a) <= width(b) ? a : b);
    const auto             &rows  = traction.rows();
    double                  force = 0., area = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
      force += shares[i] * rows[i].force;
    if (are_lines(lines))
      for (const Line &line : lines)
        area += loaded_area(line);
    else
      for (unsigned int i = 0; i < rows.size(); ++i)
        area += rows[i].force > 0. ? shares[i] * rows[i].area : 0.;
    return area > 0. ? force / area : 0.;
  }



  double
  ContactPatch::peel() const
  {
    double      largest = 0.;
    const auto &rows    = traction.rows();
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (shares[i] > 0.)
        largest = std::max(largest, -rows[i].force / rows[i].area);
    return largest;
  }



  double
  ContactPatch::shear() const
  {
    double      largest = 0.;
    const auto &rows    = traction.rows();
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (shares[i] > 0.)
        largest = std::max(largest, rows[i].shear.norm() / rows[i].area);
    return largest;
  }
} // namespace lamella
