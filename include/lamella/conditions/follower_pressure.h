// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_follower_pressure_h
#define lamella_conditions_follower_pressure_h

#include <lamella/body/facet_map.h>
#include <lamella/conditions/current_points.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/conditions/load.h>

#include <deal.II/lac/full_matrix.h>

namespace lamella
{
  /// A pressure p(X) per deformed area, opposite to the current outward normal.
  /// The work of p on a virtual displacement v of the surface x(s, t) is
  ///   f . v = -integral p v . (x_,s x x_,t) ds dt,
  /// with material coordinates s, t, integrated by Gauss points of each facet.
  class FollowerPressure : public FollowerLoad
  {
  public:
    /// Evaluates the pressure @p load at Gauss points of @p region on @p body.
    FollowerPressure(const Load &load, const Region &region, const Body &body);
    void
    add_forces(const double factor, const Vector &u, Vector &f) const override;
    void
    add_derivative(const double  factor,
                   const Vector &u,
                   const Vector &w,
                   Vector       &f) const override;
    void
    for_each_stiffness_block(const double         factor,
                             const Vector        &u,
                             const bool           with_values,
                             const BlockCallback &use) const override;

  private:
    /// A Gauss point at (s, t) with p times its weight, the values of the shape
    /// functions on the facet, and their derivatives by s and t.
    struct GaussPoint
    {
      dealii::Point<2>    st;
      double              pressure;
      std::vector<double> value, by_s, by_t;
    };
    /// A facet with its trace nodes, which interpolate the displacement on it.
    struct Facet
    {
      FacetMap                map;
      unsigned int            degree_s, degree_t;
      CurrentPoints           nodes;
      std::vector<GaussPoint> points;

      FacetMap
      moved(const Vector &u) const;
      /// Returns -@p factor times the derivative of the nodal forces by nodal
      /// displacements, at the deformed facet @p at.
      dealii::FullMatrix<double>
      stiffness(const FacetMap &at, const double factor) const;
    };
    /// Evaluates the shape functions on @p facet at @p point.
    static void
    evaluate(const SurfaceFacet &facet, GaussPoint &point);
    /// Returns the nodal forces on @p facet, times @p factor; @p now is the map
    /// of the deformed facet.
    static std::vector<dealii::Tensor<1, 3>>
    forces_on(const Facet &facet, const FacetMap &now, const double factor);
    /// Returns the nodes that determine the displacement of @p facet.
    static std::vector<Location>
    nodes_of(const Body &body, const SurfaceFacet &facet);
    static Facet
    facet_of(const Body         &body,
             const SurfaceFacet &facet,
             const Traction     &traction);

    std::vector<Facet> facets;
  };
} // namespace lamella

#endif
