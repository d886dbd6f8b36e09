// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/body/guided_obstacle.h>
#include <lamella/body/second_order.h>
#include <lamella/body/surface_topology.h>
#include <lamella/material/layup.h>
#include <lamella/shape/section_mesh.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // A rigid translation has no second-order effects.
    class NoSecondOrder : public SecondOrder
    {
    public:
      void
      add_load(Vector &) const override
      {}
      double
      solve(const Vector &) override
      {
        return 0.;
      }
      void
      add_geometric_forces(const Vector &, Vector &) const override
      {}
      double
      largest_short_wave_ratio() const override
      {
        return 0.;
      }
    };
  } // namespace



  GuidedObstacle::GuidedObstacle(const std::string  &name,
                                 const Tensor<1, 3> &guide,
                                 const Body         &pressed)
    : Body(name)
    , guide(guide)
    , pressed(pressed)
  {}



  std::string
  GuidedObstacle::theory() const
  {
    return "rigid obstacle, guided along " + to_text(guide);
  }



  DofIndex
  GuidedObstacle::n_dofs() const
  {
    return 1;
  }



  bool
  GuidedObstacle::is_nodal() const
  {
    return true;
  }



  IndexSet
  GuidedObstacle::owned_dofs() const
  {
    IndexSet owned(1);
    if (is_root_process())
      owned.add_index(0);
    return owned;
  }



  Point<3>
  GuidedObstacle::dof_position(const DofIndex) const
  {
    return center();
  }



  std::vector<Vector>
  GuidedObstacle::rigid_motions() const
  {
    std::vector<Vector> motions(6, Vector(1));
    for (unsigned int c = 0; c < 3; ++c)
      motions[c][0] = guide[c];
    return motions;
  }



  BoundingBox<3>
  GuidedObstacle::bounding_box() const
  {
    return pressed.bounding_box();
  }



  void
  GuidedObstacle::add_internal_forces(const Vector &, Vector &) const
  {}



  std::unique_ptr<SecondOrder>
  GuidedObstacle::second_order(const Vector &) const
  {
    return std::make_unique<NoSecondOrder>();
  }



  const std::vector<Ply> &
  GuidedObstacle::plies() const
  {
    static const std::vector<Ply> none;
    return none;
  }



  std::vector<std::vector<Location>>
  GuidedObstacle::locate(const std::vector<Point<3>> &points) const
  {
    std::vector<std::vector<Location>> found;
    for (const Point<3> &point : points)
      found.push_back({{point, 0, {{0, Point<3>()}}}});
    return found;
  }



  std::vector<std::vector<LinearFunctional>>
  GuidedObstacle::rows(const std::vector<Location> &locations,
                       const Quantity               quantity,
                       const Frame) const
  {
    std::vector<LinearFunctional> one(quantity == Quantity::displacement ? 3 :
                                                                           6);
    for (unsigned int c = 0; c < 3 && one.size() == 3; ++c)
      one[c].add(0, guide[c]);
    return {locations.size(), one};
  }



  Point<3>
  GuidedObstacle::position(const Location::Place &) const
  {
    return center();
  }



  PlyAndAxes
  GuidedObstacle::ply_at(const Location::Place &) const
  {
    return {};
  }



  std::vector<std::string>
  GuidedObstacle::surfaces() const
  {
    return {};
  }



  SurfaceTopology
  GuidedObstacle::surface_topology(const std::string &) const
  {
    return {};
  }



  SurfacePoint
  GuidedObstacle::surface_point(const SurfaceFacet &, const Point<2> &) const
  {
    return {};
  }



  Cells
  GuidedObstacle::cells() const
  {
    return {};
  }



  std::unique_ptr<LinearSolver>
  GuidedObstacle::solver_of(const StiffnessTerms &terms,
                            const Constraints    &constraints,
                            const SolverKind,
                            const SolverMonitor &monitor) const
  {
    return Body::solver_of(terms, constraints, SolverKind::automatic, monitor);
  }



  void
  GuidedObstacle::for_each_stiffness_block(
    const bool,
    const std::function<void(const StiffnessBlock &)> &) const
  {}
} // namespace lamella
