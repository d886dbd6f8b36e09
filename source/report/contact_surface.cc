// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/output_file.h>
#include <lamella/report/vtu.h>

#include <deal.II/base/utilities.h>

#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The cells of the grids of @p surface all of whose corners have points.
    std::vector<ContactSurface::Quadrilateral>
    quadrilaterals_on(const SlaveSurface &surface)
    {
      std::vector<ContactSurface::Quadrilateral> quads;
      for (const SlaveSurface::Facet &facet : surface.facets())
        {
          const unsigned int n = facet.degree_s + 1;
          for (unsigned int j = 0; j < facet.degree_t; ++j)
            for (unsigned int i = 0; i + 1 < n; ++i)
              {
                const std::array<unsigned int, 4> ring{{j * n + i,
                                                        j * n + i + 1,
                                                        (j + 1) * n + i + 1,
                                                        (j + 1) * n + i}};
                ContactSurface::Quadrilateral     quad;
                bool                              is_whole = true;
                for (unsigned int c = 0; c < 4 && is_whole; ++c)
                  {
                    const auto &rows = facet.rows[ring[c]];
                    is_whole = rows.size() == 1 && rows.front().second == 1.;
                    if (is_whole)
                      quad[c] = rows.front().first;
                  }
                if (is_whole)
                  quads.push_back(quad);
              }
        }
      return quads;
    }



    /// The first place of each point, on whatever side of an interface.
    std::vector<Location>
    first_of(const std::vector<std::vector<Location>> &locations)
    {
      std::vector<Location> result;
      for (const auto &all : locations)
        {
          AssertThrow(!all.empty(),
                      ExcMessage("A contact point is not on its body."));
          result.push_back(all.front());
        }
      return result;
    }



    /// Of all points, one after the other.
    using NamedArrays = std::map<std::string, std::vector<double>>;

    void
    append_vector(std::vector<double> &to, const Tensor<1, 3> &v)
    {
      for (unsigned int c = 0; c < 3; ++c)
        to.push_back(v[c]);
    }



    void
    append_scalars(const ContactRow &row, NamedArrays &scalars)
    {
      scalars["area"].push_back(row.point.area);
      scalars["initial_gap"].push_back(row.initial_gap);
      scalars["gap"].push_back(row.gap);
      scalars["force"].push_back(row.force);
      scalars["pressure"].push_back(row.force / row.point.area);
      scalars["status"].push_back(row.touches() ? 1. : 0.);
    }



    /// Appends the friction results of @p row: 0 open, 1 stick, 2 slip; shear
    /// on the second side per area; slip so far; dissipated energy per area.
    void
    append_friction(const ContactRow &row,
                    NamedArrays      &vectors,
                    NamedArrays      &scalars)
    {
      if (!row.friction)
        return;
      const double area = row.point.area;
      append_vector(vectors["shear"], row.friction->shear / area);
      scalars["state"].push_back(!row.touches()      ? 0. :
                                 row.friction->slips ? 2. :
                                                       1.);
      scalars["slid"].push_back(row.friction->length);
      scalars["dissipated"].push_back(row.friction->dissipated / area);
    }



    void
    add_arrays(const NamedArrays &arrays,
               const unsigned int n_components,
               VtuGrid           &grid)
    {
      for (const auto &[name, values] : arrays)
        grid.at_points.push_back({name, n_components, values});
    }
  } // namespace



  ContactSurface::ContactSurface(const ContactInterface &contact,
                                 const Structure        &structure)
    : contact(contact)
    , structure(structure)
  {
    // Slave nodes are known, opposite points by their positions. Lines of a
    // beam touch a roller anywhere.
    const bool is_line =
      contact.discretization == Discretization::line_to_roller;
    const Bodies         &bodies = structure.bodies();
    const Body           &first  = *bodies[contact.first_body];
    std::vector<Location> nodes;
    std::vector<Point<3>> opposite;
    for (const ContactInterface::Point &point : contact.points)
      {
        nodes.push_back(is_line ? first_of(first.locate({point.first}))[0] :
                                  point.node);
        opposite.push_back(contact.points_on_second ? point.first :
                                                      point.second);
      }
    if (contact.points_on_second)
      {
        first_locations  = first_of(first.locate(opposite));
        second_locations = nodes;
      }
    else
      {
        first_locations = nodes;
        if (contact.second_body)
          second_locations =
            first_of(bodies[*contact.second_body]->locate(opposite));
      }

    if (contact.surface != nullptr)
      quads = quadrilaterals_on(*contact.surface);
    std::set<unsigned int> in_quads;
    for (const Quadrilateral &quad : quads)
      in_quads.insert(quad.begin(), quad.end());
    for (unsigned int k = 0; k < contact.points.size(); ++k)
      if (in_quads.count(k) == 0)
        alone.push_back(k);
  }



  VtuGrid
  ContactSurface::grid(const BlockVector             &u,
                       const std::vector<ContactRow> &rows) const
  {
    VtuGrid grid;
    for (const Quadrilateral &quad : quads)
      grid.add_cell(VtuGrid::quadrilateral, quad);
    for (const unsigned int k : alone)
      grid.add_cell(VtuGrid::vertex, std::array<unsigned int, 1>{{k}});

    const Bodies       &bodies = structure.bodies();
    std::vector<double> positions;
    NamedArrays         vectors, scalars;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        const ContactInterface::Point &point     = rows[k].point;
        const auto                     displaced = [&](const unsigned int b,
                                   const Location    &where) {
          return bodies[b]->sample(where, u.block(b)).displacement;
        };
        const Tensor<1, 3> shift =
          displaced(contact.first_body, first_locations[k]);
        const Point<3> position = point.first + shift;
        append_vector(positions, position);
        append_vector(vectors["displacement"], shift);
        append_vector(vectors["normal"], point.normal);
        append_vector(vectors["separation"],
                      contact.second_body ?
                        point.second +
                          displaced(*contact.second_body, second_locations[k]) -
                          position :
                        rows[k].gap * point.normal);
        append_scalars(rows[k], scalars);
        append_friction(rows[k], vectors, scalars);
      }
    grid.points.values = positions;
    add_arrays(vectors, 3, grid);
    add_arrays(scalars, 1, grid);
    return grid;
  }



  std::string
  ContactSurface::write_vtu(const std::string             &directory,
                            const unsigned int             step,
                            const BlockVector             &u,
                            const std::vector<ContactRow> &rows) const
  {
    std::string name = "contact_" + contact.name + "_" +
                       Utilities::int_to_string(step, 4) + ".vtu";
    OutputFile output(directory + "/" + name);
    write_vtu_file(output.stream(), grid(u, rows));
    if (!output.commit())
      throw_cannot_write(directory + "/" + name);
    return name;
  }
} // namespace lamella
