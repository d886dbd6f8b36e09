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
  /// What becomes of a linear result that is no approximation of what large
  /// deflections do (`Beyond linear range`).
  enum class OutOfRange
  {
    undefined,
    refuse, ///< the run ends with a NumericsError (require_linear_range())
    accept  ///< it is written, with the notes that say so
  };

  template <>
  struct Names<OutOfRange>
  {
    static constexpr NameOf<OutOfRange> all[] = {{OutOfRange::refuse, "refuse"},
                                                 {OutOfRange::accept,
                                                  "accept"}};
  };

  /// How far bodies of a scene may turn (`Rotations`).
  enum class Rotations
  {
    undefined,
    linear,   ///< by small angles: the linear strain of Eq. 5
    large,    ///< by any angle: Green's strain (GreenBeam), Newton
    automatic ///< linear where that leaves nothing out, else large
  };

  template <>
  struct Names<Rotations>
  {
    static constexpr NameOf<Rotations> all[] = {{Rotations::linear, "linear"},
                                                {Rotations::large, "large"},
                                                {Rotations::automatic, "auto"}};
  };

  /// The axes in which stresses of bodies that turn are told (`Stress axes`).
  enum class StressAxes
  {
    undefined,
    material, ///< those that have turned with the material
    scene
  };

  template <>
  struct Names<StressAxes>
  {
    static constexpr NameOf<StressAxes> all[] = {{StressAxes::material,
                                                  "material"},
                                                 {StressAxes::scene, "scene"}};
  };

  /// In how many equal parts the way from one load step to the next is done.
  struct Substeps
  {
    /// 0: so many that another doubling changes forces, displacements and what
    /// is dissipated by less than `tolerance`, a share.
    unsigned int number    = 1;
    double       tolerance = 0.01;
    /// Of each load step, in place of `number`: those that another run took.
    std::vector<unsigned int> each = {};
    /// Of those that are not given.
    static constexpr unsigned int most = 64;
  };

  /// What a scene says of the solution, in the entries of its top level. The
  /// values here stand before a scene is read; its defaults are in declare().
  struct SolveParameters
  {
    /// t of each load step, in their order, at least one: multiplies all loads
    /// and prescribed displacements, those of obstacles among them.
    std::vector<LoadFactor> load_factors;
    Substeps                substeps;
    Rotations               rotations   = Rotations::undefined;
    StressAxes              stress_axes = StressAxes::material;
    Strategy                strategy    = Strategy::undefined;
    /// Of which a scene sets the iterations only.
    SolverParameters loop;
    NewtonParameters newton;
    /// What solves with a body's stiffness, under the condensed strategy.
    SolverKind solver = SolverKind::automatic;
    /// Bytes on each machine; 0: what it has.
    double memory_limit = 0.;
    /// The largest rotation for which linear kinematics (Eq. 5) may speak, in
    /// rad; beyond it a run fails.
    double     rotation_limit = 0.;
    OutOfRange beyond_linear  = OutOfRange::refuse;
    /// Whether somebody reads how far results are from what large deflections
    /// do, and whether they look like a slip of units. No entry: models that
    /// are made to be compared with say no.
    bool is_judged = true;

    /// Declares the entries with their defaults and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// From the top level of a scene. Throws InputError for no load factor, for
    /// numbers out of range, and for a linear solver that `full` cannot use
    /// (it factorises with MUMPS).
    static SolveParameters
    parse(const Entries &in);
  };
} // namespace lamella

#endif
