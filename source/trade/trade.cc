// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/base/version.h>
#include <lamella/recover/results.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/section/theory.h>
#include <lamella/trade/trade.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <unistd.h>

namespace lamella
{
  namespace
  {
    unsigned int
    scaled(const unsigned int count, const double factor)
    {
      return std::max(1L, std::lround(count * factor));
    }



    /// The counts of a list entry, each times @p factor.
    std::string
    scaled(const std::vector<unsigned int> &counts, const double factor)
    {
      std::vector<std::string> texts;
      for (const unsigned int count : counts)
        texts.push_back(std::to_string(scaled(count, factor)));
      return joined(texts);
    }



    /// Entries of a section and what they become.
    using Changes = std::vector<std::pair<std::string, std::string>>;

    /// One function for each kind of shape.
    struct FinerSection
    {
      double factor;
      /// How often the scene divides its cells.
      unsigned int divisions;

      Changes
      operator()(const Laminate &laminate) const
      {
        return {{"Cells per ply", scaled(laminate.cells_per_ply, factor)},
                {"Cells across", scaled(laminate.cells_across, factor)}};
      }

      Changes
      operator()(const HalfDisc &disc) const
      {
        const unsigned int quarters =
          std::max(2L, std::lround(disc.sectors * factor / 4.));
        return {{"Finest cell", to_text(disc.finest_cell / factor, 17)},
                {"Sectors", std::to_string(4 * quarters)}};
      }

      Changes
      operator()(const Ellipse &ellipse) const
      {
        const long times = std::lround(ellipse.refinements + std::log2(factor));
        return {{"Refinements", std::to_string(std::clamp(times, 0L, 6L))}};
      }

      Changes
      operator()(const ThinWalled &walls) const
      {
        const bool plies = !walls.layups.empty();
        return {{plies ? "Cells per ply" : "Cells per wall",
                 std::to_string(
                   scaled(plies ? walls.cells_per_ply : walls.cells_per_wall,
                          factor))},
                {"Cells along wall",
                 std::to_string(scaled(walls.cells_along_wall, factor))}};
      }

      Changes
      operator()(const Tube &tube) const
      {
        const unsigned int quarters =
          std::max(2L, std::lround(tube.cells_around * factor / 4.));
        return {{"Cells around", std::to_string(4 * quarters)},
                {"Cells per ply",
                 std::to_string(scaled(tube.cells_per_ply, factor))}};
      }

      /// A mesh by Gmsh is as fine as it was made: its cells are divided in
      /// four, as often as comes nearest to the factor.
      Changes
      operator()(const SectionFile &file) const
      {
        const long times = std::lround(divisions + std::log2(factor));
        if (times < 0)
          throw InputError(
            file.what + "/File",
            file.path,
            "trade.mesh-not-coarser: a section mesh from a file can be refined "
            "but not coarsened, so the factor of 'section' must be at least 1",
            "Name a coarser mesh in the variant: Section NAME/File = coarse.msh.");
        return {{"Cells divided", std::to_string(times)}};
      }
    };



    bool
    is_chosen(const BodyDescription &body, const Scene &scene)
    {
      const auto &chosen = scene.trade.bodies;
      return std::find(chosen.begin(), chosen.end(), body.name) != chosen.end();
    }



    /// The entries of the Kinematics of @p body with its name before them.
    std::string
    kinematics(const BodyDescription &body)
    {
      return "Body " + body.name + "/Kinematics/";
    }



    /// What says that @p body has this @p theory all along.
    std::vector<std::string>
    theory_of(const BodyDescription &body, const std::string &theory)
    {
      std::vector<std::string> overrides{kinematics(body) + "Theory=" + theory};
      if (!body.pieces.empty())
        for (const char *const one : {"Theories", "Theory breaks"})
          overrides.push_back(kinematics(body) + one + "=");
      return overrides;
    }



    /// Returns the entry Goals/Quantities for the quantities of @p trade; empty
    /// if they are those with References, the default of Goals.
    std::string
    quantities_of(const TradeParameters &trade)
    {
      std::vector<std::string> labels;
      for (const NamedQuantity &quantity : trade.quantities)
        if (trade.probes_as_goals.empty() && quantity.path != references_path)
          labels.push_back(quantity.label());
      return joined(labels, " | ");
    }



    /// What makes a run to a tolerance out of @p scene.
    std::vector<std::string>
    run_to_tolerance(const double tolerance, const Scene &scene)
    {
      std::vector<std::string> overrides{"Goals/Quantities=" +
                                           quantities_of(scene.trade),
                                         "Goals/Tolerance=" +
                                           to_text(100. * tolerance, 15),
                                         "Goals/Error bars=auto",
                                         "Theory=auto"};
      for (const BodyDescription &body : scene.bodies)
        if (is_chosen(body, scene))
          {
            for (const std::string &one : theory_of(body, "auto"))
              overrides.push_back(one);
            overrides.push_back(kinematics(body) + "Axis elements=auto");
            overrides.push_back(kinematics(body) + "Axis breaks=");
          }
        else if (body.pieces.empty())
          {
            // `LE-2 (L9)` is called LE-2 in a scene.
            const std::string name = body.theory.name();
            overrides.push_back(kinematics(body) +
                                "Theory=" + name.substr(0, name.find(' ')));
          }
      return overrides;
    }



