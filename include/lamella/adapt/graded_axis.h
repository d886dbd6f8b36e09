// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_graded_axis_h
#define lamella_adapt_graded_axis_h

#include <lamella/body/parameters.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/gap_rows.h>

#include <vector>

namespace lamella
{
  /// A place along an axis that wants short elements.
  struct ShortElement
  {
    /// From the start of the axis [length].
    double y = 0.;
    /// Of the elements beside it [length].
    double size = 0.;
  };

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
   *   s(y) = min_k (c size_k + growth |y - y_k|), at most length / least,
   *   c = growth / (exp(growth) - 1),
   * each piece between two places has N elements, N the integral of dy / s over
   * the piece, rounded up, and each of them has 1 / N of that integral. Every
   * place is the end of an element; places closer to each other than one_place
   * of their size are one. Between 0 and length, both left out, ascending.
   */
  std::vector<double>
  graded_breaks(const double                     length,
                const std::vector<ShortElement> &places,
                const GradingRules              &rules = {});

  /**
   * Makes the axes of `Axis elements = auto` (AxisMesh::fineness) among
   * @p bodies: graded to what touches each of them, all sizes divided by its
   * fineness, which is 0 afterwards. Contacts are looked for on equal elements
   * first, then again on the graded ones; where bodies do not lie upon each
   * other the place is that of the smallest gap, which a parabola through three
   * rows gives. Supports of ends count as clamps; two bodies whose nodes a
   * contact pairs, along the same line, are graded alike. What acts on a whole
   * body or along all of its sides grades nothing.
   *
   * Throws what conditions and contacts throw. Collective where Beam is.
   */
  void
  grade_axes(std::vector<BodyDescription>   &bodies,
             const SectionMeshes            &meshes,
             const std::vector<Support>     &supports,
             const std::vector<Load>        &loads,
             const std::vector<ContactPair> &contacts,
             const GradingRules             &rules = {});
} // namespace lamella

#endif
