// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_state_h
#define lamella_solve_friction_state_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Friction variables of an equilibrium state: one entry per gap constraint,
  /// vectors in scene axes. Empty without friction and before the first load
  /// step. Coulomb's law in a load step, with displacements u, slip s, initial
  /// slip s_0, normal force lambda_n, shear force lambda_t, friction
  /// coefficient mu:
  ///   v = s(u) + a lambda_t - s_0,   |lambda_t| <= mu lambda_n,
  ///   v = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v / |v| where v is not zero.
  /// The compliance a of a penalty (law_compliance()) also acts tangentially.
  struct FrictionState
  {
    /// Shear force of each constraint on the second contact side [force].
    std::vector<dealii::Tensor<1, 3>> shear;
    /// Unit vector along the shear force of slipping constraints; else zero.
    std::vector<dealii::Tensor<1, 3>> direction;
    /// Slip of each constraint, active or not, at the start of the load step,
    /// including the elastic slip of a penalty [length].
    std::vector<dealii::Tensor<1, 3>> before;
    /// Slip length of each constraint, summed over all load steps.
    std::vector<double> length;
    /// Energy dissipated by each constraint in all load steps: per step,
    /// friction coefficient times slip length times mean normal force.
    std::vector<double> dissipated;
    /// Gap of each constraint plus compliance times normal force [length].
    std::vector<double> contact_gap;
    /// Error of the energy balance of friction [energy], summed over all
    /// constraints and load steps. With mean forces of the step, each step adds
    ///   - (mean contact force) . (change of gap and slip) - dissipated energy.
    double path_gap = 0.;

    /// Returns true without friction, and before the first load step.
    bool
    empty() const
    {
      return shear.empty();
    }

    /// Returns the energy dissipated by friction, summed over all constraints.
    double
    all_dissipated() const;

    /// Returns the friction variables of the unloaded scene: initial gaps of
    /// the constraints @p rows; zero forces, slips and energies.
    static FrictionState
    unloaded(const GapConstraints &rows);
  };

  /// Last sentence of error messages if a friction solution is not found.
  constexpr const char *friction_remedy =
    ". Try more Substeps, a smaller step in Load factors, or a softer penalty.";

  /// Throws NumericsError: the equilibrium with friction is unstable.
  [[noreturn]] void
  throw_unstable();

  /// Returns the components of @p vector (scene axes) along the two tangents of
  /// the contact constraint @p row; zero if it has no friction.
  dealii::Tensor<1, 2>
  along_tangents(const GapConstraint &row, const dealii::Tensor<1, 3> &vector);
  /// Returns the scene vector with the @p components along the tangents of the
  /// contact constraint @p row.
  dealii::Tensor<1, 3>
  in_scene(const GapConstraint &row, const dealii::Tensor<1, 2> &components);

  /// Returns the slip (relative tangential displacement) of the constraint @p
  /// row at @p u and @p factor, along its two tangents [length].
  dealii::Tensor<1, 2>
  slip_of(const GapConstraint &row,
          const BlockVector   &u,
          const LoadFactor    &factor);

  /// Adds the nodal forces of the contact constraint @p row, for its @p normal
  /// force and @p shear force (scene axes), to the load vector @p f.
  void
  add_force(const GapConstraint        &row,
            const double                normal,
            const dealii::Tensor<1, 3> &shear,
            BlockVector                &f);
} // namespace lamella

#endif
