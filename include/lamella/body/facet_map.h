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
   * The map X(s, t) of a facet of a body as polynomials, for fast evaluation at
   * the many points of contact and loads:
   *   X(s, t) = sum_ij L_i(s) L_j(t) X_ij
   * with the Lagrange polynomials L_i of GaussLobattoBasis on [0, 1] and the
   * facet's nodes X_ij. Degrees are those of the trace, exact up to rounding,
   * or 1 along straight directions. Most facets are plane parallelograms, X =
   * X_00 + s d_s + t d_t. A surface integral is
   *   int f dA = int_0^1 int_0^1 f(X(s, t)) |d_s x d_t| ds dt,
   * with d_s = dX/ds and d_t = dX/dt, which operator() returns as well.
   * Positions are undeformed, except for moved() facets. Maps may outlive their
   * body.
   */
  class FacetMap
  {
  public:
    /// A point and the derivatives of the map there, scene axes [length].
    struct Place
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> d_s, d_t;
    };

    /// Constructs the map of @p facet of @p body from its nodes, and the sign
    /// of the normal from its middle. Does not keep the body.
    FacetMap(const Body &body, const SurfaceFacet &facet);

    /// Constructs a map from control_points() of degrees @p degree_s and @p
    /// degree_t; outward() is d_s x d_t.
    FacetMap(const unsigned int                   degree_s,
             const unsigned int                   degree_t,
             const std::vector<dealii::Point<3>> &control_points);

    /// Returns the map X(s, t) + sum_ij L_i L_j u_ij of the facet whose trace
    /// nodes (the Gauss-Lobatto grid of @p degree_s and @p degree_t, the first
    /// running fastest) have moved by @p u [length]. The outward side is kept.
    FacetMap
    moved(const unsigned int                       degree_s,
          const unsigned int                       degree_t,
          const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Returns the place of (s, t) = @p st, also a little outside of [0, 1]^2.
    Place
    operator()(const dealii::Point<2> &st) const;

    /// Second derivatives of the map [length], zero if it is affine.
    struct Curvature
    {
      dealii::Tensor<1, 3> d_ss, d_st, d_tt;
    };

    /// Returns the second derivatives at (s, t) = @p st.
    Curvature
    curvature(const dealii::Point<2> &st) const;

    /// Returns true for a plane parallelogram, to 1e-12 of its size: normal and
    /// area are constant, and points have their (s, t) without iteration.
    bool
    is_affine() const
    {
      return affine;
    }

    /// Returns true for straight parameter lines: four corners give the facet.
    bool
    is_straight() const
    {
      return nodes.size() == 4;
    }

    /// Returns the outward normal times the area per unit of the square, +- d_s
    /// x d_t with one sign per facet, at @p place of this map.
    dealii::Tensor<1, 3>
    outward(const Place &place) const
    {
      return orientation * cross_product_3d(place.d_s, place.d_t);
    }

    /// Returns the X_ij, the first index running fastest: 2 along a straight
    /// direction, else trace degree + 1.
    const std::vector<dealii::Point<3>> &
    control_points() const
    {
      return nodes;
    }

    /// Returns the degrees of the control points along s and t.
    std::array<unsigned int, 2>
    degrees() const
    {
      return {{along_s->size() - 1, along_t->size() - 1}};
    }

  private:
    /// Stores the grid @p x of the bases, two nodes along straight directions.
    void
    keep(const GaussLobattoBasis             &s,
         const GaussLobattoBasis             &t,
         const std::vector<dealii::Point<3>> &x);

    /// Polynomials in s and in t, static tables.
    const GaussLobattoBasis      *along_s, *along_t;
    std::vector<dealii::Point<3>> nodes;
    /// Corner (0, 0) and edges to (1, 0) and (0, 1), which give an affine map.
    Place origin;
    bool  affine = false;
    /// Sign: 1 if d_s x d_t points out of the body, else -1.
    double orientation = 1.;
  };
} // namespace lamella

#endif
