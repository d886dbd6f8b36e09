// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/shape/gmsh_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A corner of a cell: the vertices before and after it, counter-clockwise.
    struct Corner
    {
      unsigned int vertex, next;
      Tensor<1, 2> to_next, to_last;
    };

    std::array<Corner, 4>
    corners_of(const GmshMesh &mesh, const unsigned int cell)
    {
      constexpr std::array<unsigned int, 4> around{{0, 1, 3, 2}};
      std::array<Corner, 4>                 corners;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const auto        &v    = mesh.cells[cell].vertices;
          const unsigned int here = v[around[i]], next = v[around[(i + 1) % 4]],
                             last = v[around[(i + 3) % 4]];
          corners[i]              = {here,
                                     next,
                                     mesh.vertices[next] - mesh.vertices[here],
                                     mesh.vertices[last] - mesh.vertices[here]};
        }
      return corners;
    }

    double
    area_between(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /// A side of a cell, from the vertex of the lower number to the other.
    using Side = std::pair<unsigned int, unsigned int>;

    Side
    side_between(const unsigned int a, const unsigned int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }

    std::string
    ends(const GmshMesh &mesh, const Side &side)
    {
      return "from " + to_text(mesh.vertices[side.first]) + " to " +
             to_text(mesh.vertices[side.second]);
    }



    /**
     * How many cells each side has. Throws InputError if these are more than
     * two, or both on the same side of it; deal.II would take either for a
     * mesh.
     */
    std::map<Side, unsigned int>
    count_cells_at_sides(const GmshMesh &mesh, const Entry &entry)
    {
      struct Found
      {
        unsigned int cell, first_vertex, count;
      };
      std::map<Side, Found>        found;
      std::map<Side, unsigned int> count;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        for (const Corner &corner : corners_of(mesh, c))
          {
            const Side side = side_between(corner.vertex, corner.next);
            const auto [it, is_new] =
              found.insert({side, {c, corner.vertex, 1}});
            ++count[side];
            // All cells run counter-clockwise, so that two of them pass the
            // side between them in opposite directions.
            if (!is_new && (++it->second.count > 2 ||
                            it->second.first_vertex == corner.vertex))
              refuse_line(
                entry,
                mesh.elements[c]->line,
                "shape.overlapping-cells: this cell and the cell in line " +
                  std::to_string(mesh.elements[it->second.cell]->line) +
                  " of the file overlap at the side " + ends(mesh, side),
                "Draw each surface once, put each into one physical surface "
                "only, and mesh the section again.");
          }
      return count;
    }



    Side
    side_of_line(const GmshMesh &mesh, const unsigned int l)
    {
      const CellData<1> &line = mesh.rest.boundary_lines[l];
      return side_between(line.vertices[0], line.vertices[1]);
    }



    /// Whether line @p l of @p mesh is a side of one cell, of those of
    /// @p count; lines beside the section are none. Throws InputError for those
    /// that ought to be one, and inside.
    bool
    is_at_boundary(const GmshMesh                     &mesh,
                   const unsigned int                  l,
                   const std::map<Side, unsigned int> &count,
                   const Entry                        &entry)
    {
      const Side         side    = side_of_line(mesh, l);
      const auto         cells   = count.find(side);
      const unsigned int in_file = mesh.lines[l]->line;
      if (cells == count.end() && mesh.rest.boundary_lines[l].boundary_id != 0)
        refuse_line(entry,
                    in_file,
                    "shape.line-off-boundary: this line element of a physical "
                    "line is no side of a cell",
                    "Physical lines must be on the boundary of the section: "
                    "remove this physical line, or mesh the section again.");
      // Lines of no name beside the section: auxiliary ones.
      if (cells == count.end())
        return false;
      if (cells->second > 1)
        refuse_line(
          entry,
          in_file,
          "shape.line-inside: a physical line runs inside the section, " +
            ends(mesh, side),
          "Physical lines must be on the boundary: remove this physical line, "
          "or the Gmsh option Mesh.SaveAll.");
      return true;
    }
  } // namespace



  void
  check_cells_are_convex(const GmshMesh &mesh, const Entry &entry)
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      for (const Corner &corner : corners_of(mesh, c))
        if (!(area_between(corner.to_next, corner.to_last) >
              arithmetic::degenerate_sine * corner.to_next.norm() *
                corner.to_last.norm()))
          {
            Tensor<1, 2> center;
            for (const unsigned int v : mesh.cells[c].vertices)
              center += mesh.vertices[v] / 4.;
            refuse_line(
              entry,
              mesh.elements[c]->line,
              "shape.folded-cell: a cell is folded or has no area, at " +
                to_text(Point<2>(center)) +
                " (an inner angle of 180 degrees or more)",
              "Mesh the section again; in Gmsh, 'Mesh.RecombinationAlgorithm = "
              "3' or transfinite surfaces make better cells.");
          }
  }



  void
  check_angles(const GmshMesh &mesh, const Entry &entry)
  {
    std::vector<double> angle(mesh.vertices.size(), 0.);
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      for (const Corner &corner : corners_of(mesh, c))
        {
          double &sum = angle[corner.vertex];
          sum += std::atan2(area_between(corner.to_next, corner.to_last),
                            corner.to_next * corner.to_last);
          if (sum > 2. * numbers::PI * (1. + arithmetic::degenerate_sine))
            refuse_line(
              entry,
              mesh.elements[c]->line,
              "shape.overlapping-cells: this cell overlaps other cells near " +
                to_text(mesh.vertices[corner.vertex]),
              "Draw each surface once, and mesh the section again.");
        }
  }



  void
  keep_boundary_lines(GmshMesh &mesh, const Entry &entry)
  {
    const auto                   count = count_cells_at_sides(mesh, entry);
    std::map<Side, unsigned int> seen;
    std::vector<CellData<1>>     lines;
    for (unsigned int l = 0; l < mesh.lines.size(); ++l)
      {
        if (!is_at_boundary(mesh, l, count, entry))
          continue;
        const Side side         = side_of_line(mesh, l);
        const auto [it, is_new] = seen.insert({side, l});
        if (!is_new)
          refuse_line(entry,
                      mesh.lines[l]->line,
                      "shape.side-in-two-lines: the side " + ends(mesh, side) +
                        " is already in another physical line, in line " +
                        std::to_string(mesh.lines[it->second]->line) +
                        " of the file",
                      "Put each curve into one physical line only.");
        lines.push_back(mesh.rest.boundary_lines[l]);
      }
    mesh.rest.boundary_lines = lines;
  }
} // namespace lamella
