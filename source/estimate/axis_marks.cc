// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/estimate/axis_marks.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
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
  } // namespace



  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked)
  {
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        AxisMesh           &axis = scene.bodies[b].axis;
        std::vector<double> breaks;
        double              begin = 0.;
        for (const double length : element_lengths(axis))
          {
            const double near = arithmetic::same_in_element * length;
            for (const ElementError &element : marked)
              if (element.body == b && std::abs(element.begin - begin) < near)
                breaks.push_back(begin + 0.5 * length);
            begin += length;
            breaks.push_back(begin);
          }
        // The last one is the end of the axis.
        breaks.pop_back();
        axis.breaks = breaks;
        axis.elements.assign(breaks.size() + 1, 1);
      }
    return scene;
  }



  namespace
  {
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
  } // namespace



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



  namespace
  {
    /// An element of an axis, or several merged ones.
    struct Span
    {
      double begin = 0., end = 0.;
      /// Error in the goals: the largest share of a tolerance.
      double error = 0.;
    };

    /// Returns elements of @p body with errors; empty if one is unknown.
    std::vector<Span>
    spans_of(const AxisMesh                &axis,
             const unsigned int             body,
             const std::vector<GoalResult> &goals)
    {
      std::vector<Span> spans;
      double            begin = 0.;
      for (const double length : element_lengths(axis))
        {
          Span span{begin, begin + length, 0.};
          for (const GoalResult &goal : goals)
            {
              const auto &all = goal.local->elements;
              const auto  own =
                std::find_if(all.begin(), all.end(), [&](const auto &one) {
                  return one.body == body &&
                         std::abs(one.begin - begin) <
                           arithmetic::same_in_element * length;
                });
              if (own == all.end())
                return {};
              const double known =
                goal.local->of_pairs ? std::pow(0.5, 2. * axis.degree) : 1.;
              span.error =
                std::max(span.error,
                         known * std::abs(own->error) / goal.allowed_error());
            }
          spans.push_back(span);
          begin += length;
        }
      return spans;
    }



    Span
    together(const Span &a, const Span &b, const unsigned int degree)
    {
      const double length = b.end - a.begin,
                   least  = std::min(a.end - a.begin, b.end - b.begin);
      return {a.begin,
              b.end,
              (a.error + b.error) * std::pow(length / least, 2. * degree)};
    }



    /// Merges @p spans in order of increasing error while the sum is below
    /// @p left. Returns the remainder of @p left.
    double
    merge(std::vector<Span>         &spans,
          const std::vector<double> &kept,
          const unsigned int         degree,
          double                     left)
    {
      while (true)
        {
          std::size_t best = spans.size();
          Span        least;
          for (std::size_t k = 0; k + 1 < spans.size(); ++k)
            {
              const Span one  = together(spans[k], spans[k + 1], degree);
              const auto near = [&](const double y) {
                return std::abs(y - spans[k].end) <
                       arithmetic::same_in_element * (one.end - one.begin);
              };
              if (std::none_of(kept.begin(), kept.end(), near) &&
                  (best == spans.size() || one.error < least.error))
                {
                  best  = k;
                  least = one;
                }
            }
          if (best == spans.size() || least.error > left)
            return left;
          // The error of the new span includes those of its parts.
          left -= least.error;
          spans[best] = least;
          spans.erase(spans.begin() + best + 1);
        }
    }
  } // namespace



  Scene
  merged(Scene                                   scene,
         const std::vector<std::vector<double>> &kept,
         const std::vector<GoalResult>          &goals,
         const double                            left)
  {
    const auto is_told = [left](const GoalResult &goal) {
      return goal.local &&
             std::abs(goal.local->contact) + std::abs(goal.local->remainder) <=
               left * goal.allowed_error();
    };
    if (pairs_nodes(scene) || !std::all_of(goals.begin(), goals.end(), is_told))
      return scene;
    double rest = left;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        AxisMesh         &axis   = scene.bodies[b].axis;
        std::vector<Span> spans  = spans_of(axis, b, goals);
        const std::size_t before = spans.size();
        rest                     = merge(spans, kept[b], axis.degree, rest);
        if (spans.size() == before)
          continue;
        axis.breaks.clear();
        for (std::size_t k = 1; k < spans.size(); ++k)
          axis.breaks.push_back(spans[k].begin);
        axis.elements.assign(spans.size(), 1);
      }
    return scene;
  }
} // namespace lamella
