// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_picture_h
#define lamella_trade_trade_picture_h

#include <lamella/trade/trade_table.h>

#include <string>

namespace lamella
{
  /**
   * The commands with which gnuplot draws @p table: a row of two panels for
   * each quantity, error against seconds and against DoFs on logarithmic axes.
   * Theories are told apart by colour and mark; the marks of the Pareto front
   * are filled, named and joined by steps; dotted lines are the tolerances.
   */
  std::string
  gnuplot_script(const TradeTable &table, const std::string &title);

  /**
   * Writes these into @p directory/trade.gp and has gnuplot draw trade.png and
   * trade.svg. Returns why there are no pictures, with the remedy, where
   * gnuplot is missing or fails; empty if they were drawn.
   */
  std::string
  draw_trade(const TradeTable  &table,
             const std::string &title,
             const std::string &directory);
} // namespace lamella

#endif
