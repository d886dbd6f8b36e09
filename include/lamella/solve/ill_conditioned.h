// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_ill_conditioned_h
#define lamella_solve_ill_conditioned_h

#include <lamella/base/exceptions.h>

namespace lamella
{
  /// Exception: a problem that cannot be solved in double precision, such as an
  /// indefinite stiffness or unbalanced forces. Other cross-section functions
  /// may succeed.
  class IllConditioned : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };
} // namespace lamella

#endif
