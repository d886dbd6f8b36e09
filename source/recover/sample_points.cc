// SPDX-License-Identifier: LGPL-2.1-or-later

// Where fields are sampled: in boxes, and along lines in each ply they cross.

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/line_crossings.h>
#include <lamella/conditions/region.h>
#include <lamella/recover/sampler.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>

namespace lamella
{
  using namespace dealii;

  std::vector<Point<3>>
  box_corners(const Point<3> &middle, const Tensor<1, 3> &edges)
  {
    std::vector<Point<3>> corners;
    for (unsigned int v = 0; v < 8; ++v)
      {
        corners.push_back(middle);
        for (unsigned int d = 0; d < 3; ++d)
          corners.back()[d] += (v >> d & 1 ? 0.5 : -0.5) * edges[d];
      }
    return corners;
  }



  namespace
  {
    constexpr std::size_t most_points = 200000;
    // What pieces are divided into where elements are askew.
    constexpr unsigned int askew_parts = 4;



    [[noreturn]] void
    refuse(const std::string &path,
           const std::string &rule,
           const std::string &remedy)
    {
      throw InputError(path + "/Box", "", rule, remedy);
    }



    /// Iterated integration over a box.
    class BoxRule
    {
    public:
      BoxRule(const Body         &body,
              const Point<3>     &middle,
              const Tensor<1, 3> &edges,
              const std::string  &path)
        : body(body)
        , low(middle - 0.5 * edges)
        , edges(edges)
        , path(path)
      {
        for (unsigned int d = 0; d < 3; ++d)
          if (edges[d] > 0.)
            along.push_back(d);
        add(0, middle, 1.);
      }

      std::vector<Point<3>> points;
      std::vector<double>   weights;

    private:
      /// The points with the coordinates of @p x in all directions before
      /// number @p level of `along`.
      void
      add(const unsigned int level, Point<3> x, const double weight)
      {
        if (level == along.size())
          {
            if (points.size() == most_points)
              refuse(
                path,
                "recover.box-too-fine: the mean over Box needs more than " +
                  std::to_string(most_points) + " integration points",
                "Write a smaller Box.");
            points.push_back(x);
            weights.push_back(weight);
            return;
          }
        const unsigned int        d      = along[level];
        const std::vector<double> breaks = breaks_at(level, x);
        Point<3>                  a = x, b = x;
        b[d] += edges[d];
        const QGauss<1> gauss(body.line_degree(a, b) / 2 + 2);
        for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              const double size = breaks[k + 1] - breaks[k];
              x[d] = low[d] + edges[d] * (breaks[k] + size * gauss.point(q)[0]);
              add(level + 1, x, weight * size * gauss.weight(q));
            }
      }

      /// Where lines through the box from @p x along direction number @p level
      /// pass from element to element: on its faces and half way between them.
      std::vector<double>
      breaks_at(const unsigned int level, const Point<3> &x) const
      {
        std::vector<Point<3>> starts{x};
        starts[0][along[level]] = low[along[level]];
        for (unsigned int l = level + 1; l < along.size(); ++l)
          {
            const std::vector<Point<3>> coarser = std::move(starts);
            starts.clear();
            for (Point<3> start : coarser)
              for (const double t : {0., 0.5, 1.})
                {
                  start[along[l]] = low[along[l]] + t * edges[along[l]];
                  starts.push_back(start);
                }
          }
        std::vector<double> breaks;
        std::size_t         most = 0;
        for (const Point<3> &start : starts)
          {
            Point<3> end = start;
            end[along[level]] += edges[along[level]];
            const auto own = body.line_breaks(start, end);
            most           = std::max(most, own.size());
            breaks.insert(breaks.end(), own.begin(), own.end());
          }
        breaks = merge_breaks(std::move(breaks));
        if (breaks.size() == most)
          return breaks;
        std::vector<double> finer;
        for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
          for (unsigned int i = 0; i < askew_parts; ++i)
            finer.push_back(breaks[k] +
                            i * (breaks[k + 1] - breaks[k]) / askew_parts);
        finer.push_back(1.);
        return finer;
      }

      const Body               &body;
      const Point<3>            low;
      const Tensor<1, 3>        edges;
      const std::string         path;
      std::vector<unsigned int> along;
    };



