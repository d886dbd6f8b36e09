// SPDX-License-Identifier: LGPL-2.1-or-later

// The entries of thin walls.

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/material/layup.h>
#include <lamella/shape/shape_reader.h>

#include <numeric>

namespace lamella
{
  namespace
  {
    /// Throws InputError unless @p walls leave some of @p extension (@p named).
    void
    check_walls_fit(const std::vector<double> &walls,
                    const double               extension,
                    const std::string         &named,
                    const Entry               &entry)
    {
      const double sum = std::accumulate(walls.begin(), walls.end(), 0.);
      if (!(sum < extension))
        entry.refuse("shape.walls-too-thick: the walls together have " +
                       to_text(sum) + ", but the " + named + " " +
                       to_text(extension) + " must be larger",
                     "Make the walls thinner or the section larger.");
    }



    /// The pieces of @p entry between '|' for @p n walls: one for all or each.
    std::vector<std::string>
    one_per_wall(const Entry &entry, const std::vector<std::string> &walls)
    {
      const std::vector<std::string> items = entry.items('|');
      if (items.size() > 1 && items.size() != walls.size())
        entry.refuse("shape.count-of-layups: there are " +
                       std::to_string(items.size()) + " layups for " +
                       (walls.size() == 1 ? "one wall" :
                                            std::to_string(walls.size()) +
                                              " walls (" + joined(walls) + ")"),
                     "Write one layup, or one for each wall with '|' between.");
      return std::vector<std::string>(
        items.size() == walls.size() ?
          items :
          std::vector<std::string>(walls.size(),
                                   items.empty() ? "" : items[0]));
    }



    /// The thicknesses of @p n plies of a wall that is as thick as @p wall:
    /// those of @p piece of @p entry, or equal ones.
    std::vector<double>
    ply_thicknesses(const Entry       &entry,
                    const std::string &piece,
                    const unsigned int n,
                    const double       wall,
                    const std::string &named)
    {
      if (piece.empty())
        return std::vector<double>(n, wall / n);
      std::vector<double> values;
      for (const std::string &item : split(piece, ','))
        {
          values.push_back(entry.number(item));
          if (!(values.back() > 0.))
            entry.refuse(
              "entry.not-positive: a ply's thickness must be positive");
        }
      values           = one_per_ply(values, n, entry);
      const double sum = std::accumulate(values.begin(), values.end(), 0.);
      // Decimal fractions of a wall, as 0.333, are meant to add up.
      if (!(std::abs(sum - wall) <= arithmetic::decimal_tolerance * wall))
        entry.refuse("shape.sum-of-plies: the " + std::to_string(n) +
                       " plies of " + named + " have the total thickness " +
                       to_text(sum) + ", but the wall has the thickness " +
                       to_text(wall),
                     "Write thicknesses with this sum, or remove Wall ply "
                     "thicknesses for plies of equal thickness.");
      for (double &value : values)
        value *= wall / sum;
      return values;
    }



    /// The layups of @p walls of @p thicknesses; none without Wall layup.
    std::vector<WallLayup>
    read_layups(const ShapeReader              &reader,
                const std::vector<std::string> &walls,
                const std::vector<double>      &thicknesses)
    {
      const Entries &in    = reader.in;
      const Entry    entry = in["Wall layup"], t = in["Wall ply thicknesses"],
                  m = in["Wall ply materials"];
      if (entry.is_empty())
        return {};
      const std::vector<std::string> codes     = one_per_wall(entry, walls),
                                     of_plies  = one_per_wall(t, walls),
                                     materials = one_per_wall(m, walls);
      std::vector<WallLayup> layups;
      for (unsigned int w = 0; w < walls.size(); ++w)
        {
          const std::vector<double> angles =
            parse_layup(Entry(entry.path(), codes[w]));
          const std::string named =
            walls.size() == 1 ? "the wall" : "the wall '" + walls[w] + "'";
          const std::vector<double> thickness = ply_thicknesses(
            t, of_plies[w], angles.size(), thicknesses[w], named);
          std::vector<std::string> names =
            materials[w].empty() ?
              std::vector<std::string>{reader.oriented_material().material} :
              split(materials[w], ',');
          for (const std::string &name : names)
            reader.material(m, name);
          names = one_per_ply(names, angles.size(), m);
          layups.emplace_back();
          for (unsigned int p = 0; p < angles.size(); ++p)
            layups.back().push_back({{names[p], angles[p]}, thickness[p]});
        }
      return layups;
    }



