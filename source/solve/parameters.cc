// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/text.h>
#include <lamella/solve/parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  void
  SolveParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Load factors",
      "1",
      Anything(),
      "One a step: what multiplies all prescribed displacements "
      "and loads. 0.5, 1, 0 loads and unloads.");
    prm.declare_entry("Contact strategy",
                      "condensed",
                      Anything(),
                      "condensed: factorise once, contact on the compliance of "
                      "its rows; full: assemble and factorise K + K^p in each "
                      "iteration, as in the paper. Same results.");
    prm.declare_entry(
      "Linear solver",
      "auto",
      Anything(),
      "auto: cholmod on one process, mumps on several, cg for large solids; "
      "cholmod, mumps: factorise; cg: conjugate gradients with algebraic "
      "multigrid, for solids, with little memory.");
    prm.declare_entry("Memory limit",
                      "auto",
                      Anything(),
                      "What a run may take on each machine, as in 2 GB; auto: "
                      "what the machine has. A scene that needs more is "
                      "refused before it takes it.");
    prm.declare_entry("Maximum iterations",
                      "50",
                      Anything(),
                      "Newton iterations of a load step before it fails; a "
                      "scene that needs more wants smaller steps.");
    prm.declare_entry("Rotation limit",
                      "0.5",
                      Anything(),
                      "Largest rotation for which the linear result is written "
                      "at all [rad]; from 0.1 on it comes with a warning.");
  }



  namespace
  {
    SolverKind
    parse_solver(const std::string &text)
    {
      for (const SolverKind kind : {SolverKind::automatic,
                                    SolverKind::cholmod,
                                    SolverKind::mumps,
                                    SolverKind::cg})
        if (text == name_of(kind))
          return kind;
      throw InputError("Linear solver = " + text +
                       ": must be auto, cholmod, mumps or cg.");
    }
  } // namespace



  SolveParameters
  SolveParameters::parse(const ParameterHandler &prm)
  {
    SolveParameters parameters;
    parameters.load_factors =
      to_numbers(prm.get("Load factors"), "Load factors");
    if (parameters.load_factors.empty())
      throw InputError("Load factors is empty: give one number a load step.");

    const std::string strategy = prm.get("Contact strategy");
    if (strategy != "condensed" && strategy != "full")
      throw InputError("Contact strategy = " + strategy +
                       ": must be condensed or full.");
    parameters.strategy =
      strategy == "full" ? Strategy::full : Strategy::condensed;

    parameters.solver       = parse_solver(prm.get("Linear solver"));
    parameters.memory_limit = to_bytes(prm.get("Memory limit"), "Memory limit");
    if (parameters.strategy == Strategy::full &&
        (parameters.solver == SolverKind::cholmod ||
         parameters.solver == SolverKind::cg))
      throw InputError("Linear solver = " + prm.get("Linear solver") +
                       ": Contact strategy = full factorises with mumps. "
                       "Choose auto, or the condensed strategy.");

    const double n =
      to_number(prm.get("Maximum iterations"), "Maximum iterations");
    if (!(n >= 1. && n <= 1e6 && n == std::floor(n)))
      throw InputError("Maximum iterations = " + prm.get("Maximum iterations") +
                       ": must be a whole number from 1.");
    parameters.loop.max_iterations = static_cast<unsigned int>(n);

    parameters.rotation_limit =
      to_number(prm.get("Rotation limit"), "Rotation limit");
    if (!(parameters.rotation_limit > 0.))
      throw InputError("Rotation limit = " + prm.get("Rotation limit") +
                       ": must be positive, in rad.");
    return parameters;
  }
} // namespace lamella
