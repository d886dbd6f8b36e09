// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/shape/curve_normals.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/manifold_lib.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Parameter of a point's projection on an ellipse, and its depth below it.
    class WallManifold : public ChartManifold<2, 2, 2>
    {
    public:
      explicit WallManifold(const EllipseProjection &outside)
        : ChartManifold<2, 2, 2>(Point<2>(2. * numbers::PI, 0.))
        , outside(outside)
      {}

      std::unique_ptr<Manifold<2, 2>>
      clone() const override
      {
        return std::make_unique<WallManifold>(outside);
      }

      Point<2>
      pull_back(const Point<2> &x) const override
      {
        const double phi = outside.parameter(x);
        return {phi < 0. ? phi + 2. * numbers::PI : phi,
                (outside.point(phi) - x) * outside.normal(phi)};
      }

      Point<2>
      push_forward(const Point<2> &chart) const override
      {
        return outside.point(chart[0]) - chart[1] * outside.normal(chart[0]);
      }

    private:
      EllipseProjection outside;
    };



    /// Depths of the interfaces of cells, from the inside to the outside, and
    /// the ply of each ring of cells between two of them.
    struct Rings
    {
      std::vector<double>       depths;
      std::vector<unsigned int> plies;
    };



    Rings
    rings_of(const Tube &tube)
    {
      double depth = 0.;
      for (const WallPly &ply : tube.layup)
        depth += ply.thickness;
      Rings rings{{depth}, {}};
      for (unsigned int p = 0; p < tube.layup.size(); ++p)
        {
          for (unsigned int c = 0; c < tube.cells_per_ply; ++c)
            {
              rings.depths.push_back(depth - (c + 1.) / tube.cells_per_ply *
                                               tube.layup[p].thickness);
              rings.plies.push_back(p);
            }
          depth -= tube.layup[p].thickness;
        }
      rings.depths.back() = 0.;
      return rings;
    }



    /// The cells of @p rings, @p n in each, into @p mesh.
    void
    make_cells(const EllipseProjection &outside,
               const Rings             &rings,
               const unsigned int       n,
               Triangulation<2>        &mesh)
    {
      std::vector<Point<2>>    vertices;
      std::vector<CellData<2>> cells;
      for (unsigned int j = 0; j < rings.depths.size(); ++j)
        for (unsigned int k = 0; k < n; ++k)
          {
            // From the top along t, towards +x.
            const double phi = 0.5 * numbers::PI - 2. * numbers::PI * k / n;
            vertices.push_back(outside.point(phi) -
                               rings.depths[j] * outside.normal(phi));
          }
      for (unsigned int j = 0; j < rings.plies.size(); ++j)
        for (unsigned int k = 0; k < n; ++k)
          {
            cells.emplace_back();
            const unsigned int next  = (k + 1) % n;
            cells.back().vertices[0] = j * n + k;
            cells.back().vertices[1] = j * n + next;
            cells.back().vertices[2] = (j + 1) * n + k;
            cells.back().vertices[3] = (j + 1) * n + next;
            cells.back().material_id = rings.plies[j];
          }
      mesh.create_triangulation(vertices, cells, SubCellData());
    }
  } // namespace



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Tube &tube, const Materials &materials)
  {
    auto                    section = std::make_shared<SectionMesh>();
    const double            a = 0.5 * tube.width, b = 0.5 * tube.height;
    const EllipseProjection outside(Point<2>(a, b), a, b);
    const Rings             rings = rings_of(tube);
    Triangulation<2>       &mesh  = section->mesh;
    make_cells(outside, rings, tube.cells_around, mesh);
    mesh.set_all_manifold_ids(0);
    mesh.set_manifold(0, WallManifold(outside));
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : {2, 3})
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(f - 2);
    section->boundaries = {{0, "inner"}, {1, "outer"}};

    const auto normal_at = [outside](const Point<2> &x) {
      return outside.normal(outside.parameter(x));
    };
    double depth = rings.depths[0];
    for (const WallPly &ply : tube.layup)
      {
        depth -= ply.thickness;
        section->plies.push_back({ply.oriented_material.material,
                                  ply.oriented_material.angle,
                                  depth,
                                  tube.height - depth,
                                  materials.at(ply.oriented_material.material),
                                  {Point<2>(0., 1.), normal_at, "tube"}});
      }
    return section;
  }
} // namespace lamella
