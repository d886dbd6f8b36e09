// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/scene/find.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  namespace
  {
    /// Largest number of modes: a limit for typing errors.
    constexpr unsigned int most = 1000;



    /// Returns the modes that @p entry, a number or FROM to TO, requests.
    ModeRequest
    parse_modes(const Entry &entry)
    {
      ModeRequest        request;
      const std::string &text = entry.text();
      const std::size_t  to   = text.find(" to ");
      if (to == std::string::npos)
        {
          request.number = entry.whole(1, most);
          return request;
        }
      const double lower = entry.number(trimmed(text.substr(0, to))),
                   upper = entry.number(trimmed(text.substr(to + 4)));
      if (!(lower >= 0. && lower < upper))
        entry.refuse("scene.range-of-modes: a range of frequencies [Hz] must "
                     "ascend from at least 0",
                     "Write, for example, 100 to 500.");
      request.range = {lower, upper};
      return request;
    }
  } // namespace



  void
  FindRequest::declare(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    prm.declare_entry(
      "Find",
      "",
      Anything(),
      "Analyses after the load steps, with commas between. `first failure`: the "
      "load factor at which the smallest reserve factor of subsection Strength "
      "is 1, to 0.1 %, with a new contact solution at each trial; `modes`: "
      "natural frequencies and modes about the last load step (materials need "
      "a Density; bodies may be free); `buckling`: factors of the last loads "
      "and modes of linear buckling. Empty: nothing.");
    prm.declare_entry(
      "Modes",
      "10",
      Anything(),
      "Number of modes for Find = modes or buckling, without rigid motions; or "
      "a range of natural frequencies [Hz], as in 0 to 500.");
    prm.declare_entry(
      "Mode references",
      "",
      Anything(),
      "Reference values to print, mode: value: source, with '|' between; a "
      "frequency [Hz] of mode-1, mode-2, ..., a factor of buckling-1, ...");
  }



  FindRequest
  FindRequest::parse(const Entries &in, const bool has_criteria)
  {
    FindRequest       find;
    const Entry       entry = in["Find"];
    const ModeRequest modes = parse_modes(in["Modes"]);
    for (const std::string &item : entry.items())
      if (item == "modes")
        find.modes = modes;
      else if (item == "buckling")
        {
          if (modes.range)
            in["Modes"].refuse("scene.range-of-buckling: buckling modes have "
                               "load factors and no frequencies",
                               "Write a number of modes.");
          find.n_buckling_modes = modes.number;
        }
      else if (item != "first failure")
        entry.refuse("scene.unknown-find: write `first failure`, `modes` or "
                     "`buckling`, with commas between, or nothing");
      else if (!has_criteria)
        entry.refuse("scene.no-criteria: Find = first failure needs failure "
                     "criteria, but Criteria is empty",
                     "Write Strength/Criteria, and Strengths of materials.");
      else
        find.first_failure = true;
    std::vector<std::string> names;
    for (const auto &mode : find.names_of_modes())
      names.push_back(mode.first);
    find.references = parse_references(in["Mode references"], names);
    return find;
  }



  std::vector<std::pair<std::string, std::vector<Reference>>>
  FindRequest::names_of_modes() const
  {
    std::vector<std::pair<std::string, std::vector<Reference>>> named;
    const auto add = [&](const std::string &kind, const unsigned int n) {
      for (unsigned int k = 1; k <= n; ++k)
        {
          named.push_back({kind + std::to_string(k), {}});
          for (const Reference &one : references)
            if (one.quantity == named.back().first)
              named.back().second.push_back(
                {column_of_mode(one.quantity), one.value, one.source});
        }
    };
    if (modes)
      add("mode-", modes->range ? most : modes->number);
    add("buckling-", n_buckling_modes);
    return named;
  }
} // namespace lamella
