// SPDX-License-Identifier: LGPL-2.1-or-later

// Sections from meshes by Gmsh: what the file says (gmsh_file.h) becomes plies,
// boundaries and cells, and is refused where it makes no section. Cells and
// vertices stand in the order in which GridIn of deal.II has them.

#include <lamella/base/arithmetic.h>
#include <lamella/shape/curve_normals.h>
#include <lamella/shape/gmsh_file.h>
#include <lamella/shape/properties.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A line, triangle, quadrilateral takes some 50 bytes: millions of cells.
    constexpr std::uintmax_t largest_file = 1u << 28;



    /// The text of the file that @p entry names. Throws InputError if it cannot
    /// be had, or not within sensible memory (a device never ends).
    std::string
    text_of(const Entry &entry)
    {
      const std::string &path = entry.text();
      std::error_code    ignored;
      const bool regular = std::filesystem::is_regular_file(path, ignored);
      if (regular && std::filesystem::file_size(path, ignored) > largest_file)
        entry.refuse("shape.file-too-large: the mesh file has more than " +
                       std::to_string(largest_file >> 20) +
                       " MB and so more cells than a section can have",
                     "Use a coarser mesh.");
      std::ifstream      input(path);
      std::ostringstream text;
      if (regular)
        text << input.rdbuf();
      if (!regular || !input || !text)
        entry.refuse("shape.cannot-read: the mesh file cannot be read",
                     "Write its name relative to the folder of the scene, and "
                     "a '#' in the name as \\#.");
      return text.str();
    }



    /// Throws InputError if the nodes do not lie in a plane of constant z: the
    /// section is what the drawing has in x and y.
    void
    check_is_flat(const GmshFile &file, const Entry &entry)
    {
      const auto lower = [](const auto &a, const auto &b) {
        return a.position[2] < b.position[2];
      };
      const auto [lowest, highest] =
        std::minmax_element(file.nodes.begin(), file.nodes.end(), lower);
      double extent = 0.;
      for (const GmshFile::Node &node : file.nodes)
        extent = std::max(
          {extent, std::abs(node.position[0]), std::abs(node.position[1])});
      if (lowest == file.nodes.end() ||
          highest->position[2] - lowest->position[2] <=
            arithmetic::decimal_tolerance * extent)
        return;
      // Of the two the one that is off, if it is one.
      const double first = file.nodes[0].position[2];
      refuse_line(
        entry,
        (highest->position[2] > first ? highest : lowest)->line,
        "shape.mesh-not-plane: the mesh does not lie in one plane (z from " +
          to_text(lowest->position[2]) + " to " +
          to_text(highest->position[2]) + ")",
        "Draw the section in the plane of x and y (z = 0).");
    }



    /// How many there are, and the line of the file that has the first.
    struct ElementsOfAKind
    {
      void
      add(const GmshFile::Element &element)
      {
        first_line = n == 0 ? element.line : first_line;
        ++n;
      }

      unsigned int n = 0, first_line = 0;
    };



    /// Throws InputError for other than first-order quadrilaterals.
    void
    check_elements(const GmshFile &file, const Entry &entry)
    {
      unsigned int    cells = 0;
      ElementsOfAKind triangles, others;
      for (const GmshFile::Element &element : file.elements)
        if (element.type == GmshFile::triangle)
          triangles.add(element);
        else if (element.type == GmshFile::quadrilateral)
          ++cells;
        else if (element.type != GmshFile::line_type &&
                 element.type != GmshFile::point)
          others.add(element);
      if (triangles.n > 0)
        refuse_line(entry,
                    triangles.first_line,
                    "shape.triangular-cells: " + std::to_string(triangles.n) +
                      " cell(s) of the mesh are triangles, first this one",
                    "A section needs quadrilaterals only. In Gmsh, use "
                    "'Recombine Surface {:};' with transfinite surfaces, or "
                    "'Mesh.RecombinationAlgorithm = 3;'.");
      if (others.n > 0)
        refuse_line(
          entry,
          others.first_line,
          "shape.wrong-elements: " + std::to_string(others.n) +
            " element(s) of the mesh are of higher order or not plane",
          "Use first-order quadrilaterals in the plane of x and y "
          "(in Gmsh, Mesh.ElementOrder = 1).");
      if (cells == 0)
        entry.refuse("shape.no-quadrilaterals: the mesh has no quadrilaterals",
                     "Mesh the surfaces with 'gmsh -2' into quadrilaterals "
                     "('Recombine Surface' in the .geo file), and assign each "
                     "surface to a physical surface.");
    }



    /// The physical surfaces of @p mesh.
    std::vector<std::string>
    surfaces_of(const GmshFile &mesh)
    {
      std::vector<std::string> surfaces;
      for (const auto &[key, group] : mesh.names)
        if (key.first == 2)
          surfaces.push_back(group.name);
      return surfaces;
    }



    /// Throws InputError if a name of Parts is no physical surface, or none is.
    void
    check_parts(const GmshFile    &mesh,
                const SectionFile &file,
                const std::string &material,
                const Entry       &entry)
    {
      const std::vector<std::string> surfaces = surfaces_of(mesh);
      if (surfaces.empty())
        entry.refuse(
          "shape.no-named-surface: the mesh has no named physical surface",
          "Name the material of each surface, in Gmsh by 'Physical Surface(\"" +
            material + "\") = {1};'.");
      for (const auto &[part, oriented_material] : file.parts)
        if (std::find(surfaces.begin(), surfaces.end(), part) == surfaces.end())
          throw InputError(
            file.what + "/Parts",
            "",
            "shape.unknown-part: the mesh has no physical surface '" + part +
              "'",
            "The mesh has " + joined(surfaces) + ".");
    }



    /// Fills @p section's plies. Returns tag of a physical surface -> ply.
    std::map<int, unsigned int>
    make_plies(const GmshFile    &mesh,
               const SectionFile &file,
               const Materials   &materials,
               const Entry       &entry,
               SectionMesh       &section)
    {
      std::vector<std::string> known;
      for (const auto &[name, material] : materials)
        known.push_back(name);
      check_parts(mesh, file, known[0], entry);
      std::map<int, unsigned int> ply_of_tag;
      for (const auto &[key, group] : mesh.names)
        if (key.first == 2)
          {
            const std::string     &name = group.name;
            const auto             part = file.parts.find(name);
            const OrientedMaterial oriented_material =
              part == file.parts.end() ? OrientedMaterial{name, 0.} :
                                         part->second;
            if (materials.count(oriented_material.material) == 0)
              refuse_line(
                entry,
                group.line,
                "shape.part-without-material: the physical surface '" + name +
                  "' is no material; the most similar name in Materials is '" +
                  nearest_name(name, known) + "'",
                "Rename the surface, or write its material in Parts: '" + name +
                  ": " + known[0] + "'.");
            ply_of_tag[key.second] = section.plies.size();
            section.plies.push_back({oriented_material.material,
                                     oriented_material.angle,
                                     0.,
                                     0.,
                                     materials.at(oriented_material.material)});
          }
      return ply_of_tag;
    }



    /// Numbers the boundary ids of @p section anew, tag -> id, and names them.
    std::map<int, types::boundary_id>
    make_boundaries(const GmshFile &mesh,
                    const Entry    &entry,
                    SectionMesh    &section)
    {
      static const std::regex        form("[A-Za-z][A-Za-z0-9_-]*");
      const std::vector<std::string> reserved{
        "start", "end", "ends", "all", "body", "point", "line", "other"};
      section.boundaries = {{0, "other"}};
      std::map<int, types::boundary_id>         id_of_tag;
      std::map<std::string, types::boundary_id> id_of_name;
      for (const auto &[key, group] : mesh.names)
        if (key.first == 1)
          {
            const std::string &name = group.name;
            if (std::find(reserved.begin(), reserved.end(), name) !=
                reserved.end())
              refuse_line(entry,
                          group.line,
                          "shape.reserved-name: the physical line '" + name +
                            "' has a name reserved for sides of a body (" +
                            joined(reserved) + ")",
                          "Rename the physical line.");
            if (!std::regex_match(name, form))
              refuse_line(entry,
                          group.line,
                          "shape.invalid-name: '" + name +
                            "' is no valid name of a physical line",
                          "Write a letter, then letters, digits, '_', '-'.");
            // Groups of one name are one boundary.
            const types::boundary_id id =
              id_of_name.insert({name, section.boundaries.size()})
                .first->second;
            section.boundaries[id] = name;
            id_of_tag[key.second]  = id;
          }
      return id_of_tag;
    }



    /// The cell of @p element. Throws InputError without a physical surface.
    CellData<2>
    cell_of(const GmshFile::Element           &element,
            const std::vector<Point<2>>       &vertices,
            const std::map<int, unsigned int> &ply_of_tag,
            const Entry                       &entry)
    {
      // Around a cell in the file, rows from below in deal.II.
      constexpr std::array<unsigned int, 4> place_in_cell{{0, 1, 3, 2}};
      CellData<2>                           cell;
      Tensor<1, 2>                          center;
      for (unsigned int i = 0; i < 4; ++i)
        {
          cell.vertices[place_in_cell[i]] = element.nodes[i];
          center += vertices[element.nodes[i]] / 4.;
        }
      const auto ply = ply_of_tag.find(element.group);
      if (ply == ply_of_tag.end())
        refuse_line(
          entry,
          element.line,
          "shape.cell-without-material: the cell at " +
            to_text(Point<2>(center)) +
            " is in no named physical surface, so it has no material");
      cell.material_id = ply->second;
      return cell;
    }



    /// @p group_of_tag: tag of a physical surface (line) -> ply (boundary).
    GmshMesh
    make_mesh(const GmshFile                          &file,
              const std::map<int, unsigned int>       &ply_of_tag,
              const std::map<int, types::boundary_id> &id_of_tag,
              const Entry                             &entry)
    {
      GmshMesh mesh;
      for (const GmshFile::Node &node : file.nodes)
        mesh.vertices.emplace_back(node.position[0], node.position[1]);
      for (const GmshFile::Element &element : file.elements)
        if (element.type == GmshFile::quadrilateral)
          {
            mesh.cells.push_back(
              cell_of(element, mesh.vertices, ply_of_tag, entry));
            mesh.elements.push_back(&element);
          }
        else if (element.type == GmshFile::line_type)
          {
            CellData<1> line;
            line.vertices[0] = element.nodes[0];
            line.vertices[1] = element.nodes[1];
            const auto id    = id_of_tag.find(element.group);
            line.boundary_id = id == id_of_tag.end() ? 0 : id->second;
            mesh.rest.boundary_lines.push_back(line);
            mesh.lines.push_back(&element);
          }
      // As GridIn does.
      GridTools::delete_unused_vertices(mesh.vertices, mesh.cells, mesh.rest);
      // Its invert_cells_with_negative_measure() calls a cell that has no area
      // but for rounding an error of its own; here the next check finds it.
      for (CellData<2> &cell : mesh.cells)
        if (GridTools::cell_measure<2>(mesh.vertices, cell.vertices) < 0.)
          std::swap(cell.vertices[1], cell.vertices[2]);
      return mesh;
    }



    /// Throws InputError if @p file's scale makes lengths out of range.
    void
    check_scale(const GmshMesh &mesh, const SectionFile &file)
    {
      double extent = 0.;
      for (const Point<2> &x : mesh.vertices)
        extent = std::max({extent, std::abs(x[0]), std::abs(x[1])});
      if (!(extent * file.scale < largest_number &&
            extent * file.scale > smallest_number))
        throw InputError(
          file.what + "/Scale",
          to_text(file.scale),
          "shape.scale-out-of-range: with this scale the section would be " +
            to_text(extent * file.scale) + " wide or high",
          "Scale multiplies the coordinates of the mesh: write 0.001 for a "
          "mesh in mm and a scene in m.");
    }



    /// The plane that @p part says, of @p section; @p where is the entry.
    PlyPlane
    plane_of(const PartPlane   &part,
             const SectionMesh &section,
             const std::string &where)
    {
      // Right angles exactly, as of ply_axes().
      const Triad rotation = ply_axes(part.direction);
      PlyPlane    plane;
      plane.normal = Point<2>(rotation[0][1], rotation[0][0]);
      if (part.curve.empty())
        return plane;
      std::vector<std::string> curves;
      for (const auto &[id, name] : section.boundaries)
        curves.push_back(name);
      const std::vector<std::string> followed = split(part.curve, ' ');
      for (const std::string &curve : followed)
        if (std::find(curves.begin(), curves.end(), curve) == curves.end())
          throw InputError(
            where,
            "",
            "shape.unknown-curve: the mesh has no physical line '" + curve +
              "' on its boundary",
            "The mesh has " + joined(curves) + ".");
      const auto   normals = std::make_shared<CurveNormals>(section, followed);
      const double sign    = part.outwards ? 1. : -1.;
      plane.normal_at      = [normals, sign](const Point<2> &x) {
        return sign * normals->at(x);
      };
      return plane;
    }



    /// Sets planes of the plies of @p section by @p file's physical surfaces.
    void
    set_ply_planes(const GmshFile                    &mesh,
                   const SectionFile                 &file,
                   const std::map<int, unsigned int> &ply_of_tag,
                   SectionMesh                       &section)
    {
      const std::string              where = file.what + "/Ply planes";
      const std::vector<std::string> parts = surfaces_of(mesh);
      for (const auto &[part, direction] : file.planes)
        {
          if (std::find(parts.begin(), parts.end(), part) == parts.end())
            throw InputError(
              where,
              "",
              "shape.unknown-part: the mesh has no physical surface '" + part +
                "'",
              "The mesh has " + joined(parts) + ".");
          const PlyPlane plane = plane_of(direction, section, where);
          for (const auto &[key, group] : mesh.names)
            if (key.first == 2 && group.name == part)
              section.plies[ply_of_tag.at(key.second)].plane = plane;
        }
    }
  } // namespace



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionFile &file, const Materials &materials)
  {
    const Entry    entry(file.what + "/File", file.path);
    const GmshFile read = read_gmsh_file(text_of(entry), entry);
    check_is_flat(read, entry);
    check_elements(read, entry);
    auto       section = std::make_shared<SectionMesh>();
    const auto plies   = make_plies(read, file, materials, entry, *section);
    const auto names   = make_boundaries(read, entry, *section);
    GmshMesh   parts   = make_mesh(read, plies, names, entry);
    check_cells_are_convex(parts, entry);
    keep_boundary_lines(parts, entry);
    check_angles(parts, entry);
    GridTools::consistently_order_cells(parts.cells);
    Triangulation<2> &mesh = section->mesh;
    mesh.create_triangulation(parts.vertices, parts.cells, parts.rest);
    check_scale(parts, file);
    GridTools::scale(file.scale, mesh);

    for (const auto &cell : mesh.active_cell_iterators())
      {
        Ply       &ply   = section->plies[cell->material_id()];
        const bool first = ply.bottom == ply.top;
        for (const unsigned int v : cell->vertex_indices())
          {
            const double z = cell->vertex(v)[1];
            ply.bottom     = first && v == 0 ? z : std::min(ply.bottom, z);
            ply.top        = first && v == 0 ? z : std::max(ply.top, z);
          }
      }
    const auto all_names = std::move(section->boundaries);
    section->boundaries.clear();
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        section->boundaries[face->boundary_id()] =
          all_names.at(face->boundary_id());
    set_ply_planes(read, file, plies, *section);
    check_section_mesh(*section, entry);
    return section;
  }
} // namespace lamella
