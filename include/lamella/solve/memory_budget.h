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
   * is refused with an InputError, on all processes alike, rather than left to
   * the system, which would end the run without a word.
   *
   * A matrix is counted with 24 bytes a non-zero (value, column, the pattern
   * that it comes from, the half that a solver asks for in its own format),
   * shared evenly by the processes; a factor with what its symbolic analysis
   * says. Needs are summed over the processes of a machine and held against
   * what that machine has left. All functions are collective.
   */
  class MemoryBudget
  {
  public:
    /// @p limit bytes on each machine, or what it has if that is 0.
    explicit MemoryBudget(const double limit = 0.);

    /// Returns what the matrices of @p structure will take, in words: DoFs,
    /// non-zeros, gigabytes, and what is available. Throws InputError if that
    /// is less.
    std::string
    require_matrices(const Structure &structure) const;

    /// Returns what the factor of @p body will take, in words, with what the
    /// run will come to. Throws InputError if it does not fit. @p size is this
    /// process's own share of bytes.
    std::string
    require_factor(const Body &body, const FactorSize &size) const;

  private:
    /// Throws InputError if the processes of some machine lack @p bytes, of
    /// each process; @p what begins the message, @p remedy ends it.
    void
    require(const double       bytes,
            const std::string &what,
            const std::string &remedy) const;

    /// Bytes on each machine for the whole run, 0 for none.
    double limit;
  };
} // namespace lamella

#endif
