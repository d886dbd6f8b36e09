// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace lamella
{
  using namespace dealii;

  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials)
  {
    return std::visit(
      [&materials](const auto &kind) {
        return make_section_mesh(kind, materials);
      },
      shape);
  }



  namespace
  {
    /// The kind of each alternative of SectionShape.
    struct KindOf
    {
      ShapeKind
      operator()(const Laminate &) const
      {
        return ShapeKind::laminate;
      }

      ShapeKind
      operator()(const HalfDisc &) const
      {
        return ShapeKind::half_disc;
      }

      ShapeKind
      operator()(const Ellipse &) const
      {
        return ShapeKind::ellipse;
      }

      ShapeKind
      operator()(const ThinWalled &walls) const
      {
        return walls.form;
      }

      ShapeKind
      operator()(const SectionFile &) const
      {
        return ShapeKind::file;
      }
    };
  } // namespace



  ShapeKind
  kind_of(const SectionShape &shape)
  {
    return std::visit(KindOf(), shape);
  }



  namespace
  {
    /// The one ply of a homogeneous section between @p bottom and @p top.
    Ply
    only_ply(const Fabric &fabric, const double top, const Materials &materials)
    {
      return {
        fabric.material, fabric.angle, 0., top, materials.at(fabric.material)};
    }



    /// Polar coordinates (r, angle) of an ellipse about a centre, r = 1 on its
    /// edge. Unlike EllipticalManifold's they include the circle.
    class EllipseManifold : public ChartManifold<2, 2, 2>
    {
    public:
      /// With half the extensions @p axes.
      EllipseManifold(const Point<2> &centre, const Tensor<1, 2> &axes)
        : ChartManifold<2, 2, 2>(Point<2>(0., 2. * numbers::PI))
        , centre(centre)
        , axes(axes)
      {}

      std::unique_ptr<Manifold<2, 2>>
      clone() const override
      {
        return std::make_unique<EllipseManifold>(centre, axes);
      }

      Point<2>
      pull_back(const Point<2> &x) const override
      {
        const Point<2> p((x[0] - centre[0]) / axes[0],
                         (x[1] - centre[1]) / axes[1]);
        const double   angle = std::atan2(p[1], p[0]);
        return {p.norm(), angle < 0. ? angle + 2. * numbers::PI : angle};
      }

      Point<2>
      push_forward(const Point<2> &chart) const override
      {
        return {centre[0] + axes[0] * chart[0] * std::cos(chart[1]),
                centre[1] + axes[1] * chart[0] * std::sin(chart[1])};
      }

    private:
      Point<2>     centre;
      Tensor<1, 2> axes;
    };
  } // namespace



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = {only_ply(ellipse.fabric, ellipse.height, materials)};

    Triangulation<2> disc;
    GridGenerator::hyper_ball_balanced(disc);
    disc.refine_global(ellipse.refinements);
    Triangulation<2> &mesh = section->mesh;
    GridGenerator::flatten_triangulation(disc, mesh);
    const Point<2> half(0.5 * ellipse.width, 0.5 * ellipse.height);
    GridTools::transform(
      [&half](const Point<2> &p) {
        return Point<2>(half[0] * (1. + p[0]), half[1] * (1. + p[1]));
      },
      mesh);

    mesh.reset_all_manifolds();
    mesh.set_all_manifold_ids(numbers::flat_manifold_id);
    mesh.set_all_manifold_ids_on_boundary(0);
    mesh.set_manifold(0, EllipseManifold(half, half));
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
    section->boundaries = {{0, "arc"}};
    return section;
  }



  namespace
  {
    /// Which blocks of a grid are walls: pictures from top to bottom, the
    /// columns that are webs, the rows (from the bottom) that are flanges.
    struct WallLayout
    {
      std::vector<std::string>  picture;
      std::vector<unsigned int> webs, flanges;
    };



    const WallLayout &
    layout_of(const ShapeKind form)
    {
      static const std::map<ShapeKind, WallLayout> all{
        {ShapeKind::box, {{"###", "#.#", "###"}, {0, 2}, {0, 2}}},
        {ShapeKind::double_t, {{"###", ".#.", "###"}, {1}, {0, 2}}},
        {ShapeKind::t, {{"###", ".#."}, {1}, {1}}},
        {ShapeKind::channel, {{"##", "#.", "##"}, {0}, {0, 2}}},
        {ShapeKind::angle, {{"#.", "##"}, {0}, {0}}}};
      return all.at(form);
    }



    /// Columns or rows of blocks as widths of cells, block after block.
    std::vector<std::vector<double>>
    cut_into_cells(const double                     extension,
                   const unsigned int               n_blocks,
                   const std::vector<unsigned int> &walls,
                   const std::vector<double>       &thicknesses,
                   const ThinWalled                &section)
    {
      const double rest =
        extension - std::accumulate(thicknesses.begin(), thicknesses.end(), 0.);
      std::vector<std::vector<double>> blocks(
        n_blocks,
        std::vector<double>(section.cells_along_wall,
                            rest / (n_blocks - walls.size()) /
                              section.cells_along_wall));
      for (unsigned int i = 0; i < walls.size(); ++i)
        blocks[walls[i]].assign(section.cells_per_wall,
                                thicknesses[i] / section.cells_per_wall);
      return blocks;
    }



    /// Names what lies on the sides of the box [0, width] x [0, height].
    void
    name_sides(SectionMesh &section, const double width, const double height)
    {
      section.boundaries = {
        {0, "left"}, {1, "right"}, {2, "bottom"}, {3, "top"}, {4, "inner"}};
      const double tolerance = 1e-10 * (width + height);
      for (const auto &face : section.mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const Point<2>              c = face->center();
            const std::array<double, 4> off{
              {c[0], width - c[0], c[1], height - c[1]}};
            const auto nearest = std::min_element(off.begin(), off.end());
            face->set_boundary_id(*nearest < tolerance ? nearest - off.begin() :
                                                         4);
          }
    }



    /// Meshes the cells @p filled (column, row) of a grid of columns and rows
    /// of the widths @p steps. (deal.II's subdivided_hyper_rectangle makes the
    /// vertices of the whole grid, of which thin walls hold next to nothing.)
    void
    mesh_grid(const std::array<std::vector<double>, 2>                 &steps,
              const std::vector<std::pair<unsigned int, unsigned int>> &filled,
              Triangulation<2>                                         &mesh)
    {
      std::array<std::vector<double>, 2> at;
      for (unsigned int d = 0; d < 2; ++d)
        {
          at[d] = {0.};
          for (const double step : steps[d])
            at[d].push_back(at[d].back() + step);
        }
      // Row after row, as the cells come.
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> vertex;
      for (const auto &[i, j] : filled)
        for (unsigned int k = 0; k < 4; ++k)
          vertex[{j + k / 2, i + k % 2}] = 0;
      std::vector<Point<2>> vertices;
      for (auto &[place, number] : vertex)
        {
          number = vertices.size();
          vertices.emplace_back(at[0][place.second], at[1][place.first]);
        }
      std::vector<CellData<2>> cells;
      for (const auto &[i, j] : filled)
        {
          cells.emplace_back();
          for (unsigned int k = 0; k < 4; ++k)
            cells.back().vertices[k] = vertex.at({j + k / 2, i + k % 2});
          cells.back().material_id = 0;
        }
      mesh.create_triangulation(vertices, cells, SubCellData());
    }
  } // namespace



  std::pair<unsigned int, unsigned int>
  count_of_walls(const ShapeKind form)
  {
    const WallLayout &layout = layout_of(form);
    return {layout.webs.size(), layout.flanges.size()};
  }



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = {only_ply(walls.fabric, walls.height, materials)};

    const WallLayout  &layout                      = layout_of(walls.form);
    const unsigned int n_rows                      = layout.picture.size(),
                       n_columns                   = layout.picture[0].size();
    const std::vector<std::vector<double>> columns = cut_into_cells(walls.width,
                                                                    n_columns,
                                                                    layout.webs,
                                                                    walls.webs,
                                                                    walls),
                                           rows = cut_into_cells(walls.height,
                                                                 n_rows,
                                                                 layout.flanges,
                                                                 walls.flanges,
                                                                 walls);

    std::array<std::vector<double>, 2>                 steps;
    std::vector<std::pair<unsigned int, unsigned int>> filled;
    for (const std::vector<double> &widths : columns)
      steps[0].insert(steps[0].end(), widths.begin(), widths.end());
    for (unsigned int b = 0; b < n_rows; ++b)
      for (const double height : rows[b])
        {
          unsigned int i = 0;
          for (unsigned int c = 0; c < n_columns; ++c)
            {
              if (layout.picture[n_rows - 1 - b][c] == '#')
                for (unsigned int k = 0; k < columns[c].size(); ++k)
                  filled.emplace_back(i + k, steps[1].size());
              i += columns[c].size();
            }
          steps[1].push_back(height);
        }
    mesh_grid(steps, filled, section->mesh);
    name_sides(*section, walls.width, walls.height);
    return section;
  }
} // namespace lamella
