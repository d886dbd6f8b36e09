// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/adapt/local_interactions.h>
#include <lamella/adapt/plan.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/surface_topology.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

// Graded meshes of axes by equidistribution of the density 1 / s(y) of elements
// (de Boor, Lect. Notes Math. 363, Springer 1974, 12-20):
// 1. grading_targets(): the places that need short elements (supports, loads,
//    edges of contact), and the parts of the axis that are loaded all along;
// 2. size_at(): the element size s(y), which grows linearly from each place;
// 3. graded_breaks(): N = int dy / s elements between two places, each with
//    1 / N of that integral.



namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the element size s(y) of graded_breaks(), the mesh density
    /// function 1 / s being equidistributed (de Boor's principle).
    double
    size_at(const double                     y,
            const double                     length,
            const std::vector<ShortElement> &places,
            const std::vector<LoadedPart>   &loaded,
            const GradingRules              &rules)
    {
      // The first element, of length a, has int_0^a dy / (c a + growth y) = 1
      // if c = growth / (exp(growth) - 1); the next is exp(growth) times
      // longer.
      const double first = rules.growth / std::expm1(rules.growth);
      double       size  = length / rules.least;
      for (const ShortElement &place : places)
        size =
          std::min(size,
                   first * place.size + rules.growth * std::abs(y - place.y));
      // B4 is exact at its ends (Tong, AIAA J. 7 (1969) 178-180); inside, a
      // line load leaves the bubble q h^4 / (384 E I).
      for (const LoadedPart &part : loaded)
        if (part.begin <= y && y <= part.end)
          size = std::min(size, part.span / rules.elements_per_span);
      return size;
    }



    /// Returns places by ascending y, with 0 and the length; close ones are
    /// merged with the smaller size.
    std::vector<ShortElement>
    tidy(std::vector<ShortElement> places,
         const double              length,
         const GradingRules       &rules)
    {
      for (const double end : {0., length})
        places.push_back({end, length});
      std::sort(places.begin(),
                places.end(),
                [](const ShortElement &a, const ShortElement &b) {
                  return a.y < b.y;
                });
      std::vector<ShortElement> result;
      for (const ShortElement &place : places)
        if (!result.empty() &&
            place.y - result.back().y <
              rules.merge_distance *
                std::min({place.size, result.back().size, length}))
          {
            result.back().size = std::min(result.back().size, place.size);
            if (place.y == length)
              result.back().y = length;
          }
        else
          result.push_back(place);
      return result;
    }



    /// Returns the number of elements for @p wanted: rounded up, to an even
    /// number if @p together, and multiplied by @p refinement_factor.
    unsigned int
    n_elements(const double wanted,
               const double together,
               const double refinement_factor)
    {
      const double n = together * std::max(1., std::ceil(wanted / together));
      return std::max(1.,
                      std::ceil(refinement_factor * n -
                                arithmetic::decimal_tolerance));
    }



    /// Adds to @p breaks the n - 1 places that divide @p integral, sampled
    /// every @p step from @p begin on, into equal parts.
    void
    add_equal_parts(const std::vector<double> &integral,
                    const double               begin,
                    const double               step,
                    const unsigned int         n,
                    std::vector<double>       &breaks)
    {
      for (unsigned int i = 1; i < n; ++i)
        {
          // Inverse linear interpolation in the monotone table.
          const double wanted = integral.back() * i / n;
          const auto   above =
            std::upper_bound(integral.begin(), integral.end(), wanted);
          const unsigned int k = above - integral.begin() - 1;
          breaks.push_back(begin +
                           step * (k + (wanted - integral[k]) /
                                         (integral[k + 1] - integral[k])));
        }
    }



    bool
    is_automatic(const BodyDescription &body)
    {
      return body.axis.refinement_factor > 0.;
    }



    /// The smaller extent of a section.
    double
    height(const SectionMesh &mesh)
    {
      const BoundingBox<2> box = GridTools::compute_bounding_box(mesh.mesh);
      return std::min(box.side_length(0), box.side_length(1));
    }



    /// Returns y of the smallest gap: the vertex of the parabola through the
    /// lowest row and its neighbors.
    double
    nearest(const std::map<double, double> &gaps)
    {
      const auto lowest = std::min_element(gaps.begin(),
                                           gaps.end(),
                                           [](const auto &a, const auto &b) {
                                             return a.second < b.second;
                                           });
      if (lowest == gaps.begin() || std::next(lowest) == gaps.end())
        return lowest->first;
      const auto [a, fa] = *std::prev(lowest);
      const auto [b, fb] = *lowest;
      const auto [c, fc] = *std::next(lowest);
      // Newton's divided differences (successive parabolic interpolation;
      // Brent, Algorithms for Minimization without Derivatives, 1973, Ch. 5):
      //   p(y) = f_a + left (y - a) + bend (y - a) (y - b),  p' = 0.
      const double left = (fb - fa) / (b - a), right = (fc - fb) / (c - b),
                   bend = (right - left) / (c - a);
      return bend > 0. ? 0.5 * (a + b) - 0.5 * left / bend : b;
    }



    /// Smallest gaps of @p contact along the axis of @p beam, body @p number.
    std::map<double, double>
    gaps_along(const ContactInterface &contact,
               const unsigned int      number,
               const Beam             &beam)
    {
      std::map<double, double> gaps;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const Point<3> place    = number == contact.first_body ?
                                      contact.points[k].first :
                                      contact.points[k].second;
          const double   y        = beam.place().to_body(place)[1],
                       gap        = contact.rows[k].initial_gap;
          const auto [at, is_new] = gaps.emplace(y, gap);
          at->second              = std::min(at->second, gap);
        }
      return gaps;
    }



    /// Adds the places of @p contact on body @p number.
    void
    add_contact_places(const ContactInterface    &contact,
                       const unsigned int         number,
                       const Beam                &beam,
                       const double               H,
                       const GradingRules        &rules,
                       std::vector<ShortElement> &places)
    {
      const std::map<double, double> gaps = gaps_along(contact, number, beam);
      double lowest                       = std::numeric_limits<double>::max();
      for (const auto &[y, gap] : gaps)
        lowest = std::min(lowest, gap);
      double begin = beam.axis().length(), end = 0.;
      for (const auto &[y, gap] : gaps)
        if (gap < lowest + rules.gap_tolerance * H)
          {
            begin = std::min(begin, y);
            end   = std::max(end, y);
          }
      // A contact shorter than H acts on the beam like a line contact.
      const double size = rules.contact * H;
      if (end - begin < H)
        {
          places.push_back({nearest(gaps), size, true});
          return;
        }
      // Extended contact: short elements at its edges, where the pressure
      // concentrates, and places every (end - begin) / n in between.
      for (const double edge : {begin, end})
        places.push_back({edge, size, true});
      const double n = std::ceil(
        std::min((end - begin) / (rules.inside * H), rules.max_inside) / 2.);
      for (unsigned int i = 1; i < n; ++i)
        places.push_back(
          {begin + (end - begin) * i / n, 0.5 * (end - begin) / n});
    }



    /// Adds the places of supports and loads on body @p number.
    void
    add_condition_places(const std::vector<Region> &regions,
                         const unsigned int         number,
                         const Beam                &beam,
                         const double               end_size,
                         const double               point_size,
                         std::vector<ShortElement> &places)
    {
      for (const Region &region : regions)
        {
          if (region.body != number)
            continue;
          // A clamped end disturbs the section over a length of about H
          // (Saint-Venant's principle). Conditions on the whole surface do not
          // change at the ends.
          for (const double y : {0., beam.axis().length()})
            if (is_clamp(region, y, beam.axis().length()) &&
                !region.is_whole_body() &&
                !surface_names::is_whole_surface(region.surface))
              places.push_back({y, end_size});
          for (const Point<3> &point : region.at)
            places.push_back({beam.place().to_body(point)[1], point_size});
        }
    }



    /// The edges of loads that do not go all along the axis of body @p number.
    void
    add_load_edges(const Beam                &beam,
                   const unsigned int         number,
                   const Bodies              &bodies,
                   const std::vector<Load>   &loads,
                   const double               size,
                   std::vector<ShortElement> &places)
    {
      for (const LocalInteraction &interaction :
           find_interactions(beam, number, bodies, {}, loads, {}))
        for (const double edge : {interaction.begin, interaction.end})
          if (!interaction.is_heat_source && edge > 0. &&
              edge < beam.axis().length())
            places.push_back({edge, size});
    }



    /// Places and loaded parts that an axis is graded to.
    struct GradingTargets
    {
      std::vector<ShortElement> places;
      std::vector<LoadedPart>   loaded;
    };



    /// Returns the places of supports, loads and contacts on body @p number.
    std::vector<ShortElement>
    places_of(const unsigned int                   number,
              const Bodies                        &bodies,
              const std::vector<Support>          &supports,
              const std::vector<Load>             &loads,
              const std::vector<ContactInterface> &touching,
              const GradingRules                  &rules)
    {
      const Beam               &beam = *beams_of(bodies)[number];
      const double              H    = beam.section().extents().first;
      std::vector<ShortElement> places;
      for (const Support &support : supports)
        add_condition_places(
          support.on, number, beam, rules.clamp * H, rules.edge * H, places);
      for (ShortElement &place : places)
        place.holds = true;
      for (const ContactInterface &contact : touching)
        if (contact.first_body == number || contact.second_body == number)
          add_contact_places(contact, number, beam, H, rules, places);
      for (const Load &load : loads)
        add_condition_places(
          load.on, number, beam, rules.edge * H, rules.edge * H, places);
      add_load_edges(beam, number, bodies, loads, rules.edge * H, places);
      return places;
    }



    /// Node-to-node contact pairs nodes that face each other: two axes along
    /// the same line have the places of both.
    void
    share_graded_places(const std::vector<ContactPair>  &contacts,
                        const std::vector<const Beam *> &beams,
                        std::vector<GradingTargets>     &targets)
    {
      for (const ContactPair &contact : contacts)
        {
          if (!may_pair_nodes(contact))
            continue;
          const unsigned int a = contact.first.body, b = contact.second.body;
          const Beam        &one = *beams[a], &other = *beams[b];
          const double       length      = one.axis().length();
          const auto         y_in_one_of = [&](const double y) {
            return one.place().to_body(
              other.place().to_scene(Point<3>(0., y, 0.)))[1];
          };
          // Both ends must coincide, in the same direction of the axes.
          const double tolerance = arithmetic::same_position * length;
          if (std::abs(other.axis().length() - length) > tolerance ||
              std::abs(y_in_one_of(0.)) > tolerance ||
              std::abs(y_in_one_of(length) - length) > tolerance)
            continue;
          const auto add = [](const auto &more, auto &all) {
            all.insert(all.end(), more.begin(), more.end());
          };
          GradingTargets both = targets[a];
          add(targets[b].places, both.places);
          add(targets[b].loaded, both.loaded);
          targets[a] = targets[b] = both;
        }
    }



    /// The bodies as beams of few fields, for their geometry alone.
    Bodies
    plain_beams(const std::vector<BodyDescription> &bodies,
                const SectionMeshes                &meshes)
    {
      std::vector<BodyDescription> plain = bodies;
      for (BodyDescription &body : plain)
        {
          body.theory                    = Theory::parse({"Theory", "TE-1"});
          body.theory.poisson_correction = false;
        }
      return make_bodies(plain, meshes);
    }



    /// Returns the grading targets of all automatic axes of @p bodies.
    std::vector<GradingTargets>
    grading_targets(const std::vector<BodyDescription> &bodies,
                    const SectionMeshes                &meshes,
                    const std::vector<Support>         &supports,
                    std::vector<Load>                   loads,
                    const std::vector<ContactPair>     &contacts,
                    const Tensor<1, 3>                 &gravity,
                    const GradingRules                 &rules)
    {
      // Spans of loaded parts end at supported places, hence places come first.
      const Bodies plain = plain_beams(bodies, meshes);
      distribute_total_forces(loads, plain);
      apply_temperatures(loads, plain);
      std::vector<ContactInterface> touching;
      for (const ContactPair &contact : contacts)
        touching.push_back(make_interface(contact, plain));
      std::vector<GradingTargets> targets(bodies.size());
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (is_automatic(bodies[b]))
          {
            auto &[places, loaded] = targets[b];
            places = places_of(b, plain, supports, loads, touching, rules);
            loaded = loaded_parts(b, plain, loads, gravity, places);
          }
      share_graded_places(contacts, beams_of(plain), targets);
      return targets;
    }
  } // namespace



  // Equidistribution of int 1 / s dy between two places, trapezoidal rule.
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &given,
                const GradingRules              &rules,
                const double                     refinement_factor,
                const std::vector<LoadedPart>   &loaded)
  {
    const unsigned int              samples = rules.samples;
    const std::vector<ShortElement> places  = tidy(given, length, rules);
    std::vector<double>             breaks;
    for (unsigned int piece = 0; piece + 1 < places.size(); ++piece)
      {
        const double begin = places[piece].y, end = places[piece + 1].y,
                     step  = (end - begin) / samples;
        const auto density = [&](const unsigned int k) {
          return 1. / size_at(begin + k * step, length, places, loaded, rules);
        };
        // The integral of 1 / s up to each sample, by the trapezoidal rule.
        std::vector<double> integral{0.};
        for (unsigned int k = 0; k < samples; ++k)
          integral.push_back(integral.back() +
                             0.5 * step * (density(k) + density(k + 1)));
        const bool is_loaded =
          std::any_of(loaded.begin(), loaded.end(), [&](const auto &part) {
            return part.begin < end && part.end > begin;
          });
        // The allowance avoids a further element for an integral barely above
        // an integer.
        const unsigned int n =
          n_elements(integral.back() - rules.rounding_allowance,
                     is_loaded ? 2. : 1.,
                     refinement_factor);
        add_equal_parts(integral, begin, step, n, breaks);
        if (piece + 2 < places.size())
          breaks.push_back(end);
      }
    return breaks;
  }



  // A fixed-point iteration of two passes, as gaps depend on the mesh that
  // samples them: contacts on equal elements, then on the graded axes.
  void
  grade_axes(std::vector<BodyDescription>   &bodies,
             const SectionMeshes            &meshes,
             const std::vector<Support>     &supports,
             const std::vector<Load>        &loads,
             const std::vector<ContactPair> &contacts,
             const Tensor<1, 3>             &gravity,
             const GradingRules             &rules)
  {
    if (std::none_of(bodies.begin(), bodies.end(), is_automatic))
      return;
    for (BodyDescription &body : bodies)
      if (is_automatic(body))
        // Equal elements, for the search of contacts.
        body.axis.elements = {static_cast<unsigned int>(
          std::clamp(std::ceil(rules.search_elements * body.axis.length /
                               height(*meshes.at(body.section))),
                     rules.min_search_elements,
                     rules.max_search_elements))};
    for (unsigned int pass = 0; pass < 2; ++pass)
      {
        const std::vector<GradingTargets> targets = grading_targets(
          bodies, meshes, supports, loads, contacts, gravity, rules);
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (is_automatic(bodies[b]))
            {
              AxisMesh &axis = bodies[b].axis;
              axis.breaks    = graded_breaks(axis.length,
                                          targets[b].places,
                                          rules,
                                          axis.refinement_factor,
                                          targets[b].loaded);
              axis.elements.assign(axis.breaks.size() + 1, 1);
            }
      }
    for (BodyDescription &body : bodies)
      body.axis.refinement_factor = 0.;
  }



  void
  refine_at(AxisMesh           &axis,
            const double        y,
            const double        size,
            const GradingRules &rules)
  {
    const std::vector<double> lengths = element_lengths(axis);
    std::vector<double>       ends;
    double                    begin = 0., longest = size;
    for (const double length : lengths)
      {
        if (size == 0. && begin <= y && y <= begin + length)
          longest = std::max(longest, 0.5 * length);
        begin += length;
      }
    const double near = rules.rounding_allowance * longest;
    const std::function<void(double, double)> add = [&](const double a,
                                                        const double b) {
      const bool   has_y = a + near < y && y + near < b;
      const double most = longest + rules.growth * std::max({0., a - y, y - b}),
                   middle = has_y ? y : 0.5 * (a + b);
      if (has_y || b - a > (1. + arithmetic::same_in_element) * most)
        {
          add(a, middle);
          add(middle, b);
        }
      else
        ends.push_back(b);
    };
    begin = 0.;
    for (const double length : lengths)
      {
        add(begin, begin + length);
        begin += length;
      }
    ends.pop_back();
    axis.breaks = ends;
    axis.elements.assign(ends.size() + 1, 1);
  }
} // namespace lamella
