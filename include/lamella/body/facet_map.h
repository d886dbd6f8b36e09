// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_facet_map_h
#define lamella_body_facet_map_h

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/body.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * The map X(s, t) of a facet of a body, kept as polynomials, so that the
   * millions of points that contact and loads ask for need not ask the body:
   *   X(s, t) = sum_ij L_i(s) L_j(t) X_ij
   * in the Gauss-Lobatto points of the trace's degrees, along s and along t of
   * degree 1 where the facet is straight that way. Most facets are plane
   * parallelograms, X = X_00 + s d_s + t d_t.
   *
   * L_i are the Lagrange polynomials of GaussLobattoBasis on [0, 1], X_ij the
   * positions of the facet's nodes. The trace's degrees make this exact but for
   * rounding: on a side of a cell the geometry is such a polynomial.
   *
   * A surface integral over the facet is
   *   int f dA = int_0^1 int_0^1 f(X(s, t)) |d_s x d_t| ds dt,
   * with d_s = dX/ds and d_t = dX/dt, which operator() gives together.
   *
   * Positions are those of the undeformed scene, unless the map is that of a
   * facet that has moved(). Refers to nothing but tables
   * of the program, so maps can be copied and outlive their body; cheap to
   * keep, one point a node.
   */
  class FacetMap
  {
  public:
    /// A point and the derivatives of the map there, scene axes. The latter are
    /// lengths, since s and t have no unit.
    struct Place
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> d_s, d_t;
    };

    /// @p facet is one of @p body, which is not needed any more afterwards. It
    /// is asked for the nodes and, for the sign of the normal, the middle.
    FacetMap(const Body &body, const SurfaceFacet &facet);

    /// The map with the @p control_points of the degrees @p degree_s and
    /// @p degree_t, as control_points() and degrees() of another one say them;
    /// its outward() is d_s x d_t.
    FacetMap(const unsigned int                   degree_s,
             const unsigned int                   degree_t,
             const std::vector<dealii::Point<3>> &control_points);

    /// The map of the same facet when its trace nodes, the Gauss-Lobatto grid
    /// of the degrees @p degree_s and @p degree_t (the first coordinate running
    /// fastest), have moved by @p u [length]: X(s, t) + sum_ij L_i L_j u_ij.
    /// The degrees are those of the facet's trace; the side that is outwards
    /// stays the same.
    FacetMap
    moved(const unsigned int                       degree_s,
          const unsigned int                       degree_t,
          const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// The place of (s, t) = @p st, also a little outside of [0, 1]^2, where
    /// the polynomials go on.
    Place
    operator()(const dealii::Point<2> &st) const;

    /// The second derivatives of the map [length], zero of an affine one.
    struct Curvature
    {
      dealii::Tensor<1, 3> d_ss, d_st, d_tt;
    };

    /// Those at (s, t) = @p st.
    Curvature
    curvature(const dealii::Point<2> &st) const;

    /// Whether the facet is a plane parallelogram under an affine map: normal
    /// and area per unit of the square are then constant, and points have their
    /// (s, t) without iteration. To 1e-12 of its size.
    bool
    is_affine() const
    {
      return affine;
    }

    /// Whether each of its parameter lines is straight: a bilinear facet, plane
    /// or twisted, which its four corners tell.
    bool
    is_straight() const
    {
      return nodes.size() == 4;
    }

    /// The outward normal times the area per unit of the square,
    /// +- d_s x d_t, at @p place of this map. The sign is that of the whole
    /// facet.
    dealii::Tensor<1, 3>
    outward(const Place &place) const
    {
      return orientation * cross_product_3d(place.d_s, place.d_t);
    }

    /// The X_ij, the first index running fastest: 2 along a straight direction,
    /// else the trace's degree + 1. Four of them are the corners in the order
    /// of SurfaceFacet::corners.
    const std::vector<dealii::Point<3>> &
    control_points() const
    {
      return nodes;
    }

    /// Those of the control points, along s and along t.
    std::array<unsigned int, 2>
    degrees() const
    {
      return {{along_s->size() - 1, along_t->size() - 1}};
    }

  private:
    /// Keeps of the grid @p x of the bases @p s and @p t what the map needs:
    /// two points along a direction in which it is straight.
    void
    keep(const GaussLobattoBasis             &s,
         const GaussLobattoBasis             &t,
         const std::vector<dealii::Point<3>> &x);

    /// The polynomials in s and in t, which live as long as the program.
    const GaussLobattoBasis      *along_s, *along_t;
    std::vector<dealii::Point<3>> nodes;
    /// The corner (0, 0) and the edges from there to (1, 0) and (0, 1): all
    /// that an affine map needs.
    Place origin;
    bool  affine = false;
    /// 1 if d_s x d_t points out of the body, else -1.
    double orientation = 1.;
  };
} // namespace lamella

#endif
