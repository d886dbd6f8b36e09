// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/scene/find.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  namespace
  {
    /// Returns the modes that @p entry, a number or FROM to TO, requests.
    ModeRequest
    parse_modes(const Entry &entry)
    {
      constexpr unsigned int most = 1000;
      ModeRequest            request;
      const std::string     &text = entry.text();
      const std::size_t      to   = text.find(" to ");
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
    return find;
  }
} // namespace lamella
