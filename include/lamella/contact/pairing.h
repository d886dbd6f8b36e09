// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_h
#define lamella_contact_pairing_h

#include <lamella/base/linear_functional.h>
#include <lamella/body/body.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/slave_surface.h>

#include <limits>
#include <utility>
#include <vector>

namespace lamella
{
  /// Weights and points of the gap constraints on one side of a contact,
  /// independent of the discretization of the body. Constraint r is
  ///   sum_k w_rk . u(X_k)
  /// for a displacement field u and points X_k. Its row in the constraint
  /// matrix is the product of the weights w_rk and the displacement rows of
  /// Body::rows(), so another discretization of the same body, or the deformed
  /// body, can use the same gaps and contact forces. A node pair has one point
  /// per side, with the weight -n on the first and n on the second, n the
  /// normal. A weighted gap has the trace nodes of its facets, with weights
  /// 1/A_i int phi_i psi_k n dA: phi_i is the multiplier function, A_i its
  /// integral, psi_k the displacement shape function of the node.
  struct ConstraintGeometry
  {
    /// Pairs (index in `places`, weight vector) of one constraint, scene axes.
    using Weights = std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;

    /// Points in the body for which the contact was created.
    std::vector<Location> places;
    /// Weights of each constraint; empty for an obstacle.
    std::vector<Weights> weights;
  };

  /// Returns the constraints of @p side as functionals of the @p n_dofs DoFs of
  /// the body with index @p index: row r is sum_k sum_c w_rk,c R_kc with the
  /// weights w_rk of @p side. @p at has the three displacement rows R_kc of
  /// each point k, from Body::rows() of any discretization of the body.
  std::vector<BodyFunctional>
  body_rows(const unsigned int                                index,
            const DofIndex                                    n_dofs,
            const std::vector<std::vector<LinearFunctional>> &at,
            const ConstraintGeometry                         &side);

  /// A pair of facing nodes, one of each contact surface, for node-to-node
  /// contact (Sec. 3.3 of Nagaraj et al. 2020).
  struct PointPair
  {
    unsigned int first = 0, ///< Index of the point on the first surface.
      second           = 0; ///< Index of the point on the second surface.
    /// Unit normal n ~ n_1 - n_2, with outward normals n_1, n_2 of both points.
    dealii::Tensor<1, 3> normal;
    /// Initial gap (X_2 - X_1) . n [length] between the undeformed points X_1
    /// and X_2; negative if the surfaces overlap.
    double initial_gap = 0.;
  };

  /// Result of node-to-node pairing.
  struct Pairing
  {
    std::vector<PointPair> pairs; ///< Pairs, ascending by PointPair::first.
    unsigned int unpaired = 0,    ///< Number of unpaired points, first surface.
      unpaired_second     = 0; ///< Number of unpaired points, second surface.
    /// Smallest distance between points of both surfaces [length], for the
    /// error message if there are no pairs; the largest double if unknown.
    double nearest_distance = 0.,
           smallest_offset  = 0.; ///< Smallest tangential offset [length].
  };

  /// Returns node-to-node pairs: points aligned along the average of both
  /// normals and at most @p search_radius apart. Each point is in at most one
  /// pair; nearest pairs are formed first. Swapping the two surfaces only swaps
  /// the pairs and reverses the normals. Points a and b with areas A form a
  /// pair if, with d = X_b - X_a and the averaged normal n,
  ///   |d - (d . n) n| <= tolerance sqrt(min(A_a, A_b)),  |d| <= search_radius,
  /// and if their normals are opposed: within 60 degrees for points in contact;
  /// less strictly, |n_a - n_b| > 0.2, for points with a distance along n.
  Pairing
  pair_node_to_node(
    const std::vector<SurfacePoint> &first,
    const std::vector<SurfacePoint> &second,
    const double                     tolerance,
    const double search_radius = std::numeric_limits<double>::infinity());

  /// A gap as a function of point displacements u_1 (slave) and u_2 (master),
  ///   g(u) = sum_k v_k . u_2(X_k) - sum_j w_j . u_1(X_j) + gap,
  /// with points X_j and X_k of the slave and master surface and weight vectors
  /// w_j and v_k. `gap` is the initial gap. A node pair has v = w = n, the
  /// normal; the weights of a weighted gap (mortar) sum to its average normal.
  struct WeightedGap
  {
    dealii::Point<3> position, ///< Slave point of the gap.
      opposite; ///< Point of the master surface opposite the slave point.
    Location     node; ///< Element and unit coordinates of the slave point.
    unsigned int slave_node = 0; ///< Number in MeshSurface::grid_nodes().
    /// Unit normal n, outward from the slave side; for a weighted gap its
    /// average. The contact force on the master side is along n.
    dealii::Tensor<1, 3> normal;
    double area    = 0.,  ///< Tributary area of the slave point [length^2].
      gap          = 0.;  ///< Initial gap [length]; averaged if weighted.
    double spacing = 0.;  ///< Root of the full area of the slave node [length].
    double angle   = 0.;  ///< Angle between both normals, one reversed [rad].
    LocalStiffness slave, ///< Slave stiffness, for the automatic penalty.
      master;             ///< Master stiffness; for an obstacle the slave's.
    ConstraintGeometry::Weights
      slave_weights,  ///< Weight vectors of slave points (Gaps::slave).
      master_weights; ///< Weight vectors of master points (Gaps::master).
  };

