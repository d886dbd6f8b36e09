// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/patterns.h>
#include <lamella/material/layup.h>
#include <lamella/shape/parameters.h>

#include <filesystem>
#include <numeric>
#include <sstream>

namespace lamella
{
  using dealii::ParameterHandler;

  namespace
  {
    using dealii::Patterns::Anything;
    using dealii::Patterns::List;
    using dealii::Patterns::PatternBase;
    using patterns::number;
    using patterns::numbers;
    using patterns::optional;
    using patterns::positive;
    using patterns::Whole;

    // Along a line of a mesh: a slip of a digit must not end in a machine out
    // of memory.
    constexpr unsigned int most_in_line = 10000;
    // 49152 cells.
    constexpr unsigned int most_refinements = 6;



    /// Laminate, half Disc, Ellipse, Box, Tube, other Walls, File.
    char
    letter_of(const ShapeKind kind)
    {
      switch (kind)
        {
          case ShapeKind::laminate:
            return 'L';
          case ShapeKind::half_disc:
            return 'D';
          case ShapeKind::ellipse:
            return 'E';
          case ShapeKind::box:
            return 'B';
          case ShapeKind::tube:
            return 'T';
          case ShapeKind::file:
            return 'F';
          default:
            return 'W';
        }
    }



    /// An entry, and the letters of the shapes that have it.
    struct Declaration
    {
      Declaration(const std::string &name,
                  const std::string &fallback,
                  const PatternBase &pattern,
                  const std::string &letters,
                  const std::string &documentation)
        : name(name)
        , fallback(fallback)
        , letters(letters)
        , documentation(documentation)
        , pattern(pattern.clone())
      {}

      bool
      is_of(const ShapeKind kind) const
      {
        return letters.find(letter_of(kind)) != std::string::npos;
      }

      std::string                        name, fallback, letters, documentation;
      std::shared_ptr<const PatternBase> pattern;
    };



    const Whole cells(1, most_in_line);

