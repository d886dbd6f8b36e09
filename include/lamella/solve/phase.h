// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_phase_h
#define lamella_solve_phase_h

#include <lamella/base/names.h>

#include <string>
#include <vector>

namespace lamella
{
  /// What a run spends its time on, in the order of its work.
  enum class Phase
  {
    setup,         ///< meshes, sections, bodies, supports, loads, probes
    assembly,      ///< stiffness matrices
    factorisation, ///< what makes them ready to be solved with
    solve,         ///< linear solution, refinement, checks
    contact,       ///< search and pairing, and the search for active rows
    beyond,        ///< what large deflections would change (BeyondLinear)
    output         ///< fields at probes, lines and cuts; files
  };

  template <>
  struct Names<Phase>
  {
    static constexpr NameOf<Phase> all[] = {{Phase::setup, "setup"},
                                            {Phase::assembly, "assembly"},
                                            {Phase::factorisation,
                                             "factorisation"},
                                            {Phase::solve, "solve"},
                                            {Phase::contact, "contact"},
                                            {Phase::beyond, "beyond"},
                                            {Phase::output, "output"}};
  };

  /// The names of all phases, in their order; a static that lives as long as
  /// the program.
  const std::vector<std::string> &
  phase_names();
} // namespace lamella

#endif
