// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_transfer_h
#define lamella_body_beam_transfer_h

#include <lamella/body/beam.h>

namespace lamella
{
  /// Returns the displacement @p u of the beam @p from, interpolated to the
  /// nodes of @p to, another axial mesh of the same beam. At a node y,
  /// amplitudes of section functions alpha are u_alpha(y) = sum_i N_i(y)
  /// u_(i,alpha), with the axis shape functions N_i of @p from. Functions that
  /// @p to lacks at the node are dropped. Modes (combinations of functions) are
  /// fitted by least squares. Throws NumericsError for linearly dependent
  /// modes.
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