    const std::vector<Declaration> table{
      {"Width",
       "",
       optional(positive()),
       "LEBWT",
       "Extension along the section's x [length]."},
      {"Height",
       "",
       optional(positive()),
       "EBWT",
       "Extension along the section's z [length]."},
      {"Layup",
       "0",
       Anything(),
       "L",
       "Laminate: ply angles from bottom to top in degrees, 0 along +y, "
       "positive from +y towards +x: 0/90/0, [0/+-45/90]2s."},
      {"Ply thickness",
       "",
       List(positive()),
       "L",
       "Laminate: one thickness for all plies, or one a ply between commas, "
       "bottom to top [length]."},
      {"Ply materials",
       "",
       Anything(),
       "L",
       "Laminate: one material for all plies, or one a ply between commas. "
       "May be left out if the scene has one material."},
      {"Cells per ply",
       "1",
       List(cells),
       "LBWT",
       "Laminate: cells through the thickness, one number for all plies or "
       "one a ply. Walls with a Wall layup: one number for all plies."},
      {"Cells across",
       "1",
       List(cells),
       "L",
       "Laminate: cells across the width, equally wide, or one number for "
       "each piece between Across breaks."},
      {"Across breaks",
       "",
       numbers(),
       "L",
       "Laminate: positions x across the width that end a piece of the mesh, "
       "ascending [length]."},
      {"Material",
       "",
       Anything(),
       "DEBWT",
       "All shapes but laminate and file: a name of Materials. May be left "
       "out if the scene has one material."},
      {"Fibre angle",
       "0",
       number(),
       "DEBW",
       "All shapes but laminate, tube and file: degrees, 0 along +y, positive "
       "from +y towards +x, about z in all walls. Not with a Wall layup."},
      {"Radius",
       "",
       optional(positive()),
       "D",
       "Half disc: of its arc [length]."},
      {"Graded towards",
       "90",
       number(),
       "D",
       "Half disc: the point of the arc where the cells are finest, degrees "
       "from +x towards +z, 30 to 150; 90 is the top."},
      {"Finest cell",
       "",
       optional(positive()),
       "D",
       "Half disc: width of the cells at that point; an eighth of the radius "
       "by default [length]."},
      {"Sectors",
       "8",
       cells,
       "D",
       "Half disc: cells in each ring around that point, a multiple of 4."},
      {"Refinements",
       "1",
       Whole(0, most_refinements),
       "E",
       "Ellipse: how often 12 cells are cut into four each, 0 to 6."},
      {"Cells divided",
       "0",
       Whole(0, SectionParameters::most_divisions),
       "LDEBWTF",
       "How often all cells of the section are divided in four, also those of "
       "a file, 0 to 4."},
      {"Wall thickness",
       "",
       List(positive()),
       "BWT",
       "Thin-walled: of all walls; of a box also four between commas, left, "
       "right, bottom, top [length]."},
      {"Web thickness",
       "",
       List(positive()),
       "W",
       "double-T, T, channel, angle: of the upright wall; Wall thickness by "
       "default [length]."},
      {"Flange thickness",
       "",
       List(positive()),
       "W",
       "double-T, T, channel, angle: of the level walls, one or bottom, top; "
       "Wall thickness by default [length]."},
      {"Wall layup",
       "",
       Anything(),
       "BWT",
       "Thin-walled: ply angles from the inside of each wall to its outside in "
       "degrees, in the wall's own plane: 0 along +y, positive to the right "
       "for who looks at the wall from outside with +y pointing up. One layup "
       "for all walls, or one a wall between '|': webs from left to right, "
       "then flanges from bottom to top. Without: one material at Fibre angle, "
       "or at 0 degrees in a tube."},
      {"Wall ply thicknesses",
       "",
       Anything(),
       "BWT",
       "Thin-walled: of the plies of Wall layup, one a ply between commas, the "
       "walls between '|' [length]. They must add up to each wall's thickness. "
       "By default equal shares of it."},
      {"Wall ply materials",
       "",
       Anything(),
       "BWT",
       "Thin-walled: of the plies of Wall layup, likewise; Material by "
       "default."},
      {"Cells per wall",
       "1",
       cells,
       "BW",
       "Thin-walled: cells through each wall, of walls without a Wall layup."},
      {"Cells along wall",
       "4",
       cells,
       "BW",
       "Thin-walled: cells along each wall between its corners."},
      {"Cells around",
       "24",
       cells,
       "T",
       "Tube: cells around it, a multiple of 4, from 8."},
      {"File",
       "",
       Anything(),
       "F",
       "File: a mesh of quadrilaterals by Gmsh, NAME.msh, relative to the "
       "scene's folder."},
      {"Parts",
       "",
       Anything(),
       "F",
       "File: PART: MATERIAL ANGLE between '|', for physical surfaces that "
       "are not called as their material; the angle may be left out."},
      {"Ply planes",
       "",
       Anything(),
       "F",
       "File: PART: DIRECTION between '|', where the normal of a part's plies "
       "points, in degrees from +x towards +z, 90 by default; or PART: along "
       "CURVES, physical lines between blanks whose outward normals it "
       "follows, or PART: against CURVES for the inward ones."},
      {"Scale",
       "1",
       positive(),
       "F",
       "File: what all coordinates of the mesh are multiplied with."}};



    /// What the entries of one section are read with.
    struct Reader
    {
      const Entries &in;
      /// Names that a material may have.
      const std::vector<std::string> &materials;

      /// One a piece between commas, at least one.
      std::vector<double>
      lengths(const std::string &entry) const;
      std::vector<unsigned int>
      counts(const std::string &entry) const;

      unsigned int
      count(const std::string &entry) const
      {
        return in[entry].whole(1, most_in_line);
      }

      /// @p name, which stands in @p entry and must be a material.
      std::string
      material(const Entry &entry, const std::string &name) const
      {
        return Entry(entry.path(), name)
          .among(materials, "material", "Materials");
      }

      /// Of a section of one material.
      Fabric
      fabric() const;
    };



    std::vector<double>
    Reader::lengths(const std::string &entry) const
    {
      const std::vector<double> values = in[entry].numbers();
      if (values.empty())
        in[entry].is_missing("give a positive length.");
      return values;
    }



    std::vector<unsigned int>
    Reader::counts(const std::string &entry) const
    {
      const std::vector<unsigned int> values =
        in[entry].wholes(1, most_in_line);
      if (values.empty())
        in[entry].is_missing("give a whole number.");
      return values;
    }



    Fabric
    Reader::fabric() const
    {
      const Entry entry = in["Material"];
      Fabric      result;
      result.angle = in["Fibre angle"].number();
      if (entry.is_empty() && materials.size() == 1)
        result.material = materials[0];
      else if (entry.is_empty())
        entry.is_missing("name one of " + joined(materials) + ".");
      else
        result.material = material(entry, entry.text());
      return result;
    }



