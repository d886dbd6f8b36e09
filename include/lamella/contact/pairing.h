// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_h
#define lamella_contact_pairing_h

#include <lamella/contact/constraint_geometry.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/slave_surface.h>

#include <limits>
#include <utility>
#include <vector>

namespace lamella
{
  /// A node-to-node pair of surface points (Sec. 3.3 of the paper) by indices.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// n = (n_1 - n_2) / |n_1 - n_2|, and g_init = (X_2 - X_1) . n [length]:
    /// Eq. 17 with the averaged normal.
    dealii::Tensor<1, 3> normal;
    double               initial_gap = 0.;
  };

  /// Result of pair_node_to_node().
  struct Pairing
  {
    /// Pairs by ascending first.
    std::vector<PointPair> pairs;
    /// Number of points of either surface that face no point of the other.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// Smallest distance of the two sets, and smallest tangential offset of
    /// points with opposed normals [length]; else the largest double.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /**
   * Returns node-to-node pairs: points aligned along the average of both
   * normals and at most @p search_radius apart. Each point is in at most one
   * pair, nearest first; swapping the two sets only swaps the pairs and
   * reverses the normals. Points a and b pair, with d = X_b - X_a and n as in
   * PointPair, if
   *   |d - (d . n) n| <= tolerance sqrt(min(A_a, A_b)),  |d| <= search_radius,
   * and their normals oppose each other: to 60 degrees in contact, less
   * strictly (|n_a - n_b| > 0.2) if they are apart along n. The three nearest
   * points from an R-tree are tried first, then all.
   */
  Pairing
  pair_node_to_node(
    const std::vector<SurfacePoint> &first,
    const std::vector<SurfacePoint> &second,
    const double                     tolerance,
    const double search_radius = std::numeric_limits<double>::infinity());

  /// Geometry of a gap row with the slave side 1,
  ///   g(u) = sum_k v_k . u_2(X_k) - sum_j w_j . u_1(X_j) + gap.
  /// For a pair of points v = w = n; for a weighted gap both sum to the mean
  /// normal. make_interface() converts it to a GapConstraint.
  struct WeightedGap
  {
    /// Point of the row, and the place opposite.
    dealii::Point<3> position, opposite;
    /// Location of the point in the slave body.
    Location node;
    /// Normal n, outward from the slave side; for a weighted gap its mean,
    /// which times lambda is the row force.
    dealii::Tensor<1, 3> normal;
    /// Tributary area [length^2], and g_init or its average [length].
    double area = 0., gap = 0.;
    /// Point spacing as in ContactInterface::Point.
    double spacing = 0.;
    /// Angle between n_1 and -n_2 at the point [rad].
    double angle = 0.;
    /// Stiffnesses for the automatic penalty; for an obstacle the slave's.
    LocalStiffness slave, master;
    /// Weights w_j and v_k along n, by numbers of locations in Gaps.
    ConstraintGeometry::Weights slave_weights, master_weights;
  };

  /// A point farther behind the other surface than the depth of the cells
  /// there, without a row: the surfaces face away or the bodies overlap.
  struct DeepPenetration
  {
    dealii::Point<3> position, opposite;
    /// Distance behind the surface, positive [length].
    double behind = 0.;
  };

  /// A material point of the slave side at which a gap is measured, with its
  /// projection. A row is the average over such points,
  ///   g_i = sum_q a_q phi_i(X_q) g_q / sum_q a_q phi_i(X_q),
  /// with constant points and weights and moving projections.
  struct GapPoint
  {
    /// Slave point; facet numbers of MeshSurface.
    MeshSurface::FacetPoint slave;
    /// Opposite point; its facet is invalid_unsigned_int for an obstacle.
    MeshSurface::FacetPoint master;
    /// Area a_q of the point [length^2]; 1 for one-point rows.
    double area = 1.;
    /// Number of the facet in the SlaveSurface, unused for one-point rows.
    unsigned int part = 0;
  };

  /// Result of each discretization, before signs, penalties and DoFs.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;
    /// Locations in the cells of either body to which the weights refer.
    std::vector<Location> slave, master;
    /// Number of slave points that face nothing, except those too deep.
    unsigned int                 unpaired = 0;
    std::vector<DeepPenetration> deep_penetrations;
    /// Surface of the hat functions; null for nodal functions.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of the gaps for hat functions.
    std::vector<GapPoint> points = {};
  };

  /// Slave and master side of a discretization; the master is a mesh, or an
  /// obstacle if master_mesh is null. Refers to the surfaces.
  struct ContactSurfacePair
  {
    const MeshSurface   *slave       = nullptr;
    const MasterSurface *master      = nullptr;
    const MeshSurface   *master_mesh = nullptr;
    /// Search radius along the averaged normal [length].
    double search_radius = 0.;
    /// Edge contact: points are projected along the normals of master_mesh
    /// (closest_point_projection()).
    bool edge_contact = false;
    /// Permitted depth in an obstacle [length].
    double max_obstacle_depth = 0.;
  };

  /// Returns true for an overlap beyond a cell, -gap > min(depth_1, depth_2).
  bool
  exceeds_cell_depth(const double gap,
                     const double depth_1,
                     const double depth_2);

  /// Returns true if the gap at @p hit is too deep for slave @p depth and
  /// master; for an obstacle if -gap > max(depth, max_obstacle_depth).
  bool
  exceeds_cell_depth(const ContactSurfacePair &sides,
                     const SurfaceHit         &hit,
                     const double              depth);

  /// Returns node-to-surface gaps: the slave @p points against the places that
  /// they face. A single-pass method: master nodes may penetrate the slave
  /// side, and a uniform pressure is not transmitted exactly
  /// (doc/theory/contact.md). v = w = n at one place per side.
  Gaps
  pair_node_to_surface(const ContactSurfacePair        &sides,
                       const std::vector<SurfacePoint> &points);

  /// Returns the number of grid nodes of @p a that face no place of @p b within
  /// @p search_radius [length].
  unsigned int
  count_unpaired_nodes(const MeshSurface   &a,
                       const MasterSurface &b,
                       const double         search_radius);

  /// Returns the number of grid cells (degree_s x degree_t per facet) of @p a
  /// that face @p b, parts of facets by area, for SlaveSide::automatic. Facets
  /// are cut as plane quadrilaterals with those opposite (cut()).
  double
  count_facing_cells(const MeshSurface &a,
                     const MeshSurface &b,
                     const double       search_radius);
} // namespace lamella

#endif
