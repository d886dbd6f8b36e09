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
  /// Error bar of a value, in its unit: GoalResult without reasons.
  struct RunErrorBar
  {
    /// Estimated error, to be added to the value, and its bound.
    double estimate = 0., bar = 0.;
    /// True if the error bar is reliable.
    bool trusted = false;
  };

  /// Cost and values of a variant of a trade.
  struct VariantResult
  {
    /// Name and theory of the TradeVariant.
    std::string name, theory;
    /// Reason why there is no result; empty if there is one.
    std::string failure;
    /// Wall seconds of the whole process, without error bars that the run does
    /// not need.
    double seconds = 0.;
    /// Wall seconds by phase, and `total`; may be those of a last pass.
    std::map<std::string, double> phases;
    /// DoFs of all bodies in the last pass; 0 if failed.
    unsigned int dofs = 0;
    /// Peak memory of the process [MB].
    double memory = 0.;
    /// Values of the trade's quantities, in the scene's units; empty if failed.
    std::vector<double> values;
    /// Refinement factors on the scene's meshes; true if other entries changed.
    double axis = 1., section = 1.;
    bool   overridden = false;
    /// Tolerance of the TradeVariant.
    std::optional<double> tolerance = {};
    /// Error bar of each quantity; empty if the variant makes none.
    std::vector<std::optional<RunErrorBar>> bars = {};
    /// Worst values of NonlinearityEstimate of all load steps.
    double                stiffening      = 0.;
    std::optional<double> buckling_factor = {};
  };

  /// Numbers and costs of a variant, as sent by its process and stored in its
  /// record. Another trade may use them for other quantities.
  class VariantValues : public ResultNumbers
  {
  public:
    /// Creates the numbers of a failed variant: none.
    VariantValues() = default;

    /// Takes the numbers and error bars of @p results. Throws InputError if no
    /// step was solved.
    explicit VariantValues(const Results &results);

    /// Reads @p json written by to_json(). Throws nlohmann::json::exception.
    explicit VariantValues(const nlohmann::json &json);

    /// Returns an object from which doubles are restored exactly.
    nlohmann::json
    to_json() const;

    /// Writes DoFs, seconds, memory and nonlinear effects into @p result.
    void
    tell(VariantResult &result) const;

    /// Returns the error bar of @p quantity; none if it was no goal.
    std::optional<RunErrorBar>
    bar(const NamedQuantity &quantity) const;

    /// Returns whether the run made any error bars.
    bool
    has_bars() const
    {
      return !bars.empty();
    }

  private:
    /// Error bars by the label of the goal.
    std::map<std::string, RunErrorBar> bars;
    unsigned int                       dofs = 0;
    /// Peak memory [MB], and wall seconds by phase.
    double                        memory = 0.;
    std::map<std::string, double> seconds;
    /// Stiffening and buckling factor(VariantResult).
    double                stiffening = 0.;
    std::optional<double> buckling_factor;
  };
} // namespace lamella

#endif
