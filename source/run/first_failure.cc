// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/run/first_failure.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Of the two ends of the interval, over the upper one.
    constexpr double accuracy = 1e-3;
    /// Halvings end where plies fail at any load, too.
    constexpr unsigned int n_doublings = 10, most_halvings = 60;
  } // namespace



  void
  check_load_growth(const Structure                     &structure,
                    const std::vector<ContactInterface> &contacts,
                    const LoadFactor                    &factor)
  {
    const auto is_moved = [](const ContactInterface &contact) {
      return contact.obstacle != nullptr &&
             contact.obstacle->displacement.norm() > 0.;
    };
    const auto is_driven = [](const PrescribedFunctional &row) {
      return row.value != 0. && row.history == 0;
    };
    BlockVector growing = structure.load(factor.of_scene_alone());
    growing -= structure.load(factor.without_loads());
    if (growing.linfty_norm() == 0. &&
        std::none_of(contacts.begin(), contacts.end(), is_moved) &&
        std::none_of(structure.prescribed().begin(),
                     structure.prescribed().end(),
                     is_driven))
      throw InputError(
        "Find",
        "first failure",
        "run.no-growing-load: no load or prescribed displacement of the scene "
        "grows with the load factor",
        "Add a load (no Temperature), Gravity, or a prescribed displacement.");
  }



  FirstFailureSearch::FirstFailureSearch(const TrySolve &try_load,
                                         std::ostream   &out)
    : try_load(try_load)
    , out(out)
  {}



  bool
  FirstFailureSearch::judge(const double                   factor,
                            const std::vector<PlyReserve> &plies)
  {
    const PlyReserve *worst = worst_of(plies);
    const bool        does =
      worst != nullptr && worst->reserve && *worst->reserve <= 1.;
    out << "  load factor " << to_text(factor, 6)
        << ", smallest reserve factor "
        << (worst != nullptr && worst->reserve ? to_text(*worst->reserve, 5) :
                                                 "none")
        << std::endl;
    if (does)
      result.where = *worst;
    (does ? result.failing : result.safe) = factor;
    return does;
  }



  void
  FirstFailureSearch::attempt(const double factor, const unsigned int load_step)
  {
    try
      {
        std::vector<PlyReserve> plies;
        result.trials.push_back(try_load(factor, load_step, plies));
        judge(factor, plies);
      }
    catch (const NumericsError &error)
      {
        without_state = factor;
        reason        = strip_period(error.what());
        out << "  load factor " << to_text(factor, 6)
            << ", no result: " << reason << std::endl;
      }
  }



  std::optional<double>
  FirstFailureSearch::upper() const
  {
    if (!result.where)
      return without_state;
    if (without_state && std::abs(*without_state - result.safe) <
                           std::abs(result.failing - result.safe))
      return without_state;
    return result.failing;
  }



  FirstFailure
  FirstFailureSearch::find(const std::vector<StepResults> &steps)
  {
    out << "First failure:" << std::endl;
    // Of the first step that fails, which the search stays on the way of.
    unsigned int load_step = 0;
    while (
      load_step < steps.size() &&
      !judge(steps[load_step].load_factor.of_scene(), steps[load_step].plies))
      ++load_step;
    if (!result.where)
      for (const StepResults &step : steps)
        if (std::abs(step.load_factor.of_scene()) > std::abs(result.safe))
          result.safe = step.load_factor.of_scene();
    for (unsigned int k = 0; k < n_doublings && !upper(); ++k)
      attempt(result.safe == 0. ? 1. : 2. * result.safe, load_step);
    // It is at most 0.1 % wide.
    const auto is_interval_narrow = [this] {
      const double end = *upper();
      return std::abs(end - result.safe) <= accuracy * std::abs(end);
    };
    for (unsigned int k = 0;
         k < most_halvings && upper() && !is_interval_narrow();
         ++k)
      attempt(0.5 * (result.safe + *upper()), load_step);
    return result;
  }



  std::string
  FirstFailureSearch::note() const
  {
    const std::string safe = to_text(result.safe, 6);
    if (!upper())
      return "run.no-failure: no ply fails up to load factor " + safe;
    if (*upper() != without_state)
      return "";
    return "run.failure-not-found: no ply fails up to load factor " + safe +
           ", and at " + to_text(*without_state, 6) +
           " the solution failed. Cause: " + reason;
  }
} // namespace lamella