    /// @p items, one for each of @p n plies or one for all, as @p entry gives
    /// them.
    template <typename T>
    std::vector<T>
    one_a_ply(const std::vector<T> &items,
              const unsigned int    n,
              const Entry          &entry)
    {
      if (items.size() == 1)
        return std::vector<T>(n, items[0]);
      if (items.size() != n)
        entry.refuse("there are " + std::to_string(items.size()) +
                       " values for " + std::to_string(n) + " plies",
                     "Give one for all plies or one a ply.");
      return items;
    }



    /// The pieces of the mesh across the width.
    void
    read_pieces(Laminate &result, const Reader &reader)
    {
      result.across_breaks =
        reader.in["Across breaks"].ascending(result.width, "the width");
      result.cells_across  = reader.counts("Cells across");
      const unsigned int n = result.across_breaks.size() + 1;
      if (result.cells_across.size() != n)
        reader.in["Cells across"].refuse(
          std::string("there ") +
          (n == 1 ? "is one piece" : "are " + std::to_string(n) + " pieces") +
          " (Across breaks and one), so give as many numbers");
    }



    Laminate
    read_laminate(const Reader &reader)
    {
      const Entries &in = reader.in;
      Laminate       result;
      result.width         = in["Width"].positive();
      result.angles        = parse_layup(in["Layup"]);
      const unsigned int n = result.angles.size();
      result.cells_per_ply =
        one_a_ply(reader.counts("Cells per ply"), n, in["Cells per ply"]);
      read_pieces(result, reader);
      result.thicknesses =
        one_a_ply(reader.lengths("Ply thickness"), n, in["Ply thickness"]);

      const Entry              entry = in["Ply materials"];
      std::vector<std::string> names = entry.items();
      if (names.empty() && reader.materials.size() == 1)
        names = reader.materials;
      if (names.empty())
        entry.is_missing("name one of " + joined(reader.materials) +
                         ", or one a ply.");
      for (const std::string &name : names)
        reader.material(entry, name);
      result.materials = one_a_ply(names, n, entry);
      return result;
    }



    HalfDisc
    read_half_disc(const Reader &reader)
    {
      const Entries &in = reader.in;
      HalfDisc       result;
      result.radius         = in["Radius"].positive();
      result.graded_towards = in["Graded towards"].number();
      if (!(result.graded_towards >= 30. && result.graded_towards <= 150.))
        in["Graded towards"].refuse(
          "must be an angle from 30 to 150 degrees; 90 is the top of the arc");
      const Entry finest = in["Finest cell"];
      result.finest_cell =
        finest.is_empty() ? result.radius / 8. : finest.positive();
      if (!(result.finest_cell <= result.radius &&
            result.finest_cell >= 1e-6 * result.radius))
        finest.refuse("must lie between a millionth of the radius and the "
                      "radius " +
                      to_text(result.radius));
      result.sectors = reader.count("Sectors");
      if (result.sectors % 4 != 0)
        in["Sectors"].refuse("must be a multiple of 4, as 8 or 12");
      result.fabric = reader.fabric();
      return result;
    }



    Ellipse
    read_ellipse(const Reader &reader)
    {
      Ellipse result;
      result.width       = reader.in["Width"].positive();
      result.height      = reader.in["Height"].positive();
      result.refinements = reader.in["Refinements"].whole(0, most_refinements);
      result.fabric      = reader.fabric();
      return result;
    }



    /// Throws InputError unless @p walls, as @p entry gives them, leave some of
    /// @p extension, which is @p named so.
    void
    check_walls_fit(const std::vector<double> &walls,
                    const double               extension,
                    const std::string         &named,
                    const Entry               &entry)
    {
      const double sum = std::accumulate(walls.begin(), walls.end(), 0.);
      if (!(sum < extension))
        entry.refuse("the walls take " + to_text(sum) + " of the " + named +
                       " " + to_text(extension) + " and must leave some of it",
                     "Make the walls thinner or the section larger.");
    }



