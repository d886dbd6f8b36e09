// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/shape/section_mesh.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// By its vertices, the lower number first.
    using Edge = std::pair<unsigned int, unsigned int>;



    Edge
    edge_of(const unsigned int one, const unsigned int other)
    {
      return std::minmax(one, other);
    }



    bool
    differ(const Ply &one, const Ply &other)
    {
      return one.material != other.material || one.angle != other.angle;
    }



    /**
     * The edges of a mesh in sheets: those that face each other across cells
     * are divided alike. A sheet's edges have a common direction, from the
     * lower to the higher vertex of its first one.
     */
    class Sheets
    {
    public:
      explicit Sheets(const Triangulation<2> &mesh)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          for (const unsigned int bit : {1u, 2u})
            join({cell->vertex_index(0), cell->vertex_index(bit)},
                 {cell->vertex_index(bit ^ 3u), cell->vertex_index(3)});
      }

      /// Divides the sheet of the edge from @p corner to @p other at @p corner.
      void
      mark(const unsigned int corner, const unsigned int other)
      {
        const auto [root, is_reversed] = find(edge_of(corner, other));
        marks[root][(corner > other) != is_reversed ? 1 : 0] = true;
      }

      /// The fractions along the edge from @p begin to @p end at which it is
      /// divided into @p layers at each of its marked ends, with 0 and 1.
      std::vector<double>
      fractions(const unsigned int begin,
                const unsigned int end,
                const unsigned int layers,
                const double       ratio) const
      {
        const auto [root, is_reversed] = find(edge_of(begin, end));
        const auto       known         = marks.find(root);
        std::set<double> at{0., 1.};
        if (known != marks.end())
          for (unsigned int k = 1; k <= layers; ++k)
            {
              const bool is_turned = (begin > end) != is_reversed;
              if (known->second[is_turned ? 1 : 0])
                at.insert(std::pow(ratio, k));
              if (known->second[is_turned ? 0 : 1])
                at.insert(1. - std::pow(ratio, k));
            }
        return {at.begin(), at.end()};
      }

    private:
      /// The first edge of the sheet of @p edge, and whether that is reversed.
      std::pair<Edge, bool>
      find(Edge edge) const
      {
        bool is_reversed = false;
        for (auto next = parents.find(edge); next != parents.end();
             next      = parents.find(edge))
          {
                 is_reversed ^= next->second.second;
                 edge = next->second.first;
          }
        return {edge, is_reversed};
      }

      /// Two edges, begin and end each, that face each other.
      void
      join(const Edge &one, const Edge &other)
      {
        const auto a = find(edge_of(one.first, one.second)),
                   b = find(edge_of(other.first, other.second));
        const bool is_reversed =
          (one.first > one.second) != (other.first > other.second);
        if (a.first != b.first)
          parents[b.first] = {a.first, bool(a.second ^ b.second ^ is_reversed)};
      }

      std::map<Edge, std::pair<Edge, bool>> parents;
      /// Whether a sheet's first edge is divided at its begin and its end.
      std::map<Edge, std::array<bool, 2>> marks;
    };



    /// The vertices of a finer mesh, each made once.
    class Vertices
    {
    public:
      explicit Vertices(const std::vector<Point<2>> &coarse)
        : points(coarse)
      {}

      /// On the edge from @p begin to @p end.
      unsigned int
      on_edge(const unsigned int begin,
              const unsigned int end,
              const double       fraction)
      {
        if (fraction == 0. || fraction == 1.)
          return fraction == 0. ? begin : end;
        if (begin > end)
          return on_edge(end, begin, 1. - fraction);
        // Fractions from both ends differ by rounding.
        const auto key =
          std::make_pair(edge_of(begin, end),
                         std::lround(fraction / arithmetic::same_position));
        const auto [place, is_new] = known.insert({key, points.size()});
        if (is_new)
          points.push_back(points[begin] +
                           fraction * (points[end] - points[begin]));
        return place->second;
      }

      unsigned int
      inside(const Point<2> &point)
      {
        points.push_back(point);
        return points.size() - 1;
      }

      const std::vector<Point<2>> &
      all() const
      {
        return points;
      }

    private:
      std::vector<Point<2>>                         points;
      std::map<std::pair<Edge, long>, unsigned int> known;
    };



    /// Where the cell @p corners are its vertices' places, the point of the
    /// unit square (@p s, @p t): edges are straight.
    Point<2>
    at(const std::array<Point<2>, 4> &corners, const double s, const double t)
    {
      return Point<2>((1. - t) * ((1. - s) * corners[0] + s * corners[1]) +
                      t * ((1. - s) * corners[2] + s * corners[3]));
    }



    /// Divides cells of one mesh, and keeps what they make.
    class Divider
    {
    public:
      Divider(const Triangulation<2> &mesh,
              const Sheets           &sheets,
              const unsigned int      layers,
              const CornerRules      &rules)
        : sheets(sheets)
        , layers(layers)
        , rules(rules)
        , vertices(mesh.get_vertices())
      {}

      template <typename Cell>
      void
      add_cell(const Cell &cell)
      {
        std::array<unsigned int, 4> v;
        std::array<Point<2>, 4>     places;
        for (unsigned int k = 0; k < 4; ++k)
          {
            v[k]      = cell->vertex_index(k);
            places[k] = cell->vertex(k);
          }
        const auto s = fractions(v[0], v[1]), t = fractions(v[0], v[2]);
        const auto n_s = s.size(), n_t = t.size();
        std::vector<unsigned int> grid;
        for (unsigned int j = 0; j < n_t; ++j)
          for (unsigned int i = 0; i < n_s; ++i)
            grid.push_back(j == 0       ? vertices.on_edge(v[0], v[1], s[i]) :
                           j == n_t - 1 ? vertices.on_edge(v[2], v[3], s[i]) :
                           i == 0       ? vertices.on_edge(v[0], v[2], t[j]) :
                           i == n_s - 1 ?
                                    vertices.on_edge(v[1], v[3], t[j]) :
                                    vertices.inside(at(places, s[i], t[j])));
        for (unsigned int j = 0; j + 1 < n_t; ++j)
          for (unsigned int i = 0; i + 1 < n_s; ++i)
            {
              CellData<2>        piece;
              const unsigned int first = j * n_s + i;
              piece.vertices           = {grid[first],
                                          grid[first + 1],
                                          grid[first + n_s],
                                          grid[first + n_s + 1]};
              piece.material_id        = cell->material_id();
              cells.push_back(piece);
            }
      }

      /// An edge of the boundary, whose name its parts inherit.
      template <typename Face>
      void
      add_boundary(const Face &face)
      {
        const unsigned int begin = face->vertex_index(0),
                           end   = face->vertex_index(1);
        const auto fraction      = fractions(begin, end);
        for (unsigned int k = 0; k + 1 < fraction.size(); ++k)
          {
            CellData<1> piece;
            piece.vertices    = {vertices.on_edge(begin, end, fraction[k]),
                                 vertices.on_edge(begin, end, fraction[k + 1])};
            piece.boundary_id = face->boundary_id();
            edges.boundary_lines.push_back(piece);
          }
      }

      std::size_t
      n_cells() const
      {
        return cells.size();
      }

      void
      make(Triangulation<2> &mesh) const
      {
        mesh.create_triangulation(vertices.all(), cells, edges);
      }

    private:
      std::vector<double>
      fractions(const unsigned int begin, const unsigned int end) const
      {
        return sheets.fractions(begin, end, layers, rules.ratio);
      }

      const Sheets      &sheets;
      const unsigned int layers;
      const CornerRules  rules;
      Vertices           vertices;
      /// The finer mesh as deal.II is told of it.
      std::vector<CellData<2>> cells;
      SubCellData              edges;
    };
  } // namespace



  std::vector<unsigned int>
  singular_corners(const SectionMesh &section, const CornerRules &rules)
  {
    std::set<unsigned int> boundary;
    for (const auto &face : section.mesh.active_face_iterators())
      if (face->at_boundary())
        boundary.insert({face->vertex_index(0), face->vertex_index(1)});
    std::map<unsigned int, double>             angles;
    std::map<unsigned int, std::set<unsigned>> plies;
    for (const auto &cell : section.mesh.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (const unsigned int vertex = cell->vertex_index(v);
            boundary.count(vertex) > 0)
          {
            // The neighbors of a vertex differ from it in one bit.
            const Tensor<1, 2> a = cell->vertex(v ^ 1u) - cell->vertex(v),
                               b = cell->vertex(v ^ 2u) - cell->vertex(v);
            angles[vertex] +=
              std::acos(a * b / (a.norm() * b.norm())) * 180. / numbers::PI;
            plies[vertex].insert(cell->material_id());
          }
    std::vector<unsigned int> corners;
    for (const unsigned int vertex : boundary)
      {
        const Ply &first = section.plies[*plies[vertex].begin()];
        if (angles[vertex] > rules.min_reentrant_angle ||
            std::any_of(plies[vertex].begin(),
                        plies[vertex].end(),
                        [&](const unsigned int ply) {
                          return differ(section.plies[ply], first);
                        }))
          corners.push_back(vertex);
      }
    return corners;
  }



  std::shared_ptr<const SectionMesh>
  graded_to_corners(const SectionMesh &section,
                    const unsigned int layers,
                    const std::string &what,
                    const CornerRules &rules)
  {
    const std::vector<unsigned int> corners = singular_corners(section, rules);
    if (corners.empty())
      throw InputError(
        what + "/Corner layers",
        std::to_string(layers),
        "shape.no-singular-corner: no corner of the section has singular "
        "stresses (re-entrant corners, edges where plies differ)",
        "Remove Corner layers.");
    const Triangulation<2> &mesh = section.mesh;
    Sheets                  sheets(mesh);
    for (const auto &face : mesh.active_face_iterators())
      for (const unsigned int end : {0u, 1u})
        if (std::binary_search(corners.begin(),
                               corners.end(),
                               face->vertex_index(end)))
          sheets.mark(face->vertex_index(end), face->vertex_index(1 - end));
    Divider divider(mesh, sheets, layers, rules);
    for (const auto &cell : mesh.active_cell_iterators())
      divider.add_cell(cell);
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        divider.add_boundary(face);
    if (divider.n_cells() > max_section_cells)
      throw InputError(what + "/Corner layers",
                       std::to_string(layers),
                       "shape.too-many-cells: the corner layers would give " +
                         std::to_string(divider.n_cells()) +
                         " cells, more than " + to_text(max_section_cells),
                       "Use fewer Corner layers, or a theory of higher order.");
    auto result        = std::make_shared<SectionMesh>();
    result->plies      = section.plies;
    result->boundaries = section.boundaries;
    divider.make(result->mesh);
    return result;
  }
} // namespace lamella
