// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_weighted_gaps_h
#define lamella_contact_weighted_gaps_h

#include <lamella/contact/pairing.h>

namespace lamella
{
  /// Returns the weighted gaps of surface-to-surface contact (mortar method
  /// with hat functions), in the order of the slave nodes. The slave nodes
  /// (Gauss-Lobatto grids of the expansion degree) form a grid of quadrilateral
  /// cells; phi_i is the bilinear hat function of node i, with sum 1. Weighted
  /// gap i is
  ///   g_i = 1/A_i int phi_i n . (u_2(X_2) - u_1(X_1)) dA,
  ///   A_i = int phi_i dA,
  /// with the displacements u_1 and u_2 of both bodies at the opposite points
  /// X_1 and X_2, and the averaged normal n (find_master_point()). The first
  /// integral is over the area that faces the master side. The contact forces
  /// lambda_i represent the continuous pressure
  ///   p = sum_i (lambda_i / A_i) phi_i,
  /// positive everywhere if all forces are.
  ///
  /// The integrands have kinks at the edges of master facets. Each cell is
  /// therefore cut along these edges into segments (cut()). The weights of the
  /// nodal displacements in g_i are mortar integrals
  ///   w_j = 1/A_i int phi_i psi_j n dA,   v_k = 1/A_i int phi_i chi_k n dA
  /// with the trace functions psi_j of the slave and chi_k of the master side.
  /// As sum_j w_j = sum_k v_k, the contact forces on both sides are opposite.
  ///
  /// - A segment faces the master side if its centroid does. If several facets
  ///   are opposite, the nearest counts.
  /// - Points behind the master side by more than the element depth are omitted
  ///   and returned in Gaps::deep_penetrations.
  /// - A node is unpaired if less than 1e-12 of the integral of its hat
  ///   function is over the area that faces the master side.
  /// - Half of a hanging node's hat function is added to each of its end nodes.
  /// - Against an obstacle, cells are not cut, and there are no master weights.
  Gaps
  weighted_gaps(const ContactSurfacePair &sides);
} // namespace lamella

#endif
