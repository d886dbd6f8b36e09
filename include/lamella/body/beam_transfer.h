// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_transfer_h
#define lamella_body_beam_transfer_h

#include <lamella/body/beam.h>

namespace lamella
{
  /// Interpolates the displacement @p u of the beam @p from in @p to, another
  /// axial discretization of the same beam with the same section functions. At
  /// each node of @p to, the amplitudes u_alpha(y) = sum_i N_i(y) u_(i,alpha)
  /// of @p from are evaluated; functions missing at the node are dropped, and
  /// modes are fitted by least squares. The result is exact if @p to contains
  /// the displacement. Throws NumericsError for linearly dependent modes.
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
