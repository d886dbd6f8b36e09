// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_bare_body_h
#define lamella_tests_unit_bare_body_h

#include <lamella/body/second_order.h>
#include <lamella/body/surface_topology.h>
#include <lamella/shape/section_mesh.h>

#include <string>
#include <vector>

namespace lamella
{
  /// What a new kind of body has to write and not a function more, each as
  /// another body has it, which must outlive it: all else is what Body makes of
  /// these.
  class BareBody : public Body
  {
  public:
    explicit BareBody(const Body &given)
      : Body(given.name(), given.place())
      , given(given)
    {}

    std::string
    theory() const override
    {
      return given.theory();
    }
    DofIndex
    n_dofs() const override
    {
      return given.n_dofs();
    }
    DofInfo
    dof(const DofIndex dof) const override
    {
      return {given.dof(dof).position};
    }
    std::vector<Vector>
    rigid_motions(const Vector &u) const override
    {
      return given.rigid_motions(u);
    }
    std::unique_ptr<SecondOrder>
    second_order(const Vector &u) const override
    {
      return given.second_order(u);
    }
    const std::vector<Ply> &
    plies() const override
    {
      return given.plies();
    }
    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override
    {
      return given.locate(points);
    }
    std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Vector                &u,
         const Quantity               quantity = Quantity::displacement,
         const Frame                  frame    = Frame::scene) const override
    {
      return given.rows(locations, u, quantity, frame);
    }
    dealii::Point<3>
    position(const Location::Place &place) const override
    {
      return given.position(place);
    }
    PlyAndAxes
    ply_at(const Location::Place &place) const override
    {
      return given.ply_at(place);
    }
    std::vector<std::string>
    surfaces() const override
    {
      return given.surfaces();
    }
    SurfaceTopology
    surface_topology(const std::string &surface) const override
    {
      return given.surface_topology(surface);
    }
    SurfacePoint
    surface_point(const SurfaceFacet     &facet,
                  const dealii::Point<2> &st) const override
    {
      return given.surface_point(facet, st);
    }
    Cells
    cells() const override
    {
      const Cells all = given.cells();
      return {all.n, all.own, all.degrees};
    }
    void
    for_each_stiffness_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override
    {
      given.for_each_stiffness_block(u, correction, with_values, use);
    }

  private:
    const Body &given;
  };
} // namespace lamella

#endif
