// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_nonlinear_parameters_h
#define lamella_solve_nonlinear_parameters_h

#include <lamella/base/arithmetic.h>

namespace lamella
{
  /// Tolerances, limits and fallback options of NonlinearSolver and
  /// LinearSystem.
  struct NonlinearParameters
  {
    /// Maximum number of iterations of a load step, and of the rounds of each
    /// contact problem.
    unsigned int max_iterations = 50;
    /// Error of gaps over the scene diagonal, for linear structures over
    /// LinearSystem::displacement_scale(), that counts as zero.
    double touching = arithmetic::rounding;
    /// Equilibrium is reached if the norm of the unbalanced forces, over that
    /// of the internal forces or of the loads, is at most this value.
    double force_tolerance = arithmetic::rounding_of_solutions;
    /// A residual below this fraction of the initial residual counts as zero.
    double nothing = arithmetic::rounding_of_sums;
    /// The iteration diverges above this ratio of residual to initial residual.
    double divergence_ratio = 1e12;

    // ---- linear kinematics: lengths over LinearSystem::displacement_scale()

    /// Correction, relative to the solution, below which refinement ends.
    double refinement_tolerance = arithmetic::rounding_of_sums;
    /// Maximum number of corrections by refinement, besides the mandatory ones.
    /// Refinement also ends if a correction exceeds half the previous one.
    unsigned int max_refinements = 6;
    /// Tolerance of the contact law (relative length).
    double linear_law = arithmetic::rounding_of_results;
    /// Tolerance of the contact law if its error decreases slowly (`slow`).
    double weak_linear_law = arithmetic::rounding_of_solutions;
    /// The penalty is increased, and weak_linear_law applies, if an iteration
    /// leaves more than this fraction of the error of the contact law.
    double slow = 0.1;
    /// Relative change of spring offsets below which springs are released.
    double spring_offset_tolerance = arithmetic::rounding_of_results;
    /// Spring force over the largest force below which springs are released.
    double spring_force_tolerance = arithmetic::rounding_of_sums;

    // ---- large rotations

    /// Relative residual below which stagnation counts as convergence. Rounding
    /// errors of slender bodies are (length / thickness)^3 1e-16.
    double stagnation_level = arithmetic::same_value;
    /// Two successive ratios of residuals above this count as stagnation.
    double stall_ratio = 0.5;
    /// Relative residual that is accepted if the correction is negligible.
    double near_equilibrium = 1e-3;
    /// Correction over the scene diagonal that counts as negligible.
    double negligible_correction = arithmetic::same_position;
    /// Tolerance of the contact law over the largest displacement, replaced by
    /// `stagnation_level` if the error of the law stagnates.
    double law = arithmetic::negligible;
    /// Step, over the scene diagonal, of finite differences of contact normals.
    double difference = arithmetic::same_value;
    /// Relative tolerance of GMRES in correct_row_rotation().
    double rotation_tolerance = 1e-3;
    /// Maximum number of GMRES iterations in correct_row_rotation().
    unsigned int max_rotation_corrections = 20;
    /// Largest factor, over that of the springs' stiffness, by which removal of
    /// stabilizing springs may enlarge a correction; otherwise they stay in it.
    double max_spring_influence = 10.;
    /// Largest correction over the scene diagonal at which a stagnating
    /// residual counts as converged, if bodies have stabilizing springs.
    double converged_change = 1e-7;
    /// A motion that only springs restrain is unstable if its stiffness without
    /// springs is below minus this factor times contact force over diagonal.
    double instability_share = 0.2;
    /// Maximum number of times that surfaces are paired anew in a load step.
    unsigned int max_pairings = 3;
    /// check_stability() needs no new factorization if the distance from the
    /// displacements of the last tangent is at most this fraction of the
    /// increment.
    double converged_step = 0.01;
    /// Largest rotation in an iteration [rad]; a larger increment is scaled.
    double spin = 1.;
    /// Maximum number of bisections of a load step.
    unsigned int max_bisections = 6;
    /// Largest support rotation in a step [rad]; larger steps are divided.
    double rotation = 2.;
  };
} // namespace lamella

#endif
