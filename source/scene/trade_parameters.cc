// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/goal_parameters.h>
#include <lamella/section/theory.h>

#include <algorithm>
#include <set>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    void
    declare_variants(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Variants",
        "EBBT | TBT | TE-1 | TE-2 | TE-3 | TE-4 | SV | SV-3 | SV-6 | SV-10 | "
        "LE-1 | LE-2, axis 0.5, section 0.5 | LE-2, axis 0.5 | LE-2 | LE-3, "
        "section 0.5 | LE-2, section 2 | LE-3 | solid-1 | solid-2 | solid-2, "
        "axis 2 | LE-3, axis 2",
        Anything(),
        "Models to compare, with '|' between, the cheapest first and the "
        "finest last. A variant is a theory and, with commas between, its "
        "changes of the scene: axis FACTOR (multiplies the numbers of axis "
        "elements), section FACTOR (multiplies the numbers of section cells in "
        "each direction), PATH = VALUE (as of --set). Instead of a theory, "
        "tolerance PERCENT refines theory and mesh until the estimated errors "
        "of Quantities are smaller.");
      prm.declare_entry(
        "Bodies",
        "",
        Anything(),
        "Bodies whose theory and meshes variants change. Empty: all.");
    }



    /// Declares the entries of the comparison.
    void
    declare_comparison(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Quantities",
        "",
        Anything(),
        "Quantities to compare, with '|' between, as Quantities of subsection "
        "Goals. Empty: those of Goals, else all with References, and for "
        "probes without References the largest displacement and stress.");
      prm.declare_entry(
        "Reference",
        "finest",
        Anything(),
        "Reference for the errors: finest (the last variant that succeeds), "
        "solid (the last successful variant of hexahedra), given (the first "
        "value in References of each quantity), or the name of a variant.");
      prm.declare_entry("Tolerance",
                        "1",
                        patterns::numbers(),
                        "Errors in per cent, with commas between: for each, "
                        "the cheapest variant with a smaller error is named.");
    }



    constexpr double least_factor = 0.05, greatest_factor = 20.;
    // Longest time that the system can count, in seconds.
    constexpr double longest_time = 1e9;

    /// Returns the number after @p word in @p piece of @p variant, if any.
    std::optional<double>
    factor(const Entry       &variant,
           const std::string &piece,
           const std::string &word)
    {
      if (piece.compare(0, word.size() + 1, word + " ") != 0)
        return std::nullopt;
      const double value = variant.number(piece.substr(word.size() + 1));
      if (!(value >= least_factor && value <= greatest_factor))
        variant.refuse("scene.factor-out-of-range: the factor of " + word +
                         " must lie between " + to_text(least_factor) +
                         " and " + to_text(greatest_factor),
                       "Write, for example, 2 for a mesh twice as fine.");
      return value;
    }



    /// Returns the tolerance in @p piece of @p variant as a fraction, if any.
    std::optional<double>
    tolerance(const Entry &variant, const std::string &piece)
    {
      const std::string word = "tolerance";
      if (piece != word && piece.compare(0, word.size() + 1, word + " ") != 0)
        return std::nullopt;
      if (piece == word)
        variant.refuse(
          "scene.variant-tolerance-missing: the value of tolerance is missing",
          "Write a tolerance in per cent, as in tolerance 1.");
      const double per_cent = variant.number(piece.substr(word.size() + 1));
      if (!(per_cent > 0. && per_cent <= 100.))
        variant.refuse("scene.invalid-per-cent: the tolerance must be more "
                       "than 0 and at most 100 per cent",
                       "Write, for example, tolerance 1.");
      return per_cent / 100.;
    }



    /// Returns the theory or the tolerance that @p variant begins with.
    TradeVariant
    parse_first(const Entry &variant, const std::string &piece)
    {
      TradeVariant first;
      first.name      = variant.text();
      first.tolerance = tolerance(variant, piece);
      first.theory    = first.tolerance ?
                          "tolerance " + to_text(100. * *first.tolerance, 15) :
                          piece;
      if (first.theory.empty())
        variant.refuse("scene.variant-without-theory: each variant must begin "
                       "with a theory, as in LE-2, axis 0.5");
      if (!first.tolerance)
        Theory::parse(Entry(variant.path(), first.theory));
      return first;
    }



    /// Returns the variant of @p text, its part of the entry.
    TradeVariant
    parse_variant(const Entry &text)
    {
      const auto   pieces  = text.items();
      TradeVariant variant = parse_first(text, pieces[0]);
      for (unsigned int k = 1; k < pieces.size(); ++k)
        {
          const std::string &piece = pieces[k];
          if (const auto axis = factor(text, piece, "axis"))
            variant.axis = *axis;
          else if (const auto section = factor(text, piece, "section"))
            variant.section = *section;
          else if (piece.find('=') != std::string::npos)
            variant.overrides.push_back(piece);
          else if (!variant.overrides.empty())
            // Values that are lists contain commas.
            variant.overrides.back() += ", " + piece;
          else
            text.refuse(
              "scene.invalid-variant: '" + piece +
                "' is neither axis FACTOR nor section FACTOR nor PATH = VALUE",
              "Write, for example, LE-2, axis 2.");
        }
      if (variant.tolerance && (variant.axis != 1. || variant.section != 1.))
        text.refuse("scene.factors-with-tolerance: a variant with a tolerance "
                    "refines its meshes automatically",
                    "Remove axis FACTOR and section FACTOR from this variant.");
      return variant;
    }



    std::vector<TradeVariant>
    parse_variants(const Entry &entry)
    {
      std::vector<TradeVariant> variants;
      std::set<std::string>     names;
      for (const std::string &piece : entry.items('|'))
        {
          if (piece.empty())
            entry.refuse("scene.empty-variant: there is no variant between two "
                         "'|', or at an end of the list",
                         "Remove the extra '|'.");
          variants.push_back(parse_variant(Entry(entry.path(), piece)));
          if (!names.insert(piece).second)
            entry.refuse("scene.repeated-variant: the variant '" + piece +
                         "' is given twice; remove one of the two");
        }
      if (variants.size() < 2)
        entry.refuse("scene.too-few-variants: a trade needs at least two "
                     "variants with '|' between, as in TBT | LE-2");
      return variants;
    }



    /// Throws InputError if @p reference is `given`, but missing or zero.
    void
    check_given(const Entry                      &reference,
                const std::vector<NamedQuantity> &quantities)
    {
      for (const NamedQuantity &quantity : quantities)
        {
          if (!quantity.given)
            reference.refuse(
              "scene.no-reference: " + quantity.label() +
                " has no value in References, which Reference = given needs",
              "Add a value, remove the quantity, or write Reference = finest.");
          if (*quantity.given == 0.)
            reference.refuse(
              "scene.reference-zero: " + quantity.label() +
                " has the reference 0, so its relative error is undefined",
              "Choose another quantity, or another position of the probe.");
        }
    }



    /// Returns the text of @p entry, if it is a valid reference of errors.
    std::string
    parse_reference(const Entry                     &entry,
                    const std::vector<TradeVariant> &variants)
    {
      std::vector<std::string> references{"finest", "solid", "given"};
      for (const TradeVariant &variant : variants)
        references.push_back(variant.name);
      if (std::find(references.begin(), references.end(), entry.text()) ==
          references.end())
        entry.refuse("scene.unknown-reference: use finest, solid, given or a "
                     "variant",
                     "Check the spelling: the most similar is '" +
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
            entry.refuse("scene.invalid-per-cent: each value must be more than "
                         "0 and at most 100 per cent, as in 1, 5");
          tolerances.push_back(per_cent / 100.);
        }
      return tolerances;
    }
  } // namespace



  void
  TradeParameters::declare(ParameterHandler &prm)
  {
    declare_variants(prm);
    declare_comparison(prm);
    prm.declare_entry("Error bars",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether each variant also estimates its own errors, as "
                      "in subsection Goals; the tables show both. The time of "
                      "a variant does not include the estimate.");
    prm.declare_entry(
      "Time limit",
      "0",
      patterns::number(),
      "Processor seconds after which a variant is stopped; 0: no limit.");
  }



  TradeParameters
  TradeParameters::parse(const Entries &in, const TradeNames &names)
  {
    TradeParameters trade;
    trade.variants = parse_variants(in["Variants"]);

    const Entry bodies = in["Bodies"];
    for (const std::string &body : bodies.items())
      trade.bodies.push_back(
        Entry(bodies.path(), body).among(names.bodies, "body", "Bodies"));
    if (trade.bodies.empty())
      trade.bodies = names.bodies;

    const Entry quantities = in["Quantities"];
    trade.quantities       = parse_quantities(quantities, names.quantities);

    const Entry reference = in["Reference"];
    trade.reference       = parse_reference(reference, trade.variants);
    // Quantities of goals need not have References.
    if (trade.quantities.empty() && trade.reference != "given")
      trade.quantities = names.of_goals;
    if (trade.quantities.empty())
      {
        trade.quantities =
          quantities_with_references(names.quantities, trade.probes_as_goals);
        if (trade.reference == "given")
          trade.probes_as_goals.clear();
      }
    if (trade.reference == "given")
      check_given(reference, trade.quantities);

    trade.tolerances = parse_tolerances(in["Tolerance"]);
    trade.error_bars = in["Error bars"].boolean();
    trade.time_limit = in["Time limit"].number();
    if (!(trade.time_limit >= 0. && trade.time_limit <= longest_time))
      in["Time limit"].refuse(
        "scene.invalid-time-limit: write seconds (0: no limit), at most 1e9");
    return trade;
  }
} // namespace lamella
