// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/recover/results.h>

#include <cmath>
#include <regex>

namespace lamella
{
  void
  StepResults::drop_fields()
  {
    State kept;
    kept.iterations = state.iterations;
    kept.solved_by  = state.solved_by;
    state           = std::move(kept);
    memory          = StrategyHistory();
    probes.clear();
    lines.clear();
    cuts.clear();
    contacts.clear();
    plies_along.clear();
    for (KktResidual &contact : checks.contacts)
      contact.of_rows.clear();
  }



  unsigned int
  Results::n_dofs() const
  {
    unsigned int sum = 0;
    for (const BodySummary &body : bodies)
      sum += body.dofs;
    return sum;
  }



  namespace
  {
    /// Warning of one or several load steps, whose numbers may differ, and of
    /// the load at first failure.
    struct StepWarning
    {
      /// What is left of it without its numbers.
      std::string kind;
      /// Step of its largest load factor; null if it is of first failure.
      std::string        text;
      const StepResults *step;
      /// In their order, and whether all of them say the same.
      std::vector<unsigned int> steps;
      bool                      same = true, at_failure = false;
    };



    /// @p text with # for each number; names such as c-1 and tip/2 are none.
    std::string
    without_numbers(const std::string &text)
    {
      static const std::regex number(
        R"((^|[ (=])[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)");
      return std::regex_replace(text, number, "$1#");
    }



    /// Merges the warning @p text of @p step, or if that is null of first
    /// failure, at the load factor @p factor, into @p all.
    void
    merge(const std::string        &text,
          const StepResults        *step,
          const double              factor,
          std::vector<StepWarning> &all)
    {
      const std::string kind = without_numbers(text);
      // The same kind twice in a step is two warnings.
      const auto known =
        std::find_if(all.begin(), all.end(), [&](const StepWarning &w) {
          return w.kind == kind &&
                 (step == nullptr ? !w.at_failure :
                                    w.steps.back() != step->step);
        });
      if (known == all.end())
        {
          all.push_back({kind, text, step, {}, true, step == nullptr});
          if (step != nullptr)
            all.back().steps = {step->step};
          return;
        }
      if (step != nullptr)
        known->steps.push_back(step->step);
      else
        known->at_failure = true;
      known->same = known->same && known->text == text;
      if (std::abs(factor) >= std::abs(known->step->load_factor.of_scene()))
        {
          known->text = text;
          known->step = step;
        }
    }



    /// Returns the warnings of all steps of @p results and of first failure,
    /// each kind once, in the order of their first occurrence.
    std::vector<StepWarning>
    warnings_by_kind(const Results &results)
    {
      std::vector<StepWarning> all;
      for (const StepResults &step : results.steps)
        for (const std::string &text : step.warnings)
          merge(text, &step, step.load_factor.of_scene(), all);
      if (results.first_failure)
        for (const std::string &text : results.first_failure->warnings)
          merge(text, nullptr, results.first_failure->failing, all);
      return all;
    }



    /// `1-3, 5` of the ascending @p numbers.
    std::string
    ranges(const std::vector<unsigned int> &numbers)
    {
      std::string text;
      for (unsigned int k = 0, end; k < numbers.size(); k = end)
        {
          end = k + 1;
          while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
          text += (text.empty() ? "" : ", ") + std::to_string(numbers[k]);
          if (end > k + 1)
            text += "-" + std::to_string(numbers[end - 1]);
        }
      return text;
    }



    /// Returns `load step 2: `, `load steps 1-3 (numbers of step 3): `, `first
    /// failure: ` or `load step 1 and first failure (numbers of first failure):
    /// `.
    std::string
    place_of(const StepWarning &warning)
    {
      std::string text;
      if (!warning.steps.empty())
        text = (warning.steps.size() == 1 ? "load step " : "load steps ") +
               ranges(warning.steps);
      if (warning.at_failure)
        text += (text.empty() ? "" : " and ") + std::string("first failure");
      if (!warning.same)
        text += " (numbers of " +
                (warning.step == nullptr ?
                   "first failure" :
                   "step " + std::to_string(warning.step->step)) +
                ")";
      return text + ": ";
    }
    /// Warning with the names that it applies to: the text @p before a name of
    /// kind @p noun, and the text after it.
    struct NamedWarning
    {
      std::string              before, noun, after;
      std::vector<std::string> names;

