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
        "auto: on one process cholmod, or dense blocks for beams of SV and "
        "SV-N, mumps on several, cg for large solids; cholmod, mumps: "
        "factorize; cg: conjugate gradients with algebraic multigrid, for "
        "solids, with little memory.");
      prm.declare_entry(
        "Memory limit",
        "auto",
        Anything(),
        "What a run may take on each machine, as in 2 GB; auto: what the "
        "machine has. A scene that needs more is refused before it takes it.");
      prm.declare_entry("Maximum iterations",
                        "50",
                        patterns::number(),
                        "Newton iterations of a load step before it fails; a "
                        "scene that needs more wants smaller steps.");
    }



    void
    declare_rotations(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Rotations",
        "linear",
        selection<Rotations>(),
        "linear: displacements and rotations are small, as in the paper; "
        "large: bodies turn by any angle and slide on each other by any "
        "distance, at small strains: by fields that follow (LE-N, TE-N from "
        "TE-2 on, with Axis element = B4; solid-2) or by sections that turn "
        "(EBBT, TBT, SV, SV-N); auto: linear, or large where the "
        "linear result leaves more than 2e-3 out.");
      prm.declare_entry(
        "Stress axes",
        name_of(StressAxes::material),
        selection<StressAxes>(),
        "Of bodies that turn: what sxx ... syz of probes, lines and cuts are "
        "components of Cauchy's stress in, axes that have turned with the "
        "material or those of the scene. s11 ... s23 are in the plies' axes, "
        "which turn along.");
    }
  } // namespace



  void
  SolveParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Load factors",
      "1",
      patterns::numbers(),
      "One a step: what multiplies all prescribed displacements "
      "and loads. 0.5, 1, 0 loads and unloads.");
    prm.declare_entry("Substeps",
                      "1",
                      Anything(),
                      "With friction: in how many equal parts each load step "
                      "is done, or auto, as many (to 64) as it takes until "
                      "twice as many change forces, displacements and "
                      "dissipated energy by less than 1 %; auto 0.1: 0.1 %.");
    declare_rotations(prm);
    prm.declare_entry("Contact strategy",
                      "condensed",
                      selection<Strategy>(),
                      "condensed: factorize once, contact on the compliance of "
                      "its rows; full: assemble and factorize K + K^p in each "
                      "iteration, as in the paper. Same results.");
    declare_solver(prm);
    prm.declare_entry("Rotation limit",
                      "0.5",
                      patterns::positive(),
                      "Largest rotation for which the linear result is written "
                      "at all [rad]; from 0.1 on it comes with a warning.");
    prm.declare_entry(
      "Beyond linear range",
      "refuse",
      selection<OutOfRange>(),
      "Where stretching would stiffen a body to more than twice what the "
      "linear model says, or loads are above those that buckle it, the linear "
      "result is no approximation. refuse: the run ends there and says by how "
      "much; accept: the linear result is written, with a note.");
  }



  namespace
  {
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
          "solve.tolerance-not-positive: the tolerance after auto must be "
          "positive, as in auto 0.1");
      return substeps;
    }
  } // namespace



  SolveParameters
  SolveParameters::parse(const Entries &in)
  {
    SolveParameters parameters;
    for (const double factor : in["Load factors"].numbers())
      parameters.load_factors.emplace_back(factor);
    if (parameters.load_factors.empty())
      in["Load factors"].refuse_missing(
        "solve.load-factors-missing: write one number for each load step, as "
        "in 0.5, 1.");
    parameters.substeps     = parse_substeps(in["Substeps"]);
    parameters.rotations    = in["Rotations"].choice<Rotations>();
    parameters.stress_axes  = in["Stress axes"].choice<StressAxes>();
    parameters.strategy     = in["Contact strategy"].choice<Strategy>();
    const Entry solver      = in["Linear solver"];
    parameters.solver       = solver.choice<SolverKind>();
    parameters.memory_limit = to_bytes(in["Memory limit"]);
    if (parameters.strategy == Strategy::full &&
        (parameters.solver == SolverKind::cholmod ||
         parameters.solver == SolverKind::cg))
      solver.refuse(
        "solve.solver-conflict: Contact strategy = full works with Linear "
        "solver = mumps only",
        "Write Linear solver = auto, or Contact strategy = condensed.");
    parameters.loop.max_iterations =
      in["Maximum iterations"].whole(1, max_iterations_per_solve);
    parameters.newton.max_iterations = parameters.loop.max_iterations;
    parameters.rotation_limit        = in["Rotation limit"].positive();
    parameters.beyond_linear = in["Beyond linear range"].choice<OutOfRange>();
    return parameters;
  }
} // namespace lamella
