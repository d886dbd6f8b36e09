// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_memory_budget_h
#define lamella_solve_memory_budget_h

#include <lamella/solve/structure.h>

#include <string>

namespace lamella
{
  /// Estimate of the memory of matrices before assembly and of factors before
  /// factorization. Throws an InputError on all processes if it exceeds the
  /// limit. A matrix takes 24 bytes per nonzero (value, column, initial
  /// pattern, and the half in the format of the solver), shared evenly by the
  /// processes; a factor takes the size of its symbolic analysis. Sums over the
  /// processes of a machine are compared with its free memory. Collective.
  class MemoryBudget
  {
  public:
    /// Sets @p limit bytes per machine, or the available memory if it is 0.
    explicit MemoryBudget(const double limit = 0.);

    /// Returns a text on the matrices of @p structure: DoFs, nonzeros,
    /// gigabytes. Throws InputError if they do not fit.
    std::string
    check_matrix_memory(const Structure &structure) const;

    /// Returns a text on the factor of @p body, @p size bytes on this process.
    /// Throws InputError if it does not fit.
    std::string
    check_factor_memory(const Body &body, const FactorSize &size) const;

  private:
    /// Throws InputError if the processes of a machine lack @p bytes each, with
    /// @p what first and @p remedy last.
    void
    require(const double       bytes,
            const std::string &what,
            const std::string &remedy) const;

    /// Bytes per machine for the whole run; 0: no limit given.
    double limit;
  };
} // namespace lamella

#endif
