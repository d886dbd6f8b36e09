// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/find.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    /// Largest number of modes: a limit for typing errors.
    constexpr unsigned int most = 1000;



    /// Returns the limits in @p text, FROM to TO, of @p entry; empty for other
    /// texts.
    std::optional<std::pair<double, double>>
    parse_limits(const Entry &entry, const std::string &text)
    {
      const std::size_t to = text.find(" to ");
      if (to == std::string::npos)
        return {};
      return std::make_pair(entry.number(trimmed(text.substr(0, to))),
                            entry.number(trimmed(text.substr(to + 4))));
    }



    /// Returns the modes that @p entry, a number or FROM to TO, requests.
    ModeRequest
    parse_modes(const Entry &entry)
    {
      ModeRequest request;
      request.range = parse_limits(entry, entry.text());
      if (!request.range)
        request.number = entry.whole(1, most);
      else if (!(request.range->first >= 0. &&
                 request.range->first < request.range->second))
        entry.refuse("scene.range-of-modes: a range of frequencies [Hz] must "
                     "ascend from at least 0",
                     "Write, for example, 100 to 500.");
      return request;
    }



    void
    declare_response(ParameterHandler &prm)
    {
      prm.enter_subsection("Harmonic response");
      prm.declare_entry(
        "Frequencies",
        "",
        Anything(),
        "Frequencies [Hz]: a list as 10, 20, 50, or a range as 0 "
        "to 500 in 100 (equal intervals). Natural frequencies of "
        "damped modes within it and their half-power points are added.");
      prm.declare_entry("Damping",
                        "",
                        patterns::numbers(),
                        "Damping ratio of each mode; the last number holds for "
                        "all further modes. 0.02: 2 % of critical damping.");
      prm.declare_entry("Base acceleration",
                        "0, 0, 0",
                        patterns::numbers(),
                        "Amplitude of the acceleration of all supports. The "
                        "response is then relative to the supports.");
      prm.leave_subsection();
    }



    /// Returns the frequencies of @p entry, a list or FROM to TO in N.
    std::vector<double>
    parse_frequencies(const Entry &entry)
    {
      if (entry.is_empty())
        entry.refuse_missing("Write frequencies, as in 0 to 500 in 100.");
      const std::size_t in = entry.text().find(" in ");
      const auto limits    = parse_limits(entry, entry.text().substr(0, in));
      std::vector<double> all;
      if (!limits)
        all = entry.numbers();
      else if (in == std::string::npos)
        entry.refuse("scene.range-of-frequencies: a range of frequencies needs "
                     "a number of intervals",
                     "Write, for example, 0 to 500 in 100.");
      else
        {
          const auto [from, to] = *limits;
          const unsigned int n =
            Entry(entry.path(), entry.text().substr(in + 4)).whole(1, 100000);
          for (unsigned int k = 0; k <= n; ++k)
            all.push_back(from + (to - from) * k / n);
        }
      for (unsigned int k = 0; k < all.size(); ++k)
        if (!(all[k] >= 0. && (k == 0 || all[k] > all[k - 1])))
          entry.refuse("scene.order-of-frequencies: frequencies [Hz] must "
                       "ascend from at least 0",
                       "Sort them, and remove repetitions.");
      return all;
    }



    HarmonicRequest
    parse_response(ParameterHandler &prm)
    {
      const Entry modes = Entries(prm, "")["Modes"];
      if (const auto range = parse_modes(modes).range;
          range && range->first > 0.)
        modes.refuse("scene.modes-of-response: a response contains all modes "
                     "from the lowest one on",
                     "Write a range from 0, or a number.");
      prm.enter_subsection("Harmonic response");
      const Entries   in(prm, "Harmonic response");
      HarmonicRequest request;
      request.frequencies = parse_frequencies(in["Frequencies"]);
      const Entry damping = in["Damping"];
      if (damping.is_empty())
        damping.refuse_missing("Write damping ratios, as in 0.02, or 0 for "
                               "undamped modes.");
      request.damping = damping.numbers();
      for (const double ratio : request.damping)
        if (!(ratio >= 0. && ratio < 1.))
          damping.refuse("scene.damping-out-of-range: damping ratios are at "
                         "least 0 (undamped) and below 1 (critical)",
                         "Write, for example, 0.02.");
      request.base_acceleration = in["Base acceleration"].point();
      prm.leave_subsection();
      return request;
    }



    std::vector<Reference>
    parse_mode_references(const Entry &entry, const FindRequest &find)
    {
      std::vector<std::string> names;
      for (const auto &mode : find.names_of_modes())
        names.push_back(mode.first);
      return parse_references(entry, names);
    }
  } // namespace



  void
  FindRequest::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Find",
      "",
      Anything(),
      "Analyses after the load steps, with commas between. `first failure`: the "
      "load factor at which the smallest reserve factor of subsection Strength "
      "is 1, to 0.1 %, with a new contact solution at each trial; `modes`: "
      "natural frequencies and modes about the last load step (materials need "
      "a Density; bodies may be free); `response`: modes, and the steady "
      "harmonic response (subsection Harmonic response); `buckling`: factors "
      "of the last loads and modes of linear buckling. Empty: nothing.");
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
    declare_response(prm);
  }



  FindRequest
  FindRequest::parse(ParameterHandler &prm, const bool has_criteria)
  {
    const Entries     in(prm, "");
    FindRequest       find;
    const Entry       entry = in["Find"];
    const ModeRequest modes = parse_modes(in["Modes"]);
    for (const std::string &item : entry.items())
      if (item == "modes")
        find.modes = modes;
      else if (item == "response")
        {
          find.modes    = modes;
          find.response = parse_response(prm);
        }
      else if (item == "buckling")
        {
          if (modes.range)
            in["Modes"].refuse("scene.range-of-buckling: buckling modes have "
                               "load factors and no frequencies",
                               "Write a number of modes.");
          find.n_buckling_modes = modes.number;
        }
      else if (item != "first failure")
        entry.refuse("scene.unknown-find: write `first failure`, `modes`, "
                     "`response` or `buckling`, with commas between, or "
                     "nothing");
      else if (!has_criteria)
        entry.refuse("scene.no-criteria: Find = first failure needs failure "
                     "criteria, but Criteria is empty",
                     "Write Strength/Criteria, and Strengths of materials.");
      else
        find.first_failure = true;
    find.references = parse_mode_references(in["Mode references"], find);
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
