// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/trade_parameters.h>
#include <lamella/section/theory.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    void
    declare_ladder(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Ladder",
        "EBBT | TBT | TE-1 | TE-2 | TE-3 | TE-4 | "
        "SV | SV-3 | SV-6 | SV-10 | LE-1 | "
        "LE-2, axis 0.5, section 0.5 | LE-2, axis 0.5 | LE-2 | "
        "LE-3, section 0.5 | LE-2, section 2 | LE-3 | solid-1 | solid-2 | solid-2, axis 2 | "
        "LE-3, axis 2",
        Anything(),
        "Rungs between '|', cheap ones first and the finest last. A rung is a "
        "theory and what else it changes between commas: axis FACTOR (on the "
        "numbers of axis elements), section FACTOR (on the numbers of section "
        "cells in each direction), PATH = VALUE (as of --set). In place of a "
        "theory tolerance PERCENT: a run that chooses theory and mesh until the "
        "error bars of the Quantities are within.");
      prm.declare_entry(
        "Bodies",
        "",
        Anything(),
        "Whose theory and meshes the rungs change; all bodies by "
        "default.");
    }



    /// Declares the entries of the comparison.
    void
    declare_comparison(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Quantities",
        "",
        Anything(),
        "What is compared, between '|': PROBE: COLUMN (of probes.csv; PROBE/PLY "
        "on an interface), SUPPORT: fx (fy, fz, mx, my, mz), CONTACT: fx (and so "
        "on, pressure, width, width x, dissipated), or of a strip of a contact CONTACT: fx "
        "in AXIS FROM TO. By default those that Goals names, else what the scene "
        "gives References for, and of probes without any the largest "
        "displacement and stress.");
      prm.declare_entry(
        "Reference",
        "finest",
        Anything(),
        "What errors are taken against: finest (the last rung that succeeds), "
        "solid (the last such hexahedra), given (the first of the scene's "
        "References of each quantity), or the name of a rung.");
      prm.declare_entry("Tolerance",
                        "1",
                        patterns::numbers(),
                        "Errors, in per cent, that the cheapest rung is sought "
                        "for; one or more between commas.");
    }
  } // namespace



  void
  TradeParameters::declare(ParameterHandler &prm)
  {
    declare_ladder(prm);
    declare_comparison(prm);
    prm.declare_entry("Error bars",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether each rung makes the error bars of its own "
                      "values, too, as of subsection Goals; they stand beside "
                      "its errors. Its seconds are without them.");
    prm.declare_entry("Time limit",
                      "0",
                      patterns::number(),
                      "Processor seconds after which a rung is given up; 0: "
                      "never.");
  }



  namespace
  {
    constexpr double least_factor = 0.05, greatest_factor = 20.;
    // Longest time that the system can count, in seconds.
    constexpr double longest_time = 1e9;

    /// Returns the number after @p word in the @p piece of @p rung, if it has
    /// this form.
    std::optional<double>
    factor(const Entry &rung, const std::string &piece, const std::string &word)
    {
      if (piece.compare(0, word.size() + 1, word + " ") != 0)
        return std::nullopt;
      const double value = rung.number(piece.substr(word.size() + 1));
      if (!(value >= least_factor && value <= greatest_factor))
        rung.refuse("the factor of " + word + " must lie between " +
                      to_text(least_factor) + " and " +
                      to_text(greatest_factor),
                    "2 makes the mesh twice as fine.");
      return value;
    }



    /// Returns the tolerance in the @p piece of @p rung as a fraction, if it
    /// begins with that word.
    std::optional<double>
    tolerance(const Entry &rung, const std::string &piece)
    {
      const std::string word = "tolerance";
      if (piece != word && piece.compare(0, word.size() + 1, word + " ") != 0)
        return std::nullopt;
      if (piece == word)
        rung.refuse("the tolerance is missing", "Write, say, tolerance 1.");
      const double per_cent = rung.number(piece.substr(word.size() + 1));
      if (!(per_cent > 0. && per_cent <= 100.))
        rung.refuse("the tolerance must be more than 0 and at most 100 per "
                    "cent",
                    "Write, say, tolerance 1.");
      return per_cent / 100.;
    }



    /// Returns the theory or the tolerance that @p rung begins with.
    LadderEntry
    parse_first(const Entry &rung, const std::string &piece)
    {
      LadderEntry first;
      first.name      = rung.text();
      first.tolerance = tolerance(rung, piece);
      first.theory    = first.tolerance ?
                          "tolerance " + to_text(100. * *first.tolerance, 15) :
                          piece;
      if (first.theory.empty())
        rung.refuse("the rung begins with no theory");
      if (!first.tolerance)
        Theory::parse(Entry(rung.path(), first.theory));
      return first;
    }



    /// Returns the variant of @p text, its part of the entry.
    LadderEntry
    parse_rung(const Entry &text)
    {
      const auto  pieces = text.items();
      LadderEntry rung   = parse_first(text, pieces[0]);
      for (unsigned int k = 1; k < pieces.size(); ++k)
        {
          const std::string &piece = pieces[k];
          if (const auto axis = factor(text, piece, "axis"))
            rung.axis = *axis;
          else if (const auto section = factor(text, piece, "section"))
            rung.section = *section;
          else if (piece.find('=') != std::string::npos)
            rung.overrides.push_back(piece);
          else if (!rung.overrides.empty())
            // Values that are lists contain commas.
            rung.overrides.back() += ", " + piece;
          else
            text.refuse("'" + piece +
                          "' is none of axis FACTOR, section FACTOR and PATH = "
                          "VALUE",
                        "Write, say, LE-2, axis 2.");
        }
      if (rung.tolerance && (rung.axis != 1. || rung.section != 1.))
        text.refuse("a run to a tolerance makes its meshes itself, from those "
                    "that it begins with",
                    "Leave out axis FACTOR and section FACTOR.");
      return rung;
    }



    std::vector<LadderEntry>
    parse_ladder(const Entry &entry)
    {
      std::vector<LadderEntry> ladder;
      std::set<std::string>    names;
      for (const std::string &piece : entry.items('|'))
        {
          if (piece.empty())
            entry.refuse("a rung is empty", "Remove a '|'.");
          ladder.push_back(parse_rung(Entry(entry.path(), piece)));
          if (!names.insert(piece).second)
            entry.refuse("the rung '" + piece + "' stands there twice");
        }
      if (ladder.size() < 2)
        entry.refuse("a trade needs at least two rungs, with '|' between them");
      return ladder;
    }



    /// Throws InputError if @p reference is `given` and one of @p quantities
    /// has no reference or zero.
    void
    check_given(const Entry                      &reference,
                const std::vector<NamedQuantity> &quantities)
    {
      for (const NamedQuantity &quantity : quantities)
        {
          if (!quantity.given)
            reference.refuse(quantity.label() +
                               " has no value among the scene's References",
                             "Add one, leave the quantity out, or use "
                             "Reference = finest.");
          if (*quantity.given == 0.)
            reference.refuse(quantity.label() +
                               " has the reference 0, against which no error "
                               "is relative",
                             "Compare another quantity, or another point.");
        }
    }



    /// Returns the text of @p entry, if it is a valid reference of errors.
    std::string
    parse_reference(const Entry &entry, const std::vector<LadderEntry> &ladder)
    {
      std::vector<std::string> references{"finest", "solid", "given"};
      for (const LadderEntry &rung : ladder)
        references.push_back(rung.name);
      if (std::find(references.begin(), references.end(), entry.text()) ==
          references.end())
        entry.refuse("must be finest, solid, given or the name of a rung",
                     "The nearest is '" +
                       nearest_name(entry.text(), references) + "'.");
      return entry.text();
    }



    /// Returns the tolerances as fractions.
    std::vector<double>
    parse_tolerances(const Entry &entry)
    {
      std::vector<double> tolerances;
      for (const double per_cent : entry.numbers())
        {
          if (!(per_cent > 0. && per_cent <= 100.))
            entry.refuse("must be more than 0 and at most 100 per cent");
          tolerances.push_back(per_cent / 100.);
        }
      return tolerances;
    }



    double
    parse_time_limit(const Entry &entry)
    {
      const double seconds = entry.number();
      if (!(seconds >= 0. && seconds <= longest_time))
        entry.refuse("must be 0 (none) or seconds, at most 1e9");
      return seconds;
    }
  } // namespace



  TradeParameters
  TradeParameters::parse(const Entries &in, const TradeNames &names)
  {
    TradeParameters trade;
    trade.ladder = parse_ladder(in["Ladder"]);

    const Entry bodies = in["Bodies"];
    for (const std::string &body : bodies.items())
      trade.bodies.push_back(
        Entry(bodies.path(), body).among(names.bodies, "body", "Bodies"));
    if (trade.bodies.empty())
      trade.bodies = names.bodies;

    const Entry quantities = in["Quantities"];
    trade.quantities       = parse_quantities(quantities, names.quantities);

    const Entry reference = in["Reference"];
    trade.reference       = parse_reference(reference, trade.ladder);
    // Quantities of goals need not have References.
    if (trade.quantities.empty() && trade.reference != "given")
      trade.quantities = names.of_goals;
    if (trade.quantities.empty())
      {
        trade.quantities =
          quantities_with_references(names.quantities, trade.whole_probes);
        if (trade.reference == "given")
          trade.whole_probes.clear();
      }
    if (trade.reference == "given")
      check_given(reference, trade.quantities);

    trade.tolerances = parse_tolerances(in["Tolerance"]);
    trade.error_bars = in["Error bars"].truth();
    trade.time_limit = parse_time_limit(in["Time limit"]);
    return trade;
  }
} // namespace lamella
