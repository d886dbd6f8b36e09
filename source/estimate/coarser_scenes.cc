// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/estimate/coarser_scenes.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    bool
    is_longer(const double one, const double other)
    {
      return one > (1. + arithmetic::same_in_element) * other;
    }



    /// Returns whether elements of @p lengths get shorter toward the start of
    /// number @p k, from both sides unless it is at an end.
    bool
    is_place(const std::vector<double> &lengths, const std::size_t k)
    {
      const bool before = k >= 2 && is_longer(lengths[k - 2], lengths[k - 1]),
                 behind = k + 1 < lengths.size() &&
                          is_longer(lengths[k + 1], lengths[k]);
      return (before || k == 1) && (behind || k + 1 == lengths.size()) &&
             (before || behind);
    }



    /// Appends the ends of the elements @p begin to @p end of @p lengths,
    /// merged in pairs, to @p ends. If their number is odd, three are merged:
    /// the longest (or its neighbor) and the next two, at the end two before.
    void
    merge_pairs(const std::vector<double> &lengths,
                const std::size_t          begin,
                const std::size_t          end,
                std::vector<double>       &ends)
    {
      std::size_t third = end;
      if ((end - begin) % 2 == 1)
        {
          third =
            std::max_element(lengths.begin() + begin, lengths.begin() + end) -
            lengths.begin();
          third -= (third - begin) % 2;
        }
      double y = ends.empty() ? 0. : ends.back();
      for (std::size_t k = begin; k < end; ++k)
        {
          y += lengths[k];
          const std::size_t in_pairs = k < third ? k - begin : k - third - 1;
          if (k + 1 == end && k == third && k > begin)
            ends.back() = y;
          else if (k + 1 == end || (k != third && in_pairs % 2 == 1))
            ends.push_back(y);
        }
    }
  } // namespace



  AxisMesh
  halved(const AxisMesh &axis)
  {
    const std::vector<double> lengths = element_lengths(axis);
    // One past the last element of each part in which pairs are formed.
    std::vector<std::size_t> parts;
    if (std::all_of(axis.elements.begin(),
                    axis.elements.end(),
                    [](const unsigned int n) { return n == 1; }))
      {
        for (std::size_t k = 1; k < lengths.size(); ++k)
          if (is_place(lengths, k))
            parts.push_back(k);
        parts.push_back(lengths.size());
      }
    else
      for (const unsigned int n : axis.elements)
        parts.push_back(n + (parts.empty() ? 0 : parts.back()));

    std::vector<double> ends;
    std::size_t         begin = 0;
    for (const std::size_t end : parts)
      {
        merge_pairs(lengths, begin, end, ends);
        begin = end;
      }
    AxisMesh result = axis;
    // The last one is the end of the axis.
    ends.pop_back();
    result.breaks = ends;
    result.elements.assign(ends.size() + 1, 1);
    return result;
  }



  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times)
  {
    const auto with_degrees = [&axis](const std::vector<AxisSpan> &before) {
      std::vector<AxisSpan> spans;
      double                end = 0.;
      for (const double length : element_lengths(axis))
        {
          AxisSpan span{end, end + length, axis.degree};
          end = span.end;
          for (const AxisSpan &old : before)
            if (std::abs(old.begin - span.begin) +
                  std::abs(old.end - span.end) <
                arithmetic::same_in_element * length)
              span.degree = std::max(old.degree - 1, 1u);
          spans.push_back(span);
        }
      return spans;
    };
    std::vector<AxisSpan> spans = with_degrees({});
    for (unsigned int time = 0; time < times; ++time)
      {
        axis  = halved(axis);
        spans = with_degrees(spans);
      }
    return spans;
  }



  Scene
  with_halved_axes(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
      if (!body.theory.is_solid())
        body.axis = halved(body.axis);
    return scene;
  }



  Scene
  with_lower_degree(Scene scene)
  {
    const auto poorer = [](Theory &theory) {
      if (theory.is_layerwise() && theory.order > 1)
        --theory.order;
    };
    for (BodyDescription &body : scene.bodies)
      {
        poorer(body.theory);
        for (Theory &theory : body.pieces.theories)
          poorer(theory);
      }
    return scene;
  }
} // namespace lamella
