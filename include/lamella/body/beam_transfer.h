// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_transfer_h
#define lamella_body_beam_transfer_h

#include <lamella/body/beam.h>

namespace lamella
{
  /**
   * Returns the displacement @p u of the beam @p from on the nodes of @p to,
   * another discretization of the same beam along its axis: at each node of
   * @p to the section's amplitudes u_alpha(y) = sum_i N_i(y) u_(i,alpha) of
   * @p from, projected to its list of fields. A list with modes has the
   * least-squares fit of the amplitudes; any other drops fields that it lacks.
   * This is exact if @p to contains the displacement, and the nodal interpolant
   * otherwise.
   *
   * Both beams have the same fields of the section and the same length, and any
   * modes. Throws NumericsError if the modes of a list depend on each other.
   */
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