    /// The pieces of @p entry for @p n walls, between '|': one for all or one a
    /// wall. Empty ones if it is empty.
    std::vector<std::string>
    one_a_wall(const Entry &entry, const std::vector<std::string> &walls)
    {
      const std::vector<std::string> items = entry.items('|');
      if (items.size() > 1 && items.size() != walls.size())
        entry.refuse("there are " + std::to_string(items.size()) +
                       " pieces for " +
                       (walls.size() == 1 ? "one wall" :
                                            std::to_string(walls.size()) +
                                              " walls (" + joined(walls) + ")"),
                     "Give one for all walls or one a wall between '|'.");
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
      // Decimal fractions of a wall, as 0.333, are meant to add up.
      if (piece.empty())
        return std::vector<double>(n, wall / n);
      std::vector<double> values;
      for (const std::string &item : split(piece, ','))
        {
          values.push_back(entry.number(item));
          if (!(values.back() > 0.))
            entry.refuse("a ply's thickness must be positive");
        }
      values           = one_a_ply(values, n, entry);
      const double sum = std::accumulate(values.begin(), values.end(), 0.);
      if (!(std::abs(sum - wall) <= arithmetic::as_written * wall))
        entry.refuse("the " + std::to_string(n) + " plies of " + named +
                       " add up to " + to_text(sum) +
                       ", and not to its thickness " + to_text(wall),
                     "Give thicknesses that add up to it, or leave them out "
                     "for equal shares.");
      for (double &value : values)
        value *= wall / sum;
      return values;
    }



    /// The layups of @p walls, which are as thick as @p thicknesses; none if
    /// there is no Wall layup.
    std::vector<WallLayup>
    read_layups(const Reader                   &reader,
                const std::vector<std::string> &walls,
                const std::vector<double>      &thicknesses)
    {
      const Entries &in    = reader.in;
      const Entry    entry = in["Wall layup"], t = in["Wall ply thicknesses"],
                  m = in["Wall ply materials"];
      if (entry.is_empty())
        return {};
      const std::vector<std::string> codes     = one_a_wall(entry, walls),
                                     of_plies  = one_a_wall(t, walls),
                                     materials = one_a_wall(m, walls);
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
              std::vector<std::string>{reader.fabric().material} :
              split(materials[w], ',');
          for (const std::string &name : names)
            reader.material(m, name);
          names = one_a_ply(names, angles.size(), m);
          layups.emplace_back();
          for (unsigned int p = 0; p < angles.size(); ++p)
            layups.back().push_back({{names[p], angles[p]}, thickness[p]});
        }
      return layups;
    }



    /// Throws InputError if entries are given that exclude each other, where
    /// there is a Wall layup (@p has_layup) or none.
    void
    check_layup_entries(const Reader &reader, const bool has_layup)
    {
      const Entries &in = reader.in;
      if (has_layup && in["Fibre angle"].text() != "0")
        in["Fibre angle"].refuse(
          "with Wall layup plies have their angles there, in the plane of each "
          "wall",
          "Remove one of the two.");
      if (has_layup && in["Cells per wall"].text() != "1")
        in["Cells per wall"].refuse(
          "with Wall layup cells are counted by plies", "Use Cells per ply.");
      if (!in["Wall ply materials"].is_empty() && !in["Material"].is_empty())
        in["Material"].refuse("Wall ply materials leave nothing that uses it",
                              "Remove one of the two.");
      for (const auto &[name, fallback] :
           {std::pair<const char *, const char *>{"Wall ply thicknesses", ""},
            {"Wall ply materials", ""},
            {"Cells per ply", "1"}})
        if (!has_layup && in[name].text() != fallback)
          in[name].refuse("it belongs to Wall layup, which is not given",
                          "Give Wall layup, as in 45/-45, or remove it.");
      if (has_layup && reader.counts("Cells per ply").size() != 1)
        in["Cells per ply"].refuse("walls take one number, for all plies");
    }



