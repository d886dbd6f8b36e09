// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_memory_budget_h
#define lamella_solve_memory_budget_h

#include <lamella/solve/structure.h>

#include <string>

namespace lamella
{
  /// Compares the memory of matrices before assembly, and of factors before
  /// factorization, with the available memory of the machine or a limit. Throws
  /// InputError on all processes if it is insufficient. A matrix takes 24 bytes
  /// per nonzero, distributed evenly over the processes. The size of a factor
  /// follows from its symbolic analysis. The memory of all processes of a
  /// machine is added. Collective.
  class MemoryBudget
  {
  public:
    /// Sets the limit in bytes per machine; 0 for the available memory.
    explicit MemoryBudget(const double limit = 0.);

    /// Returns a message with the DoFs, nonzeros and gigabytes of the matrices
    /// of @p structure. Throws InputError if memory is insufficient.
    std::string
    check_matrix_memory(const Structure &structure) const;

    /// Returns a message on the factor of the stiffness of @p body, whose size
    /// on this process is @p size. Throws InputError if memory is insufficient.
    std::string
    check_factor_memory(const Body &body, const FactorSize &size) const;

  private:
    /// Throws InputError if a machine has less than @p bytes for each of its
    /// processes. The message contains @p what and @p remedy.
    void
    require(const double       bytes,
            const std::string &what,
            const std::string &remedy) const;

    /// Limit in bytes per machine for the whole program; 0 if there is none.
    double limit;
  };
} // namespace lamella

#endif
