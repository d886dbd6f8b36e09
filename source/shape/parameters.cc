// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/material/layup.h>
#include <lamella/shape/parameters.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <sstream>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    const std::vector<std::string> shapes{"laminate",
                                          "half disc",
                                          "ellipse",
                                          "box",
                                          "double-T",
                                          "T",
                                          "channel",
                                          "angle",
                                          "file"};

    /// An entry, and which shapes have it: letters of `shape_letters`.
    struct Entry
    {
      std::string name, fallback, letters, documentation;
    };

    /// Laminate, half Disc, Ellipse, Box, Walls, File; in the order of
    /// `shapes`.
    const std::string shape_letters = "LDEBWWWWF";



    const std::vector<Entry> table{
      {"Width", "", "LEBW", "Extension along the section's x [length]."},
      {"Height", "", "EBW", "Extension along the section's z [length]."},
      {"Layup",
       "0",
       "L",
       "Laminate: ply angles from bottom to top in degrees, 0 along +y, "
       "positive from +y towards +x: 0/90/0, [0/+-45/90]2s."},
      {"Ply thickness",
       "",
       "L",
       "Laminate: one thickness for all plies, or one a ply between commas, "
       "bottom to top [length]."},
      {"Ply materials",
       "",
       "L",
       "Laminate: one material for all plies, or one a ply between commas. "
       "May be left out if the scene has one material."},
      {"Cells per ply",
       "1",
       "L",
       "Laminate: cells through the thickness, one number for all plies or "
       "one a ply."},
      {"Cells across",
       "1",
       "L",
       "Laminate: cells across the width, equally wide, or one number for "
       "each piece between Across breaks."},
      {"Across breaks",
       "",
       "L",
       "Laminate: positions x across the width that end a piece of the mesh, "
       "ascending [length]."},
      {"Material",
       "",
       "DEBW",
       "All shapes but laminate and file: a name of Materials. May be left "
       "out if the scene has one material."},
      {"Fibre angle",
       "0",
       "DEBW",
       "All shapes but laminate and file: degrees, 0 along +y, positive from "
       "+y towards +x."},
      {"Radius", "", "D", "Half disc: of its arc [length]."},
      {"Graded towards",
       "90",
       "D",
       "Half disc: the point of the arc where the cells are finest, degrees "
       "from +x towards +z, 30 to 150; 90 is the top."},
      {"Finest cell",
       "",
       "D",
       "Half disc: width of the cells at that point; an eighth of the radius "
       "by default [length]."},
      {"Sectors",
       "8",
       "D",
       "Half disc: cells in each ring around that point, a multiple of 4."},
      {"Refinements",
       "1",
       "E",
       "Ellipse: how often 12 cells are cut into four each, 0 to 6."},
      {"Wall thickness",
       "",
       "BW",
       "Thin-walled: of all walls; of a box also four between commas, left, "
       "right, bottom, top [length]."},
      {"Web thickness",
       "",
       "W",
       "double-T, T, channel, angle: of the upright wall; Wall thickness by "
       "default [length]."},
      {"Flange thickness",
       "",
       "W",
       "double-T, T, channel, angle: of the level walls, one or bottom, top; "
       "Wall thickness by default [length]."},
      {"Cells per wall", "1", "BW", "Thin-walled: cells through each wall."},
      {"Cells along wall",
       "4",
       "BW",
       "Thin-walled: cells along each wall between its corners."},
      {"File",
       "",
       "F",
       "File: a mesh of quadrilaterals by Gmsh, NAME.msh, relative to the "
       "scene's folder."},
      {"Parts",
       "",
       "F",
       "File: PART: MATERIAL ANGLE between '|', for physical surfaces that "
       "are not called as their material; the angle may be left out."},
      {"Scale",
       "1",
       "F",
       "File: what all coordinates of the mesh are multiplied with."}};



    /// The entries of one section, by name, with the words for messages.
    class Reader
    {
    public:
      Reader(const std::map<std::string, std::string> &entries,
             const std::vector<std::string>           &materials,
             const std::string                        &what)
        : materials(materials)
        , what(what)
        , entries(entries)
      {}

      /// The text of @p entry.
      std::string
      text(const std::string &entry) const
      {
        const auto found = entries.find(entry);
        if (found != entries.end())
          return found->second;
        for (const Entry &known : table)
          if (known.name == entry)
            return known.fallback;
        Assert(false, dealii::ExcMessage("No such entry."));
        return "";
      }

      /// `Section NAME/ENTRY`, and `Section NAME/ENTRY = VALUE`.
      std::string
      place(const std::string &entry) const
      {
        return what + "/" + entry;
      }

      std::string
      given(const std::string &entry) const
      {
        return place(entry) + " = " + text(entry);
      }

      std::vector<double>
      lengths(const std::string &entry) const;

      double
      length(const std::string &entry) const;

      std::vector<unsigned int>
      counts(const std::string &entry, const double least = 1.) const;

      unsigned int
      count(const std::string &entry, const double least = 1.) const;

      /// @p name, which must be a material.
      std::string
      material(const std::string &name, const std::string &entry) const;

      Fabric
      fabric() const;

      const std::vector<std::string> &materials;
      const std::string              &what;

    private:
      const std::map<std::string, std::string> &entries;
    };



    double
    positive(const std::string &text, const std::string &what)
    {
      const double value = to_number(text, what + " = " + text);
      if (!(value > 0.))
        throw InputError(what + " = " + text + ": must be positive.");
      return value;
    }



    std::vector<double>
    Reader::lengths(const std::string &entry) const
    {
      std::vector<double> values;
      for (const std::string &one : split(text(entry), ','))
        values.push_back(positive(one, place(entry)));
      if (values.empty())
        throw InputError(place(entry) + " is missing: give a positive length.");
      return values;
    }



    double
    Reader::length(const std::string &entry) const
    {
      if (text(entry).empty())
        throw InputError(place(entry) + " is missing: give a positive length.");
      return positive(text(entry), place(entry));
    }



    std::vector<unsigned int>
    Reader::counts(const std::string &entry, const double least) const
    {
      std::vector<unsigned int> values;
      for (const double value : to_numbers(text(entry), given(entry)))
        {
          if (!(value >= least && value <= 10000. &&
                value == std::floor(value)))
            throw InputError(given(entry) + ": must be a whole number from " +
                             to_text(least) + " to 10000.");
          values.push_back(static_cast<unsigned int>(value));
        }
      if (values.empty())
        throw InputError(place(entry) + " is missing: give a whole number.");
      return values;
    }



    unsigned int
    Reader::count(const std::string &entry, const double least) const
    {
      const std::vector<unsigned int> values = counts(entry, least);
      if (values.size() != 1)
        throw InputError(given(entry) + ": must be one whole number.");
      return values[0];
    }



    std::string
    Reader::material(const std::string &name, const std::string &entry) const
    {
      if (std::find(materials.begin(), materials.end(), name) ==
          materials.end())
        throw InputError(given(entry) + ": there is no material '" + name +
                         "'. The nearest of Materials is '" +
                         nearest_name(name, materials) + "'.");
      return name;
    }



    Fabric
    Reader::fabric() const
    {
      Fabric result;
      result.material = text("Material");
      if (result.material.empty() && materials.size() == 1)
        result.material = materials[0];
      if (result.material.empty())
        throw InputError(place("Material") + " is missing: name one of " +
                         joined(materials) + ".");
      result.material = material(result.material, "Material");
      result.angle    = to_number(text("Fibre angle"), given("Fibre angle"));
      return result;
    }



    /// @p items, one for each of @p n plies or one for all.
    template <typename T>
    std::vector<T>
    one_a_ply(const std::vector<T> &items,
              const unsigned int    n,
              const std::string    &what)
    {
      if (items.size() == 1)
        return std::vector<T>(n, items[0]);
      if (items.size() != n)
        throw InputError(what + ": there are " + std::to_string(items.size()) +
                         " values for " + std::to_string(n) +
                         " plies. Give one for all plies or one a ply.");
      return items;
    }



    /// The pieces of the mesh across the width.
    void
    read_pieces(Laminate &result, const Reader &reader)
    {
      result.across_breaks =
        to_numbers(reader.text("Across breaks"), reader.given("Across breaks"));
      double previous = 0.;
      for (const double position : result.across_breaks)
        {
          if (!(position > previous && position < result.width))
            throw InputError(reader.given("Across breaks") +
                             ": must ascend between 0 and the width " +
                             to_text(result.width) + ".");
          previous = position;
        }
      result.cells_across  = reader.counts("Cells across");
      const unsigned int n = result.across_breaks.size() + 1;
      if (result.cells_across.size() != n)
        throw InputError(
          reader.given("Cells across") + ": there " +
          (n == 1 ? "is one piece" : "are " + std::to_string(n) + " pieces") +
          " (Across breaks and one), so give as many numbers.");
    }



    Laminate
    read_laminate(const Reader &reader)
    {
      Laminate result;
      result.width  = reader.length("Width");
      result.angles = parse_layup(reader.text("Layup"), reader.place("Layup"));
      const unsigned int n = result.angles.size();
      result.cells_per_ply = one_a_ply(reader.counts("Cells per ply"),
                                       n,
                                       reader.given("Cells per ply"));
      read_pieces(result, reader);
      result.thicknesses = one_a_ply(reader.lengths("Ply thickness"),
                                     n,
                                     reader.given("Ply thickness"));

      std::vector<std::string> names = split(reader.text("Ply materials"), ',');
      if (names.empty() && reader.materials.size() == 1)
        names = reader.materials;
      if (names.empty())
        throw InputError(reader.place("Ply materials") +
                         " is missing: name one of " +
                         joined(reader.materials) + ", or one a ply.");
      for (const std::string &name : names)
        reader.material(name, "Ply materials");
      result.materials = one_a_ply(names, n, reader.given("Ply materials"));
      return result;
    }



    HalfDisc
    read_half_disc(const Reader &reader)
    {
      HalfDisc result;
      result.radius         = reader.length("Radius");
      result.graded_towards = to_number(reader.text("Graded towards"),
                                        reader.given("Graded towards"));
      if (!(result.graded_towards >= 30. && result.graded_towards <= 150.))
        throw InputError(reader.given("Graded towards") +
                         ": must be an angle from 30 to 150 degrees; 90 is the "
                         "top of the arc.");
      result.finest_cell = reader.text("Finest cell").empty() ?
                             result.radius / 8. :
                             reader.length("Finest cell");
      if (!(result.finest_cell <= result.radius &&
            result.finest_cell >= 1e-6 * result.radius))
        throw InputError(reader.given("Finest cell") +
                         ": must lie between a millionth of the radius and "
                         "the radius " +
                         to_text(result.radius) + ".");
      result.sectors = reader.count("Sectors");
      if (result.sectors % 4 != 0)
        throw InputError(reader.given("Sectors") +
                         ": must be a multiple of 4, as 8 or 12.");
      result.fabric = reader.fabric();
      return result;
    }



    Ellipse
    read_ellipse(const Reader &reader)
    {
      Ellipse result;
      result.width       = reader.length("Width");
      result.height      = reader.length("Height");
      result.refinements = reader.count("Refinements", 0.);
      if (result.refinements > 6)
        throw InputError(reader.given("Refinements") +
                         ": must be at most 6, which makes 49152 cells.");
      result.fabric = reader.fabric();
      return result;
    }



    /// Throws InputError unless @p walls, as @p entry gives them, leave some of
    /// @p extension, which is @p named so.
    void
    check_walls_fit(const std::vector<double> &walls,
                    const double               extension,
                    const std::string         &named,
                    const std::string         &entry,
                    const Reader              &reader)
    {
      const double sum = std::accumulate(walls.begin(), walls.end(), 0.);
      if (!(sum < extension))
        throw InputError(reader.given(entry) + ": the walls take " +
                         to_text(sum) + " of the " + named + " " +
                         to_text(extension) +
                         " and must leave some of it. Make the walls thinner "
                         "or the section larger.");
    }



    ThinWalled
    read_walls(const std::string &form, const Reader &reader)
    {
      ThinWalled result;
      result.form             = form;
      result.width            = reader.length("Width");
      result.height           = reader.length("Height");
      result.cells_per_wall   = reader.count("Cells per wall");
      result.cells_along_wall = reader.count("Cells along wall");
      result.fabric           = reader.fabric();

      const auto [n_webs, n_flanges] = count_of_walls(form);
      std::string web_entry = "Wall thickness", flange_entry = web_entry;
      if (form == "box")
        {
          std::vector<double> walls = reader.lengths("Wall thickness");
          if (walls.size() == 1)
            walls.resize(4, walls[0]);
          if (walls.size() != 4)
            throw InputError(reader.given("Wall thickness") +
                             ": give one, or four between commas: left, "
                             "right, bottom, top.");
          result.webs    = {walls[0], walls[1]};
          result.flanges = {walls[2], walls[3]};
        }
      else
        {
          if (!reader.text("Web thickness").empty())
            web_entry = "Web thickness";
          if (!reader.text("Flange thickness").empty())
            flange_entry = "Flange thickness";
          result.webs    = reader.lengths(web_entry);
          result.flanges = reader.lengths(flange_entry);
          if (result.flanges.size() == 1)
            result.flanges.resize(n_flanges, result.flanges[0]);
          for (const auto &[walls, n, entry] :
               {std::make_tuple(&result.webs, n_webs, &web_entry),
                std::make_tuple(&result.flanges, n_flanges, &flange_entry)})
            if (walls->size() != n)
              throw InputError(reader.given(*entry) + ": a section " + form +
                               " takes one" +
                               (n == 2 ? " or two (bottom, top)." : "."));
        }
      check_walls_fit(result.webs, result.width, "width", web_entry, reader);
      check_walls_fit(
        result.flanges, result.height, "height", flange_entry, reader);
      return result;
    }



    SectionFile
    read_file(const std::string &folder, const Reader &reader)
    {
      SectionFile result;
      if (reader.text("File").empty())
        throw InputError(reader.place("File") +
                         " is missing: name a mesh by Gmsh, as in beam.msh.");
      result.path =
        (std::filesystem::path(folder) / reader.text("File")).string();
      result.what  = reader.what;
      result.scale = reader.length("Scale");
      for (const std::string &text : split(reader.text("Parts"), '|'))
        {
          const auto         colon = text.find(':');
          const std::string  name  = trimmed(text.substr(0, colon));
          std::istringstream words(
            colon == std::string::npos ? "" : text.substr(colon + 1));
          std::string material, angle, rest;
          words >> material >> angle >> rest;
          if (name.empty() || material.empty() || !rest.empty())
            throw InputError(reader.given("Parts") + ": '" + text +
                             "' is not PART: MATERIAL ANGLE, as in web: carbon "
                             "45. Between parts stands '|'.");
          const Fabric fabric{reader.material(material, "Parts"),
                              angle.empty() ?
                                0. :
                                to_number(angle, reader.given("Parts"))};
          if (!result.parts.emplace(name, fabric).second)
            throw InputError(reader.given("Parts") + ": '" + name +
                             "' stands there twice.");
        }
      return result;
    }



    /// Throws InputError if one of the entries is given, but none of @p shape,
    /// whose letter is @p letter.
    void
    check_entries(const std::string &shape,
                  const char         letter,
                  const Reader      &reader)
    {
      std::vector<std::string> own;
      for (const Entry &entry : table)
        if (entry.letters.find(letter) != std::string::npos)
          own.push_back(entry.name);
      for (const Entry &entry : table)
        if (entry.letters.find(letter) == std::string::npos &&
            reader.text(entry.name) != entry.fallback)
          throw InputError(reader.given(entry.name) + ": the shape '" + shape +
                           "' has no such entry. It has " + joined(own) + ".");
      if (letter == 'W' && !reader.text("Wall thickness").empty() &&
          !reader.text("Web thickness").empty() &&
          !reader.text("Flange thickness").empty())
        throw InputError(reader.given("Wall thickness") +
                         ": Web thickness and Flange thickness leave nothing "
                         "that uses it. Remove one of the three.");
    }
  } // namespace



  void
  SectionParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Shape",
                      "laminate",
                      Anything(),
                      "The kind of section: " + joined(shapes) +
                        "; each with entries of its own.");
    for (const Entry &entry : table)
      prm.declare_entry(entry.name,
                        entry.fallback,
                        Anything(),
                        entry.documentation);
  }



  SectionParameters
  SectionParameters::parse(const ParameterHandler &prm)
  {
    SectionParameters result;
    result.entries["Shape"] = prm.get("Shape");
    for (const Entry &entry : table)
      result.entries[entry.name] = prm.get(entry.name);
    return result;
  }



  namespace
  {
    constexpr double most_cells = 50000.;



    SectionShape
    read(const std::string &shape,
         const char         letter,
         const std::string &folder,
         const Reader      &reader)
    {
      switch (letter)
        {
          case 'L':
            return read_laminate(reader);
          case 'D':
            return read_half_disc(reader);
          case 'E':
            return read_ellipse(reader);
          case 'F':
            return read_file(folder, reader);
          default:
            return read_walls(shape, reader);
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
        return 4. * walls->cells_per_wall *
               (walls->cells_per_wall + walls->cells_along_wall);
      return 0.;
    }
  } // namespace



  SectionShape
  SectionParameters::shape(const std::vector<std::string> &materials,
                           const std::string              &folder,
                           const std::string              &what) const
  {
    const auto        given = entries.find("Shape");
    const std::string shape =
      given == entries.end() ? shapes[0] : given->second;
    const auto found = std::find(shapes.begin(), shapes.end(), shape);
    if (found == shapes.end())
      throw InputError(what + "/Shape = " + shape +
                       ": there is no such shape. The nearest is '" +
                       nearest_name(shape, shapes) +
                       "'; all of them: " + joined(shapes) + ".");

    const Reader reader(entries, materials, what);
    const char   letter = shape_letters[found - shapes.begin()];
    check_entries(shape, letter, reader);
    const SectionShape result = read(shape, letter, folder, reader);
    // A slip of a digit must not end in a machine out of memory.
    const double cells = estimated_cells(result);
    if (cells > most_cells)
      throw InputError(what + ": the section would have about " +
                       to_text(cells) + " cells, more than " +
                       to_text(most_cells) +
                       ". Use fewer cells, and a higher order instead.");
    return result;
  }
} // namespace lamella