    Tube
    read_tube(const Reader &reader)
    {
      const Entries &in = reader.in;
      Tube           result;
      result.width        = in["Width"].positive();
      result.height       = in["Height"].positive();
      result.cells_around = in["Cells around"].whole(8, most_in_line);
      if (result.cells_around % 4 != 0)
        in["Cells around"].refuse("must be a multiple of 4, as 16 or 24");
      const std::vector<double> thickness = reader.lengths("Wall thickness");
      if (thickness.size() != 1)
        in["Wall thickness"].refuse("a tube has one wall");
      const double shorter = std::min(result.width, result.height),
                   longer  = std::max(result.width, result.height),
                   radius  = 0.5 * shorter * (shorter / longer);
      if (!(thickness[0] < radius))
        in["Wall thickness"].refuse(
          "must be below the smallest radius of curvature of the tube's "
          "outside, " +
            to_text(radius),
          "Make the wall thinner, or use Shape = ellipse for a solid section.");

      const bool has_layup = !in["Wall layup"].is_empty();
      if (!has_layup && (!in["Wall ply thicknesses"].is_empty() ||
                         !in["Wall ply materials"].is_empty()))
        check_layup_entries(reader, false);
      if (has_layup)
        check_layup_entries(reader, true);
      result.cells_per_ply = reader.counts("Cells per ply").at(0);
      result.layup =
        has_layup ? read_layups(reader, {"tube"}, thickness).at(0) :
                    WallLayup{{{reader.fabric().material, 0.}, thickness[0]}};
      return result;
    }



    ThinWalled
    read_walls(const ShapeKind form, const Reader &reader)
    {
      const Entries &in = reader.in;
      ThinWalled     result;
      result.form             = form;
      result.width            = in["Width"].positive();
      result.height           = in["Height"].positive();
      result.cells_per_wall   = reader.count("Cells per wall");
      result.cells_along_wall = reader.count("Cells along wall");
      if (in["Wall ply materials"].is_empty())
        result.fabric = reader.fabric();

      const auto [n_webs, n_flanges] = count_of_walls(form);
      std::string web_entry = "Wall thickness", flange_entry = web_entry;
      if (form == ShapeKind::box)
        {
          std::vector<double> walls = reader.lengths("Wall thickness");
          if (walls.size() == 1)
            walls.resize(4, walls[0]);
          if (walls.size() != 4)
            in["Wall thickness"].refuse(
              "give one, or four between commas: left, right, bottom, top");
          result.webs    = {walls[0], walls[1]};
          result.flanges = {walls[2], walls[3]};
        }
      else
        {
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
              in[*entry].refuse("a section " + name_of(form) + " takes one" +
                                (n == 2 ? " or two (bottom, top)" : ""));
        }
      check_walls_fit(result.webs, result.width, "width", in[web_entry]);
      check_walls_fit(result.flanges,
                      result.height,
                      "height",
                      in[flange_entry]);
      check_layup_entries(reader, !in["Wall layup"].is_empty());
      std::vector<double> walls = result.webs;
      walls.insert(walls.end(), result.flanges.begin(), result.flanges.end());
      result.layups        = read_layups(reader, names_of_walls(form), walls);
      result.cells_per_ply = reader.counts("Cells per ply").at(0);
      return result;
    }



    /// What the physical surfaces of a mesh are made of, between '|'.
    std::map<std::string, Fabric>
    read_parts(const Reader &reader)
    {
      const Entry                   entry = reader.in["Parts"];
      std::map<std::string, Fabric> parts;
      for (const std::string &text : entry.items('|'))
        {
          const auto         colon = text.find(':');
          const std::string  name  = trimmed(text.substr(0, colon));
          std::istringstream words(
            colon == std::string::npos ? "" : text.substr(colon + 1));
          std::string material, angle, rest;
          words >> material >> angle >> rest;
          if (name.empty() || material.empty() || !rest.empty())
            entry.refuse("'" + text +
                           "' is not PART: MATERIAL ANGLE, as in web: carbon "
                           "45",
                         "Between parts stands '|'.");
          const Fabric fabric{reader.material(entry, material),
                              angle.empty() ? 0. : entry.number(angle)};
          if (!parts.emplace(name, fabric).second)
            entry.refuse("'" + name + "' stands there twice");
        }
      return parts;
    }



