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

  /// Returns the section load vectors that load the end segment @p piece in
  /// boundary_layer_modes(): tractions of Saint-Venant states at the axis node
  /// @p far_node, at the signed distance @p arm along y from the constrained
  /// end. They do no work on the free rigid motions @p motions. Their section
  /// forces at the constrained end are orthonormal in the section compliance.
  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions);
} // namespace lamella

#endif
