// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/trade/ladder.h>

#include <algorithm>
#include <cmath>
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
        return {{"Cells per wall",
                 std::to_string(scaled(walls.cells_per_wall, factor))},
                {"Cells along wall",
                 std::to_string(scaled(walls.cells_along_wall, factor))}};
      }

      Changes
      operator()(const SectionFile &file) const
      {
        throw InputError(file.what + "/File",
                         file.path,
                         "a mesh file is as fine as Gmsh made it, and no "
                         "section FACTOR changes that",
                         "Name another file in the rung: Section NAME/File = "
                         "...");
      }
    };
  } // namespace



  Rung
  make_rung(const LadderEntry &entry, const Scene &scene)
  {
    Rung                  rung{entry.name, entry.theory, {}};
    std::set<std::string> sections;
    for (const BodyDescription &body : scene.bodies)
      {
        const auto &chosen = scene.trade.bodies;
        if (std::find(chosen.begin(), chosen.end(), body.name) == chosen.end())
          continue;
        const std::string kinematics = "Body " + body.name + "/Kinematics/";
        rung.overrides.push_back(kinematics + "Theory=" + entry.theory);
        if (!body.pieces.empty())
          for (const char *const one : {"Theories", "Theory breaks"})
            rung.overrides.push_back(kinematics + one + "=");
        if (entry.axis != 1.)
          rung.overrides.push_back(
            kinematics + "Axis elements=" +
            (body.axis.fineness > 0. ?
               "auto " + to_text(body.axis.fineness * entry.axis) :
               scaled(body.axis.elements, entry.axis)));
        sections.insert(body.section);
      }
    if (entry.section != 1.)
      for (const std::string &section : sections)
        for (const auto &[name, value] : std::visit(FinerSection{entry.section},
                                                    scene.sections.at(section)))
          rung.overrides.push_back("Section " + section + "/" + name + "=" +
                                   value);
    rung.overrides.insert(rung.overrides.end(),
                          entry.overrides.begin(),
                          entry.overrides.end());
    return rung;
  }
} // namespace lamella
