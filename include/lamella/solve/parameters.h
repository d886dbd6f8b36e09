// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_parameters_h
#define lamella_solve_parameters_h

#include <lamella/base/entry.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/newton.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace lamella
{
  /// Treatment of results beyond linear kinematics (`Beyond linear range`).
  enum class OutOfRange
  {
    undefined,
    refuse, ///< the run ends with a NumericsError (check_linear_range())
    accept  ///< the result is written with a warning
  };

  template <>
  struct Names<OutOfRange>
  {
    static constexpr NameOf<OutOfRange> all[] = {{OutOfRange::refuse, "refuse"},
                                                 {OutOfRange::accept,
                                                  "accept"}};
  };

  /// Kinematics of a scene (`Rotations`).
  enum class Rotations
  {
    undefined,
    linear, ///< small rotations: the linear strain of Eq. 5
    large,  ///< finite rotations: Green's strain (TotalLagrangianBeam), Newton
    automatic ///< linear where its error is negligible, else large
  };

  template <>
  struct Names<Rotations>
  {
    static constexpr NameOf<Rotations> all[] = {{Rotations::linear, "linear"},
                                                {Rotations::large, "large"},
                                                {Rotations::automatic, "auto"}};
  };

  /// Axes of stress output for finite rotations (`Stress axes`).
  enum class StressAxes
  {
    undefined,
    material, ///< axes that rotate with the material
    scene
  };

  template <>
  struct Names<StressAxes>
  {
    static constexpr NameOf<StressAxes> all[] = {{StressAxes::material,
                                                  "material"},
                                                 {StressAxes::scene, "scene"}};
  };

  /// Number of equal substeps of a load step.
  struct Substeps
  {
    /// Fixed number, or 0 for automatic substeps: their number is doubled until
    /// forces, displacements and dissipation change by less than `tolerance`.
    unsigned int number    = 1;
    double       tolerance = 0.01;
    /// Substeps of each load step from another run, instead of `number`.
    std::vector<unsigned int> each = {};
    /// Largest number of automatic substeps.
    static constexpr unsigned int most = 64;
  };

  /// Solution parameters at the top level of a scene; defaults in declare().
  struct SolveParameters
  {
    /// Load factor t of each step, for all loads and prescribed displacements.
    std::vector<LoadFactor> load_factors;
    Substeps                substeps;
    Rotations               rotations   = Rotations::undefined;
    StressAxes              stress_axes = StressAxes::material;
    Strategy                strategy    = Strategy::undefined;
    /// Parameters of ContactSolver; a scene file sets max_iterations only.
    SolverParameters loop;
    NewtonParameters newton;
    /// Linear solver for the stiffness of a body in the condensed strategy.
    SolverKind solver = SolverKind::automatic;
    /// Memory limit in bytes per machine; 0 for the available memory.
    double memory_limit = 0.;
    /// Rotation above which a linear solution is rejected [rad].
    double     rotation_limit = 0.;
    OutOfRange beyond_linear  = OutOfRange::refuse;
    /// True if effects of large deflections are estimated and units are
    /// checked; false for auxiliary models, solved only for error estimates.
    bool computes_estimates = true;

    /// Declares the entries with their defaults and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the entries at the top level of a scene. Throws InputError if no
    /// load factor is given, for numbers out of range, and for a linear solver
    /// that the strategy `full` does not have.
    static SolveParameters
    parse(const Entries &in);
  };
} // namespace lamella

#endif
