// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/entry.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/interruption.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/section/theory.h>
#include <lamella/trade/trade.h>

#include <boost/interprocess/sync/file_lock.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>
#include <ostream>
#include <sstream>

namespace lamella
{
  using nlohmann::json;
  namespace fs = std::filesystem;

  namespace
  {
    std::vector<std::string>
    operator+(std::vector<std::string> a, const std::vector<std::string> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }



    /// A folder's name for the variant @p name: letters, digits, '-' and '.'.
    std::string
    folder_name(const unsigned int number, const std::string &name)
    {
      std::ostringstream text;
      text << std::setw(2) << std::setfill('0') << number << '_';
      for (const char c : name)
        text << (std::isalnum(static_cast<unsigned char>(c)) || c == '.' ||
                     c == '-' ?
                   c :
                   '_');
      // File systems end names at 255 bytes.
      return text.str().substr(0, 100);
    }



    /// The `plies` of @p quantities in @p scene, or the parts of an InputError
    /// as `fault`; null if the scene cannot be built.
    json
    plies_of(const std::vector<NamedQuantity> &quantities, const Scene &scene)
    {
      std::ostream                      nowhere(nullptr);
      std::unique_ptr<const Simulation> model;
      // Goals, by default these very quantities, would be looked at, too.
      Scene plain = scene;
      plain.goals = GoalParameters();
      // Whether the scene can be built at all is for the variants to say.
      if (outcome_of([&] {
            model = std::make_unique<const Simulation>(plain, nowhere);
          }).status != 0)
        return json();
      json result{{"plies", json::array()}};
      try
        {
          for (const NamedQuantity &quantity :
               model->model().with_resolved_plies(quantities))
            result["plies"].push_back(quantity.ply);
        }
      catch (const InputError &error)
        {
          result["fault"] = {error.path(),
                             error.value(),
                             error.marked(error.rule()),
                             error.remedy()};
        }
      return result;
    }



    void
    prepare_directory(const std::string &directory)
    {
      std::error_code error;
      fs::create_directories(directory + "/variants", error);
      // The lock needs a file; it is not emptied, should another have it.
      if (error || !std::ofstream(directory + "/trade.lock", std::ios::app))
        throw InputError("trade.folder-not-writable: results cannot be written "
                         "into this folder. Name another folder.")
          .at("--output " + directory + ": ");
    }



    /// Throws InputError for what a trade of @p scene does not know.
    void
    check_rotations(const Scene &scene)
    {
      const bool is_large = scene.solve.rotations == Rotations::large;
      if (scene.solve.rotations == Rotations::automatic)
        throw InputError("Rotations",
                         name_of(scene.solve.rotations),
                         "trade.automatic-rotations: a trade compares runs of "
                         "one kind, but auto may choose linear or large",
                         "Write Rotations = linear or large.");
      if (is_large && scene.trade.error_bars)
        throw InputError(
          "Trade/Error bars",
          "true",
          "trade.bars-with-large-rotations: with Rotations = "
          "large, error bars include the error of the axis mesh only",
          "Remove Error bars; the tables then have the differences from the finest variant.");
    }
  } // namespace



  Trade::Trade(const std::string              &scene_file,
               const std::vector<std::string> &overrides,
               const Scene                    &scene,
               const unsigned int              threads,
               std::ostream                   &out)
    : scene_file(scene_file)
    , overrides(overrides)
    , scene(scene)
    , threads(threads)
    , out(out)
    , base(fingerprint(overrides))
    , quantities(scene.trade.quantities)
  {
    check_rotations(scene);
    if (quantities.empty() && scene.trade.probes_as_goals.empty())
      throw InputError(
        "Trade/Quantities",
        "",
        "trade.no-quantities: a trade compares quantities of its variants, but "
        "the scene has neither probes nor References of supports and contacts",
        "Add a Probe, or write Quantities.");
    for (const TradeVariant &entry : scene.trade.variants)
      try
        {
          check_entries(
            SceneText::read(scene_file, overrides + entry.overrides));
        }
      catch (const InputError &error)
        {
          // A theory that cannot rotate fails as a variant.
          if (scene.solve.rotations == Rotations::large && !entry.tolerance &&
              !can_rotate(Theory::parse(Entry("Trade/Variants", entry.theory))))
            continue;
          throw InputError("Trade/Variants",
                           entry.name,
                           "trade.variant-unreadable: the scene with the "
                           "changes of this variant is not valid",
                           "Correct this variant: " +
                             std::string(error.what()));
        }
  }



