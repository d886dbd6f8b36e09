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
   *
   * The weights of a row are the mortar integrals
   *   w_j = 1/A_i int phi_i psi_j n dA,   v_k = 1/A_i int phi_i chi_k n dA
   * with psi_j and chi_k the trace functions of the carrying and the opposing
   * side, so B u is exact for whatever both expansions can do, and the two sum
   * to the same mean normal: action and reaction balance.
   *
   * - A segment faces the other side as a whole or not at all, as its centroid
   *   does within the reach. Of facets opposite that lie behind each other the
   *   nearest counts.
   * - Points behind the other side by more than the cells are deep are left out
   *   and returned in Gaps::too_deep.
   * - A node whose hat function meets the other side on less than 1e-12 of its
   *   own integral is unpaired.
   * - Hats are those of a continuous space: that of a hanging node is shared
   *   out in halves to the nodes that it hangs between, and has no row.
   * - Against an obstacle there are no kinks: Gauss points on the cells
   *   themselves, two degrees higher, and no opposing weights.
   *
   * Rows are in the order of the carrying side's grid nodes. The cost is that
   * of the Gauss points, each of which is carried along n to the other side by
   * a fixed point iteration: 2401 rows with some 10^5 points took 0.25 s.
   */
  Gaps
  weighted_gaps(const Sides &sides);
} // namespace lamella

#endif
