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



  namespace
  {
    /// Appends the ends of merged elements @p begin to @p end of @p lengths, of
    /// a graded part of an axis, to @p ends.
    void
    merge_graded(const std::vector<double> &lengths,
                 const std::size_t          begin,
                 const std::size_t          end,
                 std::vector<double>       &ends)
    {
      const std::vector<double> own(lengths.begin() + begin,
                                    lengths.begin() + end);
      std::size_t               last = begin;
      for (std::size_t k = 1; k <= own.size(); ++k)
        if (k == own.size() || is_place(own, k))
          {
            merge_pairs(lengths, last, begin + k, ends);
            last = begin + k;
          }
    }
  } // namespace



  AxisMesh
  halved(const AxisMesh &axis)
  {
    const std::vector<double> lengths = element_lengths(axis);
    std::vector<double>       ends;
    std::vector<unsigned int> elements;
    std::size_t               k = 0;
    for (std::size_t s = 0; s < axis.elements.size();)
      {
        // Segments of one element each are graded.
        std::size_t n         = axis.elements[s++];
        const bool  is_graded = n == 1;
        while (is_graded && s < axis.elements.size() && axis.elements[s] == 1)
          ++n, ++s;
        if (is_graded)
          merge_graded(lengths, k, k + n, ends);
        else if (n % 2 == 1)
          merge_pairs(lengths, k, k + n, ends);
        else
          ends.push_back((ends.empty() ? 0. : ends.back()) + n * lengths[k]);
        elements.resize(ends.size(), 1);
        if (n % 2 == 0 && !is_graded)
          elements.back() = n / 2;
        k += n;
      }
    AxisMesh result = axis;
    // The last one is the end of the axis.
    ends.pop_back();
    result.breaks   = ends;
    result.elements = elements;
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



  Scene
  with_fewer_waves(Scene scene, const unsigned int fewer)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.has_responses())
        body.theory.order -= std::min(fewer, body.theory.order - 1);
    return scene;
  }



  Scene
  with_lower_section_order(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.is_saint_venant() && body.theory.section_order > 1)
        --body.theory.section_order;
    return with_lower_degree(scene);
  }
} // namespace lamella