  void
  Trade::check_quantities(const std::string &directory)
  {
    const std::string said   = directory + "/variants/check.txt",
                      errors = directory + "/variants/check_errors.txt";
    const ProcessEnd end =
      run_in_process([&] { return plies_of(quantities, scene); },
                     said,
                     errors,
                     scene.trade.time_limit);
    fs::remove(said);
    fs::remove(errors);
    const json result = end.result.empty() ? json() : json::parse(end.result);
    if (result.is_null())
      return;
    if (result.contains("fault"))
      {
        const std::vector<std::string> fault = result["fault"];
        throw InputError(fault[0], fault[1], fault[2], fault[3]);
      }
    for (unsigned int q = 0; q < quantities.size(); ++q)
      quantities[q].ply = result["plies"][q];
  }



  void
  Trade::run_variants(const std::string &directory)
  {
    std::map<std::string, std::string> seen;
    unsigned int                       number = 0;
    for (const TradeVariant &entry : scene.trade.variants)
      {
        ++number;
        out << "Variant " << number << " of " << scene.trade.variants.size()
            << ", " << entry.name << ": " << std::flush;
        std::vector<std::string> all;
        try
          {
            all = overrides + make_variant(entry, scene).overrides;
          }
        catch (const InputError &error)
          {
            fail(entry, error.what());
            continue;
          }
        set_interruption_message("interrupted. " + directory +
                                 "/variants has the variants before this one. "
                                 "The same command goes on with it.");
        const std::string of      = fingerprint(entry, all);
        const auto [same, is_new] = seen.emplace(of, entry.name);
        if (!is_new)
          {
            out << "the same as " << same->second << ", left out" << std::endl;
            if (reference == entry.name)
              reference = same->second;
            continue;
          }
        run_variant(
          {entry,
           all,
           of,
           scene.trade.error_bars && !entry.tolerance,
           directory + "/variants/" + folder_name(number, entry.name)});
      }
  }



  void
  Trade::complete_quantities()
  {
    for (unsigned int k = results.size(); k-- > 0;)
      if (results[k].failure.empty())
        {
          for (const std::string &probe : scene.trade.probes_as_goals)
            for (const NamedQuantity &quantity : numbers[k].largest_at(probe))
              quantities.push_back(quantity);
          return;
        }
  }



  void
  Trade::store_values()
  {
    for (unsigned int k = 0; k < results.size(); ++k)
      if (results[k].failure.empty())
        for (const NamedQuantity &quantity : quantities)
          {
            results[k].values.push_back(numbers[k].value(quantity));
            if (numbers[k].has_bars())
              results[k].bars.push_back(numbers[k].bar(quantity));
          }
  }



  void
  Trade::run(const std::string &directory)
  {
    prepare_directory(directory);
    boost::interprocess::file_lock lock((directory + "/trade.lock").c_str());
    if (!lock.try_lock())
      throw InputError("trade.folder-in-use: another trade writes into this "
                       "folder. Wait until it ends, or name another folder.")
        .at("--output " + directory + ": ");
    // Those of an earlier trade would look like this one's.
    for (const char *name :
         {"trade.json", "trade.csv", "trade.py", "trade.png", "trade.svg"})
      fs::remove(directory + "/" + name);
    results.clear();
    numbers.clear();
    reference = scene.trade.reference;
    check_quantities(directory);
    run_variants(directory);
    set_interruption_message("");
    complete_quantities();
    store_values();
    const bool is_large = scene.solve.rotations == Rotations::large;
    out << std::flush;
    present_trade({results,
                   quantities,
                   reference,
                   scene.trade.tolerances,
                   scene.title + (is_large ? ", large rotations" : ""),
                   is_large ? "All of it with Rotations = large.\n" : ""},
                  directory);
  }



