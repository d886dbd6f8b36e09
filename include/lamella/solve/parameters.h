// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_parameters_h
#define lamella_solve_parameters_h

#include <lamella/base/entry.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/nonlinear_parameters.h>

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

  /// Names of the values of OutOfRange in parameter files.
  template <>
  struct Names<OutOfRange>
  {
    /// Value and name of each treatment.
    static constexpr NameOf<OutOfRange> all[] = {{OutOfRange::refuse, "refuse"},
                                                 {OutOfRange::accept,
                                                  "accept"}};
  };

  /// Kinematics of a scene (entry `Rotations`).
  enum class Rotations
  {
    undefined,
    linear, ///< small rotations: linear strain
    large,  ///< finite rotations: Green's strain (TotalLagrangianBeam), Newton
    automatic ///< linear if its error is negligible, else large
  };

  /// Names of the values of Rotations in parameter files.
  template <>
  struct Names<Rotations>
  {
    /// Value and name of each kinematics.
    static constexpr NameOf<Rotations> all[] = {{Rotations::linear, "linear"},
                                                {Rotations::large, "large"},
                                                {Rotations::automatic, "auto"}};
  };

  /// Axes of stress output for finite rotations (`Stress axes`).
  enum class StressAxes
  {
    undefined,
    material, ///< axes that rotate with the material
    scene     ///< axes of the scene, fixed in space
  };

  /// Names of the values of StressAxes in parameter files.
  template <>
  struct Names<StressAxes>
  {
    /// Value and name of each choice of axes.
    static constexpr NameOf<StressAxes> all[] = {{StressAxes::material,
                                                  "material"},
                                                 {StressAxes::scene, "scene"}};
  };

  /// Number of equal substeps into which each load step is divided.
  struct Substeps
  {
    /// Fixed number, or 0 for automatic substeps: their number is doubled until
    /// forces, displacements and dissipation change by less than `tolerance`.
    unsigned int number = 1;
    /// Relative change of the solution that ends automatic substeps.
    double tolerance = 0.01;
    /// Number of substeps of each load step, as found in another run; used
    /// instead of `number` if not empty.
    std::vector<unsigned int> each = {};
    /// Largest number of automatic substeps.
    static constexpr unsigned int most = 64;
  };

  /// Solution parameters at the top level of a scene file.
  struct SolveParameters
  {
    /// Load factor of each step, for all loads and prescribed displacements.
    std::vector<LoadFactor> load_factors;
    Substeps                substeps; ///< Substeps of each load step.
    Rotations  rotations   = Rotations::undefined; ///< Small or finite.
    StressAxes stress_axes = StressAxes::material; ///< Output axes.
    Strategy   strategy    = Strategy::undefined;  ///< Contact algorithm.
    /// Tolerances of the iterations; a scene sets max_iterations only.
    NonlinearParameters nonlinear;
    /// Linear solver for the stiffness of a body (condensed contact strategy).
    SolverKind solver = SolverKind::automatic;
    /// Memory limit in bytes per machine; 0 for the available memory.
    double memory_limit = 0.;
    /// Rotation above which a linear solution is rejected [rad].
    double rotation_limit = 0.;
    /// Treatment of results beyond the range of linear kinematics.
    OutOfRange beyond_linear = OutOfRange::refuse;
    /// True: effects of large deflections are estimated, and units are checked.
    /// False for auxiliary models that serve error estimates only.
    bool computes_estimates = true;

    /// Declares the entries with their defaults and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the entries at the top level of a scene. Throws InputError if
    /// there are no load factors, and for invalid numbers or linear solvers.
    static SolveParameters
    parse(const Entries &in);
  };
} // namespace lamella

#endif
