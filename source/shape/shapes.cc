// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

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
      operator()(const Tube &) const
      {
        return ShapeKind::tube;
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
    single_ply(const OrientedMaterial &oriented_material,
               const double            top,
               const Materials        &materials)
    {
      return {oriented_material.material,
              oriented_material.angle,
              0.,
              top,
              materials.at(oriented_material.material)};
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



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const Ellipse &ellipse, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = {
      single_ply(ellipse.oriented_material, ellipse.height, materials)};

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
