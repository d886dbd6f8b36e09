// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_state_h
#define lamella_solve_friction_state_h

#include <lamella/contact/gap_constraints.h>

#include <vector>

namespace lamella
{
  /// Friction variables of a state: vectors in scene axes, one per gap
  /// constraint. Empty without friction and before the first load step.
  ///
  /// Coulomb's law in a load step, with the slip s_0 at its beginning:
  ///   v = s(u) + a lambda_t - s_0,   |lambda_t| <= mu lambda_n,
  ///   v = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v / |v| where v is not zero.
  /// The compliance a (law_compliance()) also acts tangentially.
  struct FrictionState
  {
    /// Tangential force lambda_t on the second side [force].
    std::vector<dealii::Tensor<1, 3>> shear;
    /// Unit vector lambda_t / |lambda_t| of slipping constraints; else zero.
    std::vector<dealii::Tensor<1, 3>> direction;
    /// Slip s_0 [length], also of open constraints.
    std::vector<dealii::Tensor<1, 3>> before;
    /// Accumulated slip length, and accumulated dissipated energy. A step adds
    /// mu (lambda_n,0 + lambda_n,1) / 2 |v| >= 0 (forces at its ends).
    std::vector<double> length, dissipated;
    /// Gap including the compliance of the law, g + a lambda_n [length].
    std::vector<double> contact_gap;
    /// Accumulated error of the energy balance of all constraints, per step
    ///   - mean lambda . (change of (g, s) + a lambda) - dissipated,
    /// with the mean of the forces at the beginning and end of the step.
    double path_gap = 0.;

    bool
    empty() const
    {
      return shear.empty();
    }

    /// Returns the energy dissipated by friction in all constraints.
    double
    all_dissipated() const;

    /// Returns the initial variables of @p rows, zero except initial gaps.
    static FrictionState
    unloaded(const GapConstraints &rows);
  };

  /// End of the message if a friction solution is unstable or was not found.
  constexpr const char *friction_remedy =
    ". Try more Substeps, a smaller step in Load factors, or a softer penalty.";

  /// Throws NumericsError if the friction solution is unstable.
  [[noreturn]] void
  throw_unstable();

  /// Returns the components of the scene vector @p vector along the two
  /// tangents of @p row; in_scene() is the inverse.
  dealii::Tensor<1, 2>
  along_tangents(const GapConstraint &row, const dealii::Tensor<1, 3> &vector);
  dealii::Tensor<1, 3>
  in_scene(const GapConstraint &row, const dealii::Tensor<1, 2> &components);

  /// Returns the slip of @p row at displacements @p u and load factor
  /// @p factor, along its two tangents [length].
  dealii::Tensor<1, 2>
  slip_of(const GapConstraint &row,
          const BlockVector   &u,
          const LoadFactor    &factor);

  /// Adds the contact force of @p row, with normal force @p normal and shear
  /// force @p shear, to the load vector @p f.
  void
  add_force(const GapConstraint        &row,
            const double                normal,
            const dealii::Tensor<1, 3> &shear,
            BlockVector                &f);
} // namespace lamella

#endif
