// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/shape/shapes.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A wall's name, and where its normal points.
    struct Wall
    {
      std::string  name;
      Tensor<1, 2> normal;
    };



    /// Walls among the blocks of a grid: pictures from top to bottom, columns
    /// that are webs, rows (from the bottom) that are flanges; webs come first.
    struct WallLayout
    {
      std::vector<std::string>  picture;
      std::vector<unsigned int> webs, flanges;
      std::vector<Wall>         walls;
    };



    const WallLayout &
    layout_of(const ShapeKind form)
    {
      const Point<2> left(-1., 0.), right(1., 0.), down(0., -1.), up(0., 1.);
      static const std::map<ShapeKind, WallLayout> all{
        {ShapeKind::box,
         {{"###", "#.#", "###"},
          {0, 2},
          {0, 2},
          {{"left", left}, {"right", right}, {"bottom", down}, {"top", up}}}},
        {ShapeKind::double_t,
         {{"###", ".#.", "###"},
          {1},
          {0, 2},
          {{"web", right}, {"bottom", down}, {"top", up}}}},
        {ShapeKind::t,
         {{"###", ".#."}, {1}, {1}, {{"web", right}, {"flange", up}}}},
        {ShapeKind::channel,
         {{"##", "#.", "##"},
          {0},
          {0, 2},
          {{"web", left}, {"bottom", down}, {"top", up}}}},
        {ShapeKind::angle,
         {{"#.", "##"}, {0}, {0}, {{"left", left}, {"bottom", down}}}}};
      return all.at(form);
    }



    /// A column or row of cells, with its ply if it belongs to a wall.
    struct Strip
    {
      double       width;
      unsigned int ply;
    };



    /// The strips of the wall number @p w of @p section, ascending; its plies
    /// are numbered from @p first, inside to outside.
    std::vector<Strip>
    strips_of_wall(const ThinWalled  &section,
                   const unsigned int w,
                   const double       thickness,
                   const unsigned int first)
    {
      if (section.layups.empty())
        return std::vector<Strip>(section.cells_per_wall,
                                  {thickness / section.cells_per_wall, 0});
      std::vector<Strip> strips;
      const WallLayup   &layup = section.layups[w];
      for (unsigned int p = 0; p < layup.size(); ++p)
        strips.insert(strips.end(),
                      section.cells_per_ply,
                      {layup[p].thickness / section.cells_per_ply, first + p});
      const Tensor<1, 2> &normal = layout_of(section.form).walls[w].normal;
      if (normal[0] + normal[1] < 0.)
        std::reverse(strips.begin(), strips.end());
      return strips;
    }



    /// Columns (@p d = 0) or rows (1) of blocks as strips of cells, block after
    /// block; @p first is the number of the first ply of each wall.
    std::vector<std::vector<Strip>>
    strips_of(const ThinWalled                &section,
              const unsigned int               d,
              const std::vector<unsigned int> &first)
    {
      const WallLayout          &layout = layout_of(section.form);
      const std::vector<double> &thicknesses =
        d == 0 ? section.webs : section.flanges;
      const std::vector<unsigned int> &walls =
        d == 0 ? layout.webs : layout.flanges;
      const unsigned int n_blocks =
        d == 0 ? layout.picture[0].size() : layout.picture.size();
      const double rest =
        (d == 0 ? section.width : section.height) -
        std::accumulate(thicknesses.begin(), thicknesses.end(), 0.);

      const unsigned int              n = section.cells_along_wall;
      std::vector<std::vector<Strip>> blocks(
        n_blocks,
        std::vector<Strip>(n, {rest / (n_blocks - walls.size()) / n, 0}));
      for (unsigned int i = 0; i < walls.size(); ++i)
        {
          const unsigned int w = d == 0 ? i : layout.webs.size() + i;
          blocks[walls[i]] =
            strips_of_wall(section, w, thicknesses[i], first[w]);
        }
      return blocks;
    }



    /// Names what lies on the sides of the box [0, width] x [0, height].
    void
    name_sides(SectionMesh &section, const double width, const double height)
    {
      section.boundaries = {
        {0, "left"}, {1, "right"}, {2, "bottom"}, {3, "top"}, {4, "inner"}};
      const double tolerance =
        arithmetic::same_position_along * (width + height);
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



    /// A cell of a grid that is there.
    struct GridCell
    {
      unsigned int column, row, ply;
    };



    /// Meshes the cells @p filled of a grid of columns and rows of the widths
    /// @p steps. (deal.II's subdivided_hyper_rectangle makes the vertices of
    /// the whole grid, of which thin walls hold next to nothing.)
    void
    mesh_grid(const std::array<std::vector<double>, 2> &steps,
              const std::vector<GridCell>              &filled,
              Triangulation<2>                         &mesh)
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
      for (const GridCell &cell : filled)
        for (unsigned int k = 0; k < 4; ++k)
          vertex[{cell.row + k / 2, cell.column + k % 2}] = 0;
      std::vector<Point<2>> vertices;
      for (auto &[place, number] : vertex)
        {
          number = vertices.size();
          vertices.emplace_back(at[0][place.second], at[1][place.first]);
        }
      std::vector<CellData<2>> cells;
      for (const GridCell &cell : filled)
        {
          cells.emplace_back();
          for (unsigned int k = 0; k < 4; ++k)
            cells.back().vertices[k] =
              vertex.at({cell.row + k / 2, cell.column + k % 2});
          cells.back().material_id = cell.ply;
        }
      mesh.create_triangulation(vertices, cells, SubCellData());
    }



    /// The plies of @p section, all walls one after the other, each from the
    /// inside to the outside, and the number of the first of each wall.
    std::pair<std::vector<Ply>, std::vector<unsigned int>>
    plies_of_walls(const ThinWalled &section, const Materials &materials)
    {
      const std::vector<Wall>  &walls = layout_of(section.form).walls;
      std::vector<Ply>          plies;
      std::vector<unsigned int> first(walls.size(), 0);
      if (section.layups.empty())
        plies.push_back({section.oriented_material.material,
                         section.oriented_material.angle,
                         0.,
                         section.height,
                         materials.at(section.oriented_material.material)});
      for (unsigned int w = 0; w < section.layups.size(); ++w)
        {
          first[w] = plies.size();
          for (const WallPly &ply : section.layups[w])
            plies.push_back({ply.oriented_material.material,
                             ply.oriented_material.angle,
                             section.height,
                             0.,
                             materials.at(ply.oriented_material.material),
                             {walls[w].normal, {}, walls[w].name}});
        }
      return {plies, first};
    }



    /// The cells of @p section's walls with their plies: those of a flange in
    /// its row of blocks, corners included, those of a web elsewhere.
    std::vector<GridCell>
    cells_of_walls(const WallLayout                      &layout,
                   const std::vector<std::vector<Strip>> &columns,
                   const std::vector<std::vector<Strip>> &rows)
    {
      std::vector<GridCell> cells;
      unsigned int          j = 0;
      for (unsigned int b = 0; b < rows.size(); ++b)
        {
          const bool is_flange =
            std::count(layout.flanges.begin(), layout.flanges.end(), b) > 0;
          for (const Strip &row : rows[b])
            {
              unsigned int i = 0;
              for (unsigned int c = 0; c < columns.size(); ++c)
                for (const Strip &column : columns[c])
                  {
                    if (layout.picture[rows.size() - 1 - b][c] == '#')
                      cells.push_back({i, j, is_flange ? row.ply : column.ply});
                    ++i;
                  }
              ++j;
            }
        }
      return cells;
    }
  } // namespace



  std::pair<unsigned int, unsigned int>
  wall_counts(const ShapeKind form)
  {
    const WallLayout &layout = layout_of(form);
    return {layout.webs.size(), layout.flanges.size()};
  }



  std::vector<std::string>
  wall_names(const ShapeKind form)
  {
    std::vector<std::string> names;
    for (const Wall &wall : layout_of(form).walls)
      names.push_back(wall.name);
    return names;
  }



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const ThinWalled &walls, const Materials &materials)
  {
    auto              section = std::make_shared<SectionMesh>();
    const WallLayout &layout  = layout_of(walls.form);
    const auto        plies   = plies_of_walls(walls, materials);
    section->plies            = plies.first;
    const std::array<std::vector<std::vector<Strip>>, 2> strips{
      {strips_of(walls, 0, plies.second), strips_of(walls, 1, plies.second)}};

    std::array<std::vector<double>, 2> steps;
    for (unsigned int d = 0; d < 2; ++d)
      for (const std::vector<Strip> &block : strips[d])
        for (const Strip &strip : block)
          steps[d].push_back(strip.width);
    mesh_grid(steps,
              cells_of_walls(layout, strips[0], strips[1]),
              section->mesh);
    for (const auto &cell : section->mesh.active_cell_iterators())
      {
        Ply &ply   = section->plies[cell->material_id()];
        ply.bottom = std::min(ply.bottom, cell->vertex(0)[1]);
        ply.top    = std::max(ply.top, cell->vertex(2)[1]);
      }
    name_sides(*section, walls.width, walls.height);
    return section;
  }
} // namespace lamella
