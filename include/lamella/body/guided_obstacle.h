// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_guided_obstacle_h
#define lamella_body_guided_obstacle_h

#include <lamella/body/body.h>

namespace lamella
{
  /// A rigid obstacle that a given force presses: a body without elements and
  /// without stiffness whose only DoF is its displacement q [length] along a
  /// guide of unit direction d, u = q d. Contact constraints have parts on this
  /// DoF (guided_part()); equilibrium in it is f + sum lambda_k (n_k . d) = 0
  /// with the force f along d and contact forces lambda_k along n_k.
  class GuidedObstacle : public Body
  {
  public:
    /// Creates the obstacle @p name guided along the unit vector @p guide. The
    /// body @p pressed, the first one in contact with it, must outlive this
    /// object; it gives lengths for tolerances.
    GuidedObstacle(const std::string          &name,
                   const dealii::Tensor<1, 3> &guide,
                   const Body                 &pressed);

    std::string
    theory() const override;
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
    owned_dofs() const override;
    DofInfo
    dof(const DofIndex) const override
    {
      return {center()};
    }
    std::vector<Vector>
    rigid_motions(const Vector &) const override;
    /// Returns the bounding box of the pressed body.
    dealii::BoundingBox<3>
    bounding_box() const override
    {
      return pressed.bounding_box();
    }
    std::unique_ptr<SecondOrder>
    second_order(const Vector &) const override;
    const std::vector<Ply> &
    plies() const override;
    /// Returns one location for each point: all points have the displacement u.
    std::vector<std::vector<Location>>
    locate(const std::vector<dealii::Point<3>> &points) const override;
    /// Returns displacements only; strains and stresses have no entries.
    std::vector<std::vector<LinearFunctional>>
    rows(const std::vector<Location> &locations,
         const Vector                &u,
         const Quantity               quantity = Quantity::displacement,
         const Frame                  frame    = Frame::scene) const override;
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
    surface_topology(const std::string &) const override;
    SurfacePoint
    surface_point(const SurfaceFacet &, const dealii::Point<2> &) const override
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
    /// Uses a direct solver also if @p requested is `cg`.
    std::unique_ptr<LinearSolver>
    solver_of(const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested,
              const SolverMonitor  &monitor) const override;

  private:
    const dealii::Tensor<1, 3> guide;
    const Body                &pressed;
  };
} // namespace lamella

#endif
