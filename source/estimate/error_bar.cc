// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/estimate/error_bar.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// Returns why successive changes @p first and @p second give no bar.
    std::string
    distrust_reason(const double         first,
                    const double         second,
                    const double         scale,
                    const EstimateRules &rules)
    {
      if (first * second > rules.growth * first * first)
        return "the quantity changes more in each refinement, by " +
               to_text(100. * std::abs(first) / scale, 2) + " and then by " +
               to_text(100. * std::abs(second) / scale, 2) + " %" +
               describe_growth();
      return "two refinements do not agree: one changes the quantity by " +
             to_text(100. * first / scale, 2) + " %, the next by " +
             to_text(100. * second / scale, 2) + " %. Refine theory or mesh";
    }
  } // namespace



  std::string
  describe_growth()
  {
    return ", as at a singularity (a point load, the edge of a clamp, the "
           "corner of a punch). Move the probe away from such points";
  }



  ErrorBar
  error_bar(const Refinements &values, const EstimateRules &rules)
  {
    const double first  = values.richer - values.run,
                 second = values.richest - values.richer;
    ErrorBar result;
    result.estimate = values.richest - values.run;
    const double spread =
      std::max({std::abs(first), std::abs(second), std::abs(result.estimate)});
    const double rounding =
      std::max(values.rounding, rules.digits * values.scale);
    result.bar = std::max({rules.safety * std::abs(result.estimate),
                           rules.of_shares * values.shares,
                           rounding});

    if (std::abs(second) <= rules.max_remaining_share * std::abs(first) ||
        spread <= rounding)
      result.trusted = true;
    else if (spread <= rules.small * values.scale)
      {
        result.trusted = true;
        result.bar     = std::max(result.bar, rules.safety * spread);
      }
    else
      result.why = distrust_reason(first, second, values.scale, rules);
    return result;
  }



  ErrorBar
  coarser_model_bar(const std::vector<Levels> &sources,
                    const double               scale,
                    const double               rounding,
                    const EstimateRules       &rules)
  {
    ErrorBar result;
    result.trusted = true;
    for (const Levels &levels : sources)
      {
        const double d = std::abs(levels.last), e = std::abs(levels.before);
        const bool   contracts = e > 0. && d <= rules.max_remaining_share * e;
        const double left      = contracts ? (d / e) / (1. - d / e) : 1.;
        result.estimate += levels.last * left;
        result.parts.push_back(
          contracts ? std::max({d, rules.safety * d * left, levels.least}) :
                      std::max(rules.safety * std::max(d, e), levels.least));
        result.bar += result.parts.back();
        if (!contracts && std::max(d, e) > rules.small * scale)
          {
            result.trusted = false;
            result.why     = distrust_reason(e, d, scale, rules);
          }
      }
    result.bar = std::max({result.bar, rounding, rules.digits * scale});
    return result;
  }
} // namespace lamella
