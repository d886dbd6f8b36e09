// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_graded_axis_h
#define lamella_adapt_graded_axis_h

#include <lamella/adapt/section_load.h>
#include <lamella/body/parameters.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Parameters of `Axis elements = auto`, which grades axis meshes toward
  /// supports, loads and contacts (grade_axes()).
  struct GradingRules
  {
    /// Element length at a clamp, as a multiple of the smaller section side.
    double clamp = 0.15;
    /// Element length at a contact edge, over the smaller section side.
    double contact = 0.125;
    /// Element length at point and line supports and loads, and at ends of
    /// distributed loads, as a multiple of the smaller section side.
    double edge = 0.25;
    /// Largest element length within a contact area, as a multiple of the
    /// smaller section side, unless max_inside is exceeded.
    double inside = 0.5;
    /// Largest number of elements within a contact area due to `inside`.
    double max_inside = 40.;
    /// Increase of the element length per distance from a refinement point. The
    /// lengths of neighboring elements differ by a factor of about 1.8.
    double growth = 0.6;
    /// Smallest number of elements on an axis.
    unsigned int least = 4;
    /// Number of elements in a span with distributed load (LoadedPart::span).
    /// B4 elements have exact deflections at their ends. Inside an element of
    /// length h, the deflection under a uniform load q has the error q h^4 /
    /// (384 E I): 0.01 % of that of a clamped span for 10 elements.
    double elements_per_span = 10.;
    /// Refinement points closer than this fraction of the element length merge.
    double merge_distance = 0.5;
    /// Number of intervals of the trapezoidal rule for elements per length.
    unsigned int samples = 400;
    /// Excess over an integer below which a number of elements is rounded down.
    double rounding_allowance = 0.05;
    /// Points belong to the contact area if their gap exceeds the smallest gap
    /// by less than this multiple of the smaller section side.
    double gap_tolerance = 1e-3;
    /// Equal elements of the contact search per length of smaller section side.
    double search_elements     = 2.;
    double min_search_elements = 12.;  ///< Smallest number for the search.
    double max_search_elements = 240.; ///< Largest number for the search.
  };

  /// Returns the element ends of an axis of length @p length, graded to the
  /// refinement points @p given, without 0 and @p length. Point k at y_k
  /// requires elements of length size_k. The element length is, with @p rules,
  ///   s(y) = min_k (c size_k + growth |y - y_k|),
  ///   c = growth / (exp(growth) - 1),
  /// at most length / least and, in the segments @p loaded, at most span /
  /// elements_per_span. Between two refinement points there are N elements,
  /// each with 1 / N of the integral of dy / s. N is this integral, rounded up
  /// (to an even number if loaded, for halved()), times @p refinement_factor.
  /// Points closer than merge_distance are merged.
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &given,
                const GradingRules              &rules             = {},
                const double                     refinement_factor = 1.,
                const std::vector<LoadedPart>   &loaded            = {});

  /// Bisects elements of @p axis so that @p y becomes an element end and the
  /// elements at @p y are at most @p size long. If @p size is 0, these elements
  /// are bisected once. Other elements are bisected until the lengths of
  /// neighbors satisfy GradingRules::growth.
  void
  refine_at(AxisMesh           &axis,
            const double        y,
            const double        size,
            const GradingRules &rules = {});

  /// Creates the axis meshes of all @p bodies with `Axis elements = auto`,
  /// graded to loads, supports and contacts. The number of elements is
  /// multiplied by AxisMesh::refinement_factor, which is then set to 0. Contact
  /// areas are searched on equal elements, then on the graded ones. A contact
  /// area shorter than the smaller section side is refined at its smallest gap,
  /// found by a parabola through three gaps. Supports of body ends count as
  /// clamps. Bodies on one line with node-to-node contact have the same element
  /// lengths. Distributed loads on sides and lines, weight under @p gravity,
  /// and nonlinear temperature limit element lengths
  /// (GradingRules::elements_per_span). Throws the exceptions of loads,
  /// supports and contacts. Collective if @p bodies are distributed.
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