    /// The ply planes of the parts of a mesh, between '|'.
    std::map<std::string, PartPlane>
    read_planes(const Reader &reader)
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
            entry.refuse("'" + text +
                           "' is neither PART: DIRECTION, as in web: 180, nor "
                           "PART: along CURVES, nor PART: against CURVES",
                         "Between parts stands '|'.");
          PartPlane plane;
          if (follows)
            plane = {90., curves, word == "along"};
          else
            plane.direction = entry.number(word);
          if (!planes.emplace(name, plane).second)
            entry.refuse("'" + name + "' stands there twice");
        }
      return planes;
    }



    SectionFile
    read_file(const std::string &folder, const Reader &reader)
    {
      const Entry file = reader.in["File"];
      if (file.is_empty())
        file.is_missing("name a mesh by Gmsh, as in beam.msh.");
      SectionFile result;
      result.path   = (std::filesystem::path(folder) / file.text()).string();
      result.what   = reader.in.path();
      result.scale  = reader.in["Scale"].positive();
      result.parts  = read_parts(reader);
      result.planes = read_planes(reader);
      return result;
    }



    /// Throws InputError if one of the entries is given, but none of the shape
    /// @p kind.
    void
    check_entries(const ShapeKind kind, const Entries &in)
    {
      std::vector<std::string> own;
      for (const Declaration &entry : table)
        if (entry.is_of(kind))
          own.push_back(entry.name);
      for (const Declaration &entry : table)
        if (!entry.is_of(kind) && in[entry.name].text() != entry.fallback)
          in[entry.name].refuse("the shape '" + name_of(kind) +
                                  "' has no such entry",
                                "It has " + joined(own) + ".");
      if (letter_of(kind) == 'W' && !in["Wall thickness"].is_empty() &&
          !in["Web thickness"].is_empty() && !in["Flange thickness"].is_empty())
        in["Wall thickness"].refuse(
          "Web thickness and Flange thickness leave nothing that uses it",
          "Remove one of the three.");
    }
  } // namespace



  void
  SectionParameters::declare(ParameterHandler &prm)
  {
    std::string names;
    for (const NameOf<ShapeKind> &shape : Names<ShapeKind>::all)
      names += (names.empty() ? "" : ", ") + std::string(shape.name);
    prm.declare_entry("Shape",
                      name_of(ShapeKind::laminate),
                      selection<ShapeKind>(),
                      "The kind of section: " + names +
                        "; each with entries of its own.");
    for (const Declaration &entry : table)
      prm.declare_entry(entry.name,
                        entry.fallback,
                        *entry.pattern,
                        entry.documentation);
  }



  namespace
  {
    SectionShape
    read(const ShapeKind kind, const std::string &folder, const Reader &reader)
    {
      switch (kind)
        {
          case ShapeKind::laminate:
            return read_laminate(reader);
          case ShapeKind::half_disc:
            return read_half_disc(reader);
          case ShapeKind::ellipse:
            return read_ellipse(reader);
          case ShapeKind::tube:
            return read_tube(reader);
          case ShapeKind::file:
            return read_file(folder, reader);
          default:
            return read_walls(kind, reader);
        }
    }



    /// How many cells the mesh of @p shape has, roughly; 0 for a file.
    double
    estimated_cells(const SectionShape &shape)
    {
      if (const auto *laminate = std::get_if<Laminate>(&shape))
        {
          const auto sum = [](const std::vector<unsigned int> &counts) {
            return std::accumulate(counts.begin(), counts.end(), 0.);
          };
          const double plies = laminate->angles.size();
          return sum(laminate->cells_across) * sum(laminate->cells_per_ply) *
                 (laminate->cells_per_ply.size() == 1 ? plies : 1.);
        }
      if (const auto *disc = std::get_if<HalfDisc>(&shape))
        // A core, and rings that grow by pi / sectors.
        return disc->sectors *
               (disc->sectors +
                std::log(disc->radius / disc->finest_cell + 1.) *
                  disc->sectors / 3.);
      if (const auto *walls = std::get_if<ThinWalled>(&shape))
        {
          double through = walls->cells_per_wall;
          for (const WallLayup &layup : walls->layups)
            through =
              std::max(through, double(walls->cells_per_ply) * layup.size());
          return 4. * through * (through + walls->cells_along_wall);
        }
      if (const auto *tube = std::get_if<Tube>(&shape))
        return double(tube->cells_around) * tube->cells_per_ply *
               tube->layup.size();
      return 0.;
    }
  } // namespace



  SectionShape
  SectionParameters::parse(const Entries                  &in,
                           const std::vector<std::string> &materials,
                           const std::string              &folder)
  {
    const ShapeKind kind = in["Shape"].choice<ShapeKind>();
    check_entries(kind, in);
    const SectionShape result = read(kind, folder, {in, materials});
    const double       cells  = estimated_cells(result);
    if (cells > most_section_cells)
      in.refuse("the section would have about " + to_text(cells) +
                  " cells, more than " + to_text(most_section_cells),
                "Use fewer cells, and a higher order instead.");
    return result;
  }
} // namespace lamella
