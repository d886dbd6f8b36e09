// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/body/solid_parameters.h>

#include <cmath>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // Each division has eight times the cells of the one before.
    constexpr unsigned int max_ellipse_refinements = 8;



    /// How often @p piece of @p entry says to divide.
    unsigned int
    times(const Entry &entry, const std::string &piece)
    {
      const double n = entry.number(piece);
      if (!(n >= 0. && n <= max_ellipse_refinements && n == std::floor(n)))
        entry.refuse("body.times-out-of-range: the number of refinements "
                     "(times) must be a whole number from 0 to " +
                     std::to_string(max_ellipse_refinements) +
                     "; each refinement divides hexahedra into eight");
      return static_cast<unsigned int>(n);
    }



    /// `x, y, z: radius: times`, the center in the scene's axes.
    SolidRefinement::Ball
    parse_ball(const Entry &entry, const Placement &placement)
    {
      const std::vector<std::string> parts = entry.items(':');
      if (parts.size() != 3)
        entry.refuse("body.invalid-ball: write the center, the radius and the "
                     "number of refinements of a ball as x, y, z: radius: "
                     "times, for example 0, 1, 0: 0.2: 2");
      SolidRefinement::Ball ball;
      ball.center = placement.to_body(entry.point(parts[0]));
      ball.radius = entry.number(parts[1]);
      ball.times  = times(entry, parts[2]);
      if (!(ball.radius > 0.))
        entry.refuse("entry.not-positive: the ball's radius must be positive");
      return ball;
    }
  } // namespace



  void
  SolidParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Refinements",
      "0",
      patterns::number(),
      "For solids: how often all hexahedra (a section cell times an axis "
      "element each) are divided into eight. No effect on beams.");
    prm.declare_entry(
      "Refine near",
      "",
      Anything(),
      "For solids: balls x, y, z: radius: times, with '|' between, in scene "
      "coordinates. Hexahedra that intersect a ball are divided further, that "
      "many times. No effect on beams.");
  }



  SolidRefinement
  SolidParameters::parse(const Entries &in, const Placement &placement)
  {
    SolidRefinement refinement;
    const Entry     everywhere = in["Refinements"], near = in["Refine near"];
    refinement.everywhere = times(everywhere, everywhere.text());
    for (const std::string &ball : near.items('|'))
      refinement.balls.push_back(
        parse_ball(Entry(near.path(), ball), placement));
    return refinement;
  }
} // namespace lamella
