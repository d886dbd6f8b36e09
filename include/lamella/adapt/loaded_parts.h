// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_loaded_parts_h
#define lamella_adapt_loaded_parts_h

#include <lamella/body/beam.h>
#include <lamella/conditions/load.h>

#include <vector>

namespace lamella
{
  /// A point of a beam's axis at which short elements are required.
  struct ShortElement
  {
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// Required length of the axis elements at this point [length].
    double size = 0.;
    /// True if a support or contact may constrain displacements at this point.
    bool holds = false;
  };

  /// Segment of an axis with a distributed load, and the span that contains it.
  /// Spans end at supports, contacts, and changes of the load's sign.
  struct LoadedPart
  {
    double begin = 0.; ///< Start of the segment, coordinate y [length].
    double end   = 0.; ///< End of the segment, coordinate y [length].
    double span  = 0.; ///< Length of the span [length].
  };

  /// Returns the segments of the axis of the beam number @p body with
  /// distributed transverse loads: @p loads on sides and lines, weight under @p
  /// gravity, and nonlinear temperature. Spans also end at axis ends and at
  /// points of @p places with ShortElement::holds. Collective.
  std::vector<LoadedPart>
  loaded_parts(const unsigned int               body,
               const Bodies                    &bodies,
               const std::vector<Load>         &loads,
               const dealii::Tensor<1, 3>      &gravity,
               const std::vector<ShortElement> &places);
} // namespace lamella

#endif
