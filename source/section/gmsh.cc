// SPDX-License-Identifier: LGPL-2.1-or-later

// Sections from meshes by Gmsh. GridIn reads the mesh; what it does not tell
// (names), or tells in words that are not the user's, is looked for in the text
// of the file first.

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/section/properties.h>
#include <lamella/section/shapes.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// What the text of a .msh file tells.
    struct Outline
    {
      /// (dimension, tag) -> name of a physical group.
      std::map<std::pair<int, int>, std::string> names;
      /// Type of element, as Gmsh counts them -> how many.
      std::map<int, unsigned int> elements;
    };

    constexpr int line = 1, triangle = 2, quadrilateral = 3, point = 15;



    /// The lines of section $@p name of @p text, without its first and last;
    /// none if it is not there or not closed.
    std::vector<std::string>
    lines_of(const std::string &text, const std::string &name)
    {
      const std::string open = "$" + name, close = "$End" + name;
      auto              begin = text.find(open);
      const auto        end   = text.find(close);
      if (begin == std::string::npos || end == std::string::npos)
        return {};
      begin += open.size();
      std::istringstream       part(text.substr(begin, end - begin));
      std::vector<std::string> lines;
      std::string              one;
      while (std::getline(part, one))
        if (!trimmed(one).empty())
          lines.push_back(one);
      return lines;
    }



    /// Reads the elements' types, @p by_block from version 4 on, where a block
    /// `dimension tag type count` heads so many lines.
    std::map<int, unsigned int>
    count_elements(const std::vector<std::string> &lines, const bool by_block)
    {
      std::map<int, unsigned int> count;
      for (unsigned int i = 1; i < lines.size(); ++i)
        {
          std::istringstream words(lines[i]);
          int                a = 0, b = 0, type = 0;
          unsigned int       n = 1;
          if (by_block)
            words >> a >> b >> type >> n;
          else
            words >> a >> type;
          count[type] += n;
          // A block cannot go on beyond the end, whatever its head says.
          i += by_block ? std::min<std::size_t>(n, lines.size()) : 0;
        }
      return count;
    }



    /// Throws InputError if the coordinates in @p nodes do not lie in a plane
    /// of constant z: the section is what the drawing has in x and y.
    void
    check_is_flat(const std::vector<std::string> &nodes,
                  const double                    version,
                  const std::string              &what)
    {
      // A line of coordinates has a number more in format 2. (In 4.0 it cannot
      // be told from the head of a block; nothing writes that any more.)
      const unsigned int n = version < 3. ? 4 : 3;
      if (version >= 3. && version < 4.1)
        return;
      double lowest = std::numeric_limits<double>::max(), highest = -lowest,
             extent = 0.;
      for (const std::string &line : nodes)
        {
          std::istringstream        words(line);
          const std::vector<double> numbers{std::istream_iterator<double>(
                                              words),
                                            std::istream_iterator<double>()};
          if (numbers.size() != n)
            continue;
          lowest  = std::min(lowest, numbers[n - 1]);
          highest = std::max(highest, numbers[n - 1]);
          extent  = std::max(
            {extent, std::abs(numbers[n - 3]), std::abs(numbers[n - 2])});
        }
      if (highest - lowest > 1e-6 * extent)
        throw InputError(what +
                         ": the mesh does not lie in one plane (z from " +
                         to_text(lowest) + " to " + to_text(highest) +
                         "). Draw the section in x and y.");
    }


    /// @p what names the entry and the file.
    Outline
    scan(const std::string &text, const std::string &what)
    {
      const std::vector<std::string> format = lines_of(text, "MeshFormat");
      if (format.empty())
        throw InputError(what + ": this is not a mesh by Gmsh. Write one with "
                                "'gmsh -2 NAME.geo -o NAME.msh'.");
      std::istringstream words(format[0]);
      double             version = 0.;
      int                binary  = 0;
      words >> version >> binary;
      if (!(version >= 2. && version < 4.2) || binary != 0)
        throw InputError(
          what + ": the mesh is " +
          (binary != 0 ? "binary" : "of version " + to_text(version)) +
          ". Write it with 'gmsh -2 NAME.geo -format msh41 -o "
          "NAME.msh', as text of version 4.1 (or msh22).");

      check_is_flat(lines_of(text, "Nodes"), version, what);
      Outline outline;
      for (const std::string &name : lines_of(text, "PhysicalNames"))
        {
          static const std::regex form(
            R"re(\s*(\d)\s+(\d{1,9})\s+"(.*)"\s*)re");
          std::smatch match;
          if (std::regex_match(name, match, form))
            outline.names[{std::stoi(match[1]), std::stoi(match[2])}] =
              match[3];
        }
      outline.elements =
        count_elements(lines_of(text, "Elements"), version >= 4.);
      return outline;
    }



    /// Throws InputError unless the elements are quadrilaterals of first order,
    /// their lines and points.
    void
    check_elements(const Outline &outline, const std::string &what)
    {
      unsigned int others = 0;
      for (const auto &[type, n] : outline.elements)
        if (type == triangle)
          throw InputError(
            what + ": " + std::to_string(n) +
            (n == 1 ? " cell is a triangle" : " cells are triangles") +
            ". A section is made of quadrilaterals: in Gmsh, 'Recombine "
            "Surface {:};' with transfinite surfaces, or "
            "'Mesh.RecombinationAlgorithm = 3;'.");
        else if (type != line && type != quadrilateral && type != point)
          others += n;
      if (others > 0)
        throw InputError(
          what + ": of the elements " + std::to_string(others) +
          (others == 1 ? " is" : " are") +
          " of higher order or not in the plane. Use first-order quadrilaterals: Mesh.ElementOrder = "
          "1.");
      if (outline.elements.count(quadrilateral) == 0)
        throw InputError(what +
                         ": the mesh has no quadrilaterals, or the file is cut "
                         "off. Make it with 'gmsh -2', and put surfaces into "
                         "its physical surfaces.");
    }



    /// What the physical surfaces are made of, tag -> number in @p section's
    /// plies, which it fills.
    std::map<int, unsigned int>
    make_plies(const Outline                                     &outline,
               const SectionFile                                 &file,
               const std::map<std::string, EngineeringConstants> &constants,
               const std::string                                 &what,
               SectionMesh                                       &section)
    {
      std::vector<std::string> surfaces, materials;
      for (const auto &[key, name] : outline.names)
        if (key.first == 2)
          surfaces.push_back(name);
      for (const auto &[name, values] : constants)
        materials.push_back(name);
      if (surfaces.empty())
        throw InputError(what +
                         ": the mesh has no named physical surface. In Gmsh, "
                         "'Physical Surface(\"" +
                         materials[0] + "\") = {1};' says of what it is made.");
      for (const auto &[part, fabric] : file.parts)
        if (std::find(surfaces.begin(), surfaces.end(), part) == surfaces.end())
          throw InputError(file.what +
                           "/Parts: the mesh has no physical "
                           "surface '" +
                           part + "'. It has " + joined(surfaces) + ".");

      std::map<int, unsigned int> ply_of_tag;
      for (const auto &[key, name] : outline.names)
        if (key.first == 2)
          {
            const auto   part = file.parts.find(name);
            const Fabric fabric =
              part == file.parts.end() ? Fabric{name, 0.} : part->second;
            if (constants.count(fabric.material) == 0)
              throw InputError(
                what + ": the physical surface '" + name +
                "' is no material; the nearest of Materials is '" +
                nearest_name(name, materials) +
                "'. Rename it, or say in Parts what it is made of: '" + name +
                ": " + materials[0] + "'.");
            ply_of_tag[key.second] = section.plies.size();
            section.plies.push_back({fabric.material,
                                     fabric.angle,
                                     0.,
                                     0.,
                                     constants.at(fabric.material)});
          }
      return ply_of_tag;
    }



    /// Numbers the boundary ids of @p section anew, tag -> id, and names them.
    std::map<int, types::boundary_id>
    make_boundaries(const Outline     &outline,
                    const std::string &what,
                    SectionMesh       &section)
    {
      static const std::regex        form("[A-Za-z][A-Za-z0-9_-]*");
      const std::vector<std::string> reserved{
        "start", "end", "ends", "all", "body", "point", "line", "other"};
      section.boundaries = {{0, "other"}};
      std::map<int, types::boundary_id> id_of_tag;
      for (const auto &[key, name] : outline.names)
        if (key.first == 1)
          {
            if (std::find(reserved.begin(), reserved.end(), name) !=
                reserved.end())
              throw InputError(what + ": the physical line '" + name +
                               "' has a name that means something else (" +
                               joined(reserved) + "). Rename it.");
            if (!std::regex_match(name, form))
              throw InputError(what + ": '" + name +
                               "', a physical line, is not a name. Names begin "
                               "with a letter and go on with letters, digits, "
                               "'_' and '-'.");
            const types::boundary_id id = section.boundaries.size();
            section.boundaries[id]      = name;
            id_of_tag[key.second]       = id;
          }
      return id_of_tag;
    }



    /// What went wrong in GridIn, in one line.
    std::string
    told_by(const ExceptionBase &error)
    {
      std::ostringstream information;
      error.print_info(information);
      std::istringstream words(information.str());
      std::string        word, line;
      while (words >> word)
        line += (line.empty() ? "" : " ") + word;
      return line;
    }



    void
    read_mesh(const std::string &text,
              const std::string &what,
              SectionMesh       &section)
    {
      std::string told;
      try
        {
          std::istringstream input(text);
          GridIn<2>(section.mesh).read_msh(input);
          return;
        }
      catch (const ExceptionBase &error)
        {
          told = told_by(error);
        }
      catch (const std::exception &error)
        {
          told = error.what();
        }

      static const std::regex ends(R"(\(([^ ()]+) ([^ ()]+)\))");
      std::smatch             from, to;
      if (told.find("internal face") != std::string::npos &&
          std::regex_search(told, from, ends))
        {
          const std::string rest = from.suffix();
          std::regex_search(rest, to, ends);
          throw InputError(
            what + ": a line of the mesh runs inside the section, from (" +
            from.str(1) + ", " + from.str(2) + ") to (" + to.str(1) + ", " +
            to.str(2) +
            "). Only lines of its boundary can be physical ones: "
            "remove this one, or Mesh.SaveAll.");
        }
      throw InputError(what + ": the mesh cannot be read (" + told +
                       "). Write it anew with 'gmsh -2 NAME.geo -format msh41 "
                       "-o NAME.msh'.");
    }



    /// @p text with positive tags of physical groups: groups that take curves
    /// or surfaces backwards, as {-1}, have negative ones in version 4.1, and
    /// GridIn takes tags as ids. A line of $Entities is tag, six numbers of a
    /// box, count of groups, their tags, and more.
    std::string
    forwards(const std::string &text)
    {
      const std::string open = "$Entities";
      const auto begin = text.find(open), end = text.find("$EndEntities");
      if (begin == std::string::npos || end == std::string::npos)
        return text;
      std::string        entities;
      std::istringstream lines(text.substr(begin, end - begin));
      std::string        one;
      while (std::getline(lines, one))
        {
          std::istringstream       words(one);
          std::vector<std::string> word;
          for (std::string w; words >> w;)
            word.push_back(w);
          // Those of points are shorter, or have a count of 0 there.
          const unsigned int n =
            word.size() > 8 ? std::strtoul(word[7].c_str(), nullptr, 10) : 0;
          for (unsigned int k = 8; k < word.size() && k < 8 + n; ++k)
            word[k].erase(0, word[k][0] == '-' ? 1 : 0);
          entities += joined(word, " ") + "\n";
        }
      return text.substr(0, begin) + entities + text.substr(end);
    }
  } // namespace



  std::shared_ptr<const SectionMesh>
  make_section_mesh(
    const SectionFile                                 &file,
    const std::map<std::string, EngineeringConstants> &constants)
  {
    const std::string  what = file.what + "/File = " + file.path;
    std::ifstream      input(file.path);
    std::ostringstream text;
    text << input.rdbuf();
    if (!input || std::filesystem::is_directory(file.path))
      throw InputError(what +
                       ": cannot read this file. Its name is relative to the "
                       "scene's folder.");

    const Outline outline = scan(text.str(), what);
    check_elements(outline, what);
    auto       section = std::make_shared<SectionMesh>();
    const auto plies   = make_plies(outline, file, constants, what, *section);
    const auto names   = make_boundaries(outline, what, *section);
    Triangulation<2> &mesh = section->mesh;
    read_mesh(forwards(text.str()), what, *section);
    GridTools::scale(file.scale, mesh);

    for (const auto &cell : mesh.active_cell_iterators())
      {
        const auto found = plies.find(cell->material_id());
        if (found == plies.end())
          throw InputError(what + ": the cell at (" +
                           to_text(cell->center()[0]) + ", " +
                           to_text(cell->center()[1]) +
                           ") is in no named physical surface, so nothing "
                           "says of what it is made.");
        Ply       &ply   = section->plies[found->second];
        const bool first = ply.bottom == ply.top;
        for (const unsigned int v : cell->vertex_indices())
          {
            const double z = cell->vertex(v)[1];
            ply.bottom     = first && v == 0 ? z : std::min(ply.bottom, z);
            ply.top        = first && v == 0 ? z : std::max(ply.top, z);
          }
        cell->set_material_id(found->second);
      }
    const auto all_names = std::move(section->boundaries);
    section->boundaries.clear();
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        {
          const auto               found = names.find(face->boundary_id());
          const types::boundary_id id =
            found == names.end() ? 0 : found->second;
          face->set_boundary_id(id);
          section->boundaries[id] = all_names.at(id);
        }
    check_section_mesh(*section, what);
    return section;
  }
} // namespace lamella