      std::string
      text() const
      {
        if (names.empty())
          return before;
        if (names.size() == 1)
          return before + noun + " " + names.front() + ": " + after;
        return before + std::to_string(names.size()) + " " +
               (noun == "body" ? "bodies" : noun + "s") + " (" + joined(names) +
               "): " + after;
      }
    };



    /// Merges @p warnings that differ only by the name of a contact or body.
    std::vector<std::string>
    merged(const std::vector<std::string> &warnings)
    {
      static const std::regex   named(R"(\b(contact|body) ([^ :]+): )");
      std::vector<NamedWarning> all;
      for (const std::string &text : warnings)
        {
          NamedWarning one{text, "", "", {}};
          std::smatch  found;
          if (std::regex_search(text, found, named))
            one = {found.prefix(), found[1], found.suffix(), {found[2]}};
          const auto known = std::find_if(all.begin(),
                                          all.end(),
                                          [&](const NamedWarning &other) {
                                            return other.before == one.before &&
                                                   other.noun == one.noun &&
                                                   other.after == one.after;
                                          });
          if (known == all.end())
            all.push_back(one);
          else if (!one.names.empty() &&
                   one.names.front() != known->names.back())
            known->names.push_back(one.names.front());
        }
      std::vector<std::string> result;
      for (const NamedWarning &one : all)
        result.push_back(one.text());
      return result;
    }



    /// The place of @p name among @p names of @p kind.
    unsigned int
    place_of(const std::string              &kind,
             const std::string              &name,
             const std::vector<std::string> &names)
    {
      const auto place = std::find(names.begin(), names.end(), name);
      if (place == names.end())
        throw InputError("recover.unknown-name: The results have no " + kind +
                         " '" + name + "'. The names are " + joined(names) +
                         ".");
      return place - names.begin();
    }
  } // namespace



  std::vector<std::string>
  Results::all_warnings() const
  {
    std::vector<std::string> warnings = notes;
    for (const StepWarning &warning : warnings_by_kind(*this))
      {
        // The place follows the identifier.
        static const std::regex identifier(R"(^[a-z]+\.[a-z0-9-]+: )");
        std::string             text = warning.text;
        std::smatch             found;
        std::regex_search(text, found, identifier);
        if (load_steps > 1 || warning.at_failure)
          text.insert(found.length(), place_of(warning));
        warnings.push_back(text);
      }
    warnings.insert(warnings.end(), endnotes.begin(), endnotes.end());
    return merged(warnings);
  }



  NonlinearityEstimate
  Results::worst_nonlinearity() const
  {
    NonlinearityEstimate worst;
    for (const StepResults &step : steps)
      {
        const NonlinearityEstimate &one = step.checks.beyond;
        if (one.stiffening > worst.stiffening)
          {
            worst.stiffening = one.stiffening;
            worst.stiffened  = one.stiffened;
          }
        if (one.buckling_factor &&
            (!worst.buckling_factor ||
             *one.buckling_factor < *worst.buckling_factor))
          {
            worst.buckling_factor = one.buckling_factor;
            worst.buckled         = one.buckled;
          }
      }
    return worst;
  }



  const StepResults &
  Results::last() const
  {
    if (steps.empty())
      throw InputError("recover.no-load-step: No load step is solved.");
    return steps.back();
  }



  const FieldRow &
  Results::probe(const std::string &name, const unsigned int ply) const
  {
    const auto &rows = last().probes[place_of("probe", name, probes)];
    if (ply == 0)
      return rows.front();
    std::vector<std::string> plies;
    for (const FieldRow &row : rows)
      if (row.ply + 1 == ply)
        return row;
      else
        plies.push_back(std::to_string(row.ply + 1));
    throw InputError("recover.wrong-ply: The probe '" + name +
                     "' is not in ply " + std::to_string(ply) + " but in " +
                     joined(plies) + ".");
  }



  const Resultant &
  Results::support(const std::string &name) const
  {
    return last().checks.reactions[place_of("support", name, supports)];
  }



  const KktResidual &
  Results::contact(const std::string &name) const
  {
    std::vector<std::string> names;
    for (const ContactSummary &facts : contacts)
      names.push_back(facts.name);
    return last().checks.contacts[place_of("contact", name, names)];
  }
} // namespace lamella
