// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_state_h
#define lamella_solve_friction_state_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /**
   * Friction variables of a state, per gap row, as scene vectors. Empty without
   * friction and before the first load step.
   *
   * Coulomb's law of a step, with the slip s_0 at the end of the previous one:
   *   v = s(u) + a lambda_t - s_0,   |lambda_t| <= mu lambda_n,
   *   v = 0 where |lambda_t| < mu lambda_n,
   *   lambda_t = -mu lambda_n v / |v| where v is not zero.
   * The compliance a (law_compliance()) also acts tangentially.
   */
  struct FrictionState
  {
    /// Tangential force lambda_t on the second side [force].
    std::vector<dealii::Tensor<1, 3>> shear;
    /// Unit vector lambda_t / |lambda_t| of slipping rows; zero for all others.
    std::vector<dealii::Tensor<1, 3>> direction;
    /// Slip s_0 [length], also of open rows.
    std::vector<dealii::Tensor<1, 3>> before;
    /// Accumulated slip length, and dissipated energy: mu (lambda_n,0 +
    /// lambda_n,1) / 2 |v| >= 0 per step, of second order in the step.
    std::vector<double> length, dissipated;
    /// g + a lambda_n [length].
    std::vector<double> contact_gap;
    /// Accumulated defect of the contact work over all rows [energy]: per step
    ///   - mean lambda . (change of (g, s) + a lambda) - dissipated,
    /// with the mean of the forces at both ends. For linear bodies, external
    /// work = strain energy + penalty energy a |lambda|^2 / 2 + dissipation +
    /// this defect, which vanishes as steps get shorter.
    double path_gap = 0.;

    bool
    empty() const
    {
      return shear.empty();
    }

    /// Returns the sum of `dissipated` over all rows.
    double
    all_dissipated() const;

    /// Returns the state of @p rows of undeformed bodies, without forces.
    static FrictionState
    unloaded(const GapConstraints &rows);
  };

  /// End of the message if a solution with friction is unstable or not found.
  constexpr const char *friction_remedy =
    ". Try more Substeps, a smaller step in Load factors, or a softer penalty.";

  /// Throws NumericsError: the solution found is unstable.
  [[noreturn]] void
  throw_unstable();

  /// Converts a vector along the tangents into components, and back.
  dealii::Tensor<1, 2>
  along_tangents(const GapConstraint &row, const dealii::Tensor<1, 3> &vector);
  dealii::Tensor<1, 3>
  in_scene(const GapConstraint &row, const dealii::Tensor<1, 2> &components);

  /// Returns the slip s(u) of @p row at @p factor along its tangents.
  dealii::Tensor<1, 2>
  slip_of(const GapConstraint &row,
          const BlockVector   &u,
          const LoadFactor    &factor);

  /// Adds B^T lambda of @p row, with @p normal and @p shear force, to @p f.
  void
  add_force(const GapConstraint        &row,
            const double                normal,
            const dealii::Tensor<1, 3> &shear,
            BlockVector                &f);
} // namespace lamella

#endif
