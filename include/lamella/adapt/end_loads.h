// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_end_loads_h
#define lamella_adapt_end_loads_h

#include <lamella/body/beam.h>
#include <lamella/conditions/support.h>
#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// Returns the rigid motions of the segment @p piece that @p rows leave free.
  std::vector<Vector>
  free_motions(const Beam                              &piece,
               const std::vector<PrescribedFunctional> &rows);

  /// Returns the loads of boundary_layer_modes(): tractions of Saint-Venant
  /// states at the node @p far_node of the end segment @p piece, at the
  /// distance @p arm from the constrained end. The loads do no work on the free
  /// rigid @p motions and are orthonormal in energy.
  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions);
} // namespace lamella

#endif
