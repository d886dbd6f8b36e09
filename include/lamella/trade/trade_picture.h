// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_picture_h
#define lamella_trade_trade_picture_h

#include <lamella/trade/trade_table.h>

#include <string>

namespace lamella
{
  /**
   * Leaves @p directory/trade.py, which draws the table trade.csv beside it,
   * and runs it: trade.png and trade.svg, a row of two panels for each
   * quantity of @p table, error against seconds and against DoFs on logarithmic
   * axes. Theories are told apart by colour and mark; the marks of the Pareto
   * front are filled, named (where there is room) and joined by steps; dotted
   * lines are the tolerances. Rungs without an error, and quantities without
   * any rung to draw, are left out. The script is meant to be changed to taste
   * and run again; it prints @p title, whatever letters that has.
   *
   * Returns why there are no pictures, with the remedy, where no python3 has
   * matplotlib or the script fails (its words are then in trade.log); empty if
   * they were drawn. Throws InputError if the script cannot be written.
   */
  std::string
  draw_trade(const TradeTable  &table,
             const std::string &title,
             const std::string &directory);
} // namespace lamella

#endif
