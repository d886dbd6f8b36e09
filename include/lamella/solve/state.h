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
  /// Primal and dual unknowns of a scene at one load factor: displacements and
  /// contact forces, with data on the iterations. Empty before the first load
  /// step.
  struct State
  {
    /// Displacements of all bodies, one block each: expanded, with the values
    /// of prescribed DoFs.
    BlockVector u;
    /// Largest displacement of each body in the linear solution without contact
    /// at the same load factor; empty with stabilizing springs, as these bodies
    /// move far without contact. With finite rotations, a hundred times the
    /// largest on the way.
    std::vector<double> free_sizes;
    /// Contact force lambda of each gap row, positive in compression; zero in
    /// inactive rows. Loads the bodies with B^T lambda.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
    /// Friction variables; empty without friction.
    FrictionState friction;
    /// History of each contact for finite rotations, whose rows the forces
    /// belong to.
    std::vector<ContactHistory> pairings;

    /// Offsets of the stabilizing springs; empty: zero force at u = 0.
    SpringOffsets rest;

    /// Rounds of the active-set search, summed over all releases of the
    /// springs.
    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u: of the linear solution
    /// without contact, and of the contact solution on its last active set. The
    /// first of `free_corrections` (the solution itself is left out) measures
    /// the digits lost by the assembled matrix.
    std::vector<double> free_corrections, contact_corrections;

    /// Returns the length below which displacements of @p body are rounding,
    /// relative to its displacement without contact. It matters where loads
    /// cancel, such as in leaves pressed together by equal pressures.
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
