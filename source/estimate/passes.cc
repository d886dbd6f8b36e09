// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/passes.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// Returns the bar of @p goal over its tolerance; without a bar, twice the
    /// estimate stands in for it.
    double
    error_ratio(const GoalResult &goal)
    {
      return (goal.trusted ? goal.bar : 2. * std::abs(goal.estimate)) /
             goal.allowed_error();
    }



    /// Returns whether the name @p share includes @p source: some shares are of
    /// two sources that are not separated.
    bool
    is_of(const std::string &share, const Source source)
    {
      return share.find(name_of(source)) != std::string::npos;
    }



    /// Returns whether no source contributes more to the error of @p goal than
    /// the section.
    bool
    is_of_section(const GoalResult &goal)
    {
      double section = 0., largest = 0.;
      for (const auto &[name, share] : goal.shares)
        {
          largest = std::max(largest, std::abs(share));
          if (is_of(name, Source::section))
            section = std::max(section, std::abs(share));
        }
      return section > 0. && section == largest;
    }



    /// Returns the error of @p goal from elements that are not bisected.
    double
    of_others(const GoalResult &goal, const PassRefinement &refined)
    {
      double sum = 0.;
      if (refined.marked && goal.local)
        for (const ElementError &element : goal.local->elements)
          if (std::none_of(refined.marked->begin(),
                           refined.marked->end(),
                           [&element](const ElementError &other) {
                             return other.body == element.body &&
                                    other.begin == element.begin;
                           }))
            sum += std::abs(element.error);
      return sum;
    }
  } // namespace



  void
  shorten(GoalResult          &goal,
          const PassHistory   &course,
          const EstimateRules &rules)
  {
    const auto &[first, before, then, now] = course;
    if (!goal.trusted || !before.trusted || then.sources != now.sources)
      return;
    const auto is_refined = [&now = now](const std::string &share) {
      return std::any_of(now.sources.begin(),
                         now.sources.end(),
                         [&share](const Source source) {
                           return is_of(share, source);
                         });
    };
    double b = 0., own = 0., rest = 0.;
    for (const auto &[name, share] : before.shares)
      b += is_refined(name) ? std::abs(share) : 0.;
    for (const auto &[name, share] : goal.shares)
      (is_refined(name) ? own : rest) += std::abs(share);
    const double d = std::abs(goal.value - before.value),
                 q = d / std::min(b, std::abs(before.value - first.value));
    if (!(q <= rules.max_remaining_share))
      return;
    const double by_pass =
      std::max(
        {d, rules.safety * d * q / (1. - q), rules.min_share_of_previous * b}) +
      of_others(before, now);
    if (by_pass >= own)
      return;
    for (auto &[name, share] : goal.shares)
      share *= is_refined(name) ? by_pass / own : 1.;
    goal.bar =
      std::max({by_pass + rest, rules.digits * goal.scale, goal.least});
  }



  void
  raise_share(GoalResult &goal, const Source source, const double least)
  {
    for (auto &[name, share] : goal.shares)
      if (name == name_of(source) && std::abs(share) < least)
        {
          goal.bar += least - std::abs(share);
          share = std::copysign(least, share);
        }
  }



  Passes::Passes(const EstimateRules &rules)
    : rules(rules)
  {}



  namespace
  {
    /// Returns @p pass with the goals of @p before, in their order. A mode that
    /// was not found again has no bar.
    Pass
    with_goals_of(const Pass &before, Pass pass)
    {
      const auto             &found = pass.goals;
      std::vector<GoalResult> goals;
      for (unsigned int g = 0; g < before.goals.size(); ++g)
        {
          const GoalResult &goal    = before.goals[g];
          const auto        is_same = [&](const GoalResult &one) {
            return one.name == goal.name;
          };
          const auto same = g < found.size() && is_same(found[g]) ?
                              found.begin() + g :
                              std::find_if(found.begin(), found.end(), is_same);
          goals.push_back(same == found.end() ? goal : *same);
          if (same != found.end())
            continue;
          goals.back().trusted = false;
          goals.back().why     = no_similar_mode;
        }
      pass.goals = std::move(goals);
      return pass;
    }
  } // namespace



  void
  Passes::add(const Pass &pass, const PassRefinement &refined)
  {
    made.push_back(made.empty() ? pass : with_goals_of(made.back(), pass));
    refinements.push_back(refined);
    const std::size_t n = made.size();
    if (refined.divides_cells && before_division == 0)
      before_division = n - 1;
    if (n > 2)
      for (unsigned int g = 0; g < last().goals.size(); ++g)
        shorten(made.back().goals[g],
                {made[n - 3].goals[g],
                 made[n - 2].goals[g],
                 refinements[n - 2],
                 refined},
                rules);
    dropped_in_pass.resize(last().goals.size(), 0);
    for (unsigned int g = 0; g < dropped_in_pass.size(); ++g)
      if (dropped_in_pass[g] == 0 && must_be_dropped(g))
        dropped_in_pass[g] = made.size();
  }



  double
  Passes::change(const unsigned int number) const
  {
    return std::abs(last().goals[number].value -
                    made[made.size() - 2].goals[number].value);
  }



  bool
  Passes::is_met(const unsigned int number) const
  {
    if (!last().goals[number].met())
      return false;
    if (made.size() < 2)
      return true;
    // A larger change shows an error that the bar of the pass before missed.
    const GoalResult &before = made[made.size() - 2].goals[number];
    return !before.trusted || change(number) <= before.bar;
  }



  bool
  Passes::grows(const unsigned int number) const
  {
    if (last().goals[number].trusted || made.size() < 3)
      return false;
    const double before = std::abs(made[made.size() - 2].goals[number].value -
                                   made[made.size() - 3].goals[number].value);
    return change(number) > rules.growth * before;
  }



  bool
  Passes::must_be_dropped(const unsigned int number) const
  {
    const GoalResult &goal       = last().goals[number];
    const auto        has_no_bar = [number](const Pass &pass) {
      return !pass.goals[number].trusted;
    };
    if (!goal.has_limit)
      return true;
    // Division of cells is the last remedy for an error of the section.
    if (refinements.back().divides_cells && !goal.trusted &&
        is_of_section(goal))
      return true;
    // Several passes without a bar and with large changes indicate no limit.
    const std::size_t alike = made.size() - before_division;
    const bool        waits =
      before_division == 0 && is_of_section(goal) && !grows(number);
    if (alike >= rules.patience && !waits &&
        std::all_of(made.end() - rules.patience, made.end(), has_no_bar) &&
        change(number) > goal.allowed_error())
      return true;
    if (alike <= rules.slow_passes || goal.met() || waits)
      return false;
    double before = 0.;
    for (unsigned int k = 1; k <= rules.slow_passes; ++k)
      if (const GoalResult &one = made[made.size() - 1 - k].goals[number];
          one.trusted)
        before = std::max(before, error_ratio(one));
    return before > 0. && error_ratio(goal) > rules.min_progress * before;
  }



  double
  Passes::predicted_seconds(const double operations) const
  {
    const double before = made.size() > 1 ? made[made.size() - 2].seconds : 0.;
    return (last().seconds - before) *
           std::max(operations, rules.free_operations) /
           std::max(last().operations, rules.free_operations);
  }



  bool
  Passes::all_goals_met() const
  {
    for (unsigned int g = 0; g < last().goals.size(); ++g)
      if (!is_met(g))
        return false;
    return true;
  }



  std::vector<GoalResult>
  Passes::open_goals() const
  {
    std::vector<GoalResult> with_error_bar, open;
    for (unsigned int g = 0; g < last().goals.size(); ++g)
      if (!is_met(g) && dropped_in_pass[g] == 0)
        {
          open.push_back(last().goals[g]);
          if (last().goals[g].trusted)
            with_error_bar.push_back(last().goals[g]);
        }
    return with_error_bar.empty() ? open : with_error_bar;
  }



  std::vector<std::string>
  Passes::dropped_goals() const
  {
    std::vector<std::string> sentences;
    for (unsigned int g = 0; g < last().goals.size(); ++g)
      if (const GoalResult &goal = last().goals[g];
          dropped_in_pass[g] == made.size())
        sentences.push_back(
          "no further refinement pass is made for " + goal.name + ": " +
          (goal.trusted ? "its error bar has not decreased by a third in two "
                          "passes" :
                          goal.why));
    return sentences;
  }



  std::vector<Source>
  Passes::wanted() const
  {
    std::vector<std::string> names;
    for (const GoalResult &goal : open_goals())
      {
        auto shares = goal.shares;
        std::sort(shares.begin(),
                  shares.end(),
                  [](const auto &one, const auto &other) {
                    return std::abs(one.second) > std::abs(other.second);
                  });
        double left = 0.;
        for (const auto &share : shares)
          left += std::abs(share.second);
        for (const auto &[name, share] : shares)
          {
            const bool is_first = name == shares.front().first;
            if (is_first ||
                left > rules.max_unrefined_share * goal.allowed_error())
              names.push_back(name);
            left -= std::abs(share);
          }
      }
    std::vector<Source> sources;
    for (const NameOf<Source> &source : Names<Source>::all)
      if (std::any_of(names.begin(), names.end(), [&source](const auto &name) {
            return is_of(name, source.value);
          }))
        sources.push_back(source.value);
    return sources;
  }



  bool
  Passes::degrees_stall() const
  {
    const auto &now = refinements.back().sources;
    if (std::find(now.begin(), now.end(), Source::section) == now.end() ||
        made[made.size() - 2].recipe != last().recipe)
      return false;
    const auto share_of = [](const GoalResult &goal) {
      for (const auto &[name, share] : goal.shares)
        if (name == name_of(Source::section))
          return std::abs(share);
      return 0.;
    };
    for (const GoalResult &goal : open_goals())
      for (const GoalResult &before : made[made.size() - 2].goals)
        if (before.name == goal.name &&
            share_of(goal) > rules.max_degree_ratio * share_of(before) &&
            share_of(goal) > rules.max_unrefined_share * goal.allowed_error())
          return true;
    return false;
  }



  bool
  Passes::is_loss_acceptable(const std::vector<double> &lost) const
  {
    for (unsigned int g = 0; g < lost.size(); ++g)
      if (const GoalResult &goal = last().goals[g];
          dropped_in_pass[g] == 0 &&
          lost[g] > rules.max_unrefined_share * goal.allowed_error())
        return false;
    return true;
  }



  double
  Passes::largest_change() const
  {
    double worst = 0.;
    if (made.size() > 1)
      for (unsigned int g = 0; g < last().goals.size(); ++g)
        worst = std::max(worst, change(g) / last().goals[g].allowed_error());
    return worst;
  }



  std::string
  Passes::reason_to_stop() const
  {
    if (all_goals_met())
      return "all goals are within their tolerances";
    const std::vector<GoalResult> goals = open_goals();
    if (goals.empty())
      return "refinement does not improve quantities beyond their tolerance";
    for (const GoalResult &goal : goals)
      if (goal.shares.empty())
        return goal.why;
    if (made.size() == rules.max_passes)
      return std::to_string(rules.max_passes) + " refinement passes are done";
    if (wanted().empty())
      return "theory and mesh cannot be refined any further";
    return "";
  }
} // namespace lamella
