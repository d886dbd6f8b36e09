// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/body/surface_topology.h>
#include <lamella/report/contact_surface.h>
#include <lamella/report/fields_table.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Of the points in @p at_node the one whose normal is most like the
    /// @p normal of a facet; at an edge each side has its own.
    unsigned int
    point_on(const std::vector<unsigned int> &at_node,
             const Tensor<1, 3>              &normal,
             const ContactInterface          &contact)
    {
      const auto along = [&](const unsigned int k) {
        return std::abs(contact.points[k].normal * normal);
      };
      return *std::max_element(at_node.begin(),
                               at_node.end(),
                               [&](const unsigned int a, const unsigned int b) {
                                 return along(a) < along(b);
                               });
    }



    /// The cells of the grids of @p topology that have points of @p contact at
    /// all four corners; @p points are their numbers by node.
    std::vector<ContactSurface::Quadrilateral>
    quadrilaterals_between(const SurfaceTopology &topology,
                           const std::vector<std::vector<unsigned int>> &points,
                           const Body                                   &body,
                           const ContactInterface &contact)
    {
      std::vector<ContactSurface::Quadrilateral> quads;
      for (const SurfaceTopology::Facet &facet : topology.facets)
        {
          const Tensor<1, 3> normal =
            body.surface_point(facet.side, {0.5, 0.5}).normal;
          const unsigned int n = facet.side.degree_s + 1;
          for (unsigned int j = 0; j < facet.side.degree_t; ++j)
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
                    const auto &there = points[facet.grid[ring[c]]];
                    is_whole          = !there.empty();
                    if (is_whole)
                      quad[c] = point_on(there, normal, contact);
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
  } // namespace



  ContactSurface::ContactSurface(const ContactInterface &contact,
                                 const Structure        &structure)
    : contact(contact)
    , structure(structure)
  {
    // The nodes of the side that carries them are known, the places opposite
    // by their positions.
    std::vector<Location> nodes;
    std::vector<Point<3>> opposite;
    for (const ContactInterface::Point &point : contact.points)
      {
        nodes.push_back(point.node);
        opposite.push_back(contact.points_on_second ? point.first :
                                                      point.second);
      }
    const Bodies &bodies = structure.bodies();
    if (contact.points_on_second)
      {
        first_places  = first_of(bodies[contact.first_body]->locate(opposite));
        second_places = nodes;
      }
    else
      {
        first_places = nodes;
        if (contact.second_body)
          second_places =
            first_of(bodies[*contact.second_body]->locate(opposite));
      }

    const Body &carrying =
      *bodies[contact.points_on_second ? *contact.second_body :
                                         contact.first_body];
    const SurfaceTopology topology =
      carrying.surface_topology(contact.carrying_surface);
    std::vector<std::vector<unsigned int>> at_node(topology.n_grid);
    for (unsigned int k = 0; k < contact.points.size(); ++k)
      if (const auto node =
            topology.grid_node(contact.points[k].node.places.at(0)))
        at_node[*node].push_back(k);
    quads = quadrilaterals_between(topology, at_node, carrying, contact);
    std::set<unsigned int> in_quads;
    for (const Quadrilateral &quad : quads)
      in_quads.insert(quad.begin(), quad.end());
    for (unsigned int k = 0; k < contact.points.size(); ++k)
      if (in_quads.count(k) == 0)
        alone.push_back(k);
  }



  namespace
  {
    // Of VTK's list of cell types.
    constexpr unsigned int vtk_vertex = 1, vtk_quad = 9;

    /// Writes a <DataArray>; @p values prints its numbers.
    void
    write_array(std::ostream                              &out,
                const std::string                         &type,
                const std::string                         &name,
                const unsigned int                         n_components,
                const std::function<void(std::ostream &)> &values)
    {
      out << "<DataArray type=\"" << type << "\" Name=\"" << name
          << "\" NumberOfComponents=\"" << n_components
          << "\" format=\"ascii\">\n";
      values(out);
      out << "\n</DataArray>\n";
    }



    void
    write_vectors(std::ostream                            &out,
                  const std::string                       &name,
                  const std::vector<dealii::Tensor<1, 3>> &vectors)
    {
      write_array(out, "Float64", name, 3, [&vectors](std::ostream &to) {
        for (const Tensor<1, 3> &v : vectors)
          to << csv(v[0]) << " " << csv(v[1]) << " " << csv(v[2]) << "\n";
      });
    }



    void
    write_scalars(std::ostream              &out,
                  const std::string         &name,
                  const std::vector<double> &scalars)
    {
      write_array(out, "Float64", name, 1, [&scalars](std::ostream &to) {
        for (const double value : scalars)
          to << csv(value) << " ";
      });
    }



    void
    write_cells(std::ostream &out, const ContactSurface &surface)
    {
      const auto &quads = surface.quadrilaterals();
      const auto &alone = surface.lone_points();
      out << "<Cells>\n";
      write_array(out, "Int32", "connectivity", 1, [&](std::ostream &to) {
        for (const ContactSurface::Quadrilateral &quad : quads)
          to << quad[0] << " " << quad[1] << " " << quad[2] << " " << quad[3]
             << "\n";
        for (const unsigned int k : alone)
          to << k << "\n";
      });
      write_array(out, "Int32", "offsets", 1, [&](std::ostream &to) {
        for (unsigned int i = 1; i <= quads.size(); ++i)
          to << 4 * i << " ";
        for (unsigned int i = 1; i <= alone.size(); ++i)
          to << 4 * quads.size() + i << " ";
      });
      write_array(out, "UInt8", "types", 1, [&](std::ostream &to) {
        for (unsigned int i = 0; i < quads.size(); ++i)
          to << vtk_quad << " ";
        for (unsigned int i = 0; i < alone.size(); ++i)
          to << vtk_vertex << " ";
      });
      out << "</Cells>\n";
    }
  } // namespace



  std::string
  ContactSurface::write_vtu(const std::string             &directory,
                            const unsigned int             step,
                            const BlockVector             &u,
                            const std::vector<ContactRow> &rows) const
  {
    const Bodies             &bodies = structure.bodies();
    std::vector<Tensor<1, 3>> positions, displacements, normals, separations;
    std::map<std::string, std::vector<double>> scalars;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        const ContactInterface::Point &point     = rows[k].point;
        const auto                     displaced = [&](const unsigned int b,
                                   const Location    &where) {
          return bodies[b]->sample(where, u.block(b)).displacement;
        };
        displacements.push_back(displaced(contact.first_body, first_places[k]));
        positions.push_back(point.first + displacements.back());
        normals.push_back(point.normal);
        separations.push_back(
          contact.second_body ?
            point.second + displaced(*contact.second_body, second_places[k]) -
              Point<3>(positions.back()) :
            rows[k].gap * point.normal);
        scalars["area"].push_back(point.area);
        scalars["initial_gap"].push_back(rows[k].initial_gap);
        scalars["gap"].push_back(rows[k].gap);
        scalars["force"].push_back(rows[k].force);
        scalars["pressure"].push_back(rows[k].force / point.area);
        scalars["status"].push_back(rows[k].touches() ? 1. : 0.);
      }

    const std::string name = "contact_" + contact.name + "_" +
                             Utilities::int_to_string(step, 4) + ".vtu";
    OutputFile    output(directory + "/" + name);
    std::ostream &file = output.stream();
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
            "version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<UnstructuredGrid>\n<Piece NumberOfPoints=\""
         << positions.size() << "\" NumberOfCells=\""
         << quads.size() + alone.size() << "\">\n<Points>\n";
    write_vectors(file, "points", positions);
    file << "</Points>\n";
    write_cells(file, *this);
    file << "<PointData Scalars=\"pressure\">\n";
    write_vectors(file, "displacement", displacements);
    write_vectors(file, "normal", normals);
    write_vectors(file, "separation", separations);
    for (const auto &[field, values] : scalars)
      write_scalars(file, field, values);
    file << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    if (!output.put_in_place())
      fail_to_write(directory + "/" + name);
    return name;
  }
} // namespace lamella
