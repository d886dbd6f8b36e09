// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/report/contact_surface.h>
#include <lamella/report/fields_table.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A face of an element: element, unit coordinate across it, which side.
    using Face = std::tuple<unsigned int, unsigned int, bool>;

    /// The points of a face by their unit coordinates in it.
    using FaceGrid = std::map<std::pair<long, long>, unsigned int>;



    std::map<Face, FaceGrid>
    points_on_faces(const std::vector<std::vector<Location>> &locations)
    {
      // Unit coordinates without the rounding of an inverted map.
      const auto rounded = [](const double t) { return std::lround(t * 1e6); };
      const long zero = rounded(0.), one = rounded(1.);

      std::map<Face, FaceGrid> faces;
      for (unsigned int k = 0; k < locations.size(); ++k)
        for (const Location &location : locations[k])
          for (const Location::Place &place : location.places)
            for (unsigned int d = 0; d < 3; ++d)
              {
                const long across = rounded(place.unit[d]);
                if (across == zero || across == one)
                  faces[{place.cell, d, across == one}].insert(
                    {{rounded(place.unit[(d + 1) % 3]),
                      rounded(place.unit[(d + 2) % 3])},
                     k});
              }
      return faces;
    }



    /// Whether the normals of @p contact's points are those of a quadrilateral
    /// between @p positions: a face inside of the body may have points on its
    /// edges, too.
    bool
    lies_in_surface(const ContactSurface::Quadrilateral &quad,
                    const std::vector<Point<3>>         &positions,
                    const ContactInterface              &contact)
    {
      const Tensor<1, 3> normal =
        cross_product_3d(positions[quad[2]] - positions[quad[0]],
                         positions[quad[3]] - positions[quad[1]]);
      for (const unsigned int k : quad)
        if (std::abs(normal * contact.points[k].normal) < 0.5 * normal.norm())
          return false;
      return true;
    }



    /// Adds the quadrilaterals between neighbouring points of @p grid.
    void
    add_quadrilaterals(const FaceGrid                             &grid,
                       const std::vector<Point<3>>                &positions,
                       const ContactInterface                     &contact,
                       std::vector<ContactSurface::Quadrilateral> &quads)
    {
      std::set<long> s_values, t_values;
      for (const auto &[at, k] : grid)
        {
          s_values.insert(at.first);
          t_values.insert(at.second);
        }
      for (auto s = s_values.begin(); std::next(s) != s_values.end(); ++s)
        for (auto t = t_values.begin(); std::next(t) != t_values.end(); ++t)
          {
            const auto a = grid.find({*s, *t}),
                       b = grid.find({*std::next(s), *t}),
                       c = grid.find({*std::next(s), *std::next(t)}),
                       d = grid.find({*s, *std::next(t)});
            if (a == grid.end() || b == grid.end() || c == grid.end() ||
                d == grid.end())
              continue;
            const ContactSurface::Quadrilateral quad{
              {a->second, b->second, c->second, d->second}};
            if (lies_in_surface(quad, positions, contact))
              quads.push_back(quad);
          }
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
    std::vector<Point<3>> first, second;
    for (const ContactInterface::Point &point : contact.points)
      {
        first.push_back(point.first);
        second.push_back(point.second);
      }
    const Bodies &bodies        = structure.bodies();
    const auto    first_located = bodies[contact.first_body]->locate(first);
    first_places                = first_of(first_located);
    auto carrying               = first_located;
    if (contact.second_body)
      {
        const auto second_located =
          bodies[*contact.second_body]->locate(second);
        second_places = first_of(second_located);
        if (contact.points_on_second)
          carrying = second_located;
      }

    for (const auto &[face, grid] : points_on_faces(carrying))
      add_quadrilaterals(grid,
                         contact.points_on_second ? second : first,
                         contact,
                         quads);
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
