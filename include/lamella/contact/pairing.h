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
  /// A node-to-node pair of surface points (Sec. 3.3 of the paper), by their
  /// indices on the first and second surface.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// Averaged normal n = (n_1 - n_2) / |n_1 - n_2|, and initial gap g_init =
    /// (X_2 - X_1) . n [length] (Eq. 17 with the averaged normal).
    dealii::Tensor<1, 3> normal;
    double               initial_gap = 0.;
  };

  /// Result of pair_node_to_node().
  struct Pairing
  {
    /// Pairs in ascending order of the first index.
    std::vector<PointPair> pairs;
    /// Number of points of either surface that face no point of the other.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// For messages if no pairs exist: smallest distance of points of the two
    /// surfaces, and smallest tangential offset of points with opposed normals
    /// [length]; the largest double if there are none.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /// Returns node-to-node pairs: points aligned along the average of both
  /// normals and at most @p search_radius apart. Each point is in at most one
  /// pair; nearest pairs are formed first. Swapping the two surfaces only swaps
  /// the pairs and reverses the normals. Points a and b form a pair, with d =
  /// X_b - X_a and n as in PointPair, if
  ///   |d - (d . n) n| <= tolerance sqrt(min(A_a, A_b)),  |d| <= search_radius,
  /// and if their normals are opposed: to 60 degrees for points in contact,
  /// less strictly (|n_a - n_b| > 0.2) for points apart along n. The three
  /// nearest points from an R-tree are tried first, then all.
  Pairing
  pair_node_to_node(
    const std::vector<SurfacePoint> &first,
    const std::vector<SurfacePoint> &second,
    const double                     tolerance,
    const double search_radius = std::numeric_limits<double>::infinity());

  /// A gap as a function of point displacements u_1 (slave) and u_2 (master),
  /// from which make_interface() creates a GapConstraint,
  ///   g(u) = sum_k v_k . u_2(X_k) - sum_j w_j . u_1(X_j) + gap.
  /// X_j and X_k are points of the slave and master surface, and `gap` is the
  /// initial gap. A node pair has v = w = n; for weighted gaps, the weights w_j
  /// and v_k each sum to the average normal.
  struct WeightedGap
  {
    /// Slave point of the gap, and the point opposite.
    dealii::Point<3> position, opposite;
    /// Location of the slave point in its body.
    Location node;
    /// Normal n, outward from the slave side; for a weighted gap its average.
    /// The contact force on the master side is lambda n.
    dealii::Tensor<1, 3> normal;
    /// Tributary area [length^2], and (average) initial gap [length].
    double area = 0., gap = 0.;
    /// Point spacing, the root of the full tributary area [length].
    double spacing = 0.;
    /// Angle between n_1 and -n_2 at the slave point [rad].
    double angle = 0.;
    /// Stiffnesses for the automatic penalty; for an obstacle, the slave's.
    LocalStiffness slave, master;
    /// Weights w_j and v_k, with indices in Gaps::slave and Gaps::master.
    ConstraintGeometry::Weights slave_weights, master_weights;
  };

  /// A slave point without a constraint, as it is behind the other surface by
  /// more than the depth of cells: surfaces face away or bodies overlap.
  struct DeepPenetration
  {
    dealii::Point<3> position, opposite;
    /// Distance behind the surface, positive [length].
    double behind = 0.;
  };

  /// A material point of the slave side at which a gap is measured, with its
  /// projection on the master side. A weighted gap is the average
  ///   g_i = sum_q a_q phi_i(X_q) g_q / sum_q a_q phi_i(X_q),
  /// with constant points X_q and areas a_q, and multiplier functions phi_i.
  struct GapPoint
  {
    /// Slave point, by facet numbers of MeshSurface.
    MeshSurface::FacetPoint slave;
    /// Opposite point; its facet is invalid_unsigned_int for an obstacle.
    MeshSurface::FacetPoint master;
    /// Area a_q of the point [length^2]; 1 for constraints of a single point.
    double area = 1.;
    /// Facet number in the SlaveSurface; unused for single-point constraints.
    unsigned int part = 0;
  };

  /// All gaps of one contact, and the points on which they depend.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;
    /// Points of the slave and master body to which the weights refer.
    std::vector<Location> slave, master;
    /// Number of slave points without master point or deep penetration.
    unsigned int                 unpaired = 0;
    std::vector<DeepPenetration> deep_penetrations;
    /// Slave surface with hat functions; null for nodal functions.
    std::shared_ptr<const SlaveSurface> surface = {};
    /// Integration points of the gaps for hat functions.
    std::vector<GapPoint> points = {};
  };

  /// Slave and master surface of a contact. The master is a mesh, or an
  /// obstacle if master_mesh is null. Keeps pointers to the surfaces.
  struct ContactSurfacePair
  {
    const MeshSurface   *slave       = nullptr;
    const MasterSurface *master      = nullptr;
    const MeshSurface   *master_mesh = nullptr;
    /// Search radius along the averaged normal [length].
    double search_radius = 0.;
    /// True for edge contact: slave points are projected along the normals of
    /// master_mesh (closest_point_projection()).
    bool edge_contact = false;
    /// Permitted penetration of an obstacle [length].
    double max_obstacle_depth = 0.;
  };

  /// Returns true if the overlap -gap exceeds the depth of the shallower of the
  /// two cells behind the surfaces, so that the point gets no constraint.
  bool
  exceeds_cell_depth(const double gap,
                     const double depth_1,
                     const double depth_2);

  /// Returns true if the overlap at the master point @p hit exceeds the depth
  /// of the slave cell @p depth or of the master cell; for an obstacle,
  /// max(depth, max_obstacle_depth).
  bool
  exceeds_cell_depth(const ContactSurfacePair &sides,
                     const SurfaceHit         &hit,
                     const double              depth);

  /// Returns node-to-surface gaps of the slave nodes @p points and the master
  /// points that they face. Single-pass: master nodes may penetrate the slave
  /// side, and a uniform pressure is not transmitted exactly
  /// (doc/theory/contact.md). One point per side, with v = w = n.
  Gaps
  pair_node_to_surface(const ContactSurfacePair        &sides,
                       const std::vector<SurfacePoint> &points);

  /// Returns the number of grid nodes of @p a that do not face @p b within
  /// @p search_radius [length].
  unsigned int
  count_unpaired_nodes(const MeshSurface   &a,
                       const MasterSurface &b,
                       const double         search_radius);

  /// Returns the number of grid cells (degree_s x degree_t per facet) of @p a
  /// that face @p b, for SlaveSide::automatic. A facet that faces @p b in part
  /// counts by area: facets are cut as plane quadrilaterals (cut()).
  double
  count_facing_cells(const MeshSurface &a,
                     const MeshSurface &b,
                     const double       search_radius);
} // namespace lamella

#endif
