// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_state_h
#define lamella_solve_friction_state_h

#include <lamella/contact/gap_constraints.h>

#include <map>
#include <utility>
#include <vector>

namespace lamella
{
  /// History of contact with friction at a material point of a slave surface.
  /// It stays with the point when surfaces are paired anew.
  struct FrictionHistory
  {
    /// Undeformed position of the point in scene axes, known if it is dropped.
    dealii::Point<3> position;
    /// True if the point had a constraint, but has none in the present pairing.
    bool is_dropped = false;
    /// Normal force at the start of the load step.
    double force = 0.;
    /// Shear force along both tangents at the start of the load step.
    dealii::Tensor<1, 2> shear;
    /// Gap plus compliance times normal force at the start of the load step.
    double gap = 0.;
    /// Slip length in the load step up to the last pairing in which the point
    /// had a constraint [length].
    double slid = 0.;
    /// Slip length, summed over all load steps.
    double length = 0.;
    /// Energy dissipated in all load steps: per step, friction coefficient
    /// times slip length times mean normal force.
    double dissipated = 0.;
  };

  /// Friction variables of an equilibrium state: constraint forces with one
  /// entry per gap constraint, vectors in scene axes, and the history of the
  /// material points. Empty without friction and before the first load step.
  /// Coulomb's law in a load step, with displacements u, slip s, initial slip
  /// s_0, normal force lambda_n, shear force lambda_t, friction coefficient mu:
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
    /// History of each material point that has or had a constraint, by
    /// GapConstraints::material_point().
    std::map<std::pair<unsigned int, unsigned int>, FrictionHistory> history;
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

    /// Returns the energy dissipated by friction, summed over all points.
    double
    all_dissipated() const;
    /// Returns the energy dissipated by friction in the contact @p contact.
    double
    dissipated_in(const unsigned int contact) const;

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
