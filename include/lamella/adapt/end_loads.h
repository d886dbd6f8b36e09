// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_end_loads_h
#define lamella_adapt_end_loads_h

#include <lamella/body/beam.h>
#include <lamella/conditions/support.h>
#include <lamella/section/saint_venant.h>

#include <vector>

namespace lamella
{
  /// The rigid motions of @p piece that @p rows leave free.
  std::vector<Vector>
  free_motions(const Beam &piece, const std::vector<PrescribedRow> &rows);

  /// Section loads at the far end of @p piece, the node @p far_node, @p arm
  /// from the held one: the tractions of the six states, combined so that they
  /// do no work on the free @p motions and make solutions of unit energy that
  /// are orthogonal in it, as end_fields() says. As many as there are.
  std::vector<Vector>
  end_loads(const SaintVenant         &states,
            const Beam                &piece,
            const unsigned int         far_node,
            const double               arm,
            const std::vector<Vector> &motions);
} // namespace lamella

#endif
