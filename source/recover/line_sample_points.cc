// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a line is sampled: in each ply that it crosses.

#include <lamella/recover/sampler.h>

#include <algorithm>
#include <array>

namespace lamella
{
  using namespace dealii;

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
