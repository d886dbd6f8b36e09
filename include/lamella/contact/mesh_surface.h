// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_mesh_surface_h
#define lamella_contact_mesh_surface_h

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/facet_map.h>
#include <lamella/body/surface_topology.h>
#include <lamella/contact/opposing_surface.h>
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
   * A named surface of a body, undeformed or where displacements have moved it.
   * Each facet keeps its own map X(s, t)
   * (FacetMap); rays are met with it as it is, curved or not.
   *
   * Where facets meet smoothly their normals differ by what the interpolation
   * of curves leaves. Contact takes a continuous field: the average normal
   *   n_i ~ sum over facets int L_i n dA
   * at each node i of the facets' Gauss-Lobatto grids, which is what
   * Body::surface_points() says of the nodes, interpolated in between. At edges
   * sharper than 45 degrees each side keeps its own.
   *
   * Displacements of a facet are polynomials, too: their values at its trace
   * nodes, a Gauss-Lobatto grid, fix them. What nodes facets share, and which
   * hang, the body says (SurfaceTopology).
   *
   * The facets and their normals are made once, with a box tree over the
   * facets; after that the body is asked for locations only, but it is referred
   * to and has to live longer. Scene axes.
   */
  class MeshSurface : public OpposingSurface
  {
  public:
    /// @p surface is one of Body::surfaces() and has facets: check_surface()
    /// before.
    MeshSurface(const Body &body, const std::string &surface);

    /// @p undeformed when its trace nodes have moved by @p u [length], scene
    /// axes: the control points of all maps with them, and the normals. What
    /// belongs together stays: numbers of facets and nodes, what is an edge,
    /// what hangs; and locations are those of the undeformed body.
    MeshSurface(const MeshSurface                       &undeformed,
                const std::vector<dealii::Tensor<1, 3>> &u);

    using Place = FacetMap::Place;

    /// One side of one cell: a patch of the surface with what contact needs to
    /// know of it, so that no virtual function of the body is called at its
    /// points.
    struct Facet
    {
      Facet(const SurfaceFacet &side, const FacetMap &map)
        : side(side)
        , map(map)
      {}

      SurfaceFacet side;
      FacetMap     map;
      /// Bases of the grid of nodes, and of the traces. They belong to the
      /// program and never end.
      const GaussLobattoBasis *grid_s = nullptr, *grid_t = nullptr,
                              *trace_s = nullptr, *trace_t = nullptr;
      /// A ball around the facet [length], the coarse test of meet_facet(), and
      /// the facet's own unit normal, outwards, in the middle (s, t) = (0.5,
      /// 0.5).
      dealii::Point<3>     centre;
      double               radius = 0.;
      dealii::Tensor<1, 3> normal;
      /// Numbers of its trace nodes, below n_trace_nodes(), the first
      /// coordinate running fastest.
      std::vector<unsigned int> trace_nodes;
      /// Likewise of the nodes of its grid, numbers in grid_nodes(); and what
      /// SurfaceTopology calls them, one number on all sides of an edge.
      std::vector<unsigned int> grid_nodes, nodes_of_body;
      /// Whether another facet goes on beyond each of its sides s = 0, s = 1, t
      /// = 0 and t = 1, and whether the body starts or ends there.
      std::array<bool, 4> goes_on{}, body_ends{};
      /// Whether the facet is a plane parallelogram and all of its nodes have
      /// its own normal, so that smooth_normal() is that one. Then E_n = n.n :
      /// C : n.n of the ply in the middle [force/length^2], and the depth of
      /// the cell below [length].
      bool   is_flat        = false;
      double normal_modulus = 0., depth = 0.;
    };

    const Body &
    body() const
    {
      return surface_body;
    }

    /// In the body's order; numbers of facets are places in here.
    const std::vector<Facet> &
    facets() const
    {
      return all_facets;
    }

    /// The unit normal of the facet's own map at @p place, +- d_s x d_t
    /// normalised.
    dealii::Tensor<1, 3>
    outward_normal(const Facet &facet, const Place &place) const;

    /// The continuous field of normals at @p st, a unit vector: the node
    /// normals
    ///   n ~ sum_i L_i(s, t) n_i
    /// in the Gauss-Lobatto basis of the facet's grid.
    dealii::Tensor<1, 3>
    smooth_normal(const Facet &facet, const dealii::Point<2> &st) const;

    /// A node of the grids; nodes of facets that meet smoothly are one. At a
    /// sharp edge there is one for each side, at the same place. Scene axes;
    /// @p normal is n_i above, of length 1.
    struct GridNode
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> normal;
    };

    /// The carriers of weighted gaps: row i of a mortar contact belongs to one.
    const std::vector<GridNode> &
    grid_nodes() const
    {
      return nodes;
    }

    /// Where the node @p node of the grids lies in the body.
    Location
    grid_location(const unsigned int node) const;

    using HangingNode = SurfaceTopology::HangingNode;

    /// Those that others hang on come after them. Numbers are those of
    /// grid_nodes(). A node whose ends lie on the other side of a sharp edge
    /// does not hang.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// The trace functions of @p facet at @p st, in the order of trace_nodes.
    /// They are the tensor products of the Gauss-Lobatto bases of the trace's
    /// degrees: u on the facet is the sum of @p values times u at the trace
    /// nodes. @p values is cleared first.
    void
    evaluate_trace(const Facet            &facet,
                   const dealii::Point<2> &st,
                   std::vector<double>    &values) const;

    /// Those that facets share count once.
    unsigned int
    n_trace_nodes() const
    {
      return trace_places.size();
    }

    /// Where the trace node @p node lies in the body. On the first facet that
    /// has it. What body().rows() takes.
    Location
    trace_location(const unsigned int node) const;

    /// A place on a facet, by its number.
    struct FacetPlace
    {
      unsigned int     facet = 0;
      dealii::Point<2> st;
    };

    /// Where @p location, one of body().surface_points() or a place of a facet,
    /// is on the surface: of the facets that have it the one whose normal is
    /// most like @p normal. None if it is on none of them.
    std::optional<FacetPlace>
    place_of(const Location             &location,
             const dealii::Tensor<1, 3> &normal) const;

    /**
     * Where the line x + t d meets the one @p facet with d against its outward
     * normal.
     * Newton's method on the two components of X(s, t) - x across d, from the
     * middle of the facet; an affine facet takes one step. Nothing if the line
     * misses the facet's ball, if the iteration leaves the facet far behind, or
     * where d does not enter through both the facet's own and the smooth
     * normal.
     */
    std::optional<SurfaceHit>
    meet_facet(const unsigned int          facet,
               const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &d) const;

    /// The nearest of the hits of @p facets, numbers in facets(), at most
    /// @p reach away: by the size of the distance, ahead or behind.
    std::optional<SurfaceHit>
    meet_among(const std::vector<unsigned int> &facets,
               const dealii::Point<3>          &x,
               const dealii::Tensor<1, 3>      &d,
               const double                     reach) const;

    /// Only the facets whose boxes meet the box of the segment x +- reach d are
    /// tried. @p reach must be finite.
    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const override;

    /// The normal in the middle of the facet whose box is nearest to @p x.
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

    /// Facets whose boxes meet the smallest box around @p points. Boxes in the
    /// surface's own axes; ascending numbers. A safe superset of the facets
    /// that come into the convex hull of @p points.
    std::vector<unsigned int>
    facets_near(const std::vector<dealii::Point<3>> &points) const;

  private:
    /// Adds a facet; its trace nodes keep the numbers of the body.
    void
    make_facet(const SurfaceTopology::Facet &from);
    /// Sets the ball around the facet from its map.
    void
    measure(Facet &facet) const;
    /// Sets what goes on beyond the sides of facets, and where the body ends.
    void
    find_neighbours();
    /// Numbers the grid nodes, apart on the sides of edges sharper than 45
    /// degrees, and finds those that hang.
    void
    split_at_edges(const SurfaceTopology &topology);
    /// Of the grid nodes @p numbers, those of one node of the body, the one
    /// whose normal is like @p normal.
    std::optional<unsigned int>
    on_side(const std::vector<unsigned int> &numbers,
            const dealii::Tensor<1, 3>      &normal) const;
    /// Carries over those of the body, whose numbers here are @p sides.
    void
    find_hanging_nodes(const SurfaceTopology                        &topology,
                       const std::vector<std::vector<unsigned int>> &sides);
    /// Sets the n_i, those of hanging nodes as the mean of their ends, and
    /// is_flat.
    void
    average_normals();
    /// The boxes of the facets in axes along the first one.
    void
    make_search();
    /// @p x in the axes of the boxes.
    dealii::Point<3>
    to_frame(const dealii::Point<3> &x) const;

    const Body        &surface_body;
    std::vector<Facet> all_facets;
    /// Of each trace node a facet and the place on it.
    std::vector<std::pair<unsigned int, dealii::Point<2>>> trace_places;
    /// Likewise of each node of the grids.
    std::vector<std::pair<unsigned int, dealii::Point<2>>> grid_places;
    std::vector<GridNode>                                  nodes;
    std::vector<HangingNode>                               hanging;
    /// Boxes stand in axes of the surface's own, so that rays along its normals
    /// meet few of them however the body is turned.
    dealii::Tensor<2, 3> frame;
    BoxSearch            boxes;
  };

  /// Some facets of a surface, as an opposing surface: where a point is known
  /// to face one of a few. Refers to the surface and to the list, which have to
  /// live longer; normal_near() is that of the whole surface.
  class SurfacePart : public OpposingSurface
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
         const double                reach) const override
    {
      return whole.meet_among(facets, x, d, reach);
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
