// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/foot.h>
#include <lamella/contact/gap_integrals.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Adds up the points of a contact.
    class Sums
    {
    public:
      Sums(const ContactSides    &sides,
           const bool             on_second,
           const CarryingSurface *functions,
           const unsigned int     n_rows)
        : carrying(*sides.surface(on_second))
        , opposing(sides.surface(!on_second))
        , functions(functions)
        , rows(n_rows)
      {}

      void
      add(const unsigned int  number,
          const GapPoint     &point,
          const Opposition   &at,
          const Tensor<1, 3> &slid);

      std::vector<GapIntegrals>
      take();

    private:
      const MeshSurface        &carrying, *opposing;
      const CarryingSurface    *functions;
      std::vector<GapIntegrals> rows;
      std::vector<double>       trace, trace_opposite;
    };



    void
    Sums::add(const unsigned int  number,
              const GapPoint     &point,
              const Opposition   &at,
              const Tensor<1, 3> &slid)
    {
      const Tensor<1, 3>       &n     = at.normal;
      const MeshSurface::Facet &facet = carrying.facets()[point.carrying.facet];
      carrying.evaluate_trace(facet, point.carrying.st, trace);
      const std::vector<unsigned int> *beyond = nullptr;
      if (opposing != nullptr)
        {
          const auto &other = opposing->facets()[point.opposing.facet];
          opposing->evaluate_trace(other, point.opposing.st, trace_opposite);
          beyond = &other.trace_nodes;
        }
      const SymmetricTensor<2, 3> tangential =
        unit_symmetric_tensor<3>() - symmetrize(outer_product(n, n));
      const auto add_side = [&](const std::vector<unsigned int> &nodes,
                                const std::vector<double>       &values,
                                const double                     weight,
                                auto                            &sums) {
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (values[k] != 0.)
            {
              GapIntegrals::OfNode &node = sums[nodes[k]];
              node.normal += (weight * values[k]) * n;
              node.tangential += (weight * values[k]) * tangential;
            }
      };
      for (const auto &[row, weight] : shares_of(functions, number, point))
        {
          GapIntegrals &sum = rows[row];
          sum.area += weight;
          sum.gap += weight * at.hit.distance;
          sum.normal += weight * n;
          sum.slid += weight * slid;
          add_side(facet.trace_nodes, trace, weight, sum.carrying);
          if (beyond != nullptr)
            add_side(*beyond, trace_opposite, weight, sum.opposing);
        }
    }



    std::vector<GapIntegrals>
    Sums::take()
    {
      for (GapIntegrals &row : rows)
        if (row.area > 0.)
          {
            const double scale = 1. / row.area;
            row.gap *= scale;
            row.normal *= scale;
            row.slid *= scale;
            for (auto *side : {&row.carrying, &row.opposing})
              for (auto &[number, node] : *side)
                {
                  node.normal *= scale;
                  node.tangential *= scale;
                }
          }
      return std::move(rows);
    }



    /// The places that face each other where they are kept.
    std::optional<Opposition>
    kept(const ContactSides &sides,
         const MeshSurface  *opposing,
         const GapPoint     &point,
         const Point<3>     &x,
         const Tensor<1, 3> &n1,
         const double        reach)
    {
      if (opposing == nullptr)
        return opposing_place(ObstacleSurface(sides.obstacle()), x, n1, reach);
      const MeshSurface::Facet &facet =
        opposing->facets()[point.opposing.facet];
      Opposition at;
      at.hit.position = facet.map(point.opposing.st).position;
      at.hit.normal   = opposing->smooth_normal(facet, point.opposing.st);
      at.normal       = n1 - at.hit.normal;
      at.normal /= at.normal.norm();
      at.hit.distance = at.normal * (at.hit.position - x);
      at.hit.facet    = point.opposing.facet;
      at.hit.st       = point.opposing.st;
      return at;
    }



    /// The foot of @p x, from which @p point goes on.
    std::optional<Opposition>
    found(const ContactSides &sides,
          const MeshSurface  *opposing,
          GapPoint           &point,
          const Point<3>     &x,
          const Tensor<1, 3> &n1,
          const double        reach)
    {
      const auto hit =
        opposing == nullptr ?
          find_foot(*sides.obstacle(), x, n1, reach) :
          find_foot(*opposing,
                    x,
                    n1,
                    reach,
                    point.opposing,
                    sides.are_of_edges() ? edge_faces_from : faces_from_60);
      if (!hit)
        return {};
      point.opposing = {hit->facet, hit->st};
      Opposition at;
      at.hit    = *hit;
      at.normal = -hit->normal;
      return at;
    }
  } // namespace



  std::vector<std::pair<unsigned int, double>>
  shares_of(const CarryingSurface *functions,
            const unsigned int     number,
            const GapPoint        &point)
  {
    if (functions == nullptr)
      return {{number, point.area}};
    std::vector<std::pair<unsigned int, double>> result;
    const auto  phi = functions->functions_at({point.part, point.carrying.st});
    const auto &of_nodes = functions->facets()[point.part].rows;
    for (unsigned int i = 0; i < phi.size(); ++i)
      for (const auto &[row, share] : of_nodes[i])
        if (phi[i] != 0.)
          result.emplace_back(row, phi[i] * share * point.area);
    return result;
  }



  namespace
  {
    /// What @p point faces, of which it becomes the foot.
    std::optional<Opposition>
    opposition(const ContactSides &sides,
               const bool          on_second,
               const Feet          feet,
               const double        reach,
               GapPoint           &point)
    {
      const MeshSurface &carrying    = *sides.surface(on_second),
                        *opposing    = sides.surface(!on_second);
      const auto &[facet, st]        = point.carrying;
      const MeshSurface::Facet &from = carrying.facets()[facet];
      const Point<3>            x    = from.map(st).position;
      const Tensor<1, 3>        n1   = carrying.smooth_normal(from, st);
      return feet == Feet::kept ? kept(sides, opposing, point, x, n1, reach) :
                                  found(sides, opposing, point, x, n1, reach);
    }
  } // namespace



  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides    &sides,
                 const bool             on_second,
                 const CarryingSurface *functions,
                 const unsigned int     n_rows,
                 const Feet             feet,
                 const double           reach,
                 std::vector<GapPoint> &points,
                 HeldPlaces *const      held)
  {
    Sums sums(sides, on_second, functions, n_rows);
    for (unsigned int q = 0; q < points.size(); ++q)
      if (const auto at = opposition(sides, on_second, feet, reach, points[q]))
        {
          Tensor<1, 3> slid;
          if (held != nullptr && (*held)[q])
            slid = slide(sides, on_second, *(*held)[q], points[q], *at);
          else if (held != nullptr)
            (*held)[q] = held_place(sides, points[q], *at);
          sums.add(q, points[q], *at, slid);
        }
    return sums.take();
  }



  HeldPlaces
  held_places(const ContactSides    &sides,
              const bool             on_second,
              const Feet             feet,
              const double           reach,
              std::vector<GapPoint> &points)
  {
    HeldPlaces held(points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      if (const auto at = opposition(sides, on_second, feet, reach, points[q]))
        held[q] = held_place(sides, points[q], *at);
    return held;
  }
} // namespace lamella
