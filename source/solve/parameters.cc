// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/memory.h>
#include <lamella/base/patterns.h>
#include <lamella/solve/parameters.h>

#include <sstream>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // What nobody waits for.
    constexpr unsigned int max_iterations_per_solve = 1000000;



    void
    declare_solver(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Linear solver",
        "auto",
        selection<SolverKind>(),
        "auto: on one process cholmod, on several mumps, cg for large solids; "
        "cholmod, mumps: direct solvers; cg: conjugate gradients with "
        "algebraic multigrid, for solids, with little memory.");
      prm.declare_entry(
        "Memory limit",
        "auto",
        Anything(),
        "Largest memory of a run on each machine, as in 2 GB; auto: all of the "
        "machine. A scene that needs more is refused before the solution.");
      prm.declare_entry("Maximum iterations",
                        "50",
                        patterns::number(),
                        "Largest number of Newton iterations in a load step. "
                        "If a step needs more, use smaller load steps.");
    }



    void
    declare_rotations(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Rotations",
        "linear",
        selection<Rotations>(),
        "linear: small displacements and rotations, as in the paper; large: "
        "finite rotations and sliding, at small strains. It needs theories "
        "whose section functions can rotate (LE-N, TE-N with N >= 2, with Axis "
        "element = B4; solid-2) or whose sections rotate rigidly (EBBT, TBT, "
        "SV, SV-N); auto: linear, or large if linear neglects more than 2e-3.");
      prm.declare_entry(
        "Stress axes",
        name_of(StressAxes::material),
        selection<StressAxes>(),
        "With large rotations: axes of the components sxx ... syz of Cauchy "
        "stress in probes, lines and cuts: rotated with the material, or those "
        "of the scene. s11 ... s23 refer to the rotated ply axes.");
    }



    Substeps
    parse_substeps(const Entry &entry)
    {
      constexpr unsigned int most    = 1000;
      constexpr double       percent = 0.01;
      Substeps               substeps;
      std::istringstream     words(entry.text());
      std::string            word, tolerance, more;
      words >> word >> tolerance >> more;
      if (word != "auto")
        {
          substeps.number = entry.whole(1, most);
          return substeps;
        }
      substeps.number = 0;
      if (!more.empty())
        entry.refuse(
          "solve.substeps-syntax: write a number, auto, or auto with a "
          "tolerance in per cent, as in auto 0.1");
      if (!tolerance.empty())
        substeps.tolerance = percent * entry.number(tolerance);
      if (!(substeps.tolerance > 0.))
        entry.refuse(
          "solve.tolerance-not-positive: tolerances are > 0, as in auto 0.1");
      return substeps;
    }
  } // namespace



  void
  SolveParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Load factors",
      "1",
      patterns::numbers(),
      "One number for each load step, which multiplies all prescribed "
      "displacements and loads; 0.5, 1, 0 loads and unloads.");
    prm.declare_entry("Substeps",
                      "1",
                      Anything(),
                      "With friction: number of equal substeps of each load "
                      "step, or auto: doubled, to at most 64, until forces, "
                      "displacements and dissipated energy change by less than "
                      "1 %; auto 0.1: less than 0.1 %.");
    declare_rotations(prm);
    prm.declare_entry(
      "Contact strategy",
      "auto",
      selection<Strategy>(),
      "condensed: one factorization, then contact on the compliance matrix of "
      "its constraints; full: assembly and factorization of K plus the penalty "
      "matrix in each iteration, as in the paper. Both give the same results. "
      "auto: full for many touching points with friction, else condensed.");
    declare_solver(prm);
    prm.declare_entry("Rotation limit",
                      "0.5",
                      patterns::positive(),
                      "Largest rotation for which a linear result is accepted "
                      "[rad]; from 0.1 on a warning is printed.");
    prm.declare_entry(
      "Beyond linear range",
      "refuse",
      selection<OutOfRange>(),
      "Linear results are no approximation where stretching would more than "
      "double the stiffness of a body, or loads exceed the buckling load. "
      "refuse: the run ends with an error; accept: a note is printed.");
  }



  SolveParameters
  SolveParameters::parse(const Entries &in)
  {
    SolveParameters parameters;
    for (const double factor : in["Load factors"].numbers())
      parameters.load_factors.emplace_back(factor);
    if (parameters.load_factors.empty())
      in["Load factors"].refuse_missing(
        "solve.load-factors-missing: write a number per step, as in 0.5, 1.");
    parameters.substeps     = parse_substeps(in["Substeps"]);
    parameters.rotations    = in["Rotations"].choice<Rotations>();
    parameters.stress_axes  = in["Stress axes"].choice<StressAxes>();
    parameters.strategy     = in["Contact strategy"].choice<Strategy>();
    const Entry solver      = in["Linear solver"];
    parameters.solver       = solver.choice<SolverKind>();
    parameters.memory_limit = to_bytes(in["Memory limit"]);
    if (parameters.strategy == Strategy::automatic &&
        parameters.solver != SolverKind::automatic &&
        parameters.solver != SolverKind::mumps)
      parameters.strategy = Strategy::condensed;
    if (parameters.strategy == Strategy::full &&
        (parameters.solver == SolverKind::cholmod ||
         parameters.solver == SolverKind::cg))
      solver.refuse(
        "solve.solver-conflict: Contact strategy = full needs mumps",
        "Write Linear solver = auto, or Contact strategy = condensed.");
    parameters.nonlinear.max_iterations =
      in["Maximum iterations"].whole(1, max_iterations_per_solve);
    parameters.rotation_limit = in["Rotation limit"].positive();
    parameters.beyond_linear  = in["Beyond linear range"].choice<OutOfRange>();
    return parameters;
  }
} // namespace lamella
