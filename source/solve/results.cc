// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/results.h>

#include <algorithm>

namespace lamella
{
  const std::vector<std::string> &
  phase_names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> all;
      for (const NameOf<Phase> &phase : Names<Phase>::all)
        all.push_back(phase.name);
      return all;
    }();
    return names;
  }



  void
  StepResults::drop_fields()
  {
    const unsigned int iterations = state.iterations;
    state                         = State();
    state.iterations              = iterations;
    memory                        = StrategyMemory();
    probes.clear();
    lines.clear();
    cuts.clear();
    contacts.clear();
    plies_along.clear();
    for (KuhnTucker &contact : checks.contacts)
      contact.of_rows.clear();
  }



  unsigned int
  Results::n_dofs() const
  {
    unsigned int sum = 0;
    for (const BodyFacts &body : bodies)
      sum += body.dofs;
    return sum;
  }



  std::vector<std::string>
  Results::all_warnings() const
  {
    std::vector<std::string> warnings = notes;
    for (const StepResults &step : steps)
      for (const std::string &warning : step.warnings)
        warnings.push_back((load_steps > 1 ?
                              "load step " + std::to_string(step.step) + ": " :
                              "") +
                           warning);
    warnings.insert(warnings.end(), endnotes.begin(), endnotes.end());
    return warnings;
  }



  BeyondLinear
  Results::worst_beyond() const
  {
    BeyondLinear worst;
    for (const StepResults &step : steps)
      {
        const BeyondLinear &one = step.checks.beyond;
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



  namespace
  {
    /// The place of @p name among @p names of @p kind.
    unsigned int
    place_of(const std::string              &kind,
             const std::string              &name,
             const std::vector<std::string> &names)
    {
      const auto place = std::find(names.begin(), names.end(), name);
      if (place == names.end())
        throw InputError("The results have no " + kind + " '" + name +
                         "'. They have: " + joined(names) + ".");
      return place - names.begin();
    }
  } // namespace



  const StepResults &
  Results::last() const
  {
    if (steps.empty())
      throw InputError("The results have no load step.");
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
    throw InputError("The probe '" + name + "' is not in ply " +
                     std::to_string(ply) + " but in " + joined(plies) + ".");
  }



  const Resultant &
  Results::support(const std::string &name) const
  {
    return last().checks.reactions[place_of("support", name, supports)];
  }



  const KuhnTucker &
  Results::contact(const std::string &name) const
  {
    std::vector<std::string> names;
    for (const ContactFacts &facts : contacts)
      names.push_back(facts.name);
    return last().checks.contacts[place_of("contact", name, names)];
  }
} // namespace lamella
