// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_findings_h
#define lamella_trade_trade_findings_h

#include <lamella/trade/variant_result.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Results of a trade: cost and values of all variants, and the reference.
  struct TradeFindings
  {
    /// Variants from the cheapest to the finest; successful variants have a
    /// value for each quantity.
    std::vector<VariantResult> variants;
    /// Compared quantities, with reference values if the reference is `given`.
    std::vector<NamedQuantity> quantities;
    /// `finest`, `solid`, `given` or the name of a variant (TradeParameters).
    std::string reference;
    /// Relative errors for which the cheapest variants are named.
    std::vector<double> tolerances;
    /// Title of the plots, and text that is printed at the end.
    std::string title, remark = {};
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
