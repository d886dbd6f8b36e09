// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_memory_budget_h
#define lamella_solve_memory_budget_h

#include <lamella/solve/structure.h>

#include <string>

namespace lamella
{
  /**
   * Memory that is known before it is spent: that of the matrices before they
   * are assembled, that of a factor before it is computed. What would not fit
   * is refused with an InputError, on all processes alike.
   */
  class MemoryBudget
  {
  public:
    /// @p limit bytes on each machine, or what it has if that is 0.
    explicit MemoryBudget(const double limit = 0.);

    /// Returns what the matrices of @p structure will take, in words.
    std::string
    require_matrices(const Structure &structure) const;

    /// Returns what the factor of @p body will take, in words.
    std::string
    require_factor(const Body &body, const FactorSize &size) const;

  private:
    /// Throws if the processes of some machine lack @p bytes, of each process;
    /// @p what says of what.
    void
    require(const double       bytes,
            const std::string &what,
            const std::string &remedy) const;

    double limit;
  };
} // namespace lamella

#endif