    /// Throws InputError if entries are given that exclude each other, where
    /// there is a Wall layup (@p has_layup) or none.
    void
    check_layup_entries(const ShapeReader &reader, const bool has_layup)
    {
      const Entries &in = reader.in;
      if (has_layup && in["Fiber angle"].text() != "0")
        in["Fiber angle"].refuse(
          "shape.angle-with-layup: Fiber angle has no effect, since Wall layup "
          "gives the angles of the plies",
          "Remove Fiber angle or Wall layup.");
      if (has_layup && in["Cells per wall"].text() != "1")
        in["Cells per wall"].refuse(
          "shape.cells-with-layup: Cells per wall has no effect, since with "
          "Wall layup the cells are counted per ply",
          "Write Cells per ply instead.");
      if (!in["Wall ply materials"].is_empty() && !in["Material"].is_empty())
        in["Material"].refuse(
          "shape.material-unused: Wall ply materials are given, too",
          "Remove Material or Wall ply materials.");
      for (const auto &[name, fallback] :
           {std::pair<const char *, const char *>{"Wall ply thicknesses", ""},
            {"Wall ply materials", ""},
            {"Cells per ply", "1"}})
        if (!has_layup && in[name].text() != fallback)
          in[name].refuse("shape.entry-without-layup: this entry describes the "
                          "plies of Wall layup, but Wall layup is empty",
                          "Write Wall layup, or remove this entry.");
      if (has_layup && reader.counts("Cells per ply").size() != 1)
        in["Cells per ply"].refuse(
          "shape.one-number-for-plies: walls have one number of cells for all "
          "plies; write, for example, 1");
    }



    /// The thicknesses of the walls of @p result, of whose form they are; and
    /// the entries that gave those of the webs and of the flanges.
    std::pair<std::string, std::string>
    read_thicknesses(const ShapeReader &reader, ThinWalled &result)
    {
      const Entries &in        = reader.in;
      std::string    web_entry = "Wall thickness", flange_entry = web_entry;
      if (result.form == ShapeKind::box)
        {
          std::vector<double> walls = reader.lengths("Wall thickness");
          if (walls.size() == 1)
            walls.resize(4, walls[0]);
          if (walls.size() != 4)
            in["Wall thickness"].refuse(
              "shape.count-of-thicknesses: write one thickness, or four with "
              "commas between: left, right, bottom, top");
          result.webs    = {walls[0], walls[1]};
          result.flanges = {walls[2], walls[3]};
          return {web_entry, flange_entry};
        }
      const auto [n_webs, n_flanges] = wall_counts(result.form);
      if (!in["Web thickness"].is_empty())
        web_entry = "Web thickness";
      if (!in["Flange thickness"].is_empty())
        flange_entry = "Flange thickness";
      result.webs    = reader.lengths(web_entry);
      result.flanges = reader.lengths(flange_entry);
      if (result.flanges.size() == 1)
        result.flanges.resize(n_flanges, result.flanges[0]);
      for (const auto &[walls, n, entry] :
           {std::make_tuple(&result.webs, n_webs, &web_entry),
            std::make_tuple(&result.flanges, n_flanges, &flange_entry)})
        if (walls->size() != n)
          in[*entry].refuse("shape.count-of-thicknesses: a section " +
                            name_of(result.form) + " needs one thickness" +
                            (n == 2 ? " or two (bottom, top)" : ""));
      return {web_entry, flange_entry};
    }
  } // namespace



  Tube
  ShapeReader::tube() const
  {
    Tube result;
    result.width        = in["Width"].positive();
    result.height       = in["Height"].positive();
    result.cells_around = in["Cells around"].whole(8, max_cells_in_line);
    if (result.cells_around % 4 != 0)
      in["Cells around"].refuse(
        "shape.not-multiple-of-four: the number of cells around the tube must "
        "be a multiple of 4, as 16 or 24");
    const std::vector<double> thickness = lengths("Wall thickness");
    if (thickness.size() != 1)
      in["Wall thickness"].refuse(
        "shape.count-of-thicknesses: a tube has one wall; write one thickness");
    const double shorter = std::min(result.width, result.height),
                 longer  = std::max(result.width, result.height),
                 radius  = 0.5 * shorter * (shorter / longer);
    if (!(thickness[0] < radius))
      in["Wall thickness"].refuse(
        "shape.wall-above-radius: the wall must be thinner than the smallest "
        "radius of curvature of the outer surface, " +
          to_text(radius),
        "Reduce Wall thickness, or write Shape = ellipse for a solid section.");

    const bool has_layup = !in["Wall layup"].is_empty();
    if (!has_layup && (!in["Wall ply thicknesses"].is_empty() ||
                       !in["Wall ply materials"].is_empty()))
      check_layup_entries(*this, false);
    if (has_layup)
      check_layup_entries(*this, true);
    result.cells_per_ply = counts("Cells per ply").at(0);
    result.layup =
      has_layup ? read_layups(*this, {"tube"}, thickness).at(0) :
                  WallLayup{{{oriented_material().material, 0.}, thickness[0]}};
    return result;
  }



  ThinWalled
  ShapeReader::walls(const ShapeKind form) const
  {
    ThinWalled result;
    result.form             = form;
    result.width            = in["Width"].positive();
    result.height           = in["Height"].positive();
    result.cells_per_wall   = count("Cells per wall");
    result.cells_along_wall = count("Cells along wall");
    if (in["Wall ply materials"].is_empty())
      result.oriented_material = oriented_material();

    const auto [web_entry, flange_entry] = read_thicknesses(*this, result);
    check_walls_fit(result.webs, result.width, "width", in[web_entry]);
    check_walls_fit(result.flanges, result.height, "height", in[flange_entry]);
    check_layup_entries(*this, !in["Wall layup"].is_empty());
    std::vector<double> walls = result.webs;
    walls.insert(walls.end(), result.flanges.begin(), result.flanges.end());
    result.layups        = read_layups(*this, wall_names(form), walls);
    result.cells_per_ply = counts("Cells per ply").at(0);
    return result;
  }
} // namespace lamella
