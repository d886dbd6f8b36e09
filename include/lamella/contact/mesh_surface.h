// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_mesh_surface_h
#define lamella_contact_mesh_surface_h

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/body.h>
#include <lamella/contact/obstacle.h>
#include <lamella/contact/search.h>

#include <deal.II/base/polynomial.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Where a ray meets a surface, and on which facet if the surface has any;
  /// the normal is that of MeshSurface::smooth_normal().
  struct SurfaceHit : public Hit
  {
    unsigned int     facet = dealii::numbers::invalid_unsigned_int;
    dealii::Point<2> st;
  };

  /// A surface as the points of another one see it, which may come to touch it.
  class OpposingSurface
  {
  public:
    virtual ~OpposingSurface() = default;

    /**
     * The place nearest to @p x, ahead or behind and at most @p reach away,
     * where the line x + t d, d a unit vector, meets the surface with d against
     * its outward normal.
     */
    virtual std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const = 0;

    /// The outward normal somewhere near the point of the surface nearest to
    /// @p x.
    virtual dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const = 0;
  };

  /// Where a point X_1 with the outward normal n_1 faces another surface.
  struct Opposition
  {
    SurfaceHit hit;
    /// n below; the gap is hit.distance.
    dealii::Tensor<1, 3> normal;
    /// Between n_1 and -n_2, in rad.
    double angle = 0.;
  };

  /**
   * The place X_2 of @p other that the point @p x of a surface with the outward
   * normal @p n1 faces: where the line from X_1 along
   *   n = (n_1(X_1) - n_2(X_2)) / |n_1(X_1) - n_2(X_2)|
   * meets it. Both surfaces count alike: from X_2 the place opposite is X_1 and
   * the normal is -n, and of bodies that mirror each other n is the normal of
   * the mirror. A fixed point iteration from n = n_1 finds it (from the normal
   * of a place nearby, if the line along n_1 misses). None if the normals are
   * not opposed to @p opposed, the cosine of the angle between n_1 and -n_2: 60
   * degrees.
   */
  std::optional<Opposition>
  opposing_place(const OpposingSurface      &other,
                 const dealii::Point<3>     &x,
                 const dealii::Tensor<1, 3> &n1,
                 const double                reach,
                 const double                opposed = 0.5);

  /// The surface of a rigid obstacle.
  class ObstacleSurface : public OpposingSurface
  {
  public:
    explicit ObstacleSurface(std::shared_ptr<const Obstacle> obstacle);

    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const override;
    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

  private:
    std::shared_ptr<const Obstacle> obstacle;
  };

  /**
   * A named surface of a body. Each facet keeps its own map X(s, t), as
   * polynomials; rays are met with it as it is, curved or not.
   *
   * Where facets meet smoothly their normals differ by what the interpolation
   * of curves leaves. Contact takes a continuous field: the average normal
   *   n_i ~ sum over facets int L_i n dA
   * at each node i of the facets' Gauss-Lobatto grids, which is what
   * Body::surface_points() says of the nodes, interpolated in between. At edges
   * sharper than 45 degrees each side keeps its own.
   *
   * Displacements of a facet are polynomials, too: their values at its trace
   * nodes, a Gauss-Lobatto grid, fix them. Trace nodes at one place have one
   * number.
   */
  class MeshSurface : public OpposingSurface
  {
  public:
    MeshSurface(const Body &body, const std::string &surface);

    /// A point and the derivatives of the map there.
    struct Place
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> d_s, d_t;
    };

    struct Facet
    {
      SurfaceFacet side;
      /// Bases of the grid of nodes, of the traces, and of the map: as low as
      /// the shape allows.
      const GaussLobattoBasis      *grid_s, *grid_t, *trace_s, *trace_t;
      const GaussLobattoBasis      *map_s, *map_t;
      std::vector<dealii::Point<3>> map_nodes;
      /// Whether the map is affine: position and derivatives, then, at (0, 0).
      bool  is_affine = false;
      Place origin;
      /// +1 if d_s x d_t points outwards, -1 if inwards.
      double orientation = 1.;
      /// A ball around the facet, and the outward normal in the middle.
      dealii::Point<3>     centre;
      double               radius = 0.;
      dealii::Tensor<1, 3> normal;
      /// Numbers of its trace nodes, the first coordinate running fastest.
      std::vector<unsigned int> trace_nodes;
      /// Likewise of the nodes of its grid.
      std::vector<unsigned int> grid_nodes;
      /// Whether all of these have the facet's own normal.
      bool   is_flat        = false;
      double normal_modulus = 0., depth = 0.;
    };

    const Body &
    body() const
    {
      return surface_body;
    }

    const std::vector<Facet> &
    facets() const
    {
      return all_facets;
    }

    /// X and its derivatives at @p st of @p facet.
    Place
    map(const Facet &facet, const dealii::Point<2> &st) const;

    /// The facet's own normal.
    dealii::Tensor<1, 3>
    outward_normal(const Facet &facet, const Place &place) const;

    /// The continuous field of normals.
    dealii::Tensor<1, 3>
    smooth_normal(const Facet &facet, const dealii::Point<2> &st) const;

    /// A node of the grids; nodes of facets that meet smoothly are one.
    struct GridNode
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> normal;
    };

    const std::vector<GridNode> &
    grid_nodes() const
    {
      return nodes;
    }

    /// A node of a grid that lies in the middle of an edge of another facet's
    /// grid, as where a solid is locally refined: functions that are continuous
    /// and linear along that edge have the mean of its @p ends there.
    struct HangingNode
    {
      unsigned int                node = 0;
      std::array<unsigned int, 2> ends{};
    };

    /// Those that others hang on come after them.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// The trace functions of @p facet at @p st, in the order of trace_nodes.
    void
    evaluate_trace(const Facet            &facet,
                   const dealii::Point<2> &st,
                   std::vector<double>    &values) const;

    unsigned int
    n_trace_nodes() const
    {
      return trace_places.size();
    }

    /// Where the trace node @p node lies in the body.
    Location
    trace_location(const unsigned int node) const;

    /// Where the line x + t d meets the one @p facet with d against its outward
    /// normal.
    std::optional<SurfaceHit>
    meet_facet(const unsigned int          facet,
               const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &d) const;

    /// The nearest of the hits of @p facets.
    std::optional<SurfaceHit>
    meet_among(const std::vector<unsigned int> &facets,
               const dealii::Point<3>          &x,
               const dealii::Tensor<1, 3>      &d,
               const double                     reach) const;

    std::optional<SurfaceHit>
    meet(const dealii::Point<3>     &x,
         const dealii::Tensor<1, 3> &d,
         const double                reach) const override;

    dealii::Tensor<1, 3>
    normal_near(const dealii::Point<3> &x) const override;

    /// Facets whose boxes meet the smallest box around @p points.
    std::vector<unsigned int>
    facets_near(const std::vector<dealii::Point<3>> &points) const;

  private:
    void
    make_map(Facet &facet);
    void
    number_trace_nodes(Facet &facet, PointNumbering &numbering);
    void
    number_grid_nodes();
    void
    find_hanging_nodes(const PointNumbering &numbering);
    void
    average_normals();
    void
    make_search();
    dealii::Point<3>
    to_frame(const dealii::Point<3> &x) const;

    const Body        &surface_body;
    std::vector<Facet> all_facets;
    /// Of each trace node a facet and the place on it.
    std::vector<std::pair<unsigned int, dealii::Point<2>>> trace_places;
    std::vector<GridNode>                                  nodes;
    std::vector<HangingNode>                               hanging;
    /// Boxes stand in axes of the surface's own, so that rays along its normals
    /// meet few of them however the body is turned.
    dealii::Tensor<2, 3> frame;
    BoxSearch            boxes;
  };

  /// Some facets of a surface, as an opposing surface.
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
