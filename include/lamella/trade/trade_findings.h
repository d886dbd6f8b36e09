// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_findings_h
#define lamella_trade_trade_findings_h

#include <lamella/trade/rung_result.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Costs and values of the rungs of a trade, and what they are compared by.
  struct TradeFindings
  {
    /// In the order of the ladder. Those that did not fail have a value for
    /// each of the quantities.
    std::vector<RungResult> rungs;
    /// With their numbers where the reference is `given`.
    std::vector<NamedQuantity> quantities;
    /// `finest`, `solid`, `given` or the name of a rung (TradeParameters).
    std::string reference;
    /// Shares of 1.
    std::vector<double> tolerances;
    /// Of the pictures, and text that is printed behind the sentences.
    std::string title, remark = {};
  };

  /**
   * Writes @p findings to trade.json in @p directory and has scripts/trade.py
   * make the rest of it: tables and sentences, which are printed, trade.csv and
   * the pictures (doc/trade.md). What the script prints goes where this process
   * prints.
   *
   * Throws NumericsError if the rung that the reference means, or every rung,
   * failed; InputError if there is no python3 or a file cannot be written.
   */
  void
  present_trade(const TradeFindings &findings, const std::string &directory);
} // namespace lamella

#endif
