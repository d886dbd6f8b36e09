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
  /**
   * A named surface of a body, undeformed or displaced. Each facet keeps its
   * map X(s, t) (FacetMap), with which rays are intersected, curved or not.
   *
   * At smooth joints, facet normals differ by the interpolation error of
   * curves. Contact uses a continuous field: the average normal
   *   n_i ~ sum over facets int L_i n dA
   * at each node i of the Gauss-Lobatto grids of the facets, as
   * Body::surface_points() gives it, interpolated in between. At edges sharper
   * than 45 degrees each side keeps its own.
   *
   * Displacements of a facet are polynomials determined by their values at its
   * trace nodes, a Gauss-Lobatto grid. SurfaceTopology gives shared and hanging
   * nodes. Facets, normals and a box tree over the facets are created once;
   * later only locations are requested from the body. Scene axes.
   */
  class MeshSurface : public MasterSurface
  {
  public:
    /// Creates the undeformed surface; @p surface is one of Body::surfaces().
    MeshSurface(const Body &body, const std::string &surface);

    /// Displaces the trace nodes of @p undeformed by @p u [length], and with
    /// them the control points of all maps and the normals. Numbers, edges and
    /// hanging nodes are kept; locations are those of the undeformed body.
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
      /// Bases of the grid of nodes, and of the traces; static lifetime.
      const GaussLobattoBasis *grid_s = nullptr, *grid_t = nullptr,
                              *trace_s = nullptr, *trace_t = nullptr;
      /// Bounding ball of the facet [length], the coarse test of
      /// intersect_facet(), and the outward unit normal at its center.
      dealii::Point<3>     center;
      double               radius = 0.;
      dealii::Tensor<1, 3> normal;
      /// Numbers of its trace nodes, the first coordinate running fastest.
      std::vector<unsigned int> trace_nodes;
      /// Numbers of its grid nodes in grid_nodes(), the first coordinate
      /// running fastest, and in SurfaceTopology.
      std::vector<unsigned int> grid_nodes, nodes_of_body;
      /// Existence of an adjacent facet, and of an end of the body, beyond the
      /// sides s = 0, s = 1, t = 0 and t = 1.
      std::array<bool, 4> has_neighbor{}, at_body_end{};
      /// True for a plane parallelogram whose nodes all have its normal. E_n =
      /// n.n : C : n.n of the ply at the center [force/length^2], and the depth
      /// of the cell below [length].
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

    /// Returns the unit normal at @p place, +- d_s x d_t normalized.
    dealii::Tensor<1, 3>
    outward_normal(const Facet &facet, const Place &place) const;

    /// Returns the continuous unit normal at @p st, n ~ sum_i L_i(s, t) n_i,
    /// with the node normals n_i in the Gauss-Lobatto basis of the facet grid.
    dealii::Tensor<1, 3>
    smooth_normal(const Facet &facet, const dealii::Point<2> &st) const;

    /// A grid node, common to facets that join smoothly; at a sharp edge there
    /// is one for each side. @p normal is the unit n_i.
    struct GridNode
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> normal;
    };

    /// Returns the nodes of weighted gaps: each mortar row belongs to one.
    const std::vector<GridNode> &
    grid_nodes() const
    {
      return nodes;
    }

    /// Returns the location of grid node @p node in the body.
    Location
    grid_location(const unsigned int node) const;

    using HangingNode = SurfaceTopology::HangingNode;

    /// Returns the hanging nodes by numbers of grid_nodes(); nodes that others
    /// hang on come after them. No node hangs on ends across a sharp edge.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Sets @p values to the trace functions of @p facet at @p st, in the order
    /// of trace_nodes: tensor products of Gauss-Lobatto bases, so that u is the
    /// sum of @p values times u at the trace nodes.
    void
    evaluate_trace(const Facet            &facet,
                   const dealii::Point<2> &st,
                   std::vector<double>    &values) const;

    /// Returns the number of trace nodes; shared ones count once.
    unsigned int
    n_trace_nodes() const
    {
      return trace_locations.size();
    }

    /// Returns the location of trace node @p node on the first facet with it.
    Location
    trace_location(const unsigned int node) const;

    /// A point on a facet, given by its number.
    struct FacetPoint
    {
      unsigned int     facet = 0;
      dealii::Point<2> st;
    };

    /// Returns the point of the surface at @p location, on the facet whose
    /// normal is closest to @p normal. Empty if on none.
    std::optional<FacetPoint>
    place_of(const Location             &location,
             const dealii::Tensor<1, 3> &normal) const;

    /// Returns the intersection of the line x + t d with one @p facet, with d
    /// against its outward normal. Newton's method on the two components of
    /// X(s, t)
    /// - x normal to d, from the center; an affine facet takes one step. Empty
    /// if the line misses the bounding ball, if the iteration leaves the facet
    /// far behind, or if d does not enter by both normals.
    std::optional<SurfaceHit>
    intersect_facet(const unsigned int          facet,
                    const dealii::Point<3>     &x,
                    const dealii::Tensor<1, 3> &d) const;

    /// Returns the nearest intersection with the @p facets, at most @p
    /// search_radius away in either direction.
    std::optional<SurfaceHit>
    intersect_facets(const std::vector<unsigned int> &facets,
                     const dealii::Point<3>          &x,
                     const dealii::Tensor<1, 3>      &d,
                     const double                     search_radius) const;

    /// Returns the nearest intersection, by the boxes that meet the segment x
    /// +- @p search_radius d.
    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                search_radius) const override;

    /// Returns the normal at the center of the nearest facet.
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

    /// Returns the facets whose boxes meet the bounding box of @p points,
    /// ascending: a superset of the facets within their convex hull.
    std::vector<unsigned int>
    facets_near(const std::vector<dealii::Point<3>> &points) const;

  private:
    /// Adds a facet; its trace nodes keep the numbers of the body.
    void
    make_facet(const SurfaceTopology::Facet &from);
    /// Sets the bounding ball of the facet from its map.
    void
    measure(Facet &facet) const;
    /// Finds the adjacent facets and the ends of the body.
    void
    find_neighbors();
    /// Numbers the grid nodes, separately on the sides of edges sharper than 45
    /// degrees, and finds those that hang.
    void
    split_at_edges(const SurfaceTopology &topology);
    /// Returns the grid node among @p numbers, of one node, near @p normal.
    std::optional<unsigned int>
    on_side(const std::vector<unsigned int> &numbers,
            const dealii::Tensor<1, 3>      &normal) const;
    /// Adopts the hanging nodes of the body, whose numbers here are @p sides.
    void
    find_hanging_nodes(const SurfaceTopology                        &topology,
                       const std::vector<std::vector<unsigned int>> &sides);
    /// Sets the n_i, for hanging nodes the mean of their ends, and is_flat.
    void
    average_normals();
    /// Creates the boxes of the facets in axes along the first one.
    void
    make_search();
    /// Returns @p x in the axes of the boxes.
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

  /// A subset of the facets of a surface as a master surface. Refers to both;
  /// normal_near() uses the whole surface.
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
