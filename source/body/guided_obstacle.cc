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



  IndexSet
  GuidedObstacle::owned_dofs() const
  {
    IndexSet owned(1);
    if (is_root_process())
      owned.add_index(0);
    return owned;
  }



  std::vector<Vector>
  GuidedObstacle::rigid_motions(const Vector &) const
  {
    std::vector<Vector> motions(6, Vector(1));
    for (unsigned int c = 0; c < 3; ++c)
      motions[c][0] = guide[c];
    return motions;
  }



  std::unique_ptr<SecondOrder>
  GuidedObstacle::second_order(const Vector &) const
  {
    return std::make_unique<SecondOrder>();
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
                       const Vector &,
                       const Quantity quantity,
                       const Frame) const
  {
    std::vector<LinearFunctional> one(quantity == Quantity::displacement ? 3 :
                                                                           6);
    for (unsigned int c = 0; c < 3 && one.size() == 3; ++c)
      one[c].add(0, guide[c]);
    return {locations.size(), one};
  }



  SurfaceTopology
  GuidedObstacle::surface_topology(const std::string &) const
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
} // namespace lamella
