// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/estimate/enrichment.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  bool
  pairs_nodes(const Scene &scene)
  {
    return std::any_of(scene.contacts.begin(),
                       scene.contacts.end(),
                       [](const ContactPair &contact) {
                         return contact.discretization ==
                                Discretization::node_to_node;
                       });
  }



  namespace
  {
    /// Returns @p axis, of body number @p body, with elements of @p marked
    /// bisected. Equal neighbors from one segment stay in one segment, so that
    /// halved() can undo bisections.
    AxisMesh
    bisected_axis(const AxisMesh                  &axis,
                  const unsigned int               body,
                  const std::vector<ElementError> &marked)
    {
      const std::vector<double> lengths = element_lengths(axis);
      AxisMesh                  result  = axis;
      result.breaks.clear();
      result.elements.clear();
      double      begin = 0.;
      std::size_t k     = 0;
      for (const unsigned int n : axis.elements)
        {
          bool was_marked = false;
          for (unsigned int i = 0; i < n; ++i, begin += lengths[k++])
            {
              const double near = arithmetic::same_in_element * lengths[k];
              const bool   is_marked =
                std::any_of(marked.begin(), marked.end(), [&](const auto &one) {
                  return one.body == body && std::abs(one.begin - begin) < near;
                });
              if (i == 0 || is_marked != was_marked)
                {
                  if (k > 0)
                    result.breaks.push_back(begin);
                  result.elements.push_back(0);
                }
              result.elements.back() += is_marked ? 2 : 1;
              was_marked = is_marked;
            }
        }
      return result;
    }



    /// Returns those of @p elements to be refined, by their errors per DoF,
    /// until the others have at most @p left and 1 - @p share of all.
    std::vector<ElementError>
    worst_elements(std::vector<ElementError> elements,
                   const double              share,
                   const double              left)
    {
      std::sort(elements.begin(),
                elements.end(),
                [](const ElementError &a, const ElementError &b) {
                  return std::abs(a.error) * b.dofs >
                         std::abs(b.error) * a.dofs;
                });
      double sum = 0.;
      for (const ElementError &element : elements)
        sum += std::abs(element.error);
      const double most = std::min((1. - share) * sum, left);
      std::size_t  n    = 0;
      for (; n < elements.size() && !(sum <= most); ++n)
        sum -= std::abs(elements[n].error);
      elements.resize(n);
      return elements;
    }



    /// Returns the distances from the start of @p beam, body number @p number,
    /// of supported points, lines and ends.
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
            for (const dealii::Point<3> &x : region.at)
              at.push_back(std::clamp(beam.place().to_body(x)[1], 0., length));
            for (const bool at_start : {true, false})
              if (region.covers_end(at_start))
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
  } // namespace



  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked)
  {
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      scene.bodies[b].axis = bisected_axis(scene.bodies[b].axis, b, marked);
    return scene;
  }



  std::optional<std::vector<ElementError>>
  marked_elements(const Scene                   &scene,
                  const std::vector<GoalResult> &goals,
                  const double                   left,
                  const double                   share)
  {
    if (pairs_nodes(scene))
      return std::nullopt;
    std::vector<ElementError> marked;
    const auto is_marked = [&marked](const ElementError &element) {
      return std::any_of(marked.begin(),
                         marked.end(),
                         [&element](const ElementError &other) {
                           return other.body == element.body &&
                                  other.begin == element.begin;
                         });
    };
    for (const GoalResult &goal : goals)
      {
        if (!goal.local)
          return std::nullopt;
        for (const ElementError &element : worst_elements(
               goal.local->elements, share, left * goal.allowed_error()))
          if (!is_marked(element))
            marked.push_back(element);
      }
    return marked;
  }



  std::optional<Scene>
  with_short_elements_at_supports(Scene             scene,
                                  const Simulation &run,
                                  const double      longest)
  {
    const auto beams = beams_of(run.model().structure().bodies());
    std::vector<ElementError> marked;
    for (unsigned int b = 0; b < beams.size(); ++b)
      if (beams[b] != nullptr && scene.bodies[b].theory.describes_contraction())
        mark_long(scene.bodies[b].axis,
                  b,
                  held_at(*beams[b], b, scene.supports),
                  longest * beams[b]->section().extents().second,
                  marked);
    if (marked.empty())
      return {};
    return bisected(scene, marked);
  }
} // namespace lamella
