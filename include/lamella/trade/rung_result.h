// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_rung_result_h
#define lamella_trade_rung_result_h

#include <lamella/recover/results.h>
#include <lamella/scene/trade_parameters.h>

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// What a run itself says of the error of one of its values, in the unit of
  /// the value: GoalResult without its reasons.
  struct OwnBar
  {
    /// The estimated error, to be added to the value, and what bounds it.
    double estimate = 0., bar = 0.;
    /// Whether the bar can be held to. There is no bar if not.
    bool trusted = false;
  };

  /// What a rung of a trade cost and gave.
  struct RungResult
  {
    /// As in LadderEntry.
    std::string name, theory;
    /// Why there is no result; empty if there is one.
    std::string failure;
    /// Wall seconds of the whole process but for the making of error bars that
    /// it does not need (a run to a tolerance does), and of its phases.
    double seconds = 0.;
    /// By the name of the phase, and `total`, which is without the start of
    /// the process. Of a run to a tolerance those of its last pass.
    std::map<std::string, double> phases;
    /// Of all bodies, of the last pass of a run to a tolerance; 0 if the rung
    /// failed.
    unsigned int dofs = 0;
    /// Peak, of the process [MB].
    double memory = 0.;
    /// Of each quantity of the trade, in the scene's units; empty if the rung
    /// failed.
    std::vector<double> values;
    /// How much finer than the scene's its meshes are, and whether other
    /// entries were changed.
    double axis = 1., section = 1.;
    bool   overridden = false;
    /// As in LadderEntry.
    std::optional<double> tolerance = {};
    /// Of each quantity of the trade, none where the rung makes none of it;
    /// empty if it makes none at all.
    std::vector<std::optional<OwnBar>> bars = {};
    /// As in BeyondLinear, the worst of all load steps.
    double                stiffening      = 0.;
    std::optional<double> buckling_factor = {};
  };

  /**
   * What a rung's process sends home and its record keeps: its numbers, all of
   * them, so that another trade of the same ladder may ask for others without
   * running it again, and what it cost.
   */
  class RungValues : public ResultNumbers
  {
  public:
    /// Those of a rung that failed: none.
    RungValues() = default;

    /// Throws InputError if no step was solved. The bars are those of the goals
    /// in @p results.
    explicit RungValues(const Results &results);

    /// Those that to_json() has written. Throws nlohmann::json::exception for
    /// anything else.
    explicit RungValues(const nlohmann::json &json);

    /// An object whose doubles come back to the last bit.
    nlohmann::json
    to_json() const;

    /// DoFs, seconds by phase and memory, and how far it is from what large
    /// deflections do, into @p result.
    void
    tell(RungResult &result) const;

    /// The rung's own bar of @p quantity; none if that was no goal of the run.
    std::optional<OwnBar>
    bar(const NamedQuantity &quantity) const;

    /// Whether the run made bars of anything.
    bool
    has_bars() const
    {
      return !bars.empty();
    }

  private:
    /// By the label of the goal.
    std::map<std::string, OwnBar> bars;
    unsigned int                  dofs = 0;
    /// Peak [MB], and wall seconds by phase.
    double                        memory = 0.;
    std::map<std::string, double> seconds;
    /// As in RungResult.
    double                stiffening = 0.;
    std::optional<double> buckling_factor;
  };
} // namespace lamella

#endif
