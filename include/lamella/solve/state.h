// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_state_h
#define lamella_solve_state_h

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact.h>
#include <lamella/solve/friction_state.h>
#include <lamella/solve/structure.h>

#include <algorithm>
#include <vector>

namespace lamella
{
  /// Displacements and contact forces of a scene at one load factor, with data
  /// on the iterations. Empty before the first load step.
  struct State
  {
    /// Displacements of all bodies, one block each, including prescribed DoFs.
    BlockVector u;
    /// Largest displacement of each body in the linear solution without
    /// contact; empty with stabilizing springs. With finite rotations, a
    /// hundred times the largest displacement up to now.
    std::vector<double> free_sizes;
    /// Contact force lambda of each gap constraint, positive in compression;
    /// the bodies are loaded by B^T lambda.
    std::vector<double> force;
    /// Numbers of the active constraints, ascending.
    std::vector<unsigned int> active;
    /// Friction variables; empty without friction.
    FrictionState friction;
    /// History of each contact at finite rotations, for the rows of `force`.
    std::vector<ContactHistory> pairings;

    /// Offsets of the stabilizing springs; if empty, zero (no force at u = 0).
    SpringOffsets rest;

    /// Rounds of the active-set search, including release_springs().
    unsigned int iterations = 0;
    /// Relative maximum norm of each correction, without contact and with
    /// contact. The first of `free_corrections` (the solution itself is not
    /// included) measures the digits lost by the assembled matrix.
    std::vector<double> free_corrections, contact_corrections;

    /// Returns the length below which displacements of @p body are rounding,
    /// relative to the displacements without contact; relevant if loads cancel.
    double
    rounding(const unsigned int body) const
    {
      return free_sizes.empty() ? 0. : arithmetic::rounding * free_sizes[body];
    }

    /// Returns the largest rounding() of all bodies.
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
