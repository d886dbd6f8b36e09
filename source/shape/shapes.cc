// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  double
  Laminate::height() const
  {
    return std::accumulate(thicknesses.begin(), thicknesses.end(), 0.);
  }



  std::vector<Ply>
  Laminate::plies(const Materials &library) const
  {
    std::vector<Ply> stack;
    double           z = 0.;
    for (unsigned int i = 0; i < angles.size(); ++i)
      {
        stack.push_back({materials[i],
                         angles[i],
                         z,
                         z + thicknesses[i],
                         library.at(materials[i])});
        z += thicknesses[i];
      }
    return stack;
  }



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Laminate &laminate, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = laminate.plies(materials);

    std::vector<std::vector<double>> steps(2);
    std::vector<double>              ends = laminate.across_breaks;
    ends.push_back(laminate.width);
    for (unsigned int i = 0; i < ends.size(); ++i)
      {
        const double       piece = ends[i] - (i == 0 ? 0. : ends[i - 1]);
        const unsigned int n     = laminate.cells_across[i];
        steps[0].insert(steps[0].end(), n, piece / n);
      }
    for (unsigned int i = 0; i < laminate.thicknesses.size(); ++i)
      {
        const auto        &cells = laminate.cells_per_ply;
        const unsigned int n     = cells.size() == 1 ? cells[0] : cells[i];
        steps[1].insert(steps[1].end(), n, laminate.thicknesses[i] / n);
      }
    GridGenerator::subdivided_hyper_rectangle(section->mesh,
                                              steps,
                                              Point<2>(),
                                              Point<2>(laminate.width,
                                                       laminate.height()),
                                              /*colorize=*/true);
    section->boundaries = {{0, "left"},
                           {1, "right"},
                           {2, "bottom"},
                           {3, "top"}};

    for (const auto &cell : section->mesh.active_cell_iterators())
      {
        unsigned int ply = 0;
        while (cell->center()[1] > section->plies[ply].top)
          ++ply;
        cell->set_material_id(ply);
      }
    return section;
  }



  namespace
  {
    /// The reduced stiffness of @p ply in plane stress in the order
    /// {yy, xx, xy}: sigma_zz = sigma_xz = sigma_yz = 0 condensed out of C.
    Tensor<2, 3>
    plane_stress_stiffness(const Ply &ply)
    {
      const ElasticTensor                   C = ply.stiffness();
      constexpr std::array<unsigned int, 3> kept{{1, 0, 3}};
      constexpr unsigned int                zz = 2;
      // A rotation about z leaves zz uncoupled from xz and yz.
      Tensor<2, 3> Q;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          Q[i][j] =
            C[kept[i]][kept[j]] - C[kept[i]][zz] * C[zz][kept[j]] / C[zz][zz];
      return Q;
    }



    /// Polar coordinates (r, angle) of an ellipse about a center, r = 1 on its
    /// edge. Unlike EllipticalManifold's they include the circle.
    class EllipseManifold : public ChartManifold<2, 2, 2>
    {
    public:
      /// With half the extensions @p axes.
      EllipseManifold(const Point<2> &center, const Tensor<1, 2> &axes)
        : ChartManifold<2, 2, 2>(Point<2>(0., 2. * numbers::PI))
        , center(center)
        , axes(axes)
      {}

      std::unique_ptr<Manifold<2, 2>>
      clone() const override
      {
        return std::make_unique<EllipseManifold>(center, axes);
      }

      Point<2>
      pull_back(const Point<2> &x) const override
      {
        const Point<2> p((x[0] - center[0]) / axes[0],
                         (x[1] - center[1]) / axes[1]);
        const double   angle = std::atan2(p[1], p[0]);
        return {p.norm(), angle < 0. ? angle + 2. * numbers::PI : angle};
      }

      Point<2>
      push_forward(const Point<2> &chart) const override
      {
        return {center[0] + axes[0] * chart[0] * std::cos(chart[1]),
                center[1] + axes[1] * chart[0] * std::sin(chart[1])};
      }

    private:
      Point<2>     center;
      Tensor<1, 2> axes;
    };
  } // namespace



  LaminateStiffness
  laminate_stiffness(const std::vector<Ply> &plies, const double width)
  {
    LaminateStiffness result;
    const double      middle = 0.5 * plies.back().top;
    for (const Ply &ply : plies)
      {
        const Tensor<2, 3> Q      = plane_stress_stiffness(ply);
        const double       bottom = ply.bottom - middle, top = ply.top - middle;
        result.A += Q * (top - bottom);
        result.B += Q * (top * top - bottom * bottom) / 2.;
        result.D += Q * (top * top * top - bottom * bottom * bottom) / 3.;
        result.GA += ply.stiffness()[5][5] * width * (top - bottom);
      }

    FullMatrix<double> inverse(6);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          inverse(i, j)         = result.A[i][j];
          inverse(i, j + 3)     = result.B[i][j];
          inverse(i + 3, j)     = result.B[i][j];
          inverse(i + 3, j + 3) = result.D[i][j];
        }
    // Without the row and the column of the twist, held at zero.
    FullMatrix<double> untwisted(5);
    for (unsigned int i = 0; i < 5; ++i)
      for (unsigned int j = 0; j < 5; ++j)
        untwisted(i, j) = inverse(i, j);
    untwisted.gauss_jordan();
    result.EI_untwisted = width / untwisted(3, 3);

    inverse.gauss_jordan();
    result.EA = width / inverse(0, 0);
    result.EI = width / inverse(3, 3);
    return result;
  }



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const SectionShape &shape, const Materials &materials)
  {
    return std::visit(
      [&materials](const auto &kind) {
        return make_section_mesh(kind, materials);
      },
      shape);
  }



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = {{ellipse.oriented_material.material,
                       ellipse.oriented_material.angle,
                       0.,
                       ellipse.height,
                       materials.at(ellipse.oriented_material.material)}};

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



  std::shared_ptr<const SectionMesh>
  divided(const SectionMesh &section,
          const unsigned int times,
          const std::string &what)
  {
    const double cells = std::pow(4., times) * section.mesh.n_active_cells();
    if (cells > max_section_cells)
      throw InputError(
        what + "/Cells divided",
        std::to_string(times),
        "shape.too-many-cells: the division would give " + to_text(cells) +
          " cells, more than " + to_text(max_section_cells),
        "Reduce Cells divided, or use a theory of higher order.");
    Triangulation<2> fine;
    fine.copy_triangulation(section.mesh);
    fine.refine_global(times);
    auto result        = std::make_shared<SectionMesh>();
    result->plies      = section.plies;
    result->boundaries = section.boundaries;
    GridGenerator::flatten_triangulation(fine, result->mesh);
    for (const types::manifold_id id : fine.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        result->mesh.set_manifold(id, fine.get_manifold(id));
    return result;
  }
} // namespace lamella
