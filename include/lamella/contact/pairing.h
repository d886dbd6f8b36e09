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
  /// A node-to-node pair of surface points (Sec. 3.3 of the paper): indices
  /// into the lists of points, with its kinematics.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// n = (n_1 - n_2) / |n_1 - n_2|, and g_init = (X_2 - X_1) . n [length]:
    /// Eq. 17 with the averaged normal in place of n_1. Negative for overlap.
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
    /// Smallest distance between the two sets of points, and smallest
    /// tangential offset of points with normals opposed to 60 degrees [length],
    /// for a message if nothing pairs. The largest double if undefined.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /**
   * Returns node-to-node pairs: points aligned along the average of both
   * normals and at most @p search_radius apart. Each point is in at most one
   * pair, nearest first; swapping the two sets only swaps the pairs and
   * reverses the normals.
   *
   * Points a and b pair, with d = X_b - X_a and n as in PointPair, if
   *   |d - (d . n) n| <= tolerance sqrt(min(A_a, A_b)),  |d| <= reach,
   * and their normals oppose each other: to 60 degrees if the points touch,
   * less strictly (|n_a - n_b| > 0.2) if they are apart along n.
   *
   * The three nearest points from an R-tree are tried first; a point that faces
   * none of these is tried against all, which costs the product of both numbers
   * without contact. Throws nothing; an empty result is possible.
   */
  Pairing
  pair_node_to_node(
    const std::vector<SurfacePoint> &first,
    const std::vector<SurfacePoint> &second,
    const double                     tolerance,
    const double search_radius = std::numeric_limits<double>::infinity());

  /// Geometry of a gap row,
  ///   g(u) = sum_k v_k . u_2(X_k) - sum_j w_j . u_1(X_j) + gap,
  /// with the slave side 1. For a pair of points v = w = n; for a weighted gap
  /// both sum to the mean normal. Common to all discretizations;
  /// make_interface() converts it to a GapConstraint with the signs of First
  /// and Second.
  struct WeightedGap
  {
    /// Point of the row, and the place opposite.
    dealii::Point<3> position, opposite;
    /// Location of the point in the slave body.
    Location node;
    /// Normal n, outward from the slave side; for a weighted gap its mean,
    /// shorter than 1 on curved surfaces: the row force is lambda times it.
    dealii::Tensor<1, 3> normal;
    /// Tributary area [length^2], and g_init or its average over the area
    /// [length].
    double area = 0., gap = 0.;
    /// Point spacing as in ContactInterface::Point.
    double spacing = 0.;
    /// Angle between n_1 and -n_2 at the point [rad].
    double angle = 0.;
    /// Stiffnesses for the automatic penalty; for an obstacle that of the slave
    /// side.
    LocalStiffness slave, master;
    /// Weights w_j and v_k by numbers of locations in Gaps, both along n. The
    /// master ones are empty for an obstacle.
    ConstraintGeometry::Weights slave_weights, master_weights;
  };

  /// A point farther behind the other surface than the depth of the cells
  /// there. It has no row: either the surfaces face away from each other or the
  /// bodies overlap, see make_interface().
  struct DeepPenetration
  {
    dealii::Point<3> position, opposite;
    /// Distance behind the surface, positive [length].
    double behind = 0.;
  };

  /// A material point of the slave side at which a gap is measured, with its
  /// projection. A row is the average over such points,
  ///   g_i = sum_q a_q phi_i(X_q) g_q / sum_q a_q phi_i(X_q).
  /// In motion the points and weights are constant, and the projections move.
  struct GapPoint
  {
    /// Slave point; facet numbers of MeshSurface.
    MeshSurface::FacetPoint slave;
    /// Opposite point; its facet is invalid_unsigned_int for an obstacle.
    MeshSurface::FacetPoint master;
    /// Area a_q of the point [length^2]; 1 for one-point rows.
    double area = 1.;
    /// Number of the facet in the SlaveSurface with the functions phi_i;
    /// unused for one-point rows.
    unsigned int part = 0;
  };

  /// Result of each discretization, before signs, penalties and DoFs.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;
    /// Locations, in the cells of either body, to which the weights refer; no
    /// master ones for an obstacle.
    std::vector<Location> slave, master;
    /// Number of slave points that face nothing, excluding those that are too
    /// deep.
    unsigned int                 unpaired = 0;
    std::vector<DeepPenetration> deep_penetrations;
    /// Surface of the hat functions; null for nodal functions.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of the gaps for hat functions.
    std::vector<GapPoint> points = {};
  };

  /// Slave and master side of a discretization. The master is a mesh, or an
  /// obstacle if master_mesh is null. Refers to the surfaces, which must
  /// outlive it.
  struct ContactSurfacePair
  {
    const MeshSurface   *slave       = nullptr;
    const MasterSurface *master      = nullptr;
    const MeshSurface   *master_mesh = nullptr;
    /// Search radius along the averaged normal [length].
    double search_radius = 0.;
    /// Edge contact: points are projected onto the nearest places of
    /// master_mesh, along the normals there (closest_point_projection()).
    bool edge_contact = false;
    /// Permitted depth in an obstacle for any cell depth [length], so that
    /// penetrating points can be pushed out.
    double max_obstacle_depth = 0.;
  };

  /// Returns true if @p gap is an overlap beyond the depth of the cells, -gap >
  /// min(depth_1, depth_2) [length].
  bool
  exceeds_cell_depth(const double gap,
                     const double depth_1,
                     const double depth_2);

  /// Returns true if the gap at @p hit is too deep for the slave @p depth and
  /// that of the master; in an obstacle if -gap > max(depth,
  /// ContactSurfacePair::max_obstacle_depth).
  bool
  exceeds_cell_depth(const ContactSurfacePair &sides,
                     const SurfaceHit         &hit,
                     const double              depth);

  /// Returns node-to-surface gaps: the slave points @p points against the
  /// places that they face, each with its tributary area. A single-pass method:
  /// master nodes may penetrate the slave side, and a uniform pressure is not
  /// transmitted exactly (doc/theory/contact.md). v = w = n at one place per
  /// side; rows are in the order of @p points.
  Gaps
  pair_node_to_surface(const ContactSurfacePair        &sides,
                       const std::vector<SurfacePoint> &points);

  /// Returns the number of grid nodes of @p a that face no place of @p b within
  /// @p search_radius [length], searching for each.
  unsigned int
  count_unpaired_nodes(const MeshSurface   &a,
                       const MasterSurface &b,
                       const double         search_radius);

  /// Returns the number of grid cells (degree_s x degree_t per facet) of @p a
  /// that face @p b, parts of facets by area, for SlaveSide::automatic. Facets
  /// are cut as plane quadrilaterals with those opposite (cut()); the area of
  /// overlapping facets of @p b counts up to that of the facet.
  double
  count_facing_cells(const MeshSurface &a,
                     const MeshSurface &b,
                     const double       search_radius);
} // namespace lamella

#endif
