// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_weighted_gaps_h
#define lamella_contact_weighted_gaps_h

#include <lamella/contact/pairing.h>

namespace lamella
{
  /**
   * Surface to surface: gaps averaged with hat functions, as in mortar methods.
   *
   * The nodes of the carrying side's facets (Gauss-Lobatto grids of the
   * expansion's degree) make a grid of quadrilateral cells, and phi_i is the
   * bilinear hat function of node i on it: positive, and all sum to 1. Row i is
   *   g_i = 1/A_i int phi_i n . (u_2(X_2) - u_1(X_1)) dA,
   *   A_i = int phi_i dA,
   * over that part of the surface which faces the other side; X_2 is the place
   * opposite to X_1 and n the averaged normal there (opposing_place()). A force
   * lambda_i in the row is then the continuous pressure
   *   p = sum_i (lambda_i / A_i) phi_i,
   * positive everywhere if the forces are.
   *
   * Integrands have kinks where the other side passes from facet to facet, so
   * each cell is cut into segments with the facets opposite, in its chord
   * plane, and these into triangles with Gauss points: exact to rounding where
   * both sides are flat.
   */
  Gaps
  weighted_gaps(const Sides &sides);
} // namespace lamella

#endif
