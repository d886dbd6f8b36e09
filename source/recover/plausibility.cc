// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/recover/plausibility.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    // Fibres break, resins crack and metals yield before that.
    constexpr double      large_strain = 0.02;
    constexpr std::size_t enough       = 1000;



    struct Extreme
    {
      double           value = 0.;
      dealii::Point<3> place;

      void
      take(const double other, const dealii::Point<3> &at)
      {
        if (other > value)
          {
            value = other;
            place = at;
          }
      }
    };
  } // namespace



  Plausibility::Plausibility(const Bodies &bodies, const Units &units)
    : bodies(bodies)
    , units(units)
  {}



  void
  Plausibility::find_places()
  {
    places.resize(bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const auto        points = bodies[b]->surface_points("all");
        const std::size_t stride = points.size() / enough + 1;
        for (std::size_t k = 0; k < points.size(); k += stride)
          places[b].push_back(points[k].location);
      }
  }



  std::vector<std::string>
  Plausibility::doubts(const BlockVector &u)
  {
    if (units.length.empty())
      return {};
    if (places.empty())
      find_places();
    const std::string remedy =
      ". Check loads and displacements, and that all numbers are in Units = " +
      units.length + ", " + units.force + " (stresses in " + units.stress + ")";
    std::vector<std::string> sentences;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Body &body = *bodies[b];
        Extreme     strain, displacement;
        for (const Location &place : places[b])
          {
            const FieldSample at = body.sample(place, u.block(b));
            for (unsigned int c = 0; c < 6; ++c)
              strain.take(std::abs(at.strain[c]), place.position);
            displacement.take(at.displacement.norm(), place.position);
          }
        // Body::size() is half the largest extension.
        const double length = 2. * body.size();
        if (strain.value > large_strain)
          sentences.push_back(
            "strains of body " + body.name() + " reach " +
            to_text(100. * strain.value, 2) + " % at " + to_text(strain.place) +
            ", and few solids are linear beyond 2 %" + remedy);
        if (displacement.value > length)
          sentences.push_back(
            "body " + body.name() + " moves by " +
            to_text(displacement.value, 3) + " " + units.length + " at " +
            to_text(displacement.place) + ", more than its " + "own length, " +
            to_text(length, 3) + " " + units.length + remedy);
      }
    return sentences;
  }
} // namespace lamella