  /// A slave point without constraint, since it is deeper behind the master
  /// surface than the depth of the elements there.
  struct DeepPenetration
  {
    dealii::Point<3> position, ///< Slave point.
      opposite; ///< Point of the master surface opposite the slave point.
    double behind = 0.; ///< Distance behind the surface, positive [length].
  };

  /// A material point of the slave side at which a gap is measured, with its
  /// projection on the master side. The weighted gap (mortar) of node i is the
  /// average of the gaps g_q at integration points X_q with areas a_q,
  ///   g_i = sum_q a_q phi_i(X_q) g_q / sum_q a_q phi_i(X_q),
  /// with the Lagrange multiplier functions phi_i.
  struct GapPoint
  {
    MeshSurface::FacetPoint slave; ///< Slave point: facet and its coordinates.
    /// Opposite master point; its facet is invalid_unsigned_int for obstacles.
    MeshSurface::FacetPoint master;
    double       area = 1.; ///< Integration area [length^2]; 1 for a node.
    unsigned int part = 0;  ///< Index in SlaveSurface::facets(), if weighted.
  };

  /// All gaps of one contact, and the points on which they depend.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;  ///< Gaps, one per contact constraint.
    std::vector<Location>    slave, ///< Slave points that have weights.
      master; ///< Master points that have weights; none for an obstacle.
    unsigned int unpaired = 0; ///< Number of slave points that face nothing.
    /// Slave points without constraint, too deep behind the master surface.
    std::vector<DeepPenetration> deep_penetrations;
    /// Slave surface with multiplier functions of weighted gaps, else null.
    std::shared_ptr<const SlaveSurface> surface = {};
    std::vector<GapPoint> points = {}; ///< Integration points of weighted gaps.
  };

  /// Slave and master surface of a contact. The master is a mesh, or an
  /// obstacle if master_mesh is null. Keeps pointers to the surfaces.
  struct ContactSurfacePair
  {
    const MeshSurface   *slave       = nullptr; ///< Slave surface, never null.
    const MasterSurface *master      = nullptr; ///< Master surface or obstacle.
    const MeshSurface   *master_mesh = nullptr; ///< Mesh of master, or null.
    double search_radius = 0.; ///< Search radius along the normal [length].
    /// Slave facets with constraints; empty: all.
    std::vector<bool> part = {};
    /// True for edge contact: gaps are measured along normals of the master
    /// mesh (closest_point_projection()). False: along the averaged normal.
    bool   edge_contact       = false;
    double max_obstacle_depth = 0.; ///< Permitted penetration [length].
  };

  /// Returns true if the overlap (-@p gap) exceeds the smaller of @p depth_1
  /// and @p depth_2, the depths of the elements behind both surfaces [length].
  /// Such a point gets no contact constraint.
  bool
  exceeds_cell_depth(const double gap,
                     const double depth_1,
                     const double depth_2);

  /// Returns true if the overlap at the master point @p hit exceeds the depth
  /// of the slave element @p depth or of the master element. For an obstacle,
  /// the limit is the larger of @p depth and the permitted penetration
  /// ContactSurfacePair::max_obstacle_depth.
  bool
  exceeds_cell_depth(const ContactSurfacePair &sides,
                     const SurfaceHit         &hit,
                     const double              depth);

  /// Returns the node-to-surface gaps of the slave nodes @p points: one slave
  /// node and one master point per gap, along the averaged normal (edge
  /// contact: the master normal). Master nodes may penetrate the slave side,
  /// and a uniform pressure is not transmitted exactly (doc/theory/contact.md).
  Gaps
  pair_node_to_surface(const ContactSurfacePair        &sides,
                       const std::vector<SurfacePoint> &points);

  /// Returns the number of surface nodes of @p a that face no point of @p b
  /// within @p search_radius [length].
  unsigned int
  count_unpaired_nodes(const MeshSurface   &a,
                       const MasterSurface &b,
                       const double         search_radius);

  /// Returns the number of cells between surface nodes of @p a that face @p b
  /// within @p search_radius [length]; a facet has degree_s x degree_t cells. A
  /// partly facing facet counts with the fraction of its area that faces @p b.
  /// SlaveSide::automatic compares these numbers of both surfaces.
  double
  count_facing_cells(const MeshSurface &a,
                     const MeshSurface &b,
                     const double       search_radius);

  /// Throws InputError for a contact without facing points within @p
  /// search_radius [length]. The message gives the smallest distance or offset.
  [[noreturn]] void
  throw_no_pairs(const ContactPair &contact,
                 const Bodies      &bodies,
                 const double       search_radius);

  /// Throws InputError if a slave point deep behind the master surface
  /// (Gaps::deep_penetrations) lies inside the other body, or if @p gaps has no
  /// other points. Deep points outside the other body are accepted: they face
  /// away from it (the upper half of a roller). The slave is the second surface
  /// if @p on_second is true, else the first.
  void
  check_no_penetration(const ContactPair &contact,
                       const Bodies      &bodies,
                       const bool         on_second,
                       const Gaps        &gaps);

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
