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
  /// Parameters of `Axis elements = auto`. Lengths are multiples of H, the
  /// smaller side of the section.
  struct GradingRules
  {
    /// Element length at a clamp, and at the edge or the line of a contact.
    double clamp = 0.15, contact = 0.125;
    /// Element length at point and line supports and loads, and load edges.
    double edge = 0.25;
    /// Largest element length where contact is possible, for at most
    /// `max_inside` such elements.
    double inside = 0.5, max_inside = 40.;
    /// Increase of the element length per distance from a refinement point;
    /// neighboring elements differ by a factor of about 1.8.
    double growth = 0.6;
    /// Smallest number of elements on an axis.
    unsigned int least = 4;
    /// Number of elements in a span with distributed load, between supports or
    /// changes of the load's sign. B4 (cubic) elements are exact at their ends.
    /// Within an element of length h, a uniform load q leaves the error q h^4 /
    /// (384 E I) (bending stiffness E I), relative to the deflection between
    /// clamps 0.077 % for 6 elements, 0.024 % for 8, 0.01 % for 10.
    double elements_per_span = 10.;
    /// Refinement points closer than this multiple of the element length merge.
    double merge_distance = 0.5;
    /// The number of elements between two refinement points is the integral of
    /// 1 / s, with the element length s, by the trapezoidal rule with `samples`
    /// points. If it exceeds an integer by less than `rounding_allowance`, no
    /// element is added.
    unsigned int samples            = 400;
    double       rounding_allowance = 0.05;
    /// Points whose gaps differ by less than this fraction of H belong to the
    /// same contact area.
    double gap_tolerance = 1e-3;
    /// Number of equal elements for the contact search: per length H, and the
    /// least and largest number on an axis.
    double search_elements = 2., min_search_elements = 12.,
           max_search_elements = 240.;
  };

  /// Returns the element ends of an axis of length @p length, graded to the
  /// refinement points @p given, without 0 and @p length. Point k at y_k
  /// requires elements of length size_k. The element length is
  ///   s(y) = min_k (c size_k + growth |y - y_k|),
  ///   c = growth / (exp(growth) - 1),
  /// at most length / least and, in the segments @p loaded, span /
  /// elements_per_span (GradingRules). Between two refinement points there are
  /// N elements, each with 1 / N of the integral of dy / s. N is this integral,
  /// rounded up (to an even number if loaded, for halved()), times @p
  /// refinement_factor. Points closer than merge_distance times their element
  /// length are merged.
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &given,
                const GradingRules              &rules             = {},
                const double                     refinement_factor = 1.,
                const std::vector<LoadedPart>   &loaded            = {});

  /// Bisects elements of @p axis until those at @p y, which becomes an element
  /// end, are at most @p size long; for size 0, bisects them once. Neighbors
  /// are bisected to satisfy GradingRules::growth.
  void
  refine_at(AxisMesh           &axis,
            const double        y,
            const double        size,
            const GradingRules &rules = {});

  /// Creates the axes of `Axis elements = auto` of @p bodies, graded to loads,
  /// supports and contacts. The number of elements is multiplied by
  /// AxisMesh::fineness, which is set to 0. Contacts are searched on equal
  /// elements, then on the graded ones. For bodies apart, the refinement point
  /// is at the smallest gap, interpolated by a parabola through three gaps.
  /// Supports of body ends count as clamps. Bodies whose nodes are paired along
  /// a line have the same element lengths. Distributed loads on sides and
  /// lines, weight under @p gravity, and nonlinear temperature limit all
  /// element lengths (GradingRules::elements_per_span). Throws what conditions
  /// and contacts throw. Collective if bodies are.
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
