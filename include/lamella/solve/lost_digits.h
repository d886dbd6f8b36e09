// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_lost_digits_h
#define lamella_solve_lost_digits_h

#include <lamella/base/exceptions.h>

namespace lamella
{
  /// What cannot be solved for in double precision: a stiffness that is not
  /// positive definite, corrections that do not settle, forces that do not
  /// balance. Other fields of the same body may do better.
  class LostDigits : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };
} // namespace lamella

#endif
