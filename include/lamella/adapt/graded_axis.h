// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_graded_axis_h
#define lamella_adapt_graded_axis_h

#include <lamella/adapt/loaded_parts.h>
#include <lamella/body/parameters.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_rows.h>

#include <vector>

namespace lamella
{
  /// Sizes of `Axis elements = auto`, over the smaller extent H of the section.
  struct GradingRules
  {
    /// Beside a support that holds a section as a whole, and beside the edge of
    /// a contact or the line of it.
    double clamp = 0.15, contact = 0.125;
    /// Beside supports and loads at points and lines, and beside the edge of a
    /// load.
    double edge = 0.25;
    /// At most, where bodies lie upon each other, unless that makes more
    /// elements of it than most_inside.
    double inside = 0.5, most_inside = 40.;
    /// What elements grow by for each of their lengths: neighbours differ by a
    /// factor of some 1.8.
    double growth = 0.6;
    /// At least as many elements on an axis.
    unsigned int least = 4;
    /// As many where a load acts all along, over a span between places that
    /// hold the axis or where the load changes its sign. Ends of B4 are exact
    /// there; inside of an element of length h a uniform load leaves out the
    /// bubble q h^4 / (384 E I), of the q L^4 / (384 E I) between clamps
    /// n^-4: 0.077 % for n = 6, 0.024 % for 8, 0.01 % for 10, 0.005 % for 12.
    /// Between other supports it is a smaller share.
    double over_span = 10.;
    /// Places closer to each other than this share of their size are one.
    double one_place = 0.5;
    /// The samples of 1 / s between two places, for the trapezoidal rule; what
    /// its integral exceeds an integer by, if less than `spare`, makes no
    /// element more.
    unsigned int samples = 400;
    double       spare   = 0.05;
    /// Gaps that differ by less than this share of H lie upon each other.
    double same_gap = 1e-3;
    /// Equal elements that a contact is looked for with: as many over H, and on
    /// an axis at least and at most: the parabola of grade_axes() tells places
    /// better than they do.
    double to_search = 2., least_to_search = 12., most_to_search = 240.;
  };

  /**
   * The ends of elements on an axis of @p length which are as short as
   * @p places say and grow from there: with
   *   s(y) = min_k (c size_k + growth |y - y_k|), at most length / least and,
   *   within the parts of @p loaded, their spans / over_span,
   *   c = growth / (exp(growth) - 1),
   * each piece between two places has N elements, N the integral of dy / s over
   * the piece, rounded up, to an even number where it is loaded: halved() then
   * has all of them. With @p fineness there are as many times more. Each has
   * 1 / N of that integral. Every place is the end of an element; places closer
   * to each other than one_place of their size are one. Between 0 and length,
   * both left out, ascending.
   */
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &places,
                const GradingRules              &rules    = {},
                const double                     fineness = 1.,
                const std::vector<LoadedPart>   &loaded   = {});

  /// Bisects elements of @p axis, whose lengths are known, until those at @p y,
  /// which becomes the end of one, are of @p size or, if that is 0, half as
  /// long as the one there, and others by GradingRules::growth longer.
  void
  shorten_at(AxisMesh           &axis,
             const double        y,
             const double        size,
             const GradingRules &rules = {});

  /**
   * Makes the axes of `Axis elements = auto` (AxisMesh::fineness) among
   * @p bodies: graded to what touches each of them, with as many times more
   * elements everywhere as its fineness says, which is 0 afterwards. Contacts
   * are looked for on equal elements first, then again on the graded ones;
   * where bodies do not lie upon each other the place is that of the smallest
   * gap, which a parabola through three rows gives. Supports of ends count as
   * clamps; two bodies whose nodes a contact pairs, along the same line, are
   * graded alike. Loads on sides, lines along the axis, the weight under
   * @p gravity, across the axis, and heat that is not linear along it limit
   * elements all along (GradingRules::over_span).
   *
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
