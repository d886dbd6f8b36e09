// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/local_interactions.h>
#include <lamella/adapt/plan.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/beam.h>
#include <lamella/body/surface_topology.h>
#include <lamella/section/section.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Of the scene's axes those along which some displacements are given.
    class HeldAxes
    {
    public:
      void
      add(const Support &support)
      {
        for (unsigned int c = 0; c < 3; ++c)
          holds[c] = holds[c] || support.u[c].has_value();
        holds_normal = holds_normal || support.normal.has_value();
      }

      /// Whether nothing moves along @p direction, of unit length, which is
      /// @p normal to the surface or not.
      bool
      include(const Tensor<1, 3> &direction, const bool normal) const
      {
        if (normal && holds_normal)
          return true;
        for (unsigned int c = 0; c < 3; ++c)
          if (!holds[c] && std::abs(direction[c]) > arithmetic::parallel_sine)
            return false;
        return true;
      }

    private:
      std::array<bool, 3> holds{};
      bool                holds_normal = false;
    };



    /// Returns what constrains @p surface of body @p body, or all of the body.
    HeldAxes
    constrained_directions(const std::string          &surface,
                           const unsigned int          body,
                           const std::vector<Support> &supports)
    {
      HeldAxes held;
      for (const Support &support : supports)
        for (const Region &region : support.on)
          if (region.body == body &&
              (region.is_whole_body() || region.covers(surface)))
            held.add(support);
      return held;
    }



    /// Where @p place lies on @p facet, if it does.
    std::optional<Point<2>>
    on_facet(const Location::Place &place, const SurfaceFacet &facet)
    {
      const Tensor<1, 3> from = place.unit - facet.origin;
      const Point<2>     st(from * facet.along_s, from * facet.along_t);
      const Tensor<1, 3> beside =
        from - st[0] * facet.along_s - st[1] * facet.along_t;
      if (place.cell != facet.cell ||
          beside.norm() > arithmetic::same_in_element)
        return std::nullopt;
      return st;
    }



    /// Outward normal of the facets of @p surface of @p body at @p position.
    std::vector<Tensor<1, 3>>
    normals_at(const Point<3>    &position,
               const Body        &body,
               const std::string &surface)
    {
      std::vector<Tensor<1, 3>> normals;
      const auto                locations = body.locate({position});
      for (const SurfaceFacet &facet : surface_facets(body, surface))
        for (const Location &location : locations[0])
          for (const Location::Place &place : location.places)
            if (const auto st = on_facet(place, facet))
              normals.push_back(body.surface_point(facet, *st).normal);
      return normals;
    }



    /// Those of all its surfaces.
    std::vector<Tensor<1, 3>>
    normals_at(const Point<3> &position, const Body &body)
    {
      std::vector<Tensor<1, 3>> normals;
      for (const std::string &surface : body.surfaces())
        if (!surface_names::is_compound_surface(surface))
          for (const Tensor<1, 3> &n : normals_at(position, body, surface))
            normals.push_back(n);
      return normals;
    }



    /// The outward normals at @p position of the sides of @p body, number
    /// @p number, that nothing holds along them.
    std::vector<Tensor<1, 3>>
    free_normals(const Point<3>             &position,
                 const unsigned int          number,
                 const Body                 &body,
                 const std::vector<Support> &supports)
    {
      std::vector<Tensor<1, 3>> normals;
      for (const std::string &surface : body.surfaces())
        if (!surface_names::is_compound_surface(surface) &&
            surface != surface_names::end_name(true) &&
            surface != surface_names::end_name(false))
          for (const Tensor<1, 3> &n : normals_at(position, body, surface))
            if (!constrained_directions(surface, number, supports)
                   .include(n, true))
              normals.push_back(n);
      return normals;
    }



    /// Whether @p position is at the edge of a clamp.
    bool
    is_at_clamp(const Point<3>             &position,
                const unsigned int          number,
                const Bodies               &bodies,
                const std::vector<Support> &supports)
    {
      const Body  &body = *bodies[number];
      const double y    = body.place().to_body(position)[1];
      for (const bool at_start : {true, false})
        {
          const std::string end = surface_names::end_name(at_start);
          const HeldAxes held   = constrained_directions(end, number, supports);
          const auto     facets = surface_facets(body, end);
          const double   at     = body.place().to_body(facets[0].corners[0])[1];
          if (std::abs(y - at) > arithmetic::decimal_tolerance * body.size() ||
              !held.include(body.place().axes[1], true))
            continue;
          const auto normals = free_normals(position, number, body, supports);
          if (std::any_of(normals.begin(),
                          normals.end(),
                          [&](const Tensor<1, 3> &n) {
                            return held.include(n, false);
                          }))
            return true;
        }
      return false;
    }



    /// Whether @p position is where one of the surfaces of @p contact meets
    /// another side of its body, while the other body goes on: all its sides
    /// there face along the normal or the same way.
    bool
    is_at_end_of(const ContactPair &contact,
                 const Point<3>    &position,
                 const Bodies      &bodies)
    {
      if (contact.obstacle != nullptr)
        return false;
      const Body &first  = *bodies[contact.first.body],
                 &second = *bodies[contact.second.body];
      if (normals_at(position, first, contact.first.surface).empty() ||
          normals_at(position, second, contact.second.surface).empty())
        return false;
      const auto of_first   = normals_at(position, first),
                 of_second  = normals_at(position, second);
      const auto ends_alone = [](const auto &sides, const auto &others) {
        return std::any_of(
          sides.begin(), sides.end(), [&](const Tensor<1, 3> &n) {
            return std::none_of(others.begin(),
                                others.end(),
                                [&](const Tensor<1, 3> &m) {
                                  return cross_product_3d(n, m).norm() <
                                         arithmetic::parallel_sine;
                                });
          });
      };
      return ends_alone(of_first, of_second) || ends_alone(of_second, of_first);
    }



    /// Whether @p position is at a corner of the section of the body
    /// number @p number that stresses have no limit at.
    bool
    is_at_corner(const Point<3>    &position,
                 const unsigned int number,
                 const Bodies      &bodies)
    {
      const Beam *const beam = beams_of(bodies)[number];
      if (beam == nullptr)
        return false;
      const Point<3> x       = beam->place().to_body(position);
      const auto     corners = corners_of(beam->section());
      const double   near =
        arithmetic::decimal_tolerance * beam->section().extents().first;
      return std::any_of(corners.begin(),
                         corners.end(),
                         [&](const Point<2> &corner) {
                           return corner.distance({x[0], x[2]}) < near;
                         });
    }
  } // namespace



  std::string
  singularity_reason(const Point<3>                 &position,
                     const unsigned int              body,
                     const Bodies                   &bodies,
                     const std::vector<Support>     &supports,
                     const std::vector<Load>        &loads,
                     const std::vector<ContactPair> &contacts)
  {
    const double near = arithmetic::decimal_tolerance * bodies[body]->size();
    for (const Load &load : loads)
      for (const Region &region : load.on)
        if (region.body == body && region.has_point_at(position, near))
          return "below the load " + load.name +
                 ", at a point or along a line, stresses have no limit";
    if (is_at_clamp(position, body, bodies, supports))
      return "where a clamp meets a free side stresses have no limit";
    for (const ContactPair &contact : contacts)
      if ((contact.first.body == body || contact.second.body == body) &&
          is_at_end_of(contact, position, bodies))
        return "where a body of the contact " + contact.name +
               " ends on the other stresses have no limit";
    if (!is_constrained_along_axis(supports, body) &&
        is_at_corner(position, body, bodies))
      return "at a re-entrant corner of a section, and where plies that differ "
             "end at a side, stresses have no limit";
    return "";
  }
} // namespace lamella
