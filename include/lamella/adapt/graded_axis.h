// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_graded_axis_h
#define lamella_adapt_graded_axis_h

#include <lamella/adapt/loaded_parts.h>
#include <lamella/body/parameters.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Sizes of `Axis elements = auto`, over the smaller extent H of the section.
  struct GradingRules
  {
    /// Beside a clamp, and beside the edge or the line of a contact.
    double clamp = 0.15, contact = 0.125;
    /// Beside supports and loads at points and lines, or edges of loads.
    double edge = 0.25;
    /// At most, where bodies lie upon each other, up to max_inside elements.
    double inside = 0.5, max_inside = 40.;
    /// Growth of elements per length (neighbors differ by about 1.8).
    double growth = 0.6;
    /// At least as many elements on an axis.
    unsigned int least = 4;
    /// Elements in a span that is loaded all along, between supported places or
    /// changes of the load's sign. B4 is exact at its ends. Inside an element
    /// of length h, a uniform load leaves out the bubble q h^4 / (384 E I),
    /// n^-4 of the deflection between clamps: 0.077 % for n = 6, 0.024 % for 8,
    /// 0.01 % for 10, 0.005 % for 12.
    double elements_per_span = 10.;
    /// Places closer to each other than this share of their size are one.
    double merge_distance = 0.5;
    /// Samples of 1 / s between two places (trapezoidal rule); an excess of its
    /// integral over an integer below `spare` makes no element.
    unsigned int samples            = 400;
    double       rounding_allowance = 0.05;
    /// Gaps that differ by less than this share of H lie upon each other.
    double gap_tolerance = 1e-3;
    /// Number of equal elements for the search of a contact, over H, and on an
    /// axis at least and at most.
    double search_elements = 2., min_search_elements = 12.,
           max_search_elements = 240.;
  };

  /**
   * Returns the ends of elements on an axis of @p length, graded to @p places.
   * With the element size
   *   s(y) = min_k (c size_k + growth |y - y_k|),
   *   c = growth / (exp(growth) - 1),
   * limited by length / least and, in the parts of @p loaded, by span /
   * elements_per_span, a piece between two places has N elements: the integral
   * of dy / s over it, rounded up (to an even number if loaded, for halved())
   * and multiplied by @p refinement_factor. Each element has 1 / N of that
   * integral. Places closer than merge_distance of their size are merged.
   * Ascending, without 0 and length.
   */
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &places,
                const GradingRules              &rules             = {},
                const double                     refinement_factor = 1.,
                const std::vector<LoadedPart>   &loaded            = {});

  /// Bisects elements of @p axis until those at @p y, which becomes an end, are
  /// of @p size, or half as long if it is 0, others by GradingRules::growth.
  void
  refine_at(AxisMesh           &axis,
            const double        y,
            const double        size,
            const GradingRules &rules = {});

  /**
   * Makes the axes of `Axis elements = auto` among @p bodies
   * (AxisMesh::fineness, 0 afterwards): graded to loads, supports and contacts,
   * with fineness times as many elements. Contacts are searched on equal
   * elements, then on the graded ones. For bodies apart, the place is that of
   * the smallest gap, by a parabola through three rows. Supports of ends count
   * as clamps. Bodies whose nodes a contact pairs along one line share their
   * grading. Loads on sides and lines, weight under @p gravity, and heat that
   * is not linear limit elements all along (GradingRules::elements_per_span).
   * Throws what conditions and contacts throw. Collective where Beam is.
   */
  void
  grade_axes(std::vector<BodyDescription>   &bodies,
             const SectionMeshes            &meshes,
             const std::vector<Support>     &supports,
             const std::vector<Load>        &loads,
             const std::vector<ContactPair> &contacts,
             const dealii::Tensor<1, 3>     &gravity = {},
             const GradingRules             &rules   = {});
} // namespace lamella

#endif
