// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/run/find_modes.h>
#include <lamella/solve/small_motions.h>

namespace lamella
{
  namespace
  {
    /// Computes the natural modes; @p stresses are null without prestress.
    void
    find_natural_modes(const ModeRequest        &request,
                       LinearSystem             &system,
                       const State              &state,
                       const GeometricStiffness *stresses,
                       Results                  &results)
    {
      // Stresses of linear kinematics are no approximation beyond its range.
      const NonlinearityEstimate &beyond = results.last().checks.beyond;
      const bool                  is_in_range =
        beyond.stiffening <= 1. && beyond.buckling_factor.value_or(1.) >= 1.;
      results.natural_modes =
        natural_modes(system, state, is_in_range ? stresses : nullptr, request);
      if (!is_in_range)
        results.endnotes.push_back(
          "run.modes-without-prestress: The last load step is beyond the range "
          "of linear kinematics: natural modes are those of bodies without "
          "stresses. Use Rotations = large to include the stresses");
    }



    /// Computes @p n buckling modes; @p stresses are null without stresses.
    void
    find_buckling_modes(const unsigned int        n,
                        LinearSystem             &system,
                        const State              &state,
                        const GeometricStiffness *stresses,
                        Results                  &results)
    {
      if (system.tangent().of().has_finite_rotations())
        throw InputError(
          "Find",
          "buckling",
          "run.buckling-with-large-rotations: linear buckling multiplies the "
          "stresses of linear kinematics",
          "Write Rotations = linear, or increase the loads until the run "
          "reports an unstable state.");
      if (stresses == nullptr)
        throw InputError("Find",
                         "buckling",
                         "run.buckling-without-load: the last load step has no "
                         "displacements, and therefore no stresses",
                         "Add a load.");
      results.buckling_modes = buckling_modes(system, state, *stresses, n);
      if (results.buckling_modes.size() < n)
        results.endnotes.push_back(
          "run.few-buckling-modes: the loads have only " +
          std::to_string(results.buckling_modes.size()) +
          " buckling modes with positive factors");
    }
  } // namespace



  void
  find_modes(const BuiltScene &built,
             LinearSystem     *system,
             const State      &state,
             Results          &results)
  {
    const FindRequest                  &request = built.scene().find;
    std::unique_ptr<LinearSystem>       large;
    std::unique_ptr<GeometricStiffness> stresses;
    if (system == nullptr)
      {
        // The tangent stiffness at the last state contains its stresses.
        large = std::make_unique<LinearSystem>(
          std::make_shared<const TangentOperator>(
            built.structure(),
            state.u,
            built.scene().solve.solver,
            TangentOperator::BodyMonitor(),
            BlockVector(),
            results.last().load_factor),
          built.rows());
        system = large.get();
      }
    else if (state.u.linfty_norm() > 0.)
      stresses = std::make_unique<GeometricStiffness>(*system, state);
    if (request.modes)
      find_natural_modes(
        *request.modes, *system, state, stresses.get(), results);
    if (request.n_buckling_modes > 0)
      find_buckling_modes(
        request.n_buckling_modes, *system, state, stresses.get(), results);
  }
} // namespace lamella
