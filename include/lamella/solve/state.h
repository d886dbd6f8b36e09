// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_state_h
#define lamella_solve_state_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/structure.h>

#include <algorithm>
#include <vector>

namespace lamella
{
  /// Displacements and contact forces of a scene at one load factor, with data
  /// on the iterations. All vectors are empty before the first load step.
  struct State
  {
    /// Displacements of all bodies, one block each, including prescribed DoFs.
    BlockVector u;
    /// Displacement to which rounding() refers, for each body: the largest one
    /// without contact; for finite rotations, a hundred times the largest one
    /// in all load steps so far. Empty with stabilizing springs.
    std::vector<double> free_sizes;
    /// Contact force of each gap constraint, positive in compression.
    std::vector<double> force;
    /// Indices of the active constraints, ascending.
    std::vector<unsigned int> active;
    /// Friction variables; empty without friction.
    FrictionState friction;
    /// Pairing data of each contact with finite rotations, for a restart.
    std::vector<ContactHistory> pairings;

    /// Lengths at which the springs have no force; all zero if empty.
    SpringOffsets rest;

    /// Number of Newton iterations; of linear bodies, of contact rounds.
    unsigned int iterations = 0;
    /// Methods that solved the contact laws in the load step.
    MethodCounts solved_by{};
    /// Relative maximum norms of the corrections by iterative refinement
    /// without contact. The first one is the rounding error of the assembled
    /// matrix.
    std::vector<double> free_corrections;
    /// Relative corrections by iterative refinement with contact.
    std::vector<double> contact_corrections;

    /// Returns the length below which displacements of @p body are rounding
    /// errors, relative to the solution without contact [length].
    double
    rounding(const unsigned int body) const
    {
      return free_sizes.empty() ? 0. : arithmetic::rounding * free_sizes[body];
    }

    /// Returns the largest rounding error of displacements in all bodies.
    double
    rounding() const
    {
      double largest = 0.;
      for (unsigned int b = 0; b < free_sizes.size(); ++b)
        largest = std::max(largest, rounding(b));
      return largest;
    }
  };
} // namespace lamella

#endif
