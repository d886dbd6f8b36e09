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

  /// Kinematics of the rotations of a scene (`Rotations`).
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

  /// Axes of the stress output for finite rotations (`Stress axes`).
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

  /// Number of equal substeps between load steps.
  struct Substeps
  {
    /// Fixed number, or 0: doubled until forces, displacements and dissipation
    /// change by less than `tolerance`.
    unsigned int number    = 1;
    double       tolerance = 0.01;
    /// Number for each load step, in place of `number`, from another run.
    std::vector<unsigned int> each = {};
    /// Largest automatic number.
    static constexpr unsigned int most = 64;
  };

  /// Solution parameters at the top level of a scene, defaults in declare().
  struct SolveParameters
  {
    /// Load factor t of each step, on all loads and prescribed displacements.
    std::vector<LoadFactor> load_factors;
    Substeps                substeps;
    Rotations               rotations   = Rotations::undefined;
    StressAxes              stress_axes = StressAxes::material;
    Strategy                strategy    = Strategy::undefined;
    /// Parameters of the contact loop; a scene sets the iterations only.
    SolverParameters loop;
    NewtonParameters newton;
    /// Solver for the stiffness of a body in the condensed strategy.
    SolverKind solver = SolverKind::automatic;
    /// Bytes per machine; 0: the available memory.
    double memory_limit = 0.;
    /// Largest rotation for linear kinematics (Eq. 5) [rad].
    double     rotation_limit = 0.;
    OutOfRange beyond_linear  = OutOfRange::refuse;
    /// Enables estimates of large deflections and the check of units; reference
    /// models disable it.
    bool computes_estimates = true;

    /// Declares the entries with their defaults and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the top level of a scene. Throws InputError without a load factor,
    /// for numbers out of range, and for a linear solver that `full` lacks.
    static SolveParameters
    parse(const Entries &in);
  };
} // namespace lamella

#endif
