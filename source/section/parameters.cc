// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/material/layup.h>
#include <lamella/section/parameters.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  void
  SectionParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Shape",
                      "laminate",
                      Anything(),
                      "The kind of section: laminate, a rectangle of plies.");
    prm.declare_entry("Width",
                      "",
                      Anything(),
                      "Extension along the section's x [length].");
    prm.declare_entry("Layup",
                      "0",
                      Anything(),
                      "Ply angles from bottom to top in degrees, 0 along +y, "
                      "positive from +y towards +x: 0/90/0, [0/+-45/90]2s.");
    prm.declare_entry("Ply thickness",
                      "",
                      Anything(),
                      "One thickness for all plies, or one a ply between "
                      "commas, bottom to top [length].");
    prm.declare_entry(
      "Ply materials",
      "",
      Anything(),
      "One material for all plies, or one a ply between commas. "
      "May be left out if the scene has one material.");
    prm.declare_entry("Cells per ply",
                      "1",
                      Anything(),
                      "Cells through the thickness of each ply.");
    prm.declare_entry("Cells across",
                      "1",
                      Anything(),
                      "Cells across the width, equally wide.");
  }



  SectionParameters
  SectionParameters::parse(const ParameterHandler &prm)
  {
    return {prm.get("Shape"),
            prm.get("Width"),
            prm.get("Layup"),
            prm.get("Ply thickness"),
            prm.get("Ply materials"),
            prm.get("Cells per ply"),
            prm.get("Cells across")};
  }



  namespace
  {
    double
    positive(const std::string &text, const std::string &what)
    {
      if (text.empty())
        throw InputError(what + " is missing: give a positive length.");
      const double value = to_number(text, what + " = " + text);
      if (!(value > 0.))
        throw InputError(what + " = " + text + ": must be positive.");
      return value;
    }



    unsigned int
    count(const std::string &text, const std::string &what)
    {
      const double value = to_number(text, what + " = " + text);
      if (!(value >= 1. && value <= 10000. && value == std::floor(value)))
        throw InputError(what + " = " + text +
                         ": must be a whole number from 1 to 10000.");
      return static_cast<unsigned int>(value);
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
  } // namespace



  Laminate
  SectionParameters::laminate(const std::vector<std::string> &materials,
                              const std::string              &what) const
  {
    if (shape != "laminate")
      throw InputError(what + "/Shape = " + shape +
                       ": this version has one shape, 'laminate'.");

    Laminate result;
    result.width         = positive(width, what + "/Width");
    result.angles        = parse_layup(layup, what + "/Layup");
    result.cells_per_ply = count(cells_per_ply, what + "/Cells per ply");
    result.cells_across  = count(cells_across, what + "/Cells across");
    const unsigned int n = result.angles.size();

    std::vector<double> thicknesses;
    for (const std::string &text : split(ply_thickness, ','))
      thicknesses.push_back(positive(text, what + "/Ply thickness"));
    if (thicknesses.empty())
      positive("", what + "/Ply thickness");
    result.thicknesses =
      one_a_ply(thicknesses, n, what + "/Ply thickness = " + ply_thickness);

    std::vector<std::string> names = split(ply_materials, ',');
    if (names.empty() && materials.size() == 1)
      names = materials;
    if (names.empty())
      throw InputError(what + "/Ply materials is missing: name one of " +
                       joined(materials) + ", or one a ply.");
    for (const std::string &name : names)
      if (std::find(materials.begin(), materials.end(), name) ==
          materials.end())
        throw InputError(what + "/Ply materials = " + ply_materials +
                         ": there is no material '" + name +
                         "'. The nearest of Materials is '" +
                         nearest_name(name, materials) + "'.");
    result.materials =
      one_a_ply(names, n, what + "/Ply materials = " + ply_materials);
    return result;
  }
} // namespace lamella
