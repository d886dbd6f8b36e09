// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/shape/parameters.h>
#include <lamella/shape/shape_reader.h>

#include <numeric>

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



    const Whole &
    cells()
    {
      static const Whole pattern(1, ShapeReader::max_cells_in_line);
      return pattern;
    }



    /// Extensions of most shapes; the plies of laminates.
    std::vector<Declaration>
    entries_of_extensions_and_plies()
    {
      return {
        {"Width",
         "",
         optional(positive()),
         "LEBWT",
         "Size along x of the section [length]."},
        {"Height",
         "",
         optional(positive()),
         "EBWT",
         "Size along z of the section [length]."},
        {"Layup",
         "0",
         Anything(),
         "L",
         "Laminate: ply angles from bottom to top in degrees, 0 along +y, "
         "positive from +y towards +x, as in 0/90/0 or [0/+-45/90]2s."},
        {"Ply thickness",
         "",
         List(positive()),
         "L",
         "Laminate: one thickness for all plies, or one for each ply from "
         "bottom to top, with commas between [length]."},
        {"Ply materials",
         "",
         Anything(),
         "L",
         "Laminate: one material for all plies, or one for each ply, with "
         "commas between. Not needed if the scene has one material."},
        {"Cells per ply",
         "1",
         List(cells()),
         "LBWT",
         "Laminate: number of cells through a ply, one for all plies or one "
         "for each ply. Walls with a Wall layup: one number for all plies."}};
    }



    /// The pieces of laminates across; what fills the other shapes.
    std::vector<Declaration>
    entries_of_pieces_and_fabric()
    {
      return {{"Cells across",
               "1",
               List(cells()),
               "L",
               "Laminate: number of equal cells across the width, or one "
               "number for each part between Across breaks."},
              {"Across breaks",
               "",
               numbers(),
               "L",
               "Laminate: positions x, ascending, that divide the width into "
               "parts with their own number of cells [length]."},
              {"Material",
               "",
               Anything(),
               "DEBWT",
               "All shapes but laminate and file: a name of Materials. Not "
               "needed if the scene has one material."},
              {"Fiber angle",
               "0",
               number(),
               "DEBW",
               "All shapes but laminate, tube and file: fiber angle about z in "
               "degrees, 0 along +y, towards +x. Not with a Wall layup."}};
    }



    /// Half discs and ellipses.
    std::vector<Declaration>
    entries_of_discs_and_ellipses()
    {
      return {
        {"Radius",
         "",
         optional(positive()),
         "D",
         "Half disc: radius of its arc [length]."},
        {"Graded towards",
         "90",
         number(),
         "D",
         "Half disc: point of the arc where the cells are finest, an angle "
         "from +x towards +z of 30 to 150 degrees; 90 is the top."},
        {"Finest cell",
         "",
         optional(positive()),
         "D",
         "Half disc: cell size there [length]; default an eighth of Radius."},
        {"Sectors",
         "8",
         cells(),
         "D",
         "Half disc: cells in each ring around that point, a multiple of 4."},
        {"Refinements",
         "1",
         Whole(0, ShapeReader::max_ellipse_refinements),
         "E",
         "Ellipse: how often its 12 cells are divided into four, 0 to 6."}};
    }



    /// How the cells of a shape are divided.
    std::vector<Declaration>
    entries_of_divisions()
    {
      return {{"Cells divided",
               "0",
               Whole(0, SectionParameters::max_divisions),
               "LDEBWTF",
               "How often all cells of the section, also those of a file, are "
               "divided into four, 0 to 4."},
              {"Corner layers",
               "0",
               Whole(0, SectionParameters::max_corner_layers),
               "LBWF",
               "Number of layers of cells, 0 to 6, each 0.15 times as thick as "
               "the one before, towards corners with singular stresses: "
               "re-entrant corners, and edges where different plies meet."}};
    }



    /// How thick walls are, and their layups.
    std::vector<Declaration>
    entries_of_walls()
    {
      return {
        {"Wall thickness",
         "",
         List(positive()),
         "BWT",
         "Thin-walled: thickness of all walls; for a box also four values with "
         "commas between: left, right, bottom, top [length]."},
        {"Web thickness",
         "",
         List(positive()),
         "W",
         "double-T, T, channel, angle: thickness of the upright wall [length]. "
         "Default: Wall thickness."},
        {"Flange thickness",
         "",
         List(positive()),
         "W",
         "double-T, T, channel, angle: thickness of the horizontal walls, one "
         "value, or bottom, top [length]. Default: Wall thickness."},
        {"Wall layup",
         "",
         Anything(),
         "BWT",
         "Thin-walled: ply angles in degrees from the inside of each wall to "
         "its outside, in the plane of the wall: 0 along +y, positive to the "
         "right as seen from outside with +y up. One layup for all walls, or "
         "one for each wall with '|' between: webs from left to right, then "
         "flanges from bottom to top. Empty: one material with Fiber angle (in "
         "a tube 0 degrees)."}};
    }



    /// The plies of walls, and their cells.
    std::vector<Declaration>
    entries_of_wall_plies()
    {
      return {
        {"Wall ply thicknesses",
         "",
         Anything(),
         "BWT",
         "Thin-walled: thicknesses of the plies of Wall layup with "
         "commas between, and '|' between walls [length]. Their sum must "
         "be the thickness of the wall. Empty: equal thicknesses."},
        {"Wall ply materials",
         "",
         Anything(),
         "BWT",
         "Thin-walled: materials of these plies, likewise. Empty: Material."},
        {"Cells per wall",
         "1",
         cells(),
         "BW",
         "Thin-walled: number of cells through walls without a Wall layup."},
        {"Cells along wall",
         "4",
         cells(),
         "BW",
         "Thin-walled: number of cells along each wall between its corners."},
        {"Cells around",
         "24",
         cells(),
         "T",
         "Tube: cells around the tube, a multiple of 4, at least 8."}};
    }



    /// Meshes by Gmsh.
    std::vector<Declaration>
    entries_of_files()
    {
      return {
        {"File",
         "",
         Anything(),
         "F",
         "File: quadrilateral mesh by Gmsh, relative to the scene."},
        {"Parts",
         "",
         Anything(),
         "F",
         "File: materials of physical surfaces that have other names, PART: "
         "MATERIAL ANGLE with '|' between; ANGLE may be omitted."},
        {"Ply planes",
         "",
         Anything(),
         "F",
         "File: ply normals of physical surfaces, with '|' between. PART: "
         "DIRECTION is an angle in degrees from +x towards +z, 90 by default; "
         "PART: along CURVES follows the outward normals of physical lines "
         "(with blanks between), PART: against CURVES the inward normals."},
        {"Scale",
         "1",
         positive(),
         "F",
         "File: factor that multiplies all coordinates of the mesh."}};
    }



    /// All entries, in the order in which they are printed.
    const std::vector<Declaration> &
    declarations()
    {
      static const std::vector<Declaration> all = [] {
        std::vector<Declaration> entries;
        for (const auto &some : {entries_of_extensions_and_plies(),
                                 entries_of_pieces_and_fabric(),
                                 entries_of_discs_and_ellipses(),
                                 entries_of_divisions(),
                                 entries_of_walls(),
                                 entries_of_wall_plies(),
                                 entries_of_files()})
          entries.insert(entries.end(), some.begin(), some.end());
        return entries;
      }();
      return all;
    }



    /// Throws InputError if an entry is given that shape @p kind does not have.
    void
    check_entries(const ShapeKind kind, const Entries &in)
    {
      std::vector<std::string> own;
      for (const Declaration &entry : declarations())
        if (entry.is_of(kind))
          own.push_back(entry.name);
      for (const Declaration &entry : declarations())
        if (!entry.is_of(kind) && in[entry.name].text() != entry.fallback)
          in[entry.name].refuse("shape.entry-of-other-shape: the shape '" +
                                  name_of(kind) + "' does not have this entry",
                                "Remove this entry; the shape has " +
                                  joined(own) + ".");
      if (letter_of(kind) == 'W' && !in["Wall thickness"].is_empty() &&
          !in["Web thickness"].is_empty() && !in["Flange thickness"].is_empty())
        in["Wall thickness"].refuse(
          "shape.wall-thickness-unused: Wall thickness has no effect, since "
          "Web thickness and Flange thickness are given",
          "Remove one of these three entries.");
    }



    SectionShape
    read(const ShapeKind    kind,
         const std::string &folder,
         const ShapeReader &reader)
    {
      switch (kind)
        {
          case ShapeKind::laminate:
            return reader.laminate();
          case ShapeKind::half_disc:
            return reader.half_disc();
          case ShapeKind::ellipse:
            return reader.ellipse();
          case ShapeKind::tube:
            return reader.tube();
          case ShapeKind::file:
            return reader.file(folder);
          default:
            return reader.walls(kind);
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
                        "; each has its own entries.");
    for (const Declaration &entry : declarations())
      prm.declare_entry(entry.name,
                        entry.fallback,
                        *entry.pattern,
                        entry.documentation);
  }



  SectionShape
  SectionParameters::parse(const Entries                  &in,
                           const std::vector<std::string> &materials,
                           const std::string              &folder)
  {
    const ShapeKind kind = in["Shape"].choice<ShapeKind>();
    check_entries(kind, in);
    SectionShape result = read(kind, folder, {in, materials});
    const double cells  = estimated_cells(result);
    if (cells > max_section_cells)
      in.refuse("shape.too-many-cells: the section would have about " +
                  to_text(cells) + " cells, more than " +
                  to_text(max_section_cells),
                "Use fewer cells, and a theory of higher order instead.");
    return result;
  }
} // namespace lamella
