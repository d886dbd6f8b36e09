// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/body/body.h>
#include <lamella/body/parameters.h>
#include <lamella/body/second_order.h>
#include <lamella/body/surface_topology.h>
#include <lamella/contact/parameters.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A rigid obstacle that a given force presses: a body without elements and
    /// without stiffness whose only DoF is its displacement q [length] along a
    /// guide of unit direction d, u = q d. Contact constraints have parts on
    /// this DoF (guided_part()); equilibrium in it is f + sum lambda_k (n_k .
    /// d) = 0 with the force f along d and contact forces lambda_k along n_k.
    class GuidedObstacle : public Body
    {
    public:
      /// Creates the obstacle @p name guided along the unit vector @p guide.
      /// The body @p pressed, the first one in contact with it, must outlive
      /// this object; it gives lengths for tolerances.
      GuidedObstacle(const std::string          &name,
                     const dealii::Tensor<1, 3> &guide,
                     const Body                 &pressed)
        : Body(name)
        , guide(guide)
        , pressed(pressed)
      {}

      std::string
      theory() const override
      {
        return "rigid obstacle, guided along " + to_text(guide);
      }

      DofIndex
      n_dofs() const override
      {
        return 1;
      }
      /// Returns true: the DoF is no amplitude of a section function.
      bool
      is_nodal() const override
      {
        return true;
      }
      dealii::IndexSet
      owned_dofs() const override
      {
        IndexSet owned(1);
        if (is_root_process())
          owned.add_index(0);
        return owned;
      }

      DofInfo
      dof(const DofIndex) const override
      {
        return {center()};
      }
      std::vector<Vector>
      rigid_motions(const Vector &) const override
      {
        std::vector<Vector> motions(6, Vector(1));
        for (unsigned int c = 0; c < 3; ++c)
          motions[c][0] = guide[c];
        return motions;
      }

      /// Returns the bounding box of the pressed body.
      dealii::BoundingBox<3>
      bounding_box() const override
      {
        return pressed.bounding_box();
      }
      std::unique_ptr<SecondOrder>
      second_order(const Vector &) const override
      {
        return std::make_unique<SecondOrder>();
      }

      const std::vector<Ply> &
      plies() const override
      {
        static const std::vector<Ply> none;
        return none;
      }

      /// Returns one location for each point: all points have the displacement
      /// u.
      std::vector<std::vector<Location>>
      locate(const std::vector<dealii::Point<3>> &points) const override
      {
        std::vector<std::vector<Location>> found;
        for (const Point<3> &point : points)
          found.push_back({{point, 0, {{0, Point<3>()}}}});
        return found;
      }

      /// Returns displacements only; strains and stresses have no entries.
      std::vector<std::vector<LinearFunctional>>
      rows(const std::vector<Location> &locations,
           const Vector &,
           const Quantity quantity = Quantity::displacement,
           const Frame             = Frame::scene) const override
      {
        std::vector<LinearFunctional> one(
          quantity == Quantity::displacement ? 3 : 6);
        for (unsigned int c = 0; c < 3 && one.size() == 3; ++c)
          one[c].add(0, guide[c]);
        return {locations.size(), one};
      }

      dealii::Point<3>
      position(const Location::Place &) const override
      {
        return center();
      }
      PlyAndAxes
      ply_at(const Location::Place &) const override
      {
        return {};
      }
      std::vector<std::string>
      surfaces() const override
      {
        return {};
      }
      SurfaceTopology
      surface_topology(const std::string &) const override
      {
        return {};
      }

      SurfacePoint
      surface_point(const SurfaceFacet &,
                    const dealii::Point<2> &) const override
      {
        return {};
      }
      Cells
      cells() const override
      {
        return {};
      }
      void
      for_each_stiffness_block(const Vector &,
                               const Vector &,
                               const bool,
                               const BlockCallback &) const override
      {}
      /// Uses a direct solver also for `cg`.
      std::unique_ptr<LinearSolver>
      solver_of(const StiffnessTerms &terms,
                const Constraints    &constraints,
                const SolverKind,
                const SolverMonitor &monitor) const override
      {
        return Body::solver_of(terms,
                               constraints,
                               SolverKind::automatic,
                               monitor);
      }

    private:
      const dealii::Tensor<1, 3> guide;
      const Body                &pressed;
    };



    // The load of the only DoF of the obstacle is |Force|.
    Load
    load_on(const Obstacle &obstacle)
    {
      Load load;
      load.name = "Obstacle " + obstacle.name;
      load.on.resize(1);
      load.on[0].body = *obstacle.body;
      load.on[0].kind = Region::Kind::point;
      load.on[0].at   = {obstacle.point};
      load.history    = obstacle.history;
      for (unsigned int c = 0; c < 3; ++c)
        load.force[c] = obstacle.force[c];
      return load;
    }
  } // namespace



  void
  add_guided_obstacles(const Obstacles                &obstacles,
                       const std::vector<ContactPair> &contacts,
                       Bodies                         &bodies,
                       std::vector<Load>              &loads,
                       std::vector<Stabilization>     &stabilizations)
  {
    for (const auto &obstacle : obstacles)
      {
        if (!obstacle->body)
          continue;
        const auto presses = std::find_if(contacts.begin(),
                                          contacts.end(),
                                          [&](const ContactPair &contact) {
                                            return contact.obstacle == obstacle;
                                          });
        if (presses == contacts.end())
          throw InputError("Obstacle " + obstacle->name + "/Force",
                           to_text(obstacle->force),
                           "contact.force-without-contact: no contact balances "
                           "this force",
                           "Name the obstacle in Second of a Contact.");
        AssertThrow(*obstacle->body == bodies.size(), ExcInternalError());
        const Body &pressed = *bodies[presses->first.body];
        loads.push_back(load_on(*obstacle));
        stabilizations.push_back({stabilization_of_contact, &pressed});
        bodies.push_back(std::make_unique<GuidedObstacle>(obstacle->name,
                                                          obstacle->guide(),
                                                          pressed));
      }
  }
} // namespace lamella