  namespace
  {
    Theory
    theory_of(const VariantResult &variant)
    {
      return Theory::parse(Entry("Theory", variant.theory));
    }



    /// Returns true if the theory of @p one contains that of @p other. Runs to
    /// a tolerance hold those to a larger one, and no others.
    bool
    holds(const VariantResult &one, const VariantResult &other)
    {
      if (one.tolerance || other.tolerance)
        return one.tolerance && other.tolerance &&
               *one.tolerance <= *other.tolerance;
      return theory_of(one).holds(theory_of(other));
    }



    json
    number(const std::optional<double> &value)
    {
      return value ? json(*value) : json();
    }



    json
    to_json(const VariantResult &variant, const std::vector<VariantResult> &all)
    {
      json held = json::array(), bars = json::array();
      for (unsigned int k = 0; k < all.size(); ++k)
        if (holds(variant, all[k]))
          held.push_back(k);
      for (const std::optional<RunErrorBar> &own : variant.bars)
        bars.push_back(
          own ? json{{"bar", own->bar}, {"trusted", own->trusted}} : json());
      return {{"name", variant.name},
              {"theory", variant.theory},
              {"is_solid", !variant.tolerance && theory_of(variant).is_solid()},
              {"holds", held},
              {"failure", variant.failure},
              {"seconds", variant.seconds},
              {"phases", variant.phases},
              {"dofs", variant.dofs},
              {"memory", variant.memory},
              {"values", variant.values},
              {"bars", bars},
              {"axis", variant.axis},
              {"section", variant.section},
              {"overridden", variant.overridden},
              {"stiffening", variant.stiffening},
              {"buckling_factor", number(variant.buckling_factor)}};
    }
  } // namespace



  void
  present_trade(const TradeFindings &findings, const std::string &directory)
  {
    json trade{{"title", findings.title},
               {"remark", findings.remark},
               {"phases", phase_names()},
               {"reference", findings.reference},
               {"tolerances", findings.tolerances},
               {"variants", json::array()},
               {"quantities", json::array()}};
    for (const VariantResult &variant : findings.variants)
      trade["variants"].push_back(to_json(variant, findings.variants));
    for (const NamedQuantity &quantity : findings.quantities)
      trade["quantities"].push_back(
        {{"label", quantity.label()}, {"given", number(quantity.given)}});
    write_file(directory + "/trade.json", trade.dump(1) + "\n");

    const std::string python = python_with("json");
    if (python.empty())
      throw InputError(
        "trade.no-python: the tables need python3. Install it and start the "
        "trade again; finished variants are not repeated.");
    const std::string errors = directory + "/trade_errors.txt";
    const ProcessEnd  end =
      run_process(python,
                  {"-X", "utf8", path_of_script("trade.py"), directory},
                  "",
                  errors);
    std::ostringstream message;
    message << std::ifstream(errors).rdbuf();
    std::filesystem::remove(errors);
    if (end.status == 2)
      throw NumericsError("trade.no-reference: The reference solution of the "
                          "trade is missing, so there are no errors. Cause: " +
                          trimmed(message.str()));
    if (end.status != 0)
      throw InputError("trade.tables-failed: the tables of the trade could not "
                       "be written. Correct the cause and start the trade "
                       "again; finished variants are not repeated. Cause: " +
                       trimmed(message.str()));
  }
} // namespace lamella
