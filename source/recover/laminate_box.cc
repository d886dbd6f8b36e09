// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/body/surface_topology.h>
#include <lamella/recover/interlaminar.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of lengths, what is rounding.
    constexpr double rounding = arithmetic::same_position_across;



    [[noreturn]] void
    refuse(const Body &body, const std::string &path, const std::string &why)
    {
      throw InputError(
        path,
        name_of(StressValues::equilibrium),
        "recover.not-a-laminate: Stress = equilibrium needs a beam whose "
        "section is a laminate or a rectangle, but body '" +
          body.name() + "' " + why,
        "Write Stress = recovered, nodal or element.");
    }



    /// Refuses solids, plies that do not lie level, and heat.
    void
    refuse_kind(const Body &body, const std::string &path)
    {
      if (body.is_nodal())
        refuse(body, path, "is a solid");
      for (const Ply &ply : body.plies())
        if (ply.plane.normal_at || ply.plane.normal != Point<2>(0., 1.))
          refuse(body, path, "has inclined plies");
      if (body.is_heated())
        throw InputError(
          path,
          name_of(StressValues::equilibrium),
          "recover.equilibrium-with-heat: stresses by equilibrium do not "
          "include thermal expansion, but body '" +
            body.name() + "' has a Temperature",
          "Write Stress = recovered, nodal or element.");
    }



    /// The one outward normal of @p surface.
    Tensor<1, 3>
    plane_normal(const Body        &body,
                 const std::string &surface,
                 const std::string &path)
    {
      Tensor<1, 3> normal;
      for (const SurfaceFacet &facet : surface_facets(body, surface))
        for (const double s : {0., 0.5, 1.})
          {
            const Tensor<1, 3> n =
              body.surface_point(facet, Point<2>(s, 0.5)).normal;
            if (normal.norm() == 0.)
              normal = n;
            if ((n - normal).norm() > rounding)
              refuse(body, path, "has a " + surface + " that is not plane");
          }
      if (normal.norm() == 0.)
        refuse(body, path, "has no surface '" + surface + "'");
      return normal;
    }



    /// A facet of the section at the start, as @p frame has it: x and z.
    struct FacetInFrame
    {
      const Body         &body;
      const Placement    &frame;
      const SurfaceFacet &facet;

      std::vector<Point<2>>
      corners() const
      {
        std::vector<Point<2>> all;
        for (const Point<3> &corner : facet.corners)
          {
            const Point<3> x = frame.to_body(corner);
            all.emplace_back(x[0], x[2]);
          }
        return all;
      }

      Point<2>
      place(const double s, const double t) const
      {
        const Point<3> x =
          frame.to_body(body.surface_point(facet, Point<2>(s, t)).position);
        return Point<2>(x[0], x[2]);
      }

      /// Whether it fills the box @p cell of its corners, with straight sides.
      bool
      is_rectangle(const BoundingBox<2> &cell) const
      {
        const auto [low, high] = cell.get_boundary_points();
        const double near      = rounding * low.distance(high);
        const auto   corners   = this->corners();
        bool         is_one    = true;
        for (const Point<2> &corner : corners)
          for (unsigned int d = 0; d < 2; ++d)
            is_one &= std::min(corner[d] - low[d], high[d] - corner[d]) < near;
        for (const double s : {0., 0.5, 1.})
          for (const double t : {0., 0.5, 1.})
            {
              Point<2> straight;
              for (unsigned int k = 0; k < 4; ++k)
                straight += (k % 2 == 0 ? 1. - s : s) *
                            (k / 2 == 0 ? 1. - t : t) * corners[k];
              is_one &= straight.distance(place(s, t)) < near;
            }
        return is_one;
      }
    };



    /// The cells of the section at the start, as ranges of x and z in
    /// @p frame; refuses what is no rectangle along its axes.
    std::vector<BoundingBox<2>>
    rectangles(const Body        &body,
               const Placement   &frame,
               const std::string &path)
    {
      std::vector<BoundingBox<2>> cells;
      for (const SurfaceFacet &facet : surface_facets(body, "start"))
        {
          const FacetInFrame   in_frame{body, frame, facet};
          const BoundingBox<2> cell(in_frame.corners());
          if (!in_frame.is_rectangle(cell))
            refuse(body, path, "has section cells that are no rectangles");
          cells.push_back(cell);
        }
      return cells;
    }



    /// Refuses a section, with the cells @p cells in @p frame, that has
    /// different plies at one height.
    void
    check_stacked_plies(const Body                        &body,
                        const Placement                   &frame,
                        const std::vector<BoundingBox<2>> &cells,
                        const std::string                 &path)
    {
      const double y =
        frame.to_body(surface_facets(body, "start")[0].corners[0])[1];
      std::vector<Point<3>> middles;
      for (const BoundingBox<2> &cell : cells)
        middles.push_back(
          frame.to_scene({cell.center()[0], y, cell.center()[1]}));
      const auto found = body.locate(middles);
      for (unsigned int a = 0; a < cells.size(); ++a)
        for (unsigned int b = 0; b < a; ++b)
          {
            const double overlap =
              std::min(cells[a].upper_bound(1), cells[b].upper_bound(1)) -
              std::max(cells[a].lower_bound(1), cells[b].lower_bound(1));
            if (overlap > rounding * cells[a].side_length(1) &&
                found[a].front().ply != found[b].front().ply)
              refuse(body, path, "has plies side by side");
          }
    }
  } // namespace



  LaminateBox
  laminate_box(const Body &body, const std::string &path)
  {
    refuse_kind(body, path);
    const Tensor<1, 3> up    = plane_normal(body, "top", path),
                       along = plane_normal(body, "end", path);
    if ((plane_normal(body, "bottom", path) + up).norm() > rounding)
      refuse(body, path, "has a bottom and a top that are not parallel");
    LaminateBox box;
    box.frame        = Placement::from_directions(Point<3>(), along, up);
    const auto cells = rectangles(body, box.frame, path);

    check_stacked_plies(body, box.frame, cells, path);
    std::vector<Point<2>> corners;
    double                area = 0.;
    for (const BoundingBox<2> &cell : cells)
      {
        corners.push_back(cell.get_boundary_points().first);
        corners.push_back(cell.get_boundary_points().second);
        area += cell.volume();
      }
    const BoundingBox<2> all(corners);
    if (std::abs(all.volume() - area) > rounding * area)
      refuse(body, path, "has a section with gaps or reentrant corners");
    const auto [low, high] = all.get_boundary_points();
    const double y0 =
      box.frame.to_body(surface_facets(body, "start")[0].corners[0])[1];
    const double y1 =
      box.frame.to_body(surface_facets(body, "end")[0].corners[0])[1];
    box.frame.origin = box.frame.to_scene({low[0], y0, low[1]});
    box.size         = Point<3>(high[0] - low[0], y1 - y0, high[1] - low[1]);
    return box;
  }
} // namespace lamella
