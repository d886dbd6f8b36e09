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
  /// Estimated error of an output value, in the unit of the value.
  struct RunErrorBar
  {
    double estimate = 0.;    ///< Error estimate, to be added to the value.
    double bar      = 0.;    ///< Error bound.
    bool   trusted  = false; ///< True if the error bar is reliable.
  };

  /// Cost and values of one variant of a scene in a trade (comparison).
  struct VariantResult
  {
    std::string name;   ///< Name of the variant.
    std::string theory; ///< Theory of the variant (TradeVariant::theory).
    /// Reason of the failure; empty if the variant succeeded.
    std::string failure;
    /// Wall time of the process [s], without the time of error bars that the
    /// solution does not need.
    double seconds = 0.;
    /// Wall time [s] of each Phase by name, and `total`. For a solution to a
    /// tolerance, those of the last refinement pass.
    std::map<std::string, double> phases;
    /// DoFs of all bodies in the last refinement pass; 0 if the variant failed.
    unsigned int dofs   = 0;
    double       memory = 0.; ///< Peak memory of the process [MB].
    /// Values of the compared quantities; empty if the variant failed.
    std::vector<double> values;
    double              axis = 1.; ///< Factor for the number of axis elements.
    double              section = 1.; ///< Refinement factor of section meshes.
    bool overridden             = false; ///< True if other entries are changed.
    /// Relative error to which the scene is solved; empty for a given mesh.
    std::optional<double> tolerance = {};
    /// Error bar of each compared quantity; empty if none is computed.
    std::vector<std::optional<RunErrorBar>> bars = {};
    /// Largest relative stiffening in all load steps (NonlinearityEstimate).
    double stiffening = 0.;
    /// Smallest buckling factor of all load steps; empty if there is none.
    std::optional<double> buckling_factor = {};
  };

  /// All output values and the cost of a variant, as stored in its record (a
  /// JSON file). Another trade may evaluate other quantities from it.
  class VariantValues : public ResultNumbers
  {
  public:
    /// Constructs an object without values, for a failed variant.
    VariantValues() = default;

    /// Copies values and error bars. Throws InputError if @p results is empty.
    explicit VariantValues(const Results &results);

    /// Reads the result of to_json(). Throws nlohmann::json::exception.
    explicit VariantValues(const nlohmann::json &json);

    /// Returns all data as JSON; numbers are restored exactly.
    nlohmann::json
    to_json() const;

    /// Sets DoFs, times, memory and nonlinear effects in @p result.
    void
    tell(VariantResult &result) const;

    /// Returns the error bar of @p quantity; empty if none was computed.
    std::optional<RunErrorBar>
    bar(const NamedQuantity &quantity) const;

    /// Returns true if error bars were computed.
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
