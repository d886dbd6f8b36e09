// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_rung_result_h
#define lamella_run_rung_result_h

#include <lamella/scene/trade_parameters.h>

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

  /// The file of a run that holds its results, read.
  class RunFiles
  {
  public:
    /// Reads summary.json and probes.csv of @p directory. Throws InputError if
    /// they are not there or not whole.
    explicit RunFiles(const std::string &directory);

    /// The value of @p quantity at the last load step. Throws InputError if a
    /// probe lies on an interface, its plies differ there and the quantity
    /// names none, or names one that is not there.
    double
    value(const TradeQuantity &quantity) const;

    /// The displacement and the stress that are largest at the probe @p name.
    std::vector<TradeQuantity>
    largest_at(const std::string &name) const;

    /// DoFs, seconds by phase and memory into @p result.
    void
    read_cost(RungResult &result) const;

  private:
    using Row = std::map<std::string, std::string>;

    std::vector<const Row *>
    rows_of(const std::string &probe) const;

    unsigned int                               dofs   = 0;
    double                                     memory = 0.;
    std::map<std::string, double>              seconds;
    std::map<std::string, std::vector<double>> supports, contacts;
    /// Of probes.csv, the last load step.
    std::vector<Row> probes;
  };
} // namespace lamella

#endif
