// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/report/fields_of_nodes.h>
#include <lamella/report/fields_table.h>

namespace lamella
{
  namespace
  {
    struct Node
    {
      dealii::Point<3> position;
      unsigned int     fields;
    };



    /// DoFs of a node follow upon each other, and all are at home there.
    std::vector<Node>
    nodes_of(const Body &body)
    {
      std::vector<Node> nodes;
      for (DofIndex dof = 0; dof < body.n_dofs(); ++dof)
        {
          const dealii::Point<3> position = body.dof(dof).position;
          if (nodes.empty() || position != nodes.back().position)
            nodes.push_back({position, 0});
          ++nodes.back().fields;
        }
      return nodes;
    }
  } // namespace



  std::string
  fields_of_nodes(const Bodies &bodies)
  {
    std::string text = "body,node,s,x,y,z,fields\n";
    for (const auto &body : bodies)
      {
        if (body->is_nodal())
          continue;
        const std::vector<Node> nodes = nodes_of(*body);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const dealii::Point<3> &place = nodes[k].position;
            text += body->name() + "," + std::to_string(k + 1) + "," +
                    csv(place.distance(nodes.front().position));
            for (unsigned int c = 0; c < 3; ++c)
              text += "," + csv(place[c]);
            text += "," + std::to_string(nodes[k].fields) + "\n";
          }
      }
    return text;
  }
} // namespace lamella
