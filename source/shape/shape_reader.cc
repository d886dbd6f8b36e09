// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/material/material.h>
#include <lamella/shape/shape_reader.h>

#include <filesystem>
#include <numeric>
#include <sstream>

namespace lamella
{
  std::vector<double>
  ShapeReader::lengths(const std::string &entry) const
  {
    std::vector<double> values = in[entry].numbers();
    if (values.empty())
      in[entry].refuse_missing("shape.length-missing: give a length > 0.");
    return values;
  }



  std::vector<unsigned int>
  ShapeReader::counts(const std::string &entry) const
  {
    std::vector<unsigned int> values =
      in[entry].whole_numbers(1, max_cells_in_line);
    if (values.empty())
      in[entry].refuse_missing("shape.number-missing: write a whole number.");
    return values;
  }



  OrientedMaterial
  ShapeReader::oriented_material() const
  {
    const Entry      entry = in["Material"];
    OrientedMaterial result;
    result.angle = in["Fiber angle"].number();
    if (entry.is_empty() && materials.size() == 1)
      result.material = materials[0];
    else if (entry.is_empty())
      entry.refuse_missing(
        "shape.material-missing: write a material: " + joined(materials) + ".");
    else
      result.material = material(entry, entry.text());
    return result;
  }



  unsigned int
  ShapeReader::count(const std::string &entry) const
  {
    return in[entry].whole(1, max_cells_in_line);
  }



  std::string
  ShapeReader::material(const Entry &entry, const std::string &name) const
  {
    return Entry(entry.path(), name).among(materials, "material", "Materials");
  }



  namespace
  {
    /// The pieces of the mesh across the width.
    void
    read_pieces(Laminate &result, const ShapeReader &reader)
    {
      result.across_breaks =
        reader.in["Across breaks"].ascending(result.width, "the width");
      result.cells_across  = reader.counts("Cells across");
      const unsigned int n = result.across_breaks.size() + 1;
      if (result.cells_across.size() != n)
        reader.in["Cells across"].refuse(
          "shape.count-of-cells: Across breaks divide the width into " +
            std::to_string(n) + " part(s)",
          "Write the number of cells of each part, as in 4, 2, 4.");
    }



    /// What the physical surfaces of a mesh are made of, between '|'.
    std::map<std::string, OrientedMaterial>
    read_parts(const ShapeReader &reader)
    {
      const Entry                             entry = reader.in["Parts"];
      std::map<std::string, OrientedMaterial> parts;
      for (const std::string &text : entry.items('|'))
        {
          const auto         colon = text.find(':');
          const std::string  name  = trimmed(text.substr(0, colon));
          std::istringstream words(
            colon == std::string::npos ? "" : text.substr(colon + 1));
          std::string material, angle, rest;
          words >> material >> angle >> rest;
          if (name.empty() || material.empty() || !rest.empty())
            entry.refuse(
              "shape.invalid-part: '" + text +
                "' has not the form PART: MATERIAL ANGLE, as in web: carbon 45",
              "Write '|' between parts.");
          const OrientedMaterial oriented_material{
            reader.material(entry, material),
            angle.empty() ? 0. : entry.number(angle)};
          if (!parts.emplace(name, oriented_material).second)
            entry.refuse("shape.repeated-part: '" + name +
                         "' is given twice; remove one of the two");
        }
      return parts;
    }



    /// The ply planes of the parts of a mesh, between '|'.
    std::map<std::string, PartPlane>
    read_planes(const ShapeReader &reader)
    {
      const Entry                      entry = reader.in["Ply planes"];
      std::map<std::string, PartPlane> planes;
      for (const std::string &text : entry.items('|'))
        {
          const auto         colon = text.find(':');
          const std::string  name  = trimmed(text.substr(0, colon));
          std::istringstream words(
            colon == std::string::npos ? "" : text.substr(colon + 1));
          std::string word, curve, curves;
          words >> word;
          while (words >> curve)
            curves += (curves.empty() ? "" : " ") + curve;
          const bool follows = word == "along" || word == "against";
          if (name.empty() || word.empty() || follows == curves.empty())
            entry.refuse("shape.invalid-ply-plane: '" + text +
                           "' is not the direction of plies of a part",
                         "Write PART: ANGLE in degrees (for example web: 180), "
                         "PART: along CURVES or PART: against CURVES, with the "
                         "name of a group of curves, and '|' between parts.");
          PartPlane plane;
          if (follows)
            plane = {90., curves, word == "along"};
          else
            plane.direction = entry.number(word);
          if (!planes.emplace(name, plane).second)
            entry.refuse("shape.repeated-part: '" + name +
                         "' is given twice; remove one of the two");
        }
      return planes;
    }



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



  Laminate
  ShapeReader::laminate() const
  {
    Laminate result;
    result.width         = in["Width"].positive();
    result.angles        = parse_layup(in["Layup"]);
    const unsigned int n = result.angles.size();
    result.cells_per_ply =
      one_per_ply(counts("Cells per ply"), n, in["Cells per ply"]);
    read_pieces(result, *this);
    result.thicknesses =
      one_per_ply(lengths("Ply thickness"), n, in["Ply thickness"]);

    const Entry              entry = in["Ply materials"];
    std::vector<std::string> names = entry.items();
    if (names.empty() && materials.size() == 1)
      names = materials;
    if (names.empty())
      entry.refuse_missing("shape.material-missing: write a material: " +
                           joined(materials) + ", or one for each ply.");
    for (const std::string &name : names)
      material(entry, name);
    result.materials = one_per_ply(names, n, entry);
    return result;
  }



  HalfDisc
  ShapeReader::half_disc() const
  {
    HalfDisc result;
    result.radius         = in["Radius"].positive();
    result.graded_towards = in["Graded towards"].number();
    if (!(result.graded_towards >= 30. && result.graded_towards <= 150.))
      in["Graded towards"].refuse(
        "shape.angle-out-of-range: the angle must lie between 30 and 150 "
        "degrees; 90 is the top of the arc");
    const Entry finest = in["Finest cell"];
    result.finest_cell =
      finest.is_empty() ? result.radius / 8. : finest.positive();
    if (!(result.finest_cell <= result.radius &&
          result.finest_cell >= 1e-6 * result.radius))
      finest.refuse("shape.invalid-finest-cell: the cell size must lie between "
                    "a millionth of Radius and Radius, which is " +
                    to_text(result.radius));
    result.sectors = count("Sectors");
    if (result.sectors % 4 != 0)
      in["Sectors"].refuse(
        "shape.not-multiple-of-four: Sectors must be a multiple of 4, as 8");
    result.oriented_material = oriented_material();
    return result;
  }



  Ellipse
  ShapeReader::ellipse() const
  {
    Ellipse result;
    result.width       = in["Width"].positive();
    result.height      = in["Height"].positive();
    result.refinements = in["Refinements"].whole(0, max_ellipse_refinements);
    result.oriented_material = oriented_material();
    return result;
  }



  SectionFile
  ShapeReader::file(const std::string &folder) const
  {
    const Entry name = in["File"];
    if (name.is_empty())
      name.refuse_missing(
        "shape.file-missing: write the name of a mesh file of Gmsh, for example beam.msh.");
    SectionFile result;
    result.path   = (std::filesystem::path(folder) / name.text()).string();
    result.what   = in.path();
    result.scale  = in["Scale"].positive();
    result.parts  = read_parts(*this);
    result.planes = read_planes(*this);
    return result;
  }



  // The entries of thin walls.



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
