// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_phase_h
#define lamella_solve_phase_h

#include <lamella/base/names.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Phases of a run whose time is measured, in the order of execution.
  enum class Phase
  {
    setup,         ///< meshes, sections, bodies, supports, loads, probes
    assembly,      ///< stiffness matrices
    factorization, ///< factorization, or setup of iterative solvers
    solve,         ///< linear solution, refinement, checks
    contact,       ///< search, pairing and active set
    beyond,        ///< effects of large deflections (NonlinearityEstimate)
    modes,         ///< natural and buckling modes
    output         ///< fields at probes, lines and cuts; files
  };

  /// Names of the phases in output files.
  template <>
  struct Names<Phase>
  {
    /// Value and name of each phase, in the order of execution.
    static constexpr NameOf<Phase> all[] = {{Phase::setup, "setup"},
                                            {Phase::assembly, "assembly"},
                                            {Phase::factorization,
                                             "factorization"},
                                            {Phase::solve, "solve"},
                                            {Phase::contact, "contact"},
                                            {Phase::beyond, "beyond"},
                                            {Phase::modes, "modes"},
                                            {Phase::output, "output"}};
  };

  /// Returns the names of all phases in order, with static lifetime.
  const std::vector<std::string> &
  phase_names();
} // namespace lamella

#endif
