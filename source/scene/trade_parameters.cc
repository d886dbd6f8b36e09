// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/scene/trade_parameters.h>
#include <lamella/section/theory.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  std::string
  TradeQuantity::label() const
  {
    return name + (ply == 0 ? "" : "/" + std::to_string(ply)) + ": " + column;
  }



  void
  TradeParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Ladder",
      "EBBT | TBT | TE-1 | TE-2 | TE-3 | TE-4 | LE-1 | "
      "LE-2, axis 0.5, section 0.5 | LE-2, axis 0.5 | LE-2 | "
      "LE-3, section 0.5 | LE-3 | solid-1 | solid-2 | solid-2, axis 2 | "
      "LE-3, axis 2",
      Anything(),
      "Rungs between '|', cheap ones first and the finest last. A rung is a "
      "theory and what else it changes between commas: axis FACTOR (on the "
      "numbers of axis elements), section FACTOR (on the numbers of section "
      "cells in each direction), PATH = VALUE (as of --set).");
    prm.declare_entry("Bodies",
                      "",
                      Anything(),
                      "Whose theory and meshes the rungs change; all bodies by "
                      "default.");
    prm.declare_entry(
      "Quantities",
      "",
      Anything(),
      "What is compared, between '|': PROBE: COLUMN (of probes.csv; PROBE/PLY "
      "on an interface), SUPPORT: fx (fy, fz) or CONTACT: fx. By default what "
      "the scene gives References for, and of probes without any the largest "
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
                      Anything(),
                      "Errors, in per cent, that the cheapest rung is sought "
                      "for; one or more between commas.");
    prm.declare_entry("Time limit",
                      "0",
                      Anything(),
                      "Processor seconds after which a rung is given up; 0: "
                      "never.");
  }



  namespace
  {
    constexpr double least_factor = 0.05, greatest_factor = 20.;

    /// The number behind @p word in @p text, if that is what it is.
    std::optional<double>
    factor(const std::string &text,
           const std::string &word,
           const std::string &what)
    {
      if (text.compare(0, word.size() + 1, word + " ") != 0)
        return std::nullopt;
      const double value = to_number(text.substr(word.size() + 1), what);
      if (!(value >= least_factor && value <= greatest_factor))
        throw InputError(what + ": the factor of " + word +
                         " must lie between " + to_text(least_factor) +
                         " and " + to_text(greatest_factor) +
                         "; 2 makes the mesh twice as fine.");
      return value;
    }



    LadderEntry
    parse_rung(const std::string &text)
    {
      const std::string what = "Trade/Ladder, rung '" + text + "'";
      if (text.empty())
        throw InputError("Trade/Ladder has an empty rung: remove a '|'.");
      const auto  pieces = split(text, ',');
      LadderEntry rung;
      rung.name   = text;
      rung.theory = pieces[0];
      Theory::parse(rung.theory, "Trade/Ladder");
      for (unsigned int k = 1; k < pieces.size(); ++k)
        {
          const std::string &piece = pieces[k];
          if (const auto axis = factor(piece, "axis", what))
            rung.axis = *axis;
          else if (const auto section = factor(piece, "section", what))
            rung.section = *section;
          else if (piece.find('=') != std::string::npos)
            rung.overrides.push_back(piece);
          else if (!rung.overrides.empty())
            // The rest of a value that is a list itself.
            rung.overrides.back() += ", " + piece;
          else
            throw InputError(what + ": '" + piece +
                             "' is none of axis FACTOR, section FACTOR and "
                             "PATH = VALUE. Write, say, LE-2, axis 2.");
        }
      return rung;
    }



    std::vector<LadderEntry>
    parse_ladder(const std::string &text)
    {
      std::vector<LadderEntry> ladder;
      std::set<std::string>    names;
      for (const std::string &piece : split(text, '|'))
        {
          ladder.push_back(parse_rung(piece));
          if (!names.insert(piece).second)
            throw InputError("Trade/Ladder: the rung '" + piece +
                             "' stands there twice.");
        }
      if (ladder.size() < 2)
        throw InputError("Trade/Ladder = " + text +
                         ": a trade needs at least two rungs, with '|' between "
                         "them.");
      return ladder;
    }



    /// The first of @p references of @p column.
    std::optional<double>
    first_of(const std::vector<Reference> &references,
             const std::string            &column)
    {
      for (const Reference &reference : references)
        if (reference.quantity == column)
          return reference.value;
      return std::nullopt;
    }



    const std::vector<std::string> &
    components()
    {
      static const std::vector<std::string> names{"fx", "fy", "fz"};
      return names;
    }



    std::vector<std::string>
    all_names(const TradeNames &names)
    {
      std::vector<std::string> all;
      for (const Probe &probe : names.probes)
        all.push_back(probe.name);
      for (const auto *resultants : {&names.supports, &names.contacts})
        for (const auto &resultant : *resultants)
          all.push_back(resultant.first);
      return all;
    }



    /// A component of a resultant, if a support or a contact has this name.
    TradeQuantity
    find_resultant(const std::string &name,
                   const std::string &column,
                   const TradeNames  &names,
                   const std::string &what)
    {
      const bool of_support = names.supports.count(name) > 0,
                 of_contact = names.contacts.count(name) > 0;
      if (of_support && of_contact)
        throw InputError(what + ": both a support and a contact are called '" +
                         name + "'. Rename one of the two.");
      TradeQuantity quantity;
      if (!of_support && !of_contact)
        return quantity;
      if (std::find(components().begin(), components().end(), column) ==
          components().end())
        throw InputError(what + ": " + name +
                         " is no probe but a resultant: its quantities are " +
                         joined(components()) + ".");
      quantity.of =
        of_support ? TradeQuantity::Of::support : TradeQuantity::Of::contact;
      quantity.name   = name;
      quantity.column = column;
      quantity.given =
        first_of((of_support ? names.supports : names.contacts).at(name),
                 column);
      return quantity;
    }



    TradeQuantity
    parse_quantity(const std::string &text, const TradeNames &names)
    {
      const std::string what  = "Trade/Quantities, '" + text + "'";
      const auto        parts = split(text, ':');
      if (parts.size() != 2)
        throw InputError(what + ": write NAME: QUANTITY, as in tip: uz.");
      const auto   place = split(parts[0], '/');
      const Probe *probe = nullptr;
      for (const Probe &candidate : names.probes)
        if (!place.empty() && candidate.name == place[0])
          probe = &candidate;
      if (probe == nullptr)
        {
          const TradeQuantity resultant =
            find_resultant(parts[0], parts[1], names, what);
          if (resultant.of == TradeQuantity::Of::undefined)
            throw InputError(what +
                             ": no probe, support or contact is called '" +
                             parts[0] + "'. The nearest is '" +
                             nearest_name(parts[0], all_names(names)) + "'.");
          return resultant;
        }
      TradeQuantity quantity{
        TradeQuantity::Of::probe, place[0], 0, parts[1], {}};
      if (place.size() > 1)
        {
          const double ply = to_number(place[1], what + ", the ply");
          if (place.size() > 2 || !(ply >= 1. && ply == std::floor(ply)))
            throw InputError(what + ": plies are counted from 1 at the bottom, "
                                    "as in tip/2: syz.");
          quantity.ply = static_cast<unsigned int>(ply);
        }
      const auto &columns = field_names();
      if (std::find(columns.begin(), columns.end(), parts[1]) == columns.end())
        throw InputError(what + ": a probe gives no '" + parts[1] +
                         "'. The nearest is '" +
                         nearest_name(parts[1], columns) +
                         "'; all of them: " + joined(columns) + ".");
      quantity.given = first_of(probe->references, parts[1]);
      return quantity;
    }



    /// Everything that the scene has References for, each once.
    std::vector<TradeQuantity>
    quantities_with_references(const TradeNames         &names,
                               std::vector<std::string> &whole_probes)
    {
      std::vector<TradeQuantity> quantities;
      const auto                 add = [&](const TradeQuantity::Of       of,
                           const std::string            &name,
                           const std::vector<Reference> &references) {
        std::set<std::string> seen;
        for (const Reference &reference : references)
          if (seen.insert(reference.quantity).second)
            quantities.push_back(
              {of, name, 0, reference.quantity, reference.value});
      };
      for (const Probe &probe : names.probes)
        {
          add(TradeQuantity::Of::probe, probe.name, probe.references);
          if (probe.references.empty())
            whole_probes.push_back(probe.name);
        }
      for (const auto &[name, references] : names.supports)
        add(TradeQuantity::Of::support, name, references);
      for (const auto &[name, references] : names.contacts)
        add(TradeQuantity::Of::contact, name, references);
      return quantities;
    }



    /// Throws InputError for a quantity without a reference, or with zero.
    void
    check_given(const std::vector<TradeQuantity> &quantities)
    {
      for (const TradeQuantity &quantity : quantities)
        {
          const std::string what =
            "Trade/Reference = given: " + quantity.label();
          if (!quantity.given)
            throw InputError(what + " has no value among the scene's "
                                    "References. Add one, leave the quantity "
                                    "out, or use Reference = finest.");
          if (*quantity.given == 0.)
            throw InputError(what + " has the reference 0, against which no "
                                    "error is relative. Compare another "
                                    "quantity, or another point.");
        }
    }
  } // namespace



  TradeParameters
  TradeParameters::parse(const ParameterHandler &prm, const TradeNames &names)
  {
    TradeParameters trade;
    trade.ladder = parse_ladder(prm.get("Ladder"));

    trade.bodies = split(prm.get("Bodies"), ',');
    for (const std::string &body : trade.bodies)
      if (std::find(names.bodies.begin(), names.bodies.end(), body) ==
          names.bodies.end())
        throw InputError("Trade/Bodies = " + prm.get("Bodies") +
                         ": there is no body '" + body + "'. The nearest is '" +
                         nearest_name(body, names.bodies) + "'.");
    if (trade.bodies.empty())
      trade.bodies = names.bodies;

    for (const std::string &piece : split(prm.get("Quantities"), '|'))
      trade.quantities.push_back(parse_quantity(piece, names));

    trade.reference = trimmed(prm.get("Reference"));
    std::vector<std::string> references{"finest", "solid", "given"};
    for (const LadderEntry &rung : trade.ladder)
      references.push_back(rung.name);
    if (std::find(references.begin(), references.end(), trade.reference) ==
        references.end())
      throw InputError("Trade/Reference = " + trade.reference +
                       ": must be finest, solid, given or the name of a rung. "
                       "The nearest is '" +
                       nearest_name(trade.reference, references) + "'.");
    if (trade.quantities.empty())
      {
        trade.quantities =
          quantities_with_references(names, trade.whole_probes);
        if (trade.reference == "given")
          trade.whole_probes.clear();
      }
    if (trade.reference == "given")
      check_given(trade.quantities);

    for (const double per_cent :
         to_numbers(prm.get("Tolerance"), "Trade/Tolerance"))
      {
        if (!(per_cent > 0. && per_cent <= 100.))
          throw InputError("Trade/Tolerance = " + prm.get("Tolerance") +
                           ": must be more than 0 and at most 100 per cent.");
        trade.tolerances.push_back(per_cent / 100.);
      }
    trade.time_limit = to_number(prm.get("Time limit"), "Trade/Time limit");
    if (!(trade.time_limit >= 0. && trade.time_limit <= 1e9))
      throw InputError("Trade/Time limit = " + prm.get("Time limit") +
                       ": must be 0 (none) or seconds, at most 1e9.");
    return trade;
  }
} // namespace lamella
