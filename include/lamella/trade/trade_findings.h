// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_findings_h
#define lamella_trade_trade_findings_h

#include <lamella/trade/variant_result.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Costs and values of the variants of a trade, and their reference.
  struct TradeFindings
  {
    /// Variants in the order of the hierarchy. Successful variants have a value
    /// for each quantity.
    std::vector<VariantResult> variants;
    /// Compared quantities, with given numbers if the reference is `given`.
    std::vector<NamedQuantity> quantities;
    /// `finest`, `solid`, `given` or the name of a variant (TradeParameters).
    std::string reference;
    /// Relative tolerances.
    std::vector<double> tolerances;
    /// Title of the pictures, and text that is printed after the sentences.
    std::string title, remark = {};
  };

  /// Writes @p findings to trade.json in @p directory and runs scripts/trade.py
  /// there, which prints tables and sentences, and writes trade.csv and the
  /// pictures (doc/guides/convergence-study.md). Throws NumericsError if the
  /// variant of the reference, or every variant, failed; InputError if there is
  /// no python3 or a file cannot be written.
  void
  present_trade(const TradeFindings &findings, const std::string &directory);
} // namespace lamella

#endif
