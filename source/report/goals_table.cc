// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/report/console.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/tables.h>

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
      static const std::vector<std::string> names{
        "axis", "fields", "section", "contact", "path"};
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



    /// Name of the largest contribution to the error; empty if all are zero.
    std::string
    largest_share(const GoalResult &goal)
    {
      std::string largest;
      for (const auto &[name, share] : goal.shares)
        if (share != 0. &&
            (largest.empty() ||
             std::abs(share) > std::abs(share_of(goal, largest))))
          largest = name;
      return largest;
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
        {"axis and section",
         "shorter elements along the axis (Axis elements) and a higher degree "
         "over the section (LE-N)"},
        {"contact", "a larger Penalty, or Enforcement = exact"},
        {"path", "more Substeps"}};
      return all.at(source);
    }



    /// Sentences on goals, each once with all its goals, in order of the first.
    class Sayings
    {
    public:
      void
      add(const std::string &goal, const std::string &what)
      {
        for (auto &[said, goals] : all)
          if (said == what)
            {
              goals.push_back(goal);
              return;
            }
        all.push_back({what, {goal}});
      }

      /// @p before, the goals, @p one or @p several, what is said.
      void
      print(std::ostream      &out,
            const std::string &before,
            const std::string &one,
            const std::string &several) const
      {
        for (const auto &[what, goals] : all)
          out << "  " << before << joined(goals, "; ")
              << (goals.size() == 1 ? one : several) << what << ".\n";
      }

    private:
      std::vector<std::pair<std::string, std::vector<std::string>>> all;
    };



    /// @p value to @p digits, with the unit of @p goal.
    std::string
    number_text(const GoalResult &goal, const double value, const int digits)
    {
      return trimmed(to_text(value, digits) + " " + goal.unit);
    }



    /// What the linear model leaves out, if that is worth a word.
    void
    print_nonlinear_effects(std::ostream &out, const Results &results)
    {
      const NonlinearityEstimate &beyond = results.last().checks.beyond;
      constexpr double            less   = 1e-2;
      if (beyond.stiffening > less || beyond.buckling_factor)
        {
          out << "  All of these are of the linear model, which no refinement "
                 "mends:";
          if (beyond.stiffening > less)
            out << " stiffening by large deflections "
                << to_text(100. * beyond.stiffening, 2) << " %";
          if (beyond.buckling_factor)
            out << (beyond.stiffening > less ? "," : "") << " buckling at "
                << to_text(*beyond.buckling_factor, 3) << " times these loads";
          out << ".\n";
        }
    }
  } // namespace



  std::string
  share_text(const GoalResult &goal, const double value)
  {
    if (goal.scale == 0.)
      return number_text(goal, value, 2);
    const std::string share = to_text(100. * value / goal.scale, 2) + " %";
    return goal.is_near_zero() ?
             number_text(goal, value, 2) + " (" + share + ")" :
             share;
  }



  std::string
  goals_csv(const Results &results)
  {
    std::string text =
      "goal,value,estimate,corrected,bar,trusted,tolerance,met";
    for (const std::string &source : sources())
      text += "," + source;
    text += ",stiffening,buckling_factor,scale,why\n";
    for (const GoalResult &goal : results.goals)
      {
        const NonlinearityEstimate &beyond = results.last().checks.beyond;
        CsvLine                     line;
        line << '"' + goal.name + '"' << goal.value << goal.estimate
             << goal.value + goal.estimate
             << (goal.trusted ? csv(goal.bar) : "") << goal.trusted
             << (goal.tolerance ? csv(goal.allowed_error()) : "")
             << (goal.tolerance ? (goal.met() ? "1" : "0") : "");
        for (const std::string &source : sources())
          line << share_of(goal, source);
        line << beyond.stiffening << beyond.buckling_factor << goal.scale
             << '"' + goal.why + '"';
        text += line.text();
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
          const std::string name = '"' + goal.name + '"';
          for (const ElementError &element : goal.local->elements)
            text += (CsvLine() << name << results.bodies[element.body].name
                               << element.begin << element.end << element.error)
                      .text();
          text +=
            (CsvLine() << name << "(contact),," << goal.local->contact).text();
          text +=
            (CsvLine() << name << "(remainder),," << goal.local->remainder)
              .text();
        }
    return text;
  }



  void
  print_goals(std::ostream &out, const Results &results)
  {
    const std::vector<GoalResult> &goals = results.goals;
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
    Sayings near_zero, allowed, no_bar, wanting;
    for (const GoalResult &goal : goals)
      {
        constexpr double much = 0.01;
        if (goal.is_near_zero())
          near_zero.add(goal.name, number_text(goal, goal.scale, 4));
        if (goal.tolerance &&
            (goal.is_near_zero() || goal.tolerance->is_absolute))
          allowed.add(goal.name, number_text(goal, goal.allowed_error(), 3));
        if (!goal.trusted)
          no_bar.add(goal.name, goal.why);
        else if (const std::string source = largest_share(goal);
                 goal.bar > much * goal.scale && !source.empty())
          wanting.add(goal.name, remedy(source));
      }
    near_zero.print(out,
                    "",
                    " is near zero: per cent are of the largest of its kind, ",
                    " are near zero: per cent are of the largest of their "
                    "kind, ");
    allowed.print(out, "", " may be off by ", " may be off by ");
    no_bar.print(out, "No bar for ", " yet: ", " yet: ");
    wanting.print(out, "", " wants ", " want ");
    print_nonlinear_effects(out, results);
  }
} // namespace lamella
