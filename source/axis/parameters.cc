// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/parameters.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  void
  AxisParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Axis element",
                      "B4",
                      Anything(),
                      "Beam element: B2, B3 or B4 with 2, 3 or 4 nodes. B4 is "
                      "exact for bending under forces at its ends.");
    prm.declare_entry("Axis elements",
                      "10",
                      Anything(),
                      "Number of equal elements along the axis, or one number "
                      "for each piece between Axis breaks.");
    prm.declare_entry(
      "Axis breaks",
      "",
      Anything(),
      "Distances from the start of the axis that end a piece of "
      "the mesh, ascending [length].");
    prm.declare_entry("Axis nodes",
                      "Gauss-Lobatto",
                      Anything(),
                      "Gauss-Lobatto or equidistant nodes of a B4: the same "
                      "displacements, other places of node-to-node contact.");
    prm.declare_entry("Shear strains",
                      "auto",
                      Anything(),
                      "assumed: transverse shear strains are interpolated one "
                      "degree lower along the axis (MITC), against shear "
                      "locking; full: as the displacements give them; auto: "
                      "assumed for B2 and B3, full for B4.");
  }



  AxisParameters
  AxisParameters::parse(const ParameterHandler &prm)
  {
    return {prm.get("Axis element"),
            prm.get("Axis elements"),
            prm.get("Axis breaks"),
            prm.get("Axis nodes"),
            prm.get("Shear strains")};
  }



  AxisMesh
  AxisParameters::mesh(const double length, const std::string &what) const
  {
    AxisMesh mesh;
    mesh.length = length;
    if (element != "B2" && element != "B3" && element != "B4")
      throw InputError(what + "/Axis element = " + element +
                       ": must be B2, B3 or B4.");
    mesh.degree = element[1] - '1';
    if (nodes != "Gauss-Lobatto" && nodes != "equidistant")
      throw InputError(what + "/Axis nodes = " + nodes +
                       ": must be Gauss-Lobatto or equidistant.");
    mesh.equidistant_nodes = nodes == "equidistant";
    if (shear_strains != "auto" && shear_strains != "assumed" &&
        shear_strains != "full")
      throw InputError(what + "/Shear strains = " + shear_strains +
                       ": must be auto, assumed or full.");
    mesh.assumed_shear = shear_strains == "assumed" ||
                         (shear_strains == "auto" && mesh.degree < 3);

    mesh.breaks     = to_numbers(breaks, what + "/Axis breaks");
    double previous = 0.;
    for (const double position : mesh.breaks)
      {
        if (!(position > previous && position < length))
          throw InputError(what + "/Axis breaks = " + breaks +
                           ": must ascend between 0 and the length " +
                           to_text(length) + ".");
        previous = position;
      }

    const std::string entry = what + "/Axis elements = " + elements;
    for (const double n : to_numbers(elements, entry))
      {
        if (!(n >= 1. && n <= 1e5 && n == std::floor(n)))
          throw InputError(entry + ": must be whole numbers from 1 to 100000.");
        mesh.elements.push_back(static_cast<unsigned int>(n));
      }
    if (mesh.elements.size() != mesh.breaks.size() + 1)
      throw InputError(entry + ": there are " +
                       std::to_string(mesh.breaks.size() + 1) +
                       " pieces (Axis breaks and one) and " +
                       std::to_string(mesh.elements.size()) +
                       (mesh.elements.size() == 1 ? " number" : " numbers") +
                       ". Give a number for each piece.");
    return mesh;
  }
} // namespace lamella
