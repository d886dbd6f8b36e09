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
    /// As in LadderEntry.
    std::string name, theory;
    /// Why there is no result; empty if there is one.
    std::string failure;
    /// Wall seconds of the whole process, and of its phases.
    double seconds = 0.;
    /// By the name of the phase, and `total`, which is without the start of
    /// the process.
    std::map<std::string, double> phases;
    /// Of all bodies; 0 if the rung failed.
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
  };

  /**
   * The numbers of a run that a trade may ask for, at its last load step. A
   * rung's process sends them home, and its record keeps them: all of them and
   * not only those asked for, so another trade of the same ladder may ask for
   * others without running it again.
   */
  class RungValues
  {
  public:
    /// Those of a rung that failed: none.
    RungValues() = default;

    /// Throws InputError if no step was solved.
    explicit RungValues(const Results &results);

    /// Those that to_json() has written. Throws nlohmann::json::exception for
    /// anything else.
    explicit RungValues(const nlohmann::json &json);

    /// An object whose doubles come back to the last bit.
    nlohmann::json
    to_json() const;

    /// The value of @p quantity, which must be one of the scene's. Throws
    /// InputError if a probe lies on an interface, its plies differ there (by
    /// more than 1e-9 of the larger) and the quantity names none, or names one
    /// that is not there.
    double
    value(const TradeQuantity &quantity) const;

    /// The displacement and the stress, components in scene axes, that are
    /// largest in magnitude at the probe @p name: two quantities. On an
    /// interface the stress is that of the first ply there.
    std::vector<TradeQuantity>
    largest_at(const std::string &name) const;

    /// DoFs, seconds by phase and memory into @p result.
    void
    tell_cost(RungResult &result) const;

  private:
    /// A row of a probe, of one ply (from 1 at the bottom).
    struct ProbeRow
    {
      std::string  probe;
      unsigned int ply = 0;
      /// By the names of probes.csv.
      std::map<std::string, double> columns;
    };

    /// Those of one probe, a ply each, from the bottom.
    std::vector<const ProbeRow *>
    rows_of(const std::string &probe) const;

    unsigned int dofs = 0;
    /// Peak [MB], and wall seconds by phase.
    double                        memory = 0.;
    std::map<std::string, double> seconds;
    /// Three components each of the reaction on the bodies, and of the force on
    /// the second side.
    std::map<std::string, std::vector<double>> supports, contacts;
    std::vector<ProbeRow>                      probes;
  };
} // namespace lamella

#endif
