// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_findings_h
#define lamella_trade_trade_findings_h

#include <lamella/trade/variant_result.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Results of a trade, which compares variants of a scene, for the report.
  struct TradeFindings
  {
    /// Variants from the cheapest to the finest. Successful variants have one
    /// value for each compared quantity.
    std::vector<VariantResult> variants;
    /// Compared quantities, with reference values if the reference is `given`.
    std::vector<NamedQuantity> quantities;
    /// Reference solution: `finest`, `solid`, `given` or the name of a variant.
    std::string reference;
    /// Relative errors; the report names the cheapest variant for each.
    std::vector<double> tolerances;
    std::string         title;       ///< Title of the plots.
    std::string         remark = {}; ///< Text that is printed after the tables.
  };

  /// Writes @p findings to trade.json in @p directory and runs
  /// scripts/trade.py, which prints tables and the cheapest variants, and
  /// writes trade.csv and plots (doc/guides/convergence-study.md). Throws
  /// NumericsError if the reference variant or every variant failed; InputError
  /// if python3 is not found or a file cannot be written.
  void
  present_trade(const TradeFindings &findings, const std::string &directory);
} // namespace lamella

#endif
