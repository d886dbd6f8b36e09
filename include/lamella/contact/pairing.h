// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pairing_h
#define lamella_contact_pairing_h

#include <lamella/contact/carrying_surface.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/row_geometry.h>

#include <limits>
#include <utility>
#include <vector>

namespace lamella
{
  /// Two points that face each other, numbers in the lists of surface points. A
  /// node-to-node pair as in the paper's Sec. 3.3, with its kinematics.
  struct PointPair
  {
    unsigned int first = 0, second = 0;
    /// n = (n_1 - n_2) / |n_1 - n_2|, and g_init = (X_2 - X_1) . n [length]:
    /// Eq. 17 with the averaged normal in the place of n_1. Negative: an
    /// overlap.
    dealii::Tensor<1, 3> normal;
    double               initial_gap = 0.;
  };

  /// The result of pair_node_to_node().
  struct Pairing
  {
    /// By ascending first.
    std::vector<PointPair> pairs;
    /// Points of either surface that face no point of the other.
    unsigned int unpaired = 0, unpaired_second = 0;
    /// The smallest distance between the two sets of points, whatever they
    /// face, and the smallest sideways offset: what to tell if nothing pairs.
    /// [length]; the offset only of points whose normals are opposed to 60
    /// degrees. The largest double if there are none.
    double nearest_distance = 0., smallest_offset = 0.;
  };

  /**
   * Node-to-node pairs: points that lie along the average of both normals from
   * each other (sideways offset below @p tolerance times the square root of the
   * tributary area, the smaller one) and at most @p reach apart. Each point is
   * in one pair at most, the nearest ones go first; swapping the two sets swaps
   * the pairs and turns the normals, nothing else.
   *
   * What makes a pair of the points a and b, d = X_b - X_a and n as above:
   *   |d - (d . n) n| <= tolerance sqrt(min(A_a, A_b)),  |d| <= reach,
   * and normals that oppose each other: to 60 degrees where the points touch,
   * less strictly (|n_a - n_b| > 0.2) where they are apart along n.
   *
   * The three nearest points are tried first, by an R-tree; a point that faces
   * none of these is tried against all, which costs the product of both numbers
   * where nothing touches. Nothing is thrown: an empty result is judged by the
   * caller.
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
   *
   * All three discretisations come down to this; make_interface() turns it into
   * a GapRow with the signs of First and Second.
   */
  struct WeightedGap
  {
    /// The point that carries the row, and the place opposite.
    dealii::Point<3> position, opposite;
    /// The point as a place of the carrying body.
    Location node;
    /// n, outwards from the carrying side; of a weighted gap its mean, which is
    /// shorter than 1 where the surfaces are curved: the force of the row is
    /// lambda times it.
    dealii::Tensor<1, 3> normal;
    /// The tributary area [length^2], and g_init or its average over the area
    /// [length].
    double area = 0., gap = 0.;
    /// As in ContactInterface::Point.
    double spacing = 0.;
    /// Between n_1 and -n_2 at the point, in rad.
    double angle = 0.;
    /// What the automatic penalty is made of; of an obstacle the carrying
    /// side's.
    LocalStiffness carrying, opposing;
    /// w_j and v_k by numbers of locations in Gaps. None opposing if that is an
    /// obstacle. Without sign: both along n.
    RowGeometry::Weights carrying_weights, opposing_weights;
  };

  /// A place further behind the other surface than the cells there are deep. It
  /// makes no row. Either the surfaces look away from each other there or the
  /// bodies lie in each other: check in make_interface().
  struct DeepPlace
  {
    dealii::Point<3> position, opposite;
    /// How far, positive [length].
    double behind = 0.;
  };

  /**
   * A material point of the carrying side at which a gap is measured, and where
   * it faces the other side. A row is the average of the gaps at such points,
   *   g_i = sum_q a_q phi_i(X_q) g_q / sum_q a_q phi_i(X_q);
   * where bodies move, the points and what they weigh stay, and their feet on
   * the other side wander.
   */
  struct GapPoint
  {
    /// Numbers of facets are those of MeshSurface.
    MeshSurface::FacetPlace carrying;
    /// invalid_unsigned_int as facet if that is an obstacle.
    MeshSurface::FacetPlace opposing;
    /// a_q: the area that the point stands for [length^2]; 1 where one point is
    /// a row.
    double area = 1.;
    /// The number of the facet in the CarryingSurface whose functions phi_i
    /// are; unused where one point is a row.
    unsigned int part = 0;
  };

  /// What two sides have in common. The result of each discretisation, before
  /// signs, penalties and DoFs.
  struct Gaps
  {
    std::vector<WeightedGap> gaps;
    /// What the weights refer to. Locations in the cells of either body; none
    /// opposing if that is an obstacle.
    std::vector<Location> carrying, opposing;
    /// Points of the carrying side that face nothing. Points that are too deep
    /// are not among them.
    unsigned int           unpaired = 0;
    std::vector<DeepPlace> too_deep;
    /// What carries the gaps if their functions are hats; null if each is that
    /// of its node.
    std::shared_ptr<const CarryingSurface> surface = {};
    /// Where the gaps are averaged if their functions are hats.
    std::vector<GapPoint> points = {};
  };

  /// The side that a discretisation puts its points on, and the one that it
  /// holds them against: a mesh, or an obstacle if opposing_mesh is null. In
  /// the words of mortar methods the slave and the master. Refers to surfaces
  /// that have to live longer.
  struct Sides
  {
    const MeshSurface     *carrying      = nullptr;
    const OpposingSurface *opposing      = nullptr;
    const MeshSurface     *opposing_mesh = nullptr;
    /// Places further apart do not face each other. Along the averaged normal
    /// [length].
    double reach = 0.;
    /// Whether the points are those of edges, which face the nearest places of
    /// opposing_mesh, along the normals there (find_foot()).
    bool of_edges = false;
    /// How deep in an obstacle places may be, whatever the cells are [length]:
    /// what has moved in has to come out again.
    double inside_obstacle = 0.;
  };

  /// Whether @p gap is so negative that the places lie behind each other by
  /// more than the cells are deep. -gap > min(depth_1, depth_2), all lengths.
  bool
  is_too_deep(const double gap, const double depth_1, const double depth_2);

  /// The same at @p hit of the opposing side, with the @p depth of the carrying
  /// one; in an obstacle -gap > max(depth, Sides::inside_obstacle).
  bool
  is_too_deep(const Sides &sides, const SurfaceHit &hit, const double depth);

  /**
   * Node to surface: the points @p points of the carrying side against the
   * places that they face, each with its tributary area.
   * A single-pass method: nothing keeps the nodes of the opposing side out of
   * the carrying one, and a uniform pressure is not passed on exactly
   * (doc/contact.md). Each row has v = w = n at one place a side. Rows are in
   * the order of @p points.
   */
  Gaps
  pair_node_to_surface(const Sides                     &sides,
                       const std::vector<SurfacePoint> &points);

  /// Nodes of the grid of @p a that face no place of @p b. Within @p reach
  /// [length]; all places of the grid nodes are looked up.
  unsigned int
  nodes_facing_nothing(const MeshSurface     &a,
                       const OpposingSurface &b,
                       const double           reach);

  /// Grid cells (degree_s x degree_t a facet) of @p a that face @p b, parts of
  /// facets counted by area. Facets are cut as plane quadrilaterals with those
  /// opposite (cut()); of facets of @p b behind each other the area counts up
  /// to that of the facet. Decides PointsOn::automatic.
  double
  cells_facing(const MeshSurface &a, const MeshSurface &b, const double reach);
} // namespace lamella

#endif
