// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/export/calculix_element.h>

#include <array>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  CalculixElement::CalculixElement(const std::string &name)
    : element_name(name)
  {
    const std::vector<std::string> names{"C3D20R", "C3D8I", "C3D8R"};
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(
        "export.unknown-element: there is no such element. Choose one of " +
        joined(names) + "; the most similar is " + nearest_name(name, names) +
        ".")
        .at("--element " + name + ": ");
    // Corners around the bottom, then around the top.
    for (const double z : {0., 1.})
      for (const auto &[x, y] : std::array<std::array<double, 2>, 4>{
             {{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}}})
        unit_nodes.emplace_back(x, y, z);
    if (name != "C3D20R")
      return;
    // The middles of the edges: around the bottom, the top, then upright.
    const auto add_middle = [this](const unsigned int a, const unsigned int b) {
      unit_nodes.push_back(unit_nodes[a] +
                           0.5 * (unit_nodes[b] - unit_nodes[a]));
    };
    for (const unsigned int first : {0, 4})
      for (unsigned int v = 0; v < 4; ++v)
        add_middle(first + v, first + (v + 1) % 4);
    for (unsigned int v = 0; v < 4; ++v)
      add_middle(v, v + 4);
  }



  std::vector<double>
  CalculixElement::shape_values(const Point<3> &unit) const
  {
    std::vector<double> values;
    for (const Point<3> &node : unit_nodes)
      {
        double product = 1., sum = 0.;
        bool   corner = true;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double r = 2. * unit[d] - 1., at = 2. * node[d] - 1.;
            product *= at == 0. ? 1. - r * r : 0.5 * (1. + at * r);
            sum += at * r;
            corner = corner && at != 0.;
          }
        // A corner's function of 20 nodes vanishes at the middles of its edges.
        values.push_back(product * (degree() == 2 && corner ? sum - 2. : 1.));
      }
    return values;
  }



  std::vector<unsigned int>
  CalculixElement::face_nodes(const unsigned int face) const
  {
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      if (unit_nodes[i][face / 2] == face % 2)
        nodes.push_back(i);
    return nodes;
  }



  unsigned int
  calculix_face(const unsigned int face)
  {
    // x = 0, x = 1, y = 0, y = 1, z = 0, z = 1 by their corners: 4-8-5-1,
    // 2-6-7-3, 1-5-6-2, 3-7-8-4, 1-2-3-4, 5-8-7-6.
    constexpr std::array<unsigned int, 6> number{{6, 4, 3, 5, 1, 2}};
    return number[face];
  }
} // namespace lamella
