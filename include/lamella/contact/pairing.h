// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_h
#define lamella_contact_pairing_h

#include <lamella/contact/enforcement.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/row_geometry.h>

#include <limits>
#include <utility>
#include <vector>

namespace lamella
{
  /// Two points that face each other, numbers in the lists of surface points.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// (n_1 - n_2) / |n_1 - n_2|, and (X_2 - X_1) . n (Eq. 17).
    dealii::Tensor<1, 3> normal;
    double               initial_gap = 0.;
  };

  struct Pairing
  {
    std::vector<PointPair> pairs;
    /// Points of either surface that face no point of the other.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// The smallest distance between the two sets of points, whatever they
    /// face, and the smallest sideways offset: what to tell if nothing pairs.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /**
   * Node-to-node pairs: points that lie along the average of both normals from
   * each other (sideways offset below @p tolerance times the square root of the
   * tributary area, the smaller one) and at most @p reach apart. Each point is
   * in one pair at most, the nearest ones go first; swapping the two sets swaps
   * the pairs and turns the normals, nothing else.
   */
  Pairing
  pair_node_to_node(
    const std::vector<SurfacePoint> &first,
    const std::vector<SurfacePoint> &second,
    const double                     tolerance,
    const double reach = std::numeric_limits<double>::infinity());

  /**
   * The geometry of a gap row,
   *   g(u) = sum_k v_k . u_2(X_k) - sum_j w_j . u_1(X_j) + gap,
   * where 1 is the side whose points carry the rows. For a pair of points v = w
   * = n; for a weighted gap both sum to the mean normal.
   */
  struct WeightedGap
  {
    /// The point that carries the row, and the place opposite.
    dealii::Point<3> position, opposite;
    /// n, outwards from the carrying side; of a weighted gap its mean, which is
    /// shorter than 1 where the surfaces are curved: the force of the row is
    /// lambda times it.
    dealii::Tensor<1, 3> normal;
    double               area = 0., gap = 0.;
    /// As in ContactInterface::Point.
    double spacing = 0.;
    /// Between n_1 and -n_2 at the point, in rad.
    double         angle = 0.;
    LocalStiffness carrying, opposing;
    /// w_j and v_k by numbers of locations in Gaps.
    RowGeometry::Weights carrying_weights, opposing_weights;
  };

  /// A place further behind the other surface than the cells there are deep.
  struct DeepPlace
  {
    dealii::Point<3> position, opposite;
    double           behind = 0.;
  };

  /// What two sides have in common.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;
    /// What the weights refer to.
    std::vector<Location> carrying, opposing;
    /// Points of the carrying side that face nothing.
    unsigned int           unpaired = 0;
    std::vector<DeepPlace> too_deep;
  };

  /// The side that a discretisation puts its points on, and the one that it
  /// holds them against: a mesh, or an obstacle if opposing_mesh is null.
  struct Sides
  {
    const MeshSurface     *carrying      = nullptr;
    const OpposingSurface *opposing      = nullptr;
    const MeshSurface     *opposing_mesh = nullptr;
    /// Places further apart do not face each other.
    double reach = 0.;
  };

  /// Whether @p gap is so negative that the places lie behind each other by
  /// more than the cells are deep.
  bool
  is_too_deep(const double gap, const double depth_1, const double depth_2);

  /// The depth of the opposing side's cell at @p hit; none of an obstacle's
  /// is less deep than those of any mesh.
  double
  opposing_depth(const Sides &sides, const SurfaceHit &hit);

  /// Node to surface: the points @p points of the carrying side against the
  /// places that they face, each with its tributary area.
  Gaps
  pair_node_to_surface(const Sides                     &sides,
                       const std::vector<SurfacePoint> &points);

  /// Nodes of the grid of @p a that face no place of @p b.
  unsigned int
  nodes_facing_nothing(const MeshSurface     &a,
                       const OpposingSurface &b,
                       const double           reach);

  /// Grid cells (degree_s x degree_t a facet) of @p a that face @p b, parts of
  /// facets counted by area.
  double
  cells_facing(const MeshSurface &a, const MeshSurface &b, const double reach);
} // namespace lamella

#endif
