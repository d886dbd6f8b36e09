// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_facet_map_h
#define lamella_body_facet_map_h

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/body.h>

#include <array>
#include <vector>

namespace lamella
{
  /// The map X(s, t) from the unit square to a facet of a body surface, as
  /// polynomials for fast evaluation:
  ///   X(s, t) = sum_ij L_i(s) L_j(t) X_ij
  /// with the Lagrange polynomials L_i of GaussLobattoBasis on [0, 1] and the
  /// nodes X_ij of the facet. Degrees are those of the displacement on the
  /// facet, or 1 along straight directions. A surface integral is
  ///   int f dA = int_0^1 int_0^1 f(X(s, t)) |d_s x d_t| ds dt,
  /// with d_s = dX/ds and d_t = dX/dt. Positions are undeformed, except for
  /// moved(). A map does not refer to its body.
  class FacetMap
  {
  public:
    /// A point and the derivatives of the map there, scene axes [length].
    struct Place
    {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> d_s, d_t;
    };

    /// Constructs the map of @p facet of @p body.
    FacetMap(const Body &body, const SurfaceFacet &facet);

    /// Constructs the map of degrees @p degree_s and @p degree_t through nodes
    /// @p control_points; outward() is d_s x d_t.
    FacetMap(const unsigned int                   degree_s,
             const unsigned int                   degree_t,
             const std::vector<dealii::Point<3>> &control_points);

    /// Returns the map X(s, t) + sum_ij L_i L_j u_ij of the facet displaced by
    /// @p u [length] at the Gauss-Lobatto grid of @p degree_s and @p degree_t,
    /// s running fastest. The outward side does not change.
    FacetMap
    moved(const unsigned int                       degree_s,
          const unsigned int                       degree_t,
          const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Returns the point at (s, t) = @p st and the derivatives there.
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

    /// Returns true for a plane parallelogram (tolerance 1e-12 of its size), on
    /// which normal and area are constant.
    bool
    is_affine() const
    {
      return affine;
    }

    /// Returns true if the four corners determine the facet (bilinear map).
    bool
    is_straight() const
    {
      return nodes.size() == 4;
    }

    /// Returns the outward normal times the area per unit of the square, d_s x
    /// d_t or d_t x d_s, at @p place of this map.
    dealii::Tensor<1, 3>
    outward(const Place &place) const
    {
      return orientation * cross_product_3d(place.d_s, place.d_t);
    }

    /// Returns the nodes X_ij, i running fastest.
    const std::vector<dealii::Point<3>> &
    control_points() const
    {
      return nodes;
    }

    /// Returns the degrees of the map along s and t.
    std::array<unsigned int, 2>
    degrees() const
    {
      return {{along_s->size() - 1, along_t->size() - 1}};
    }

  private:
    /// Stores the nodes @p x of the bases @p s and @p t; reduces straight
    /// directions to degree 1.
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
    /// 1 if d_s x d_t points out of the body, otherwise -1.
    double orientation = 1.;
  };
} // namespace lamella

#endif
