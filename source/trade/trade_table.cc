// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/section/theory.h>
#include <lamella/trade/trade_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamella
{
  namespace
  {
    Theory
    theory_of(const RungResult &rung)
    {
      return Theory::parse(Entry("Theory", rung.theory));
    }



    /// Whether the theory of @p one holds that of @p other. Runs to a tolerance
    /// hold those to a larger one, and no others.
    bool
    holds(const RungResult &one, const RungResult &other)
    {
      if (one.tolerance || other.tolerance)
        return one.tolerance && other.tolerance &&
               *one.tolerance <= *other.tolerance;
      return theory_of(one).holds(theory_of(other));
    }
  } // namespace



  TradeTable::TradeTable(std::vector<RungResult>    rungs,
                         std::vector<NamedQuantity> quantities,
                         const std::string         &reference,
                         std::vector<double>        tolerances)
    : all(std::move(rungs))
    , asked(std::move(quantities))
    , bounds(std::move(tolerances))
  {
    if (reference != "given")
      against = find_reference(reference);
  }



  int
  TradeTable::find_reference(const std::string &name) const
  {
    for (int k = all.size() - 1; k >= 0; --k)
      {
        const bool meant = name == "finest" || all[k].name == name ||
                           (name == "solid" && !all[k].tolerance &&
                            theory_of(all[k]).is_solid());
        if (meant && all[k].failure.empty())
          return k;
        if (meant && all[k].name == name)
          throw NumericsError(
            "the rung '" + name +
            "', which is the reference, failed: " + all[k].failure);
      }
    throw NumericsError(
      name == "solid" ?
        "no rung with hexahedra succeeded, so there is no reference." :
        "no rung of the ladder succeeded. The first failed because: " +
          all.front().failure);
  }



  double
  TradeTable::reference(const unsigned int q) const
  {
    return against < 0 ? asked[q].given.value() : all[against].values[q];
  }



  bool
  TradeTable::has_error(const unsigned int k, const unsigned int q) const
  {
    return all[k].failure.empty() && static_cast<int>(k) != against &&
           reference(q) != 0.;
  }



  double
  TradeTable::error(const unsigned int k, const unsigned int q) const
  {
    return std::abs(all[k].values[q] / reference(q) - 1.);
  }



  double
  TradeTable::cost(const unsigned int k, const Cost cost) const
  {
    return cost == Cost::seconds ? all[k].seconds : all[k].dofs;
  }



  bool
  TradeTable::made_bar(const unsigned int k, const unsigned int q) const
  {
    return !all[k].bars.empty() && all[k].bars[q].has_value();
  }



  std::optional<double>
  TradeTable::bar(const unsigned int k, const unsigned int q) const
  {
    if (!made_bar(k, q) || !all[k].bars[q]->trusted || reference(q) == 0.)
      return std::nullopt;
    return all[k].bars[q]->bar / std::abs(reference(q));
  }



  bool
  TradeTable::is_richer(const unsigned int other, const unsigned int k) const
  {
    return holds(all[other], all[k]) && all[other].axis >= all[k].axis &&
           all[other].section >= all[k].section && !all[other].overridden &&
           !all[k].overridden && all[other].dofs > all[k].dofs;
  }



  int
  TradeTable::richer_and_worse(const unsigned int k,
                               const unsigned int q,
                               const double       least) const
  {
    for (unsigned int other = 0; other < all.size(); ++other)
      if (is_richer(other, k) && has_error(other, q) && error(other, q) > least)
        return other;
    return -1;
  }



  bool
  TradeTable::is_accident(const unsigned int k, const unsigned int q) const
  {
    // A chance of less than that does no harm.
    constexpr double times = 2., least = 1e-3;
    return richer_and_worse(k, q, std::max(times * error(k, q), least)) >= 0;
  }



  std::vector<unsigned int>
  TradeTable::front(const unsigned int q, const Cost kind) const
  {
    std::vector<unsigned int> result;
    for (unsigned int k = 0; k < all.size(); ++k)
      if (has_error(k, q) && !is_accident(k, q))
        result.push_back(k);
    const auto price = [&](const unsigned int k) {
      return std::make_pair(cost(k, kind), error(k, q));
    };
    std::sort(result.begin(),
              result.end(),
              [&](const unsigned int a, const unsigned int b) {
                return price(a) < price(b);
              });
    // By rising cost, only what is closer than everything before it.
    std::vector<unsigned int> front;
    for (const unsigned int k : result)
      if (front.empty() || error(k, q) < error(front.back(), q))
        front.push_back(k);
    return front;
  }



  std::vector<unsigned int>
  TradeTable::within(const unsigned int q, const double tolerance) const
  {
    std::vector<unsigned int> result;
    for (unsigned int k = 0; k < all.size(); ++k)
      if (has_error(k, q) && error(k, q) <= tolerance)
        result.push_back(k);
    return result;
  }



  int
  TradeTable::cheapest_of(const std::vector<unsigned int> &rungs) const
  {
    if (rungs.empty())
      return -1;
    double least = cost(rungs.front(), Cost::seconds);
    for (const unsigned int k : rungs)
      least = std::min(least, cost(k, Cost::seconds));
    int best = -1;
    for (const unsigned int k : rungs)
      if (cost(k, Cost::seconds) <= 1.05 * least + 0.1 &&
          (best < 0 || all[k].dofs < all[best].dofs))
        best = k;
    return best;
  }



  int
  TradeTable::cheapest(const unsigned int q, const double tolerance) const
  {
    return cheapest_of(within(q, tolerance));
  }



  int
  TradeTable::cheapest_to_count_on(const unsigned int q,
                                   const double       tolerance) const
  {
    std::vector<unsigned int> sure;
    for (const unsigned int k : within(q, tolerance))
      if (richer_and_worse(k, q, tolerance) < 0)
        sure.push_back(k);
    return cheapest_of(sure);
  }



  std::pair<int, double>
  TradeTable::nearest_to_reference() const
  {
    std::pair<int, double> nearest(-1, std::numeric_limits<double>::infinity());
    for (unsigned int k = 0; k < all.size(); ++k)
      {
        double most = 0.;
        bool   any  = false;
        for (unsigned int q = 0; q < asked.size(); ++q)
          if (has_error(k, q))
            {
              any  = true;
              most = std::max(most, error(k, q));
            }
        if (any && most < nearest.second)
          nearest = {k, most};
      }
    return nearest;
  }
} // namespace lamella
