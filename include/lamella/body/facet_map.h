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
  /// with d_s = dX/ds and d_t = dX/dt. X is the undeformed facet, or the
  /// deformed facet in a map from moved(). The body need not outlive the map.
  class FacetMap
  {
  public:
    /// A point X(s, t) of a facet and the tangent vectors there.
    struct Place
    {
      dealii::Point<3>     position; ///< Position X, scene axes.
      dealii::Tensor<1, 3> d_s,      ///< Tangent vector dX/ds [length].
        d_t;                         ///< Tangent vector dX/dt [length].
    };

    /// Constructs the map of the undeformed facet @p facet of @p body.
    FacetMap(const Body &body, const SurfaceFacet &facet);

    /// Constructs the map of degrees @p degree_s and @p degree_t through the
    /// nodes @p control_points, s running fastest; its normal is dX/ds x dX/dt.
    FacetMap(const unsigned int                   degree_s,
             const unsigned int                   degree_t,
             const std::vector<dealii::Point<3>> &control_points);

    /// Returns the map of the deformed facet. @p u are the displacements
    /// [length] at the Gauss-Lobatto grid of @p degree_s and @p degree_t, s
    /// running fastest. The outward side does not change.
    FacetMap
    moved(const unsigned int                       degree_s,
          const unsigned int                       degree_t,
          const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Returns the point and the tangents of the facet at (s, t) = @p st.
    Place
    operator()(const dealii::Point<2> &st) const;

    /// Second derivatives of the map X(s, t), zero if it is affine.
    struct Curvature
    {
      dealii::Tensor<1, 3> d_ss, ///< d^2 X / ds^2 [length].
        d_st,                    ///< d^2 X / (ds dt) [length].
        d_tt;                    ///< d^2 X / dt^2 [length].
    };

    /// Returns the second derivatives of the map X(s, t) at (s, t) = @p st.
    Curvature
    curvature(const dealii::Point<2> &st) const;

    /// Returns true if the facet is a plane parallelogram (tolerance 1e-12 of
    /// its size), which has constant normal and Jacobian.
    bool
    is_affine() const
    {
      return affine;
    }

    /// Returns true if the map is bilinear, given by four corners.
    bool
    is_straight() const
    {
      return nodes.size() == 4;
    }

    /// Returns the outward normal at @p place, a point of this map, times the
    /// area per unit area of the square (s, t): dX/ds x dX/dt or its opposite.
    dealii::Tensor<1, 3>
    outward(const Place &place) const
    {
      return orientation * cross_product_3d(place.d_s, place.d_t);
    }

    /// Returns the nodes X_ij of the map, the index i along s running fastest.
    const std::vector<dealii::Point<3>> &
    control_points() const
    {
      return nodes;
    }

    /// Returns the polynomial degrees of the map along s and t.
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

    /// Lagrange polynomials in s and in t, static tables.
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
