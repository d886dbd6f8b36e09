// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_rung_result_h
#define lamella_trade_rung_result_h

#include <lamella/scene/trade_parameters.h>
#include <lamella/solve/results.h>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// What a rung of a trade cost and gave.
  struct RungResult
  {
    std::string name, theory;
    /// Why there is no result; empty if there is one.
    std::string failure;
    /// Wall seconds of the whole process, and of its phases.
    double                        seconds = 0.;
    std::map<std::string, double> phases;
    unsigned int                  dofs = 0;
    /// Peak, of the process [MB].
    double memory = 0.;
    /// Of each quantity of the trade.
    std::vector<double> values;
    /// How much finer than the scene's its meshes are, and whether other
    /// entries were changed.
    double axis = 1., section = 1.;
    bool   overridden = false;
  };

  /**
   * The numbers of a run that a trade may ask for, at its last load step. A
   * rung's process sends them home, and its record keeps them.
   */
  class RungValues
  {
  public:
    RungValues() = default;

    /// Throws InputError if no step was solved.
    explicit RungValues(const Results &results);

    /// Those that to_json() has written. Throws nlohmann::json::exception for
    /// anything else.
    explicit RungValues(const nlohmann::json &json);

    nlohmann::json
    to_json() const;

    /// The value of @p quantity. Throws InputError if a probe lies on an
    /// interface, its plies differ there and the quantity names none, or names
    /// one that is not there.
    double
    value(const TradeQuantity &quantity) const;

    /// The displacement and the stress that are largest at the probe @p name.
    std::vector<TradeQuantity>
    largest_at(const std::string &name) const;

    /// DoFs, seconds by phase and memory into @p result.
    void
    tell_cost(RungResult &result) const;

  private:
    /// A row of a probe, of one ply (from 1 at the bottom).
    struct ProbeRow
    {
      std::string                   probe;
      unsigned int                  ply = 0;
      std::map<std::string, double> columns;
    };

    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    unsigned int                               dofs   = 0;
    double                                     memory = 0.;
    std::map<std::string, double>              seconds;
    std::map<std::string, std::vector<double>> supports, contacts;
    std::vector<ProbeRow>                      probes;
  };
} // namespace lamella

#endif
