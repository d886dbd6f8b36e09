// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_loaded_parts_h
#define lamella_adapt_loaded_parts_h

#include <lamella/body/beam.h>
#include <lamella/conditions/load.h>

#include <vector>

namespace lamella
{
  /// A place along an axis that needs short elements.
  struct ShortElement
  {
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// Length of the elements beside it.
    double size = 0.;
    /// True if a support or a contact may constrain the axis there.
    bool holds = false;
  };

  /// Part of an axis that is loaded all along, and its span [length] between
  /// supports, contacts, or changes of the load's sign.
  struct LoadedPart
  {
    double begin = 0., end = 0., span = 0.;
  };

  /// Returns the parts of the axis of the beam @p body loaded across it: by @p
  /// loads on sides and lines, weight under @p gravity, and heat that is not
  /// linear. Spans end at axis ends and supported @p places. Collective.
  std::vector<LoadedPart>
  loaded_parts(const unsigned int               body,
               const Bodies                    &bodies,
               const std::vector<Load>         &loads,
               const dealii::Tensor<1, 3>      &gravity,
               const std::vector<ShortElement> &places);
} // namespace lamella

#endif