    /// The places of @p points, all of which must be in @p body.
    std::vector<std::vector<Location>>
    located(const Body                  &body,
            const std::vector<Point<3>> &points,
            const std::string           &path)
    {
      auto found = body.locate(points);
      for (unsigned int i = 0; i < points.size(); ++i)
        if (found[i].empty())
          {
            const auto limits = body.bounding_box().get_boundary_points();
            refuse(path,
                   "recover.box-outside: the box must lie in body '" +
                     body.name() + "', which extends from " +
                     to_text(limits.first) + " to " + to_text(limits.second) +
                     ", but contains " + to_text(points[i]) +
                     " outside of the body",
                   "Make Box smaller, or move the probe (At).");
          }
      return found;
    }
  } // namespace



  std::vector<BoxPoints>
  box_points(const Body         &body,
             const Point<3>     &middle,
             const Tensor<1, 3> &edges,
             const std::string  &path)
  {
    const auto             at_middle = locate_in_plies(body, {middle}, path);
    std::vector<BoxPoints> sides;
    if (edges.norm() == 0.)
      {
        for (const Location &location : at_middle.front())
          sides.push_back({{1., location}});
        return sides;
      }
    located(body, box_corners(middle, edges), path);
    const BoxRule rule(body, middle, edges, path);
    const auto    found = located(body, rule.points, path);
    // What lies in one ply only belongs to either side. A piece that is thin
    // enough for the search to find it in both plies makes no interface.
    constexpr double sliver = arithmetic::quadrature_tolerance;
    double           in_two = 0.;
    for (unsigned int i = 0; i < found.size(); ++i)
      in_two += found[i].size() > 1 ? rule.weights[i] : 0.;
    const bool in_interface = in_two > sliver;
    sides.resize(in_interface ? 2 : 1);
    for (unsigned int i = 0; i < found.size(); ++i)
      {
        sides.front().emplace_back(rule.weights[i], found[i].front());
        if (in_interface)
          sides.back().emplace_back(rule.weights[i], found[i].back());
      }
    return sides;
  }



  namespace
  {
    /// The point at the share @p t of @p line.
    Point<3>
    point_on_line(const Line &line, const double t)
    {
      return line.from + t * (line.to - line.from);
    }



    /// A piece of a line in one ply, in shares of the line.
    struct Piece
    {
      double       begin, end;
      unsigned int ply;
    };



    /// Pieces of one ply each: elements of the same ply are merged. A line in
    /// an interface has two sides, the lower ply first, then the upper.
    std::array<std::vector<Piece>, 2>
    pieces_of(const Line &line, const Body &body, const std::string &path)
    {
      std::array<std::vector<Piece>, 2> sides;
      const std::vector<double> breaks = body.line_breaks(line.from, line.to);
      std::vector<Point<3>>     middles;
      for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
        middles.push_back(
          point_on_line(line, 0.5 * (breaks[k] + breaks[k + 1])));
      const auto found = locate_in_plies(body, middles, path);
      for (unsigned int k = 0; k < middles.size(); ++k)
        for (unsigned int side = 0;
             side < std::min<std::size_t>(2, found[k].size());
             ++side)
          {
            const unsigned int  ply    = found[k][side].ply;
            std::vector<Piece> &pieces = sides[side];
            if (!pieces.empty() && pieces.back().ply == ply &&
                pieces.back().end == breaks[k])
              pieces.back().end = breaks[k + 1];
            else
              pieces.push_back({breaks[k], breaks[k + 1], ply});
          }
      return sides;
    }
  } // namespace



  std::vector<Sampler::LinePoint>
  Sampler::places_of(const Line &line) const
  {
    const Body       &body = *bodies[line.body];
    const std::string path = "Line " + line.name;
    locate_all(body, {line.from, line.to}, path);

    std::vector<LinePoint> places;
    for (const std::vector<Piece> &pieces : pieces_of(line, body, path))
      for (const Piece &piece : pieces)
        for (unsigned int i = 0; i < line.samples; ++i)
          {
            const double t =
              piece.begin + (piece.end - piece.begin) * i / (line.samples - 1);
            const auto both = body.locate({point_on_line(line, t)});
            for (const Location &location : both.front())
              if (location.ply == piece.ply)
                places.push_back({t * line.from.distance(line.to), location});
          }
    return places;
  }
} // namespace lamella
