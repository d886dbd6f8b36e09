// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_loaded_parts_h
#define lamella_adapt_loaded_parts_h

#include <lamella/body/beam.h>
#include <lamella/conditions/load.h>

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
    /// Whether a support or a contact may hold the axis there.
    bool holds = false;
  };

  /// A part of an axis that a load acts on all along, and the distance between
  /// what holds the axis there, or its load changes its sign [length].
  struct LoadedPart
  {
    double begin = 0., end = 0., span = 0.;
  };

  /// Where loads act across the axis of body number @p body, a beam, all along:
  /// those of @p loads on its sides and on lines along it, its weight under
  /// @p gravity, and its heat, unless that is linear along the axis. Those of
  /// @p places that hold the axis end spans, and its ends do. Collective.
  std::vector<LoadedPart>
  loaded_parts(const unsigned int               body,
               const Bodies                    &bodies,
               const std::vector<Load>         &loads,
               const dealii::Tensor<1, 3>      &gravity,
               const std::vector<ShortElement> &places);
} // namespace lamella

#endif
