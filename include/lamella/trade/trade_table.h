// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_table_h
#define lamella_trade_trade_table_h

#include <lamella/trade/rung_result.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * Errors against costs: what a trade found.
   *
   * The error of a rung's value v against the reference r is |v / r - 1|. A
   * rung stands on the Pareto front of a cost if none is at most as costly and
   * at most as far off, and better in one of the two. The rung that is itself
   * the reference has no error and stands on no front. Rungs and quantities are
   * numbered from 0, in the order of the constructor's lists.
   *
   * A rung is richer than another with more DoFs, meshes at least as fine and
   * the same theory or one that holds it (EBBT, TBT, TE-1, TE-2, ...; SV, SV-1,
   * ...; LE-1, LE-2, ...; solid-1, solid-2), if the two change no other entries
   * of the scene; a run to a tolerance is richer than one to a larger one. A
   * poor theory can be right by accident, where a curve of errors changes its
   * sign: then a richer one is further off. Such a rung is not to be counted on
   * for a tolerance if a richer one misses it, and it is an accident that no
   * front shows if a richer one is off by more than twice as much and by more
   * than 0.1 %.
   */
  class TradeTable
  {
  public:
    /// What a rung is charged for.
    enum class Cost
    {
      seconds, ///< wall seconds of the whole process
      dofs     ///< degrees of freedom of all bodies
    };

    /// @p rungs that did not fail have a value for each of the @p quantities;
    /// @p reference is `finest`, `solid`, `given` or a rung's name, see
    /// TradeParameters, and for `given` each quantity has its number;
    /// @p tolerances are shares of 1. Throws NumericsError if the rung that the
    /// reference means, or every rung, failed.
    TradeTable(std::vector<RungResult>    rungs,
               std::vector<NamedQuantity> quantities,
               const std::string         &reference,
               std::vector<double>        tolerances);

    /// The failed ones among them.
    const std::vector<RungResult> &
    rungs() const
    {
      return all;
    }
    const std::vector<NamedQuantity> &
    quantities() const
    {
      return asked;
    }
    const std::vector<double> &
    tolerances() const
    {
      return bounds;
    }
    /// The number of the rung that errors are taken against; -1 if they are
    /// taken against given values.
    int
    reference_rung() const
    {
      return against;
    }

    /// r of quantity @p q; zero if no error can be relative to it.
    double
    reference(const unsigned int q) const;

    /// Whether rung @p k has an error in quantity @p q: it succeeded, is not
    /// the reference itself, and the reference is not zero.
    bool
    has_error(const unsigned int k, const unsigned int q) const;
    /// |v / r - 1| of rung @p k in quantity @p q, as a share of 1; only where
    /// has_error().
    double
    error(const unsigned int k, const unsigned int q) const;
    /// Of rung @p k; of a failed one the seconds that it took to fail, and no
    /// DoFs.
    double
    cost(const unsigned int k, const Cost cost) const;

    /// Whether rung @p k says something of its own error in quantity @p q, a
    /// bar or that it has none.
    bool
    made_bar(const unsigned int k, const unsigned int q) const;
    /// The bar of rung @p k in quantity @p q as a share of |r|, as the error
    /// is, which it is to be no less than; none where the rung has none, or
    /// where the reference is zero.
    std::optional<double>
    bar(const unsigned int k, const unsigned int q) const;
    /// `Bars that hold, ...: 38 of 40 (1 more with the reference's own bar
    /// added); values without a bar: 6.`, of all values that have an error;
    /// empty if no rung has made bars.
    std::string
    count_of_bars() const;

    /// Whether rung @p k, which has an error of quantity @p q, owes it to
    /// chance: a richer one is off by more than twice as much and by more than
    /// 0.1 %.
    bool
    is_accident(const unsigned int k, const unsigned int q) const;

    /// The rungs of the Pareto front of quantity @p q, accidents left out, by
    /// rising cost and so by falling error; of rungs with the same cost and
    /// error one. Seconds are taken as they are, without the allowance of
    /// cheapest().
    std::vector<unsigned int>
    front(const unsigned int q, const Cost cost) const;

    /// The cheapest rung with an error of quantity @p q of at most
    /// @p tolerance; -1 if there is none. Seconds that differ by less than what
    /// a machine lets two equal runs differ, 5 % and 0.1 s, count as equal,
    /// and the fewer DoFs decide.
    int
    cheapest(const unsigned int q, const double tolerance) const;
    /// The cheapest of those that no richer rung contradicts by an error of
    /// more than @p tolerance; -1 if there is none.
    int
    cheapest_to_count_on(const unsigned int q, const double tolerance) const;

    /// `For 1 % in tip: uz the cheapest is TBT: 75 DoFs, 0.3 s (off by 0.2 %).`
    /// and, where a richer rung is off by more than @p tolerance, that one
    /// should not count on it, and which is the cheapest to count on.
    std::string
    sentence(const unsigned int q, const double tolerance) const;

    /// What errors are taken against, and how sure that is, in words: the rung
    /// that is nearest to the reference is off by something, and smaller errors
    /// than that say little, since the reference itself may be off by as much.
    /// Where even that one is far away, nothing tells.
    std::string
    basis() const;

    /// What errors against a linear reference do not say, by the reference, or
    /// the rung of most DoFs if values are given: its stiffening above 1 % and
    /// its buckling factor below 10 (BeyondLinear). Empty where there is
    /// neither.
    std::string
    beyond_linear() const;

  private:
    /// The last rung that @p name means and that did not fail.
    int
    find_reference(const std::string &name) const;
    /// Whether rung @p other is richer than rung @p k.
    bool
    is_richer(const unsigned int other, const unsigned int k) const;
    /// The first rung richer than @p k with an error of quantity @p q above
    /// @p error; -1 if there is none.
    int
    richer_and_worse(const unsigned int k,
                     const unsigned int q,
                     const double       error) const;
    /// The rungs with an error of quantity @p q of at most @p tolerance.
    std::vector<unsigned int>
    within(const unsigned int q, const double tolerance) const;
    /// The cheapest of @p rungs, as cheapest() has it.
    int
    cheapest_of(const std::vector<unsigned int> &rungs) const;
    /// The rung whose largest error over all quantities is the smallest, and
    /// that error; -1 where there are none.
    std::pair<int, double>
    nearest_to_reference() const;
    /// `TBT: 75 DoFs, 0.3 s (off by 0.2 %).`
    std::string
    described(const unsigned int k, const unsigned int q) const;

    /// rungs(), quantities(), tolerances() and reference_rung().
    std::vector<RungResult>    all;
    std::vector<NamedQuantity> asked;
    std::vector<double>        bounds;
    int                        against = -1;
  };

  /// Prints the costs of all rungs, their errors in per cent with their own
  /// bars beside them, how often these hold, and the sentences for each
  /// tolerance and quantity. @p out takes plain text.
  void
  print_trade(std::ostream &out, const TradeTable &table);

  /// Writes the file @p path, one line a rung and quantity: rung, theory, dofs,
  /// seconds, the phases, memory_mb, quantity, value, reference, error
  /// (relative), front_seconds and front_dofs (1 on the front), bar (relative
  /// to the reference; empty if there is none), failure. A rung that failed has
  /// one line, with empty cells and why. Throws InputError if the file cannot
  /// be written.
  void
  write_trade_csv(const TradeTable &table, const std::string &path);
} // namespace lamella

#endif
