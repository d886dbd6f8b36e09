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
  /// The primal and dual unknowns of a scene at one load factor: displacements
  /// and contact forces, and how they were come by. Empty: no state at all, as
  /// before the first load step.
  struct State
  {
    /// Displacements of all bodies, a block each: expanded, so prescribed DoFs
    /// have their values.
    BlockVector u;
    /// Of each body: the largest displacement of the linear solution without
    /// contact, at the same load factor; empty where stabilising springs hold a
    /// body, which moves far without contact. Of bodies that turn a hundred
    /// times the largest on the way to it.
    std::vector<double> free_sizes;
    /// Of each gap row: the contact force lambda, positive in compression; zero
    /// in rows that are not active. It loads the bodies with B^T lambda.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
    /// Empty unless a contact has friction.
    FrictionState friction;
    /// Of bodies that turn: what each contact has come to, whose rows the
    /// forces are of.
    std::vector<ContactMemory> pairings;

    /// Where the stabilising springs are without force; empty: at u = 0.
    SpringRest rest;

    /// Rounds of the search for the active rows, those of all releases of the
    /// springs added up.
    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u: of the free linear
    /// solution, and of the solution with contact on its last active set. The
    /// first of `free_corrections` (the solution itself is left out) measures
    /// the digits that the assembled matrix lost.
    std::vector<double> free_corrections, contact_corrections;

    /// Lengths of @p body below this are what rounding leaves where loads
    /// cancel, as of leaves that equal pressures press on each other and that
    /// do not move: of what they would move by without contact.
    double
    rounding(const unsigned int body) const
    {
      return free_sizes.empty() ? 0. : arithmetic::rounding * free_sizes[body];
    }

    /// The largest of all bodies.
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