    /// What makes a variant of a run of @p scene: theories and meshes.
    std::vector<std::string>
    run_of_theory(const TradeVariant &entry, const Scene &scene)
    {
      std::vector<std::string> overrides;
      std::set<std::string>    sections;
      for (const BodyDescription &body : scene.bodies)
        {
          if (!is_chosen(body, scene))
            continue;
          for (const std::string &one : theory_of(body, entry.theory))
            overrides.push_back(one);
          if (entry.axis != 1.)
            overrides.push_back(
              kinematics(body) + "Axis elements=" +
              (body.axis.refinement_factor > 0. ?
                 "auto " + to_text(body.axis.refinement_factor * entry.axis) :
                 scaled(body.axis.elements, entry.axis)));
          sections.insert(body.section);
        }
      if (entry.section != 1.)
        for (const std::string &section : sections)
          for (const auto &[name, value] :
               std::visit(FinerSection{entry.section,
                                       scene.divisions_of(section)},
                          scene.sections.at(section)))
            overrides.push_back("Section " + section + "/" + name + "=" +
                                value);
      return overrides;
    }
  } // namespace



  std::vector<std::string>
  goals_of(const TradeVariant &entry, const Scene &scene)
  {
    if (entry.tolerance)
      return {};
    std::vector<std::string> overrides{
      "Goals/Quantities=" + quantities_of(scene.trade),
      std::string("Goals/Error bars=") +
        (scene.trade.error_bars ? "true" : "false")};
    // A tolerance, and what limits its passes, would make it another run.
    if (!scene.goals.tolerances.empty())
      for (const char *entry :
           {"Tolerance=", "Budget DoFs=0", "Budget seconds=0"})
        overrides.push_back(std::string("Goals/") + entry);
    return overrides;
  }



  std::vector<std::string>
  overrides_of(const TradeVariant &entry, const Scene &scene)
  {
    std::vector<std::string> overrides =
      entry.tolerance ? run_to_tolerance(*entry.tolerance, scene) :
                        run_of_theory(entry, scene);
    overrides.insert(overrides.end(),
                     entry.overrides.begin(),
                     entry.overrides.end());
    return overrides;
  }



  using nlohmann::json;

  namespace
  {
    std::vector<std::string>
    operator+(std::vector<std::string> a, const std::vector<std::string> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }



    /// Throws InputError for scenes that cannot be compared.
    void
    check_scene(const Scene &scene)
    {
      if (scene.solve.rotations == Rotations::automatic)
        throw InputError("Rotations",
                         name_of(scene.solve.rotations),
                         "trade.automatic-rotations: a trade compares runs of "
                         "one kind, but auto may choose linear or large",
                         "Write Rotations = linear or large.");
      if (scene.solve.rotations == Rotations::large && scene.trade.error_bars)
        throw InputError(
          "Trade/Error bars",
          "true",
          "trade.bars-with-large-rotations: with Rotations = "
          "large, error bars include the error of the axis mesh only",
          "Remove Error bars; the tables then have the differences from the finest variant.");
      if (scene.trade.quantities.empty() && scene.trade.probes_as_goals.empty())
        throw InputError(
          "Trade/Quantities",
          "",
          "trade.no-quantities: a trade compares quantities of its variants, "
          "but the scene has neither probes nor References of supports and "
          "contacts",
          "Add a Probe, or write Quantities.");
    }



    /// Throws InputError if the scene with the changes of @p entry cannot be
    /// read. A theory without finite rotations fails as a variant.
    void
    check_variant(const TradeVariant &entry,
                  const CommandLine  &command,
                  const Scene        &scene)
    {
      try
        {
          check_entries(SceneText::read(command.scene,
                                        command.overrides + entry.overrides));
        }
      catch (const InputError &error)
        {
          if (scene.solve.rotations == Rotations::large && !entry.tolerance &&
              !can_rotate(Theory::parse(Entry("Trade/Variants", entry.theory))))
            return;
          throw InputError("Trade/Variants",
                           entry.name,
                           "trade.variant-unreadable: the scene with the "
                           "changes of this variant is not valid",
                           "Correct this variant: " +
                             std::string(error.what()));
        }
    }



    /// Returns the parameters @p resolved without `subsection Trade`.
    std::string
    without_trade(const std::string &resolved)
    {
      const std::string begin = "subsection Trade\n", end = "\nend\n";
      const auto        first = resolved.find(begin);
      const auto        last  = resolved.find(end, first);
      if (first == std::string::npos || last == std::string::npos)
        return resolved;
      return resolved.substr(0, first) + resolved.substr(last + end.size());
    }



