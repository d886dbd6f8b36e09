// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/beam.h>
#include <lamella/estimate/axis_marks.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/estimate/support_refinement.h>

#include <algorithm>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the distances from the start of @p beam, body number @p number,
    /// of supported points and lines, and of supported ends if it is heated.
    std::vector<double>
    held_at(const Beam                 &beam,
            const unsigned int          number,
            const std::vector<Support> &supports)
    {
      const double        length = beam.axis().length();
      std::vector<double> at;
      for (const Support &support : supports)
        for (const Region &region : support.on)
          {
            if (region.body != number)
              continue;
            for (const Point<3> &x : region.at)
              at.push_back(std::clamp(beam.place().to_body(x)[1], 0., length));
            for (const bool at_start : {true, false})
              if (beam.is_heated() && region.covers_end(at_start))
                at.push_back(at_start ? 0. : length);
          }
      return at;
    }



    /// Adds the elements of @p axis, of body @p number, that are longer than
    /// @p longest and contain one of the places @p at, to @p marked.
    void
    mark_long(const AxisMesh            &axis,
              const unsigned int         number,
              const std::vector<double> &at,
              const double               longest,
              std::vector<ElementError> &marked)
    {
      double begin = 0.;
      for (const double length : element_lengths(axis))
        {
          const double near = arithmetic::same_in_element * length;
          if (length > longest &&
              std::any_of(at.begin(), at.end(), [&](const double y) {
                return begin - near < y && y < begin + length + near;
              }))
            {
              ElementError element;
              element.body  = number;
              element.begin = begin;
              element.end   = begin + length;
              marked.push_back(element);
            }
          begin += length;
        }
    }



    /// Returns @p scene with beams of LE-1.
    Scene
    of_first_degree(Scene scene)
    {
      for (BodyDescription &body : scene.bodies)
        if (body.theory.describes_contraction() && !body.theory.is_solid())
          {
            const unsigned int order  = body.theory.section_order;
            body.theory               = Theory::layerwise(1);
            body.theory.section_order = order;
          }
      return scene;
    }



    bool
    has_support_effects(const Scene &scene)
    {
      return std::none_of(scene.bodies.begin(),
                          scene.bodies.end(),
                          [](const BodyDescription &body) {
                            return !body.pieces.empty();
                          }) &&
             std::none_of(scene.contacts.begin(),
                          scene.contacts.end(),
                          [](const ContactPair &contact) {
                            return contact.discretization ==
                                   Discretization::node_to_node;
                          });
    }



    /// Returns @p scene, a scene of the bodies of @p run, with long elements at
    /// supported places bisected @p rules.times; nothing if there are none.
    std::optional<Scene>
    with_short_elements(Scene                         scene,
                        const Simulation             &run,
                        const SupportRefinementRules &rules)
    {
      const auto beams = beams_of(run.model().structure().bodies());
      bool       any   = false;
      for (unsigned int time = 0; time < rules.times; ++time)
        {
          std::vector<ElementError> marked;
          for (unsigned int b = 0; b < beams.size(); ++b)
            if (beams[b] != nullptr &&
                scene.bodies[b].theory.describes_contraction())
              mark_long(scene.bodies[b].axis,
                        b,
                        held_at(*beams[b], b, scene.supports),
                        rules.longest * beams[b]->section().extents().second,
                        marked);
          any   = any || !marked.empty();
          scene = bisected(scene, marked);
        }
      return any ? std::optional(scene) : std::nullopt;
    }
  } // namespace



  std::vector<double>
  support_refinement_changes(const Simulation             &run,
                             std::ostream                 &out,
                             ModelCache                   &cache,
                             const SupportRefinementRules &rules)
  {
    const Scene scene = for_estimates(run);
    if (!has_support_effects(scene))
      return {};
    const auto shorter = with_short_elements(scene, run, rules);
    if (!shorter)
      return {};
    ComparisonModels    models(run, out, cache);
    const ResultNumbers as_is = models
                                  .solved(of_first_degree(scene),
                                          "LE-1, for places that are held")
                                  .numbers,
                        finer = models
                                  .solved(of_first_degree(*shorter),
                                          "LE-1, short elements there")
                                  .numbers;
    std::vector<double> missed;
    const RunGoals      goals(run);
    for (const NamedQuantity &quantity : goals.quantities())
      missed.push_back(finer.value(quantity) - as_is.value(quantity));
    return missed;
  }
} // namespace lamella
