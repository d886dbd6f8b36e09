// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/processes.h>
#include <lamella/body/body.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/cell_grid.h>
#include <lamella/body/fields.h>
#include <lamella/body/surface_topology.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <set>

namespace lamella
{
  using namespace dealii;

  Body::Body(std::string name, const Placement &placement)
    : placement(placement)
    , body_name(std::move(name))
  {}



  Body::~Body() = default;



  const Constraints &
  Body::kinematic_constraints() const
  {
    static const Constraints none = [] {
      Constraints empty;
      empty.close();
      return empty;
    }();
    return none;
  }



  Point<3>
  Body::center() const
  {
    return bounding_box().center();
  }



  double
  Body::size() const
  {
    const BoundingBox<3> box = bounding_box();
    return 0.5 *
           std::max(
             {box.side_length(0), box.side_length(1), box.side_length(2)});
  }



  namespace
  {
    [[noreturn]] void
    refuse_material(const Ply         &ply,
                    const std::string &property,
                    const Body        &body,
                    const std::string &what_asks_for_it,
                    const std::string &remedy)
    {
      throw InputError("Material " + ply.material,
                       "",
                       "body.material-property-missing: the material has no " +
                         property + ", and body '" + body.name() +
                         "', which consists of this material, " +
                         what_asks_for_it,
                       remedy);
    }
  } // namespace



  void
  Body::heat(const ScalarField &change)
  {
    for (const Ply &ply : plies())
      if (!ply.properties.expansion)
        refuse_material(ply,
                        "Thermal expansion",
                        *this,
                        "has a Temperature",
                        "Write it, or remove the body from the load.");
    temperature_change = change;
  }



  std::vector<double>
  densities(const Body &body)
  {
    std::vector<double> rho;
    for (const Ply &ply : body.plies())
      {
        if (!ply.properties.density)
          refuse_material(
            ply,
            "Density",
            body,
            "needs it for Gravity or Find = modes",
            "Write it (0 if its mass does not count), or leave these out.");
        rho.push_back(*ply.properties.density);
      }
    return rho;
  }



  bool
  have_densities(const Bodies &bodies)
  {
    for (const auto &body : bodies)
      for (const Ply &ply : body->plies())
        if (!ply.properties.density)
          return false;
    return true;
  }



  void
  Body::add_internal_forces(const Vector &u, Vector &f) const
  {
    add_product_of_blocks(
      [&](const auto &use) {
        for_each_stiffness_block(undisplaced, undisplaced, true, use);
      },
      u,
      f);
  }



  void
  Body::add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const
  {
    if (!has_finite_rotations())
      return add_internal_forces(w, f);
    add_product_of_blocks(
      [&](const auto &use) {
        for_each_stiffness_block(u, Vector(u.size()), true, use);
      },
      w,
      f);
  }



  double
  Body::stiffness_entries() const
  {
    double n = 0.;
    for_each_stiffness_block(
      undisplaced, undisplaced, false, [&n](const StiffnessBlock &block) {
        n += double(block.rows.size()) * block.columns.size();
      });
    return dealii::Utilities::MPI::sum(n, communicator());
  }



  namespace
  {
    /// Adds the integrals of the nodal functions over @p facet.
    void
    add_areas(const Body                   &body,
              const SurfaceTopology::Facet &facet,
              std::vector<SurfaceNode>     &nodes)
    {
      const unsigned int  degree = std::max({facet.side.degree_s,
                                             facet.side.degree_t,
                                             facet.side.trace_degree_s,
                                             facet.side.trace_degree_t});
      const auto          basis  = GaussLobattoBasis::of_degree;
      const QGauss<2>     gauss(degree + 2);
      std::vector<double> N;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const SurfacePoint at =
            body.surface_point(facet.side, gauss.point(q));
          evaluate_on_grid(basis(facet.side.degree_s),
                           basis(facet.side.degree_t),
                           gauss.point(q),
                           N);
          for (unsigned int k = 0; k < N.size(); ++k)
            nodes[facet.grid[k]].add(N[k] * gauss.weight(q) * at.area,
                                     at.normal);
        }
    }
  } // namespace



  std::vector<SurfacePoint>
  Body::surface_points(const std::string &surface) const
  {
    const auto               basis    = GaussLobattoBasis::of_degree;
    const SurfaceTopology    topology = surface_topology(surface);
    std::vector<SurfaceNode> nodes(topology.n_grid);
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet         &side = facet.side;
        const std::vector<Point<2>> grid =
          grid_points(basis(side.degree_s), basis(side.degree_t));
        for (unsigned int k = 0; k < grid.size(); ++k)
          nodes[facet.grid[k]].meet(surface_point(side, grid[k]));
        add_areas(*this, facet, nodes);
      }
    for (const auto &[node, ends] : topology.hanging)
      nodes[node].distribute_to_ends(nodes[ends[0]], nodes[ends[1]]);

    std::vector<SurfacePoint> points;
    for (const SurfaceNode &node : nodes)
      if (node.has_point())
        points.push_back(node.finished());
    return points;
  }



  std::vector<Location>
  Body::constraint_points(const std::string &surface) const
  {
    const SurfaceTopology  topology = surface_topology(surface);
    std::set<unsigned int> hanging, seen;
    for (const SurfaceTopology::HangingNode &node : topology.hanging)
      hanging.insert(node.node);
    std::vector<Location> locations;
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet &side    = facet.side;
        const bool          is_grid = facet.grid.size() == facet.trace.size();
        const std::vector<Point<2>> trace =
          grid_points(GaussLobattoBasis::of_degree(side.trace_degree_s),
                      GaussLobattoBasis::of_degree(side.trace_degree_t));
        for (unsigned int k = 0; k < trace.size(); ++k)
          if (!(is_grid && hanging.count(facet.grid[k]) > 0) &&
              seen.insert(facet.trace[k]).second)
            locations.push_back(surface_point(side, trace[k]).location);
      }
    return locations;
  }



  std::vector<Location>
  Body::body_points() const
  {
    const CellGrid        grid(cells().degrees);
    std::vector<Location> locations;
    for (unsigned int cell = 0; cell < cells().n; ++cell)
      for (const Point<3> &unit : grid.nodes())
        locations.push_back(
          {position({cell, unit}), ply_at({cell, unit}).ply, {{cell, unit}}});
    return locations;
  }



  Placement
  Placement::from_directions(const Point<3>     &origin,
                             const Tensor<1, 3> &axis,
                             const Tensor<1, 3> &up)
  {
    const Tensor<1, 3> across = cross_product_3d(axis, up);
    if (!(across.norm() > arithmetic::parallel_sine * axis.norm() * up.norm()))
      throw InputError(
        "Placement",
        "",
        "body.placement-degenerate: Axis and Up must be neither zero nor "
        "parallel, since they define the directions x and z of the section",
        "Choose Up perpendicular to Axis, as in 0, 0, 1 for Axis = 0, 1, 0.");
    Placement placement;
    placement.origin  = origin;
    placement.axes[0] = across / across.norm();
    placement.axes[1] = axis / axis.norm();
    placement.axes[2] = cross_product_3d(placement.axes[0], placement.axes[1]);
    return placement;
  }
} // namespace lamella
