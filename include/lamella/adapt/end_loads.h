// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_end_loads_h
#define lamella_adapt_end_loads_h

#include <lamella/body/beam.h>
#include <lamella/conditions/support.h>
#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// Returns the rigid motions of @p piece that @p rows leave free.
  std::vector<Vector>
  free_motions(const Beam                              &piece,
               const std::vector<PrescribedFunctional> &rows);

  /// Returns the section loads of boundary_layer_modes() at the far end of @p
  /// piece, node @p far_node at the distance @p arm from the held one, without
  /// work on the free @p motions, with solutions orthonormal in energy.
  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions);
} // namespace lamella

#endif
