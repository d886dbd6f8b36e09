// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_mesh_surface_h
#define lamella_contact_mesh_surface_h

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/facet_map.h>
#include <lamella/body/surface_topology.h>
#include <lamella/contact/master_surface.h>
#include <lamella/contact/search.h>

#include <deal.II/base/polynomial.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Surface mesh of a named surface of a body, undeformed or deformed, for
  /// contact. Each facet, one side of a cell, has an exact map X(s, t)
  /// (FacetMap), with which lines are intersected.
  ///
  /// At smooth joints, normals of curved facets differ by interpolation errors.
  /// Contact therefore uses a continuous normal: the average
  ///   n_i ~ sum over facets int L_i n dA
  /// at each node i of the Gauss-Lobatto grids of the facets, interpolated by
  /// the functions L_i of the grid, with facet normals n. At edges sharper than
  /// 45 degrees, each side has its own normals.
  ///
  /// Displacements of a facet are polynomials determined by their values at its
  /// trace nodes, a Gauss-Lobatto grid. SurfaceTopology gives shared and
  /// hanging nodes. All coordinates are in scene axes.
  class MeshSurface : public MasterSurface
  {
  public:
    /// Creates the undeformed surface @p surface of @p body (Body::surfaces()).
    MeshSurface(const Body &body, const std::string &surface);

    /// Creates the deformed surface from @p undeformed with the displacements
    /// @p u of its trace nodes [length]. Node numbers, edges and hanging nodes
    /// are the same; locations refer to the undeformed body.
    MeshSurface(const MeshSurface                       &undeformed,
                const std::vector<dealii::Tensor<1, 3>> &u);

    /// Position and tangents at a point of a facet (FacetMap::Place).
    using Place = FacetMap::Place;

    /// A surface patch, one side of a cell, with all data for contact.
    struct Facet
    {
      /// Sets `side` and `map` only.
      Facet(const SurfaceFacet &side, const FacetMap &map)
        : side(side)
        , map(map)
      {}

      SurfaceFacet             side; ///< Location of the facet in the body.
      FacetMap                 map;  ///< Map X(s, t) from the unit square.
      const GaussLobattoBasis *grid_s  = nullptr; ///< Basis in s, for normals.
      const GaussLobattoBasis *grid_t  = nullptr; ///< Basis in t, for normals.
      const GaussLobattoBasis *trace_s = nullptr; ///< Displacement basis in s.
      const GaussLobattoBasis *trace_t = nullptr; ///< Displacement basis in t.
      dealii::Point<3>         center;      ///< Center of a bounding ball.
      double                   radius = 0.; ///< Radius of the bounding ball.
      dealii::Tensor<1, 3>     normal; ///< Outward unit normal at s = t = 1/2.
      /// Indices of the trace nodes, the first coordinate running fastest.
      std::vector<unsigned int> trace_nodes;
      /// Indices in MeshSurface::grid_nodes(), s running fastest.
      std::vector<unsigned int> grid_nodes,
        nodes_of_body; ///< Grid node numbers in SurfaceTopology.
      /// True if there is an adjacent facet at the sides s = 0, 1 and t = 0, 1.
      std::array<bool, 4> has_neighbor{},
        at_body_end{}; ///< True if the body ends at s, t = 0, 1.
      /// True for a plane parallelogram all of whose nodes have its normal.
      bool   is_flat        = false;
      double normal_modulus = 0., ///< Ply's modulus along `normal`.
        depth = 0.; ///< Depth of the cell behind the facet [length].
    };

    /// Returns the body to which the surface belongs.
    const Body &
    body() const
    {
      return surface_body;
    }

    /// Returns all facets. Facet numbers are indices in this vector.
    const std::vector<Facet> &
    facets() const
    {
      return all_facets;
    }

    /// Returns the outward unit normal of @p facet from its map at @p place.
    dealii::Tensor<1, 3>
    outward_normal(const Facet &facet, const Place &place) const;

    /// Returns the unit normal at the point @p st = (s, t) of @p facet that is
    /// interpolated from node normals and continuous across smooth joints.
    dealii::Tensor<1, 3>
    smooth_normal(const Facet &facet, const dealii::Point<2> &st) const;

    /// A node at which normals are stored, shared by facets that join smoothly.
    /// At a sharp edge there is one node for each side.
    struct GridNode
    {
      dealii::Point<3>     position; ///< Position, scene axes.
      dealii::Tensor<1, 3> normal;   ///< Unit normal, mean over facets.
    };

    /// Returns the grid nodes of all facets; weighted gaps belong to them.
    const std::vector<GridNode> &
    grid_nodes() const
    {
      return nodes;
    }

    /// Returns the location of grid node number @p node in the body.
    Location
    grid_location(const unsigned int node) const;

    /// Returns the number in grid_nodes() of the node at @p location, on the
    /// side of a sharp edge with the outward normal closest to @p normal.
    unsigned int
    grid_node(const Location             &location,
              const dealii::Tensor<1, 3> &normal) const;

    /// A node on a side of a larger facet (SurfaceTopology::HangingNode).
    using HangingNode = SurfaceTopology::HangingNode;

    /// Returns the hanging nodes, as indices in grid_nodes(). If an end node of
    /// the side on which a node hangs is itself hanging, it comes later.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Sets @p values to the shape functions of the trace nodes of @p facet at
    /// @p st: the displacement u(s, t) is the sum of @p values times nodal
    /// displacements, in the order of Facet::trace_nodes.
    void
    evaluate_trace(const Facet            &facet,
                   const dealii::Point<2> &st,
                   std::vector<double>    &values) const;

    /// Returns the number of trace nodes; shared nodes count once.
    unsigned int
    n_trace_nodes() const
    {
      return trace_locations.size();
    }

    /// Returns the location in the body of trace node number @p node.
    Location
    trace_location(const unsigned int node) const;

    /// A point of the surface, given by facet and parameters.
    struct FacetPoint
    {
      unsigned int     facet = 0; ///< Index in facets().
      dealii::Point<2> st;        ///< Parameters (s, t) in the unit square.
    };

    /// Returns the surface point at @p location in the body; at an edge, on the
    /// facet whose normal is closest to @p normal. Empty if it is on no facet.
    std::optional<FacetPoint>
    place_of(const Location             &location,
             const dealii::Tensor<1, 3> &normal) const;

    /// Returns the intersection of the line x + t d with facet number @p
    /// facet_index, where it enters the body. Newton's method starts from the
    /// center. Empty if the line misses the facet, or leaves the body according
    /// to both the facet normal and the smooth normal.
    std::optional<SurfaceHit>
    intersect_facet(const unsigned int          facet_index,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d) const;

    /// Returns the nearest intersection of the line x + t d with the facets
    /// numbered @p facets, at most @p search_radius away in either direction.
    std::optional<SurfaceHit>
    intersect_facets(const std::vector<unsigned int> &facets,
                     const dealii::Point<3>          &x,
                     const dealii::Tensor<1, 3>      &d,
                     const double                     search_radius) const;

    /// Returns the nearest intersection of the line x + t d with the surface,
    /// with |t| <= @p search_radius; empty if there is none.
    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const override;

    /// Returns the normal at the center of the facet nearest to @p x.
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

    /// Returns the numbers (ascending) of the facets whose bounding boxes meet
    /// the bounding box of @p points.
    std::vector<unsigned int>
    facets_near(const std::vector<dealii::Point<3>> &points) const;

  private:
    /// Adds a facet with the trace node numbers of the body.
    void
    make_facet(const SurfaceTopology::Facet &from);
    /// Sets the bounding ball of the facet from its map.
    void
    measure(Facet &facet) const;
    /// Finds the adjacent facets and the ends of the body.
    void
    find_neighbors();
    /// Numbers the grid nodes, separately on the two sides of edges sharper
    /// than 45 degrees, and finds the hanging nodes.
    void
    split_at_edges(const SurfaceTopology &topology);
    /// Returns the one of the coincident grid nodes @p numbers whose normal is
    /// within 45 degrees of @p normal.
    std::optional<unsigned int>
    on_side(const std::vector<unsigned int> &numbers,
            const dealii::Tensor<1, 3>      &normal) const;
    /// Sets the hanging nodes. @p sides are the grid nodes at each body node.
    void
    find_hanging_nodes(const SurfaceTopology                        &topology,
                       const std::vector<std::vector<unsigned int>> &sides);
    /// Computes node normals (at hanging nodes from end nodes) and is_flat.
    void
    average_normals();
    /// Creates the bounding boxes of the facets in axes of the first facet.
    void
    make_search();
    /// Returns the coordinates of @p x in the axes of the bounding boxes.
    dealii::Point<3>
    to_frame(const dealii::Point<3> &x) const;

    const Body        &surface_body;
    std::vector<Facet> all_facets;
    /// A facet and the point on it for each trace node.
    std::vector<std::pair<unsigned int, dealii::Point<2>>> trace_locations;
    /// A facet and the point on it for each grid node.
    std::vector<std::pair<unsigned int, dealii::Point<2>>>
                             grid_points_on_facets;
    std::vector<GridNode>    nodes;
    std::vector<HangingNode> hanging;
    /// Axes of the boxes, aligned with the surface.
    dealii::Tensor<2, 3> frame;
    BoxSearch            boxes;
  };

  /// Master surface that consists of some facets of a MeshSurface.
  class SurfacePart : public MasterSurface
  {
  public:
    /// Selects the facets numbered @p facets of @p whole; keeps references.
    SurfacePart(const MeshSurface               &whole,
                const std::vector<unsigned int> &facets)
      : whole(whole)
      , facets(facets)
    {}

    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const override
    {
      return whole.intersect_facets(facets, x, d, search_radius);
    }

    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override
    {
      return whole.normal_near(x);
    }

  private:
    const MeshSurface               &whole;
    const std::vector<unsigned int> &facets;
  };

  /// Returns the closest-point projection X_2 of @p x onto @p surface: the
  /// nearest one within @p search_radius whose facet normal n_2 is opposite to
  /// @p n1, the outward normal at x. @p opposed is the smallest permitted
  /// cosine of the angle between n1 and -n_2. The result has n_2 as normal and
  /// the gap g = n_2 . (x - X_2) as distance, negative for penetration. The
  /// motion of X_2 on the facet does not enter the gradient, as tangents are
  /// normal to n_2: delta g = n_2 . (delta x - delta X_2). The result is empty
  /// if there is no projection.
  ///
  /// If the previous projection @p last is known, its facet is kept while the
  /// projection lies on it, or beyond a side with an adjacent facet by at most
  /// 5 % of the facet length. Beyond a side without an adjacent facet there is
  /// no projection, except up to 1 % of this length along the beam axis.
  std::optional<SurfaceHit>
  closest_point_projection(const MeshSurface          &surface,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius,
                           const std::optional<MeshSurface::FacetPoint> &last,
                           const double opposed = min_facing_cosine);

  /// Returns the closest-point projection of @p x, with outward normal @p n1,
  /// onto @p obstacle within @p search_radius. The gap is g = N . (x - p) for a
  /// plane with normal N through p, and g = |r| - R for a cylinder of radius R,
  /// with the component r of x - p normal to its axis. Empty if r = 0.
  std::optional<SurfaceHit>
  closest_point_projection(const Obstacle             &obstacle,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius);
} // namespace lamella

#endif
