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
    /// Displacements of all bodies, one block each, with prescribed values.
    BlockVector u;
    /// Largest displacement of each body in the linear solution without
    /// contact; empty with stabilizing springs. With finite rotations, a
    /// hundred times the largest on the way.
    std::vector<double> free_sizes;
    /// Contact force lambda of each gap row, positive in compression; the load
    /// of the bodies is B^T lambda.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
    /// Friction variables; empty without friction.
    FrictionState friction;
    /// History of each contact at finite rotations, with the forces' rows.
    std::vector<ContactHistory> pairings;

    /// Offsets of the stabilizing springs; empty: zero force at u = 0.
    SpringOffsets rest;

    /// Rounds of the active-set search, summed over all spring releases.
    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u, without contact and with
    /// it. The first of `free_corrections` (without the solution itself)
    /// measures the digits lost by the assembled matrix.
    std::vector<double> free_corrections, contact_corrections;

    /// Returns the length below which displacements of @p body are rounding,
    /// relative to those without contact; it matters where loads cancel.
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