    /// Returns the resolved parameters of the scene with @p overrides, and the
    /// mesh files that it reads. If it is not valid, which the run of the
    /// variant reports, the former are the overrides.
    json
    parameters_with(const std::string              &scene_file,
                    const std::vector<std::string> &overrides)
    {
      json files = json::array();
      try
        {
          const Scene scene =
            read_scene(SceneText::read(scene_file, overrides));
          for (const auto &section : scene.sections)
            if (const auto *file = std::get_if<SectionFile>(&section.second))
              files.push_back(file->path);
          return {{"fingerprint", without_trade(scene.resolved)},
                  {"files", files}};
        }
      catch (const InputError &error)
        {
          return {{"fingerprint", joined(overrides, "\n") + error.what()},
                  {"files", files}};
        }
    }



    /// Returns the indices of the variants with the theory of @p one or a
    /// poorer one (Theory::holds()). Runs to a tolerance hold those to a larger
    /// one, and no others.
    std::vector<unsigned int>
    held_by(const TradeVariant &one, const std::vector<TradeVariant> &all)
    {
      const auto theory_of = [](const TradeVariant &variant) {
        return Theory::parse(Entry("Theory", variant.theory));
      };
      std::vector<unsigned int> held;
      for (unsigned int k = 0; k < all.size(); ++k)
        if (one.tolerance || all[k].tolerance ?
              one.tolerance && all[k].tolerance &&
                *one.tolerance <= *all[k].tolerance :
              theory_of(one).holds(theory_of(all[k])))
          held.push_back(k);
      return held;
    }



    /// Returns the overrides of the variant @p entry and a text that changes if
    /// its results become invalid, or the reason why it cannot be run.
    json
    overrides_json(const TradeVariant &entry,
                   const CommandLine  &command,
                   const Scene        &scene)
    {
      try
        {
          const auto goals = goals_of(entry, scene),
                     own   = overrides_of(entry, scene);
          // Fewer quantities need no other run of a given model.
          const bool estimates  = entry.tolerance || scene.trade.error_bars;
          json       result     = parameters_with(command.scene,
                                        command.overrides +
                                          (estimates ? goals + own : own));
          result["fingerprint"] = result["fingerprint"].get<std::string>() +
                                  (estimates ? ", with error bars" : "") +
                                  ", " + version() + ", threads " +
                                  std::to_string(command.threads);
          result["failure"]   = "";
          result["overrides"] = command.overrides + goals + own +
                                std::vector<std::string>{"Write VTU=false"};
          return result;
        }
      catch (const InputError &error)
        {
          return {{"failure", error.what()}};
        }
    }



    json
    variant_json(const TradeVariant &entry,
                 const CommandLine  &command,
                 const Scene        &scene)
    {
      json variant{{"name", entry.name},
                   {"theory", entry.theory},
                   {"holds", held_by(entry, scene.trade.variants)},
                   {"is_solid",
                    !entry.tolerance &&
                      Theory::parse(Entry("Theory", entry.theory)).is_solid()},
                   {"axis", entry.axis},
                   {"section", entry.section},
                   {"overridden", !entry.overrides.empty()},
                   {"estimates", entry.tolerance || scene.trade.error_bars}};
      variant.update(overrides_json(entry, command, scene));
      return variant;
    }



    json
    plan_of(const CommandLine &command, const Scene &scene)
    {
      const TradeParameters &trade = scene.trade;
      const bool is_large          = scene.solve.rotations == Rotations::large;
      json plan{{"title", scene.title + (is_large ? ", large rotations" : "")},
                {"remark",
                 is_large ? "All of it with Rotations = large.\n" : ""},
                {"phases", phase_names()},
                {"reference", trade.reference},
                {"tolerances", trade.tolerances},
                {"time_limit", trade.time_limit},
                {"probes", trade.probes_as_goals},
                {"program", executable_path()},
                {"scene", command.scene},
                {"goals", command.overrides + goals_of({}, scene)},
                {"threads", command.threads},
                {"jobs", command.jobs},
                {"files", {command.scene, executable_path()}},
                {"variants", json::array()},
                {"quantities", json::array()}};
      for (const NamedQuantity &quantity : trade.quantities)
        plan["quantities"].push_back(
          {{"label", quantity.label()},
           {"given", quantity.given ? json(*quantity.given) : json()}});
      for (const TradeVariant &entry : trade.variants)
        plan["variants"].push_back(variant_json(entry, command, scene));
      return plan;
    }
  } // namespace



  void
  run_trade(const CommandLine &command, const Scene &scene)
  {
    check_scene(scene);
    for (const TradeVariant &entry : scene.trade.variants)
      check_variant(entry, command, scene);
    const std::string python = python_with("json");
    if (python.empty())
      throw InputError("trade.no-python: a trade needs python3, which was not "
                       "found. Install the package python3.");
    const std::string plan =
      command.output + "/variants/plan-" + std::to_string(getpid()) + ".json";
    OutputFile file(plan);
    file.stream() << plan_of(command, scene).dump(1) << "\n";
    if (!file.commit())
      throw InputError("trade.folder-not-writable: results cannot be written "
                       "into this folder. Name another folder.")
        .at("--output " + command.output + ": ");
    exec_program(
      python, {"-X", "utf8", path_of_script("trade.py"), command.output, plan});
  }
} // namespace lamella
