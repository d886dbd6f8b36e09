// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_variant_result_h
#define lamella_trade_variant_result_h

#include <lamella/recover/results.h>
#include <lamella/scene/trade_parameters.h>

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Error estimate of an output value, in the unit of the value.
  struct RunErrorBar
  {
    /// Error estimate, to be added to the value, and error bound.
    double estimate = 0., bar = 0.;
    /// True if the error bar is reliable.
    bool trusted = false;
  };

  /// Cost and values of a variant of a scene in a trade (comparison).
  struct VariantResult
  {
    /// Name and theory of the TradeVariant.
    std::string name, theory;
    /// Reason of the failure; empty if the variant succeeded.
    std::string failure;
    /// Wall time of the process [s], without error bars that it does not need.
    double seconds = 0.;
    /// Wall time [s] by phase, and `total`; of a run to a tolerance that of the
    /// last refinement pass.
    std::map<std::string, double> phases;
    /// DoFs of all bodies in the last refinement pass; 0 if the variant failed.
    unsigned int dofs = 0;
    /// Peak memory of the process [MB].
    double memory = 0.;
    /// Values of the compared quantities; empty if the variant failed.
    std::vector<double> values;
    /// Refinement factors of the meshes; true if other entries are changed.
    double axis = 1., section = 1.;
    bool   overridden = false;
    /// TradeVariant::tolerance.
    std::optional<double> tolerance = {};
    /// Error bar of each quantity; empty if none are computed.
    std::vector<std::optional<RunErrorBar>> bars = {};
    /// Largest stiffening and smallest buckling factor of all load steps
    /// (NonlinearityEstimate).
    double                stiffening      = 0.;
    std::optional<double> buckling_factor = {};
  };

  /// All output values and the cost of a variant, stored in its record, from
  /// which another trade may evaluate other quantities.
  class VariantValues : public ResultNumbers
  {
  public:
    /// Constructs an object without values, for a failed variant.
    VariantValues() = default;

    /// Copies values and error bars of @p results. Throws InputError if empty.
    explicit VariantValues(const Results &results);

    /// Reads @p json written by to_json(). Throws nlohmann::json::exception.
    explicit VariantValues(const nlohmann::json &json);

    /// Returns all data as JSON; doubles are restored exactly.
    nlohmann::json
    to_json() const;

    /// Sets DoFs, time, memory and nonlinear effects in @p result.
    void
    tell(VariantResult &result) const;

    /// Returns the error bar of @p quantity, if it was a goal of the run.
    std::optional<RunErrorBar>
    bar(const NamedQuantity &quantity) const;

    /// Returns whether the run computed error bars.
    bool
    has_bars() const
    {
      return !bars.empty();
    }

  private:
    /// Error bars by label of the quantity.
    std::map<std::string, RunErrorBar> bars;
    unsigned int                       dofs = 0;
    /// Peak memory [MB], and wall time [s] by phase.
    double                        memory = 0.;
    std::map<std::string, double> seconds;
    /// Estimates of the linear run, as in VariantResult.
    double                stiffening = 0.;
    std::optional<double> buckling_factor;
  };
} // namespace lamella

#endif
