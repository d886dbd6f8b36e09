// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/report/console.h>
#include <lamella/report/fields_table.h>
#include <lamella/report/goals_table.h>

#include <cmath>
#include <map>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// The columns of shares, whether a goal has them all or not.
    const std::vector<std::string> &
    sources()
    {
      static const std::vector<std::string> names{"axis",
                                                  "fields",
                                                  "section",
                                                  "contact"};
      return names;
    }



    double
    share_of(const GoalResult &goal, const std::string &source)
    {
      for (const auto &[name, share] : goal.shares)
        if (name == source)
          return share;
      return 0.;
    }



    std::string
    remedy(const std::string &source)
    {
      static const std::map<std::string, std::string> all{
        {"axis", "shorter elements along the axis (Axis elements)"},
        {"fields", "a richer theory (SV-N with a larger N, or LE-N)"},
        {"section",
         "a higher degree over the section (LE-N, Section order) or more cells "
         "in it"},
        {"contact", "a larger Penalty, or Enforcement = exact"}};
      return all.at(source);
    }



    /// @p value over the goal's scale, as in "0.12 %"; the value itself where
    /// all of its kind are zero.
    std::string
    share_text(const GoalResult &goal, const double value)
    {
      if (goal.scale == 0.)
        return to_text(value, 2);
      return to_text(100. * value / goal.scale, 2) + " %";
    }
  } // namespace



  std::string
  largest_share(const GoalResult &goal)
  {
    std::string largest;
    for (const auto &[name, share] : goal.shares)
      if (share != 0. && (largest.empty() ||
                          std::abs(share) > std::abs(share_of(goal, largest))))
        largest = name;
    return largest;
  }



  std::string
  goals_csv(const std::vector<GoalResult> &goals)
  {
    std::string text =
      "goal,value,estimate,corrected,bar,trusted,tolerance,met";
    for (const std::string &source : sources())
      text += "," + source;
    text += ",kinematics,scale,why\n";
    for (const GoalResult &goal : goals)
      {
        text += '"' + goal.name + '"' + "," + csv(goal.value) + "," +
                csv(goal.estimate) + "," + csv(goal.value + goal.estimate) +
                "," + (goal.trusted ? csv(goal.bar) : "") + "," +
                (goal.trusted ? "1" : "0") + "," +
                (goal.tolerance ? csv(*goal.tolerance * goal.scale) : "") +
                "," + (goal.tolerance ? (goal.met() ? "1" : "0") : "");
        for (const std::string &source : sources())
          text += "," + csv(share_of(goal, source));
        text += "," + csv(goal.kinematics) + "," + csv(goal.scale) + ",\"" +
                goal.why + "\"\n";
      }
    return text;
  }



  std::string
  indicators_csv(const Results &results)
  {
    std::string text = "goal,body,begin,end,error\n";
    for (const GoalResult &goal : results.goals)
      if (goal.local)
        {
          const std::string name = '"' + goal.name + "\",";
          for (const ElementError &element : goal.local->elements)
            text += name + results.bodies[element.body].name + "," +
                    csv(element.begin) + "," + csv(element.end) + "," +
                    csv(element.error) + "\n";
          text += name + "(contact),,," + csv(goal.local->contact) + "\n";
          text += name + "(remainder),,," + csv(goal.local->remainder) + "\n";
        }
    return text;
  }



  namespace
  {
    /// The names of those of @p goals that have no bar, because of @p why.
    std::vector<std::string>
    without_bar(const std::vector<GoalResult> &goals, const std::string &why)
    {
      std::vector<std::string> names;
      for (const GoalResult &goal : goals)
        if (!goal.trusted && goal.why == why)
          names.push_back(goal.name);
      return names;
    }
  } // namespace



  void
  print_goals(std::ostream &out, const std::vector<GoalResult> &goals)
  {
    if (goals.empty())
      return;
    out << "\nGoals, with what is held of their errors:\n";
    TextTable table{{"goal", "value", "bar", "estimated error", "from"}};
    for (const GoalResult &goal : goals)
      table.push_back(
        {goal.name,
         to_text(goal.value, 7),
         goal.trusted ? "+- " + share_text(goal, goal.bar) : "no bar yet",
         (goal.estimate > 0. ? "+" : "") + share_text(goal, goal.estimate),
         largest_share(goal)});
    print_table(out, table);
    for (const GoalResult &goal : goals)
      if (goal.scale != std::abs(goal.value))
        out << "  " << goal.name << " is near zero: per cent are of "
            << to_text(goal.scale) << ", the largest of its kind.\n";
    for (const GoalResult &goal : goals)
      {
        constexpr double much = 0.01;
        if (!goal.trusted)
          {
            // A reason that several have is said once.
            if (const auto names = without_bar(goals, goal.why);
                names.front() == goal.name)
              out << "  No bar for " << joined(names) << " yet: " << goal.why
                  << ".\n";
          }
        else if (const std::string source = largest_share(goal);
                 goal.bar > much * goal.scale && !source.empty())
          out << "  " << goal.name << " wants " << remedy(source) << ".\n";
        if (goal.kinematics > std::max(goal.bar, 1e-3 * goal.scale))
          out << "  " << goal.name
              << ": rotations that are not small change it "
              << "by some " << share_text(goal, goal.kinematics)
              << ", which no refinement shows.\n";
      }
  }
} // namespace lamella
