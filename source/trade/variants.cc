// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/trade/variants.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

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
} // namespace lamella
