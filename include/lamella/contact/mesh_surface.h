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
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Surface mesh of a named surface of a body, undeformed or deformed, for
  /// contact. Each facet, one side of a cell, has an exact map X(s, t)
  /// (FacetMap), with which lines are intersected.
  ///
  /// At smooth joints, normals of adjacent facets differ by the interpolation
  /// error of curves. Contact therefore uses a continuous normal: the average
  ///   n_i ~ sum over facets int L_i n dA
  /// at each node i of the Gauss-Lobatto grids of the facets, as in
  /// Body::surface_points(), interpolated by the functions L_i of the grid. At
  /// edges sharper than 45 degrees, each side has its own normals.
  ///
  /// Displacements of a facet are polynomials determined by their values at its
  /// trace nodes, a Gauss-Lobatto grid. SurfaceTopology gives shared and
  /// hanging nodes. All coordinates are in scene axes.
  class MeshSurface : public MasterSurface
  {
  public:
    /// Creates the undeformed surface; @p surface is one of Body::surfaces().
    MeshSurface(const Body &body, const std::string &surface);

    /// Creates the deformed surface from @p undeformed with the displacements
    /// @p u of its trace nodes [length]. Node numbers, edges and hanging nodes
    /// are the same; locations refer to the undeformed body.
    MeshSurface(const MeshSurface                       &undeformed,
                const std::vector<dealii::Tensor<1, 3>> &u);

    using Place = FacetMap::Place;

    /// A surface patch, one side of a cell, with all data for contact.
    struct Facet
    {
      Facet(const SurfaceFacet &side, const FacetMap &map)
        : side(side)
        , map(map)
      {}

      SurfaceFacet side;
      FacetMap     map;
      /// 1D Lagrange bases in s and t on the nodes of the grid (normals) and of
      /// the trace (displacements); static lifetime.
      const GaussLobattoBasis *grid_s = nullptr, *grid_t = nullptr,
                              *trace_s = nullptr, *trace_t = nullptr;
      /// Bounding ball of the facet [length], for the coarse test of
      /// intersect_facet(), and outward unit normal at the center.
      dealii::Point<3>     center;
      double               radius = 0.;
      dealii::Tensor<1, 3> normal;
      /// Numbers of the trace nodes, the first coordinate running fastest.
      std::vector<unsigned int> trace_nodes;
      /// Numbers of the grid nodes in MeshSurface::grid_nodes(), the first
      /// coordinate running fastest, and in SurfaceTopology.
      std::vector<unsigned int> grid_nodes, nodes_of_body;
      /// True if there is an adjacent facet, or the end of the body, beyond the
      /// sides s = 0, s = 1, t = 0 and t = 1.
      std::array<bool, 4> has_neighbor{}, at_body_end{};
      /// `is_flat`: plane parallelogram all of whose nodes have its normal.
      /// Elastic modulus of the ply along the normal at the center
      /// [force/length^2]; depth of the cell behind the facet [length].
      bool   is_flat        = false;
      double normal_modulus = 0., depth = 0.;
    };

    const Body &
    body() const
    {
      return surface_body;
    }

    /// Returns the facets; facet numbers are indices here.
    const std::vector<Facet> &
    facets() const
    {
      return all_facets;
    }

    /// Returns the outward unit normal of @p facet at @p place (from its map).
    dealii::Tensor<1, 3>
    outward_normal(const Facet &facet, const Place &place) const;

    /// Returns the continuous unit normal at @p st, n ~ sum_i L_i(s, t) n_i,
    /// with the node normals n_i in the Gauss-Lobatto basis of the facet grid.
    dealii::Tensor<1, 3>
    smooth_normal(const Facet &facet, const dealii::Point<2> &st) const;

    /// A grid node, shared by facets that join smoothly; at a sharp edge there
    /// is one for each side. @p normal is the unit normal n_i.
    struct GridNode
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> normal;
    };

    /// Returns the grid nodes of all facets, to which weighted gaps belong.
    const std::vector<GridNode> &
    grid_nodes() const
    {
      return nodes;
    }

    /// Returns the location of grid node @p node in the body.
    Location
    grid_location(const unsigned int node) const;

    using HangingNode = SurfaceTopology::HangingNode;

    /// Returns the hanging nodes, as indices in grid_nodes(). Nodes between
    /// which a node hangs come later if they hang themselves.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Sets @p values to the trace shape functions of @p facet at @p st, in the
    /// order of trace_nodes: tensor products of Gauss-Lobatto bases, so that
    /// u(s, t) is the sum of @p values times trace displacements.
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

    /// Returns the location in the body of trace node @p node.
    Location
    trace_location(const unsigned int node) const;

    /// A point (s, t) on the facet of the given number.
    struct FacetPoint
    {
      unsigned int     facet = 0;
      dealii::Point<2> st;
    };

    /// Returns the surface point at the location @p location in the body; at an
    /// edge, on the facet whose normal is closest to @p normal. Empty if the
    /// location is on no facet.
    std::optional<FacetPoint>
    place_of(const Location             &location,
             const dealii::Tensor<1, 3> &normal) const;

    /// Returns the intersection of the line x + t d with facet number @p facet,
    /// where it enters the body. Newton's method starts from the center. Empty
    /// if the line misses the facet, or enters the body by neither the facet
    /// normal nor the smooth normal.
    std::optional<SurfaceHit>
    intersect_facet(const unsigned int          facet,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d) const;

    /// Returns the nearest intersection with the facets @p facets, at most
    /// @p search_radius away in either direction.
    std::optional<SurfaceHit>
    intersect_facets(const std::vector<unsigned int> &facets,
                     const dealii::Point<3>          &x,
                     const dealii::Tensor<1, 3>      &d,
                     const double                     search_radius) const;

    /// Returns the nearest intersection, among facets whose boxes meet the
    /// segment from x - search_radius d to x + search_radius d.
    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const override;

    /// Returns the normal at the center of the facet nearest to @p x.
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

    /// Returns the facets (ascending) whose boxes meet the bounding box of
    /// @p points: a superset of those within their convex hull.
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
    /// Returns the one of @p numbers, the grid nodes at one node of the body,
    /// whose normal is within 45 degrees of @p normal.
    std::optional<unsigned int>
    on_side(const std::vector<unsigned int> &numbers,
            const dealii::Tensor<1, 3>      &normal) const;
    /// Sets the hanging nodes. @p sides are the grid nodes at each body node.
    void
    find_hanging_nodes(const SurfaceTopology                        &topology,
                       const std::vector<std::vector<unsigned int>> &sides);
    /// Sets the normals n_i (end nodes' mean at hanging nodes) and is_flat.
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

  /// Master surface that consists of some facets of a MeshSurface. Keeps
  /// references to both constructor arguments.
  class SurfacePart : public MasterSurface
  {
  public:
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
} // namespace lamella

#endif
