// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/report/fields_table.h>
#include <lamella/report/section_table.h>

#include <deal.II/fe/mapping_q.h>

#include <array>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The side @p f of @p cell as points between semicolons, from its first
    /// vertex to the other or, unless it goes @p forwards, back.
    std::string
    side_points(const Triangulation<2>::active_cell_iterator &cell,
                const unsigned int                            f,
                const bool                                    forwards,
                const MappingQ<2>                            &mapping)
    {
      const bool curved =
        cell->face(f)->manifold_id() != numbers::flat_manifold_id;
      const unsigned int n = curved ? 8 : 1;
      std::string        side;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double   t    = double(forwards ? i : n - i) / n;
          const Point<2> unit = f < 2 ? Point<2>(f, t) : Point<2>(t, f - 2);
          const Point<2> x    = mapping.transform_unit_to_real_cell(cell, unit);
          side += (i == 0 ? "," : ";") + csv(x[0]) + " " + csv(x[1]);
        }
      return side;
    }
  } // namespace



  std::string
  section_table(const SectionMesh &section)
  {
    // Sides counter-clockwise: deal.II's face, and its direction there.
    constexpr std::array<std::pair<unsigned int, bool>, 4> around{
      {{2, true}, {1, true}, {3, false}, {0, false}}};
    const MappingQ<2> mapping(6);

    std::string table = "cell,ply,wall,material,angle,normal_x,normal_z";
    for (const char *kind : {"boundary", "side"})
      for (unsigned int k = 1; k <= 4; ++k)
        table += std::string(",") + kind + "_" + std::to_string(k);
    table += "\n";
    for (const auto &cell : section.mesh.active_cell_iterators())
      {
        const Ply  &ply = section.plies[cell->material_id()];
        std::string names, sides;
        for (const auto &[f, forwards] : around)
          {
            const auto face = cell->face(f);
            names += ",";
            if (face->at_boundary())
              names += section.boundaries.at(face->boundary_id());
            sides += side_points(cell, f, forwards, mapping);
          }
        const Tensor<1, 2> normal = ply.plane.at(
          mapping.transform_unit_to_real_cell(cell, Point<2>(0.5, 0.5)));
        table += std::to_string(cell->active_cell_index()) + "," +
                 std::to_string(cell->material_id() + 1) + "," +
                 ply.plane.wall + "," + ply.material + "," + csv(ply.angle) +
                 "," + csv(normal[0]) + "," + csv(normal[1]) + names + sides +
                 "\n";
      }
    return table;
  }



  void
  write_section(const std::string &directory,
                const std::string &name,
                const SectionMesh &section)
  {
    write_file(directory + "/sections/" + name + ".csv",
               section_table(section));
  }
} // namespace lamella
