// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_transfer_h
#define lamella_body_beam_transfer_h

#include <lamella/body/beam.h>

namespace lamella
{
  /**
   * Returns the displacement @p u of the beam @p from on the nodes of @p to,
   * another discretization of the same beam along its axis: at each node the
   * section's amplitudes u_alpha(y) = sum_i N_i(y) u_(i,alpha) of @p from,
   * projected to the node's list. A list with modes has the least-squares fit;
   * any other drops fields that it lacks. The result is exact if @p to contains
   * the displacement, else its nodal interpolant. Both beams have the same
   * section fields and length. Throws NumericsError for dependent modes.
   */
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
