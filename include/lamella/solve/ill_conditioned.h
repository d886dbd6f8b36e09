// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_ill_conditioned_h
#define lamella_solve_ill_conditioned_h

#include <lamella/base/exceptions.h>

namespace lamella
{
  /// Exception: the problem cannot be solved in double precision, for example
  /// due to an indefinite stiffness or unbalanced forces. The solution is then
  /// repeated with additional section functions of the beams.
  class IllConditioned : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };
} // namespace lamella

#endif
