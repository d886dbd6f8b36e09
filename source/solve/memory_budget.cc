// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/solve/memory_budget.h>

#include <algorithm>

namespace lamella
{
  namespace
  {
    // A value, its column in the matrix and in the pattern that it comes from,
    // and the half of it that a solver asks for in its own format.
    constexpr double bytes_per_entry = 8. + 4. + 4. + 8.;



    std::string
    remedies(const bool nodal)
    {
      return "Use a coarser mesh, a lower order" +
             std::string(nodal ? ", Linear solver = cg" : "") +
             " or more machines.";
    }
  } // namespace



  MemoryBudget::MemoryBudget(const double limit)
    : limit(limit)
  {}



  void
  MemoryBudget::require(const double       bytes,
                        const std::string &what,
                        const std::string &remedy) const
  {
    const double available = available_memory(limit),
                 needed = dealii::Utilities::MPI::max(sum_over_machine(bytes),
                                                      communicator());
    if (needed > available)
      throw InputError(limit > 0. ? "Memory limit" : "",
                       limit > 0. ? gigabytes(limit) : "",
                       "solve.out-of-memory: " + what + ", but only " +
                         gigabytes(available) +
                         " are available on each machine" +
                         (limit > 0. ? " (the program already uses " +
                                         gigabytes(resident_memory()) +
                                         " of the Memory limit)" :
                                       ""),
                       remedy);
  }



  std::string
  MemoryBudget::check_matrix_memory(const Structure &structure) const
  {
    double entries = 0.;
    for (const auto &body : structure.bodies())
      entries += body->stiffness_entries();
    const double      bytes = bytes_per_entry * entries;
    const std::string what  = std::to_string(structure.n_dofs()) + " DoFs, " +
                             to_text(entries, 3) + " non-zeros (" +
                             gigabytes(bytes) + ")";
    require(bytes / n_processes(), "The scene has " + what, remedies(false));
    return what + "; " + gigabytes(available_memory(limit)) + " available";
  }



  std::string
  MemoryBudget::check_factor_memory(const Body       &body,
                                    const FactorSize &size) const
  {
    const std::string what =
      "factor of " + to_text(size.non_zeros, 3) + " non-zeros (" +
      gigabytes(dealii::Utilities::MPI::sum(size.bytes, communicator())) + ")";
    require(size.bytes,
            "Body '" + body.name() + "' has a " + what,
            remedies(body.is_nodal()));
    // Matrices exist by now; what follows (rows, output) is small.
    const double peak = dealii::Utilities::MPI::sum(
      std::max(peak_memory(), resident_memory() + size.bytes), communicator());
    return "body " + body.name() + ", " + what + "; about " + gigabytes(peak) +
           " in all, " + gigabytes(available_memory(limit)) + " available";
  }
} // namespace lamella
