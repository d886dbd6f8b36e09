// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/recover/strength_sweep.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  void
  StrengthParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Criteria",
                      "",
                      Patterns::Anything(),
                      "Failure criteria, with '|' between: " +
                        joined(criterion_names()) +
                        ". Empty: no reserve factors are computed.");
    prm.declare_entry("Bodies",
                      "",
                      Patterns::Anything(),
                      "Bodies to check, between commas. Empty: all.");
    prm.declare_entry("Excluded boxes",
                      "",
                      Patterns::Anything(),
                      "Boxes that are not checked, for stress singularities: "
                      "two opposite corners in scene coordinates, x, y, z: x, "
                      "y, z, with '|' between boxes.");
    prm.declare_entry("Stress",
                      name_of(StressValues::recovered),
                      selection<StressValues>(),
                      "Stresses at the most critical points: recovered, or "
                      "equilibrium (laminates only), as in a Probe.");
  }



  namespace
  {
    std::vector<Criterion>
    parse_criteria(const Entry &entry)
    {
      std::vector<Criterion> criteria;
      for (const std::string &item : entry.items('|'))
        {
          const auto criterion = named<Criterion>(item);
          if (!criterion)
            entry.refuse("recover.unknown-criterion: there is no criterion '" +
                           item + "'",
                         "Check the spelling: the most similar name is '" +
                           nearest_name(item, criterion_names()) +
                           "'; the criteria are " + joined(criterion_names()) +
                           ".");
          if (std::find(criteria.begin(), criteria.end(), *criterion) !=
              criteria.end())
            entry.refuse("recover.named-twice: '" + item +
                         "' is given twice; remove one of the two");
          criteria.push_back(*criterion);
        }
      return criteria;
    }



    std::vector<unsigned int>
    parse_bodies(const Entry &entry, const std::vector<std::string> &bodies)
    {
      std::vector<unsigned int> numbers;
      for (const std::string &item : entry.items())
        {
          Entry(entry.path(), item).among(bodies, "body", "Bodies");
          numbers.push_back(std::find(bodies.begin(), bodies.end(), item) -
                            bodies.begin());
        }
      if (numbers.empty())
        for (unsigned int b = 0; b < bodies.size(); ++b)
          numbers.push_back(b);
      std::sort(numbers.begin(), numbers.end());
      if (const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
          twice != numbers.end())
        entry.refuse("recover.named-twice: '" + bodies[*twice] +
                     "' is given twice; remove one of the two");
      return numbers;
    }



    std::array<Point<3>, 2>
    parse_box(const Entry &entry, const std::string &text)
    {
      const std::vector<std::string> corners = split(text, ':');
      if (corners.size() != 2)
        entry.refuse("recover.not-a-box: '" + text +
                       "' is no box; a box is given by two opposite corners",
                     "Write x, y, z: x, y, z, and '|' between boxes.");
      const std::array<Point<3>, 2> box = {
        {entry.point(corners[0]), entry.point(corners[1])}};
      for (unsigned int c = 0; c < 3; ++c)
        if (box[0][c] > box[1][c])
          entry.refuse("recover.not-a-box: the first corner of box '" + text +
                         "' has the larger coordinate " +
                         std::string(1, "xyz"[c]),
                       "Write the smaller coordinates in the first corner.");
      return box;
    }
  } // namespace



  StrengthParameters
  StrengthParameters::parse(const Entries                  &in,
                            const std::vector<std::string> &bodies)
  {
    StrengthParameters result;
    result.criteria = parse_criteria(in["Criteria"]);
    result.bodies   = parse_bodies(in["Bodies"], bodies);
    for (const std::string &item : in["Excluded boxes"].items('|'))
      result.excluded_boxes.push_back(parse_box(in["Excluded boxes"], item));
    result.stress = in["Stress"].choice<StressValues>();
    if (result.stress != StressValues::recovered &&
        result.stress != StressValues::equilibrium)
      in["Stress"].refuse(
        "recover.stress-not-accurate: reserve factors need more accurate "
        "stresses than Stress = element or nodal gives",
        "Write Stress = recovered or equilibrium.");
    if (result.criteria.empty())
      for (const char *name : {"Bodies", "Excluded boxes"})
        if (!in[name].is_empty())
          in[name].refuse("recover.no-criteria: this entry has no effect, "
                          "since Strength has no Criteria",
                          "Write Criteria, or remove this entry.");
    return result;
  }
} // namespace lamella
