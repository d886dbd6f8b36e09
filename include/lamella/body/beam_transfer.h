// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_transfer_h
#define lamella_body_beam_transfer_h

#include <lamella/body/beam.h>

namespace lamella
{
  /**
   * The displacement @p u of the beam @p from on the nodes of @p to, another
   * discretisation of the same beam along its axis: at each node of @p to the
   * section's amplitudes u_alpha(y) = sum_i N_i(y) u_(i,alpha) of @p from, as
   * its list of fields can have them. Where the list has modes they are the
   * least squares of the amplitudes, else those fields that the list lacks are
   * left out. So it is exact where the displacements of @p from are among
   * those of @p to, and the nodal interpolant otherwise.
   *
   * Both have the same fields of the section and the same length; whatever
   * modes. Throws NumericsError if the modes of a list depend on each other.
   */
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
