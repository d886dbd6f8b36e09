// SPDX-License-Identifier: LGPL-2.1-or-later

// The mesh of a half disc, graded towards a point P of its arc: half a
// butterfly at P, rings around it, and a block between the last ring and the
// flat side. It is made for P = i on the half of the unit disc with Im > 0, and
// then carried to where P is due by the conformal map of the half disc onto
// itself, z -> (z + b) / (1 + b z), b = (c - 1) / (c + 1), c = cot(angle / 2),
// under which small cells keep their shape, the corners stay, and arc and flat
// side are mapped onto themselves.

#include <lamella/base/arithmetic.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <complex>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /// The mesh for P = i on the unit disc.
    class GradedHalfDisc
    {
    public:
      GradedHalfDisc(const unsigned int sectors, const double finest_cell)
        : sectors(sectors)
        , half(sectors / 4)
        , core_width(std::min(half * finest_cell, last_radius / 1.6))
      {
        add_rest(add_rings(add_core()));
      }

      std::vector<Complex>     points;
      std::vector<CellData<2>> cells;

    private:
      /// Numbers of points from +x to -x, around P.
      using Ring = std::vector<unsigned int>;

      /// The radius of the last ring, and the part of its half width by which
      /// the corners of the core stay behind those of a rectangle.
      static constexpr double last_radius = 0.6, rounding = 0.15;

      /// The point at @p x along the tangent at P and @p depth below it, bent
      /// so that depth 0 is the arc: a point as far from P, on a ring.
      static Complex
      bent(const double x, const double depth)
      {
        const double radius = std::hypot(x, depth);
        const double sunk   = std::asin(0.5 * radius);
        const double angle =
          sunk + (numbers::PI - 2. * sunk) * std::atan2(depth, x) / numbers::PI;
        return Complex(0., 1.) +
               radius * Complex(std::cos(angle), -std::sin(angle));
      }

      /// x + i depth of the core's point (i, j), |i| <= half, 0 <= j <= half.
      Complex
      core_point(const int i, const int j) const
      {
        const double x = double(i) / half, depth = double(j) / half;
        return core_width * Complex(x * (1. - rounding * depth),
                                    depth * (1. - rounding * std::abs(x)));
      }

      /// From +x to -x, around P.
      std::vector<Complex>
      core_outline() const
      {
        std::vector<Complex> outline;
        for (int j = 0; j < half; ++j)
          outline.push_back(core_point(half, j));
        for (int i = half; i > -half; --i)
          outline.push_back(core_point(i, half));
        for (int j = half; j >= 0; --j)
          outline.push_back(core_point(-half, j));
        return outline;
      }

      Ring
      add_ring(const std::vector<Complex> &ring)
      {
        Ring numbers;
        for (const Complex &point : ring)
          {
            numbers.push_back(points.size());
            points.push_back(point);
          }
        return numbers;
      }

      /// The ring of points x + i depth of @p flat, with cells to @p inner.
      Ring
      add_bent_ring(const std::vector<Complex> &flat, const Ring &inner)
      {
        std::vector<Complex> ring;
        for (const Complex &p : flat)
          ring.push_back(bent(p.real(), p.imag()));
        Ring outer = add_ring(ring);
        add_cells_between(inner, outer);
        return outer;
      }

      void
      add_cells_between(const Ring &inner, const Ring &outer)
      {
        for (unsigned int l = 0; l + 1 < inner.size(); ++l)
          {
            cells.emplace_back();
            cells.back().vertices = {outer[l + 1],
                                     outer[l],
                                     inner[l + 1],
                                     inner[l]};
          }
      }

      Ring
      add_core()
      {
        // Rows of points from the arc downwards, each from -x to +x.
        std::vector<Ring> rows;
        for (int j = 0; j <= half; ++j)
          {
            std::vector<Complex> row;
            for (int i = half; i >= -half; --i)
              {
                const Complex p = core_point(i, j);
                row.push_back(bent(p.real(), p.imag()));
              }
            rows.push_back(add_ring(row));
            if (j > 0)
              add_cells_between(rows[j - 1], rows[j]);
          }
        Ring outline;
        for (int j = 0; j < half; ++j)
          outline.push_back(rows[j].front());
        outline.insert(outline.end(), rows[half].begin(), rows[half].end());
        for (int j = half - 1; j >= 0; --j)
          outline.push_back(rows[j].back());
        return outline;
      }

      Ring
      add_rings(Ring inner)
      {
        const auto on_circle = [this](const unsigned int l) {
          return std::polar(1., numbers::PI * l / sectors);
        };

        // From the outline of the core to a circle.
        const std::vector<Complex> outline      = core_outline();
        const double               first_radius = 1.6 * core_width;
        const unsigned int n_blended = std::max(1., std::round(sectors / 8.));
        for (unsigned int k = 1; k <= n_blended; ++k)
          {
            std::vector<Complex> flat;
            const double         t = double(k) / n_blended;
            for (unsigned int l = 0; l <= sectors; ++l)
              flat.push_back((1. - t) * outline[l] +
                             t * first_radius * on_circle(l));
            inner = add_bent_ring(flat, inner);
          }

        // A sector is as wide as deep at the ratio exp(pi / sectors).
        const double growth =
          std::min(1.6, std::max(1.3, std::exp(numbers::PI / sectors)));
        const double       span = std::log(last_radius / first_radius);
        const unsigned int n =
          span < 1e-3 ? 0 : std::max(1., std::round(span / std::log(growth)));
        for (unsigned int k = 1; k <= n; ++k)
          {
            std::vector<Complex> flat;
            for (unsigned int l = 0; l <= sectors; ++l)
              flat.push_back(first_radius * std::exp(k * span / n) *
                             on_circle(l));
            inner = add_bent_ring(flat, inner);
          }
        return inner;
      }

      void
      add_rest(const Ring &inner)
      {
        // Transfinite interpolation between the last ring, the flat side and
        // the two pieces of the arc between their ends.
        const unsigned int n_layers = std::max(1u, sectors / 4);
        const double       first    = std::arg(points[inner.front()]);
        const Complex      right    = points[inner.front()],
                      left          = points[inner.back()];
        Ring below                  = inner;
        for (unsigned int k = 1; k <= n_layers; ++k)
          {
            const double  v     = double(k) / n_layers;
            const Complex arc_r = std::polar(1., first * (1. - v)),
                          arc_l(-arc_r.real(), arc_r.imag());
            std::vector<Complex> ring;
            for (unsigned int l = 0; l <= sectors; ++l)
              {
                const double u = double(l) / sectors;
                ring.push_back((1. - v) * points[inner[l]] + v * (1. - 2. * u) +
                               (1. - u) * (arc_r - (1. - v) * right - v) +
                               u * (arc_l - (1. - v) * left + v));
              }
            const Ring outer = add_ring(ring);
            add_cells_between(below, outer);
            below = outer;
          }
      }

      unsigned int sectors;
      int          half;
      double       core_width;
    };



    /// The vertices and cells of @p disc, graded towards where it says.
    std::pair<std::vector<Point<2>>, std::vector<CellData<2>>>
    graded_cells(const HalfDisc &disc)
    {
      // The map shrinks lengths at P by the sine of the angle.
      const double   angle = disc.graded_towards * numbers::PI / 180.;
      const double   c = 1. / std::tan(0.5 * angle), b = (c - 1.) / (c + 1.);
      GradedHalfDisc graded(disc.sectors,
                            disc.finest_cell / disc.radius / std::sin(angle));
      std::vector<Point<2>> vertices;
      for (const Complex &z : graded.points)
        {
          Complex    w = (z + b) / (1. + b * z);
          const bool on_arc =
            std::abs(std::abs(z) - 1.) < arithmetic::rounding_of_results;
          w /= on_arc ? std::abs(w) : 1.;
          vertices.emplace_back(disc.radius * (1. + w.real()),
                                std::abs(z.imag()) <
                                    arithmetic::rounding_of_results ?
                                  0. :
                                  disc.radius * w.imag());
        }
      return {vertices, graded.cells};
    }
  } // namespace



  std::shared_ptr<const SectionMesh>
  make_section_mesh(const HalfDisc &disc, const Materials &materials)
  {
    auto section   = std::make_shared<SectionMesh>();
    section->plies = {{disc.oriented_material.material,
                       disc.oriented_material.angle,
                       0.,
                       disc.radius,
                       materials.at(disc.oriented_material.material)}};

    auto [vertices, cells] = graded_cells(disc);
    GridTools::consistently_order_cells(cells);
    Triangulation<2> &mesh = section->mesh;
    mesh.create_triangulation(vertices, cells, SubCellData());

    section->boundaries = {{0, "arc"}, {1, "flat"}};
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        {
          const bool flat =
            face->vertex(0)[1] == 0. && face->vertex(1)[1] == 0.;
          face->set_boundary_id(flat ? 1 : 0);
          face->set_manifold_id(flat ? numbers::flat_manifold_id : 0);
        }
    mesh.set_manifold(0, SphericalManifold<2>(Point<2>(disc.radius, 0.)));
    return section;
  }
} // namespace lamella
