// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/material/layup.h>
#include <lamella/shape/shape_reader.h>

#include <filesystem>
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



  namespace
  {
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
  } // namespace



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
} // namespace lamella
