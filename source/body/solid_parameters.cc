// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/solid_parameters.h>

#include <cmath>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // Each division has eight times the cells of the one before.
    constexpr unsigned int most_refinements = 8;



    unsigned int
    times(const std::string &text, const std::string &entry)
    {
      const double n = to_number(text, entry);
      if (!(n >= 0. && n <= most_refinements && n == std::floor(n)))
        throw InputError(entry +
                         ": how often must be a whole number from 0 "
                         "to " +
                         std::to_string(most_refinements) +
                         ", each time divides cells in eight.");
      return static_cast<unsigned int>(n);
    }
  } // namespace



  void
  SolidParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Refinements",
                      "0",
                      Anything(),
                      "Of solids: how often all hexahedra, a section cell "
                      "times an axis element each, are divided in eight. "
                      "Beams ignore it.");
    prm.declare_entry("Refine near",
                      "",
                      Anything(),
                      "Of solids: then divides those that reach into a ball, "
                      "x, y, z: radius: times, between '|' [scene axes]. "
                      "Beams ignore it.");
  }



  SolidParameters
  SolidParameters::parse(const ParameterHandler &prm)
  {
    return {prm.get("Refinements"), prm.get("Refine near")};
  }



  SolidRefinement
  SolidParameters::refinement(const Placement   &placement,
                              const std::string &what) const
  {
    SolidRefinement result;
    result.everywhere =
      times(refinements, what + "/Refinements = " + refinements);
    for (const std::string &text : split(near, '|'))
      {
        const std::string              entry = what + "/Refine near = " + text;
        const std::vector<std::string> parts = split(text, ':');
        if (parts.size() != 3)
          throw InputError(entry + ": must be x, y, z: radius: times.");
        SolidRefinement::Ball ball;
        ball.centre = placement.to_body(to_point(parts[0], entry));
        ball.radius = to_number(parts[1], entry);
        ball.times  = times(parts[2], entry);
        if (!(ball.radius > 0.))
          throw InputError(entry + ": the radius must be positive.");
        result.balls.push_back(ball);
      }
    return result;
  }
} // namespace lamella
