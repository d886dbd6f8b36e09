// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/search.h>
#include <lamella/contact/segments.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Adds up rows of one body.
    class RowSum
    {
    public:
      explicit RowSum(const DofIndex n_dofs)
        : weights(n_dofs, 0.)
        , is_touched(n_dofs, false)
      {}

      void
      add(const LinearFunctional &row, const double factor)
      {
        for (const auto &[dof, weight] : row.entries())
          {
            if (!is_touched[dof])
              touched.push_back(dof);
            is_touched[dof] = true;
            weights[dof] += factor * weight;
          }
      }

      /// The sum; it begins anew.
      LinearFunctional
      take()
      {
        std::sort(touched.begin(), touched.end());
        LinearFunctional row;
        for (const DofIndex dof : touched)
          {
            row.add(dof, weights[dof]);
            weights[dof]    = 0.;
            is_touched[dof] = false;
          }
        touched.clear();
        return row;
      }

    private:
      std::vector<double>   weights;
      std::vector<bool>     is_touched;
      std::vector<DofIndex> touched;
    };



    // Cosines between a normal and what it is to oppose. Where points touch
    // nothing but the normals tells whether they face each other; points that
    // are apart and lie along the averaged normal do, up to a steep angle.
    constexpr double opposed = min_facing_cosine, steep = 0.1;

    // As many nodes of an edge may stand at one place.
    constexpr unsigned int twins = 3;



    struct Candidate
    {
      PointPair pair;
      double    cosine = 0.;
    };



    /// The pair (i, j) if the two points face each other.
    std::optional<Candidate>
    facing(const std::vector<SurfacePoint> &first,
           const std::vector<SurfacePoint> &second,
           const unsigned int               i,
           const unsigned int               j,
           const double                     tolerance,
           const double                     search_radius)
    {
      const SurfacePoint &a = first[i], &b = second[j];
      const Tensor<1, 3>  sum = a.normal - b.normal;
      if (sum.norm() <= 2. * steep)
        return {};
      Candidate candidate;
      candidate.pair = {i, j, sum / sum.norm(), 0.};
      // |n_1 - n_2| / 2 is the cosine of the angle between n_1 and n.
      candidate.cosine           = 0.5 * sum.norm();
      const Tensor<1, 3> &n      = candidate.pair.normal;
      const Tensor<1, 3>  d      = b.position - a.position;
      const double        offset = (d - (d * n) * n).norm();
      const double close = tolerance * std::sqrt(std::min(a.area, b.area));
      if (offset > close || d.norm() > search_radius ||
          (d.norm() <= close && a.normal * b.normal >= -opposed))
        return {};
      candidate.pair.initial_gap = d * n;
      return candidate;
    }



    /// All candidates for the point @p i: among the points nearest to it, or
    /// else (steep slopes that are apart) among all.
    void
    add_candidates(const std::vector<SurfacePoint> &first,
                   const std::vector<SurfacePoint> &second,
                   const unsigned int               i,
                   const std::vector<unsigned int> &nearest,
                   const double                     tolerance,
                   const double                     search_radius,
                   std::vector<Candidate>          &candidates)
    {
      bool found = false;
      for (const unsigned int j : nearest)
        if (const auto one =
              facing(first, second, i, j, tolerance, search_radius))
          {
            candidates.push_back(*one);
            found = true;
          }
      for (unsigned int j = 0; !found && j < second.size(); ++j)
        if (const auto one =
              facing(first, second, i, j, tolerance, search_radius))
          candidates.push_back(*one);
    }



    /// What to tell if nothing pairs.
    void
    update_nearest(const SurfacePoint &a,
                   const SurfacePoint &b,
                   Pairing            &result)
    {
      const Tensor<1, 3> d    = b.position - a.position;
      result.nearest_distance = std::min(result.nearest_distance, d.norm());
      if (a.normal * b.normal < -opposed)
        {
          const Tensor<1, 3> sum = a.normal - b.normal, n = sum / sum.norm();
          result.smallest_offset =
            std::min(result.smallest_offset, (d - (d * n) * n).norm());
        }
    }



    /// The gap of the slave node @p point; its place has the next number in
    /// @p result, and that of the place opposite, if that is on a mesh.
    WeightedGap
    gap_at(const SurfacePoint &point,
           const MasterPoint  &facing,
           const MeshSurface  *master,
           Gaps               &result)
    {
      const SurfaceHit &hit = facing.hit;
      WeightedGap       gap;
      gap.node          = point.location;
      gap.position      = point.position;
      gap.opposite      = hit.position;
      gap.normal        = facing.normal;
      gap.area          = point.area;
      gap.spacing       = std::sqrt(point.area);
      gap.gap           = hit.distance;
      gap.angle         = facing.angle;
      gap.slave         = {point.normal_modulus, point.area, point.depth};
      gap.master        = gap.slave;
      gap.slave_weights = {
        {static_cast<unsigned int>(result.slave.size()), facing.normal}};
      result.slave.push_back(point.location);
      if (master == nullptr)
        return gap;
      const MeshSurface::Facet &facet = master->facets()[hit.facet];
      gap.master         = {facet.normal_modulus, point.area, facet.depth};
      gap.master_weights = {
        {static_cast<unsigned int>(result.master.size()), facing.normal}};
      result.master.push_back(
        master->body().surface_point(facet.side, hit.st).location);
      return gap;
    }



    std::optional<MasterPoint>
    master_point_for(const ContactSurfacePair &sides, const SurfacePoint &point)
    {
      if (!sides.edge_contact)
        return find_master_point(*sides.master,
                                 point.position,
                                 point.normal,
                                 sides.search_radius);
      const auto projection = closest_point_projection(*sides.master_mesh,
                                                       point.position,
                                                       point.normal,
                                                       sides.search_radius,
                                                       {},
                                                       min_facing_cosine_edge);
      if (!projection)
        return {};
      MasterPoint at;
      at.hit    = *projection;
      at.normal = -projection->normal;
      // It may be a little beyond the rim, where no place of the body is.
      for (unsigned int a = 0; a < 2; ++a)
        at.hit.st[a] = std::clamp(projection->st[a], 0., 1.);
      at.hit.position =
        sides.master_mesh->facets()[projection->facet].map(at.hit.st).position;
      return at;
    }



    bool
    is_in(const Body &body, const BoundingBox<3> &box, const Point<3> &x)
    {
      return box.point_inside(x) && !body.locate({x})[0].empty();
    }



    /// The first of @p places of which one side is in the body (or the
    /// obstacle) of the other; null if there is none.
    const DeepPenetration *
    first_inside(const ContactPair                  &contact,
                 const Bodies                       &bodies,
                 const bool                          on_second,
                 const std::vector<DeepPenetration> &places)
    {
      if (places.empty())
        return nullptr;
      const Body
        &slave = *bodies[(on_second ? contact.second : contact.first).body],
        &other =
          *bodies[(on_second || contact.obstacle != nullptr ? contact.first :
                                                              contact.second)
                    .body];
      const BoundingBox<3> box          = slave.bounding_box(),
                           box_of_other = other.bounding_box();
      for (const DeepPenetration &place : places)
        if (is_in(slave, box, place.opposite) ||
            (contact.obstacle != nullptr ?
               contains(*contact.obstacle, place.position) :
               is_in(other, box_of_other, place.position)))
          return &place;
      return nullptr;
    }
  } // namespace



  std::vector<BodyFunctional>
  body_rows(const unsigned int                                index,
            const DofIndex                                    n_dofs,
            const std::vector<std::vector<LinearFunctional>> &at,
            const ConstraintGeometry                         &side)
  {
    RowSum                      sum(n_dofs);
    std::vector<BodyFunctional> rows;
    for (const ConstraintGeometry::Weights &weights : side.weights)
      {
        for (const auto &[k, w] : weights)
          for (unsigned int c = 0; c < 3; ++c)
            sum.add(at[k][c], w[c]);
        rows.push_back({index, sum.take()});
      }
    return rows;
  }



  Pairing
  pair_node_to_node(const std::vector<SurfacePoint> &first,
                    const std::vector<SurfacePoint> &second,
                    const double                     tolerance,
                    const double                     search_radius)
  {
    std::vector<Point<3>> positions;
    for (const SurfacePoint &point : second)
      positions.push_back(point.position);
    const PointSearch search(positions);

    Pairing result;
    result.nearest_distance = std::numeric_limits<double>::max();
    result.smallest_offset  = std::numeric_limits<double>::max();
    std::vector<Candidate> candidates;
    for (unsigned int i = 0; i < first.size(); ++i)
      {
        const auto nearest = search.nearest(first[i].position, twins);
        for (const unsigned int j : nearest)
          update_nearest(first[i], second[j], result);
        add_candidates(
          first, second, i, nearest, tolerance, search_radius, candidates);
      }
    std::stable_sort(candidates.begin(),
                     candidates.end(),
                     [](const Candidate &a, const Candidate &b) {
                       const double p = std::abs(a.pair.initial_gap),
                                    q = std::abs(b.pair.initial_gap);
                       return p != q ? p < q : a.cosine > b.cosine;
                     });
    std::vector<bool> first_done(first.size(), false),
      second_done(second.size(), false);
    for (const Candidate &candidate : candidates)
      if (!first_done[candidate.pair.first] &&
          !second_done[candidate.pair.second])
        {
          result.pairs.push_back(candidate.pair);
          first_done[candidate.pair.first]   = true;
          second_done[candidate.pair.second] = true;
        }
    std::sort(result.pairs.begin(),
              result.pairs.end(),
              [](const PointPair &a, const PointPair &b) {
                return a.first < b.first;
              });
    result.unpaired        = first.size() - result.pairs.size();
    result.unpaired_second = second.size() - result.pairs.size();
    return result;
  }



  bool
  exceeds_cell_depth(const double gap,
                     const double depth_1,
                     const double depth_2)
  {
    return -gap > std::min(depth_1, depth_2);
  }



  bool
  exceeds_cell_depth(const ContactSurfacePair &sides,
                     const SurfaceHit         &hit,
                     const double              depth)
  {
    return sides.master_mesh == nullptr ?
             -hit.distance > std::max(depth, sides.max_obstacle_depth) :
             exceeds_cell_depth(hit.distance,
                                depth,
                                sides.master_mesh->facets()[hit.facet].depth);
  }



  Gaps
  pair_node_to_surface(const ContactSurfacePair        &sides,
                       const std::vector<SurfacePoint> &points)
  {
    Gaps result;
    for (const SurfacePoint &point : points)
      {
        const auto facing = master_point_for(sides, point);
        if (!facing)
          {
            ++result.unpaired;
            continue;
          }
        const SurfaceHit &hit = facing->hit;
        if (exceeds_cell_depth(sides, hit, point.depth))
          {
            result.deep_penetrations.push_back(
              {point.position, hit.position, -hit.distance});
            continue;
          }
        result.gaps.push_back(
          gap_at(point, *facing, sides.master_mesh, result));
      }
    return result;
  }



  unsigned int
  count_unpaired_nodes(const MeshSurface   &a,
                       const MasterSurface &b,
                       const double         search_radius)
  {
    unsigned int count = 0;
    for (const MeshSurface::GridNode &node : a.grid_nodes())
      count += !find_master_point(b, node.position, node.normal, search_radius);
    return count;
  }



  double
  count_facing_cells(const MeshSurface &a,
                     const MeshSurface &b,
                     const double       search_radius)
  {
    double cells = 0.;
    for (const MeshSurface::Facet &facet : a.facets())
      {
        const auto facing =
          find_master_point(b, facet.center, facet.normal, search_radius);
        const ChordPlane plane(facet.side.corners, facet.normal);
        double           covered = 0.;
        for (const Segment &segment : cut(
               plane, facing ? facing->normal : facet.normal, b, search_radius))
          covered += segment.area;
        cells += std::min(1., covered / plane.area) * facet.side.degree_s *
                 facet.side.degree_t;
      }
    return cells;
  }



  void
  throw_no_pairs(const ContactPair &contact,
                 const Bodies      &bodies,
                 const double       search_radius)
  {
    const auto points = [&bodies](const Region &region) {
      return bodies[region.body]->surface_points(region.surface);
    };
    const std::string path = "Contact " + contact.name;
    if (contact.obstacle != nullptr)
      throw InputError(
        path,
        "",
        "contact.no-pairs: no point of First faces the obstacle '" +
          contact.obstacle->name + "' within the search distance " +
          to_text(search_radius) + " along its normal",
        "Check the surface in First and the position of the obstacle.");
    const bool to_node = contact.discretization == Discretization::node_to_node;
    const Pairing pairing = pair_node_to_node(points(contact.first),
                                              points(contact.second),
                                              contact.tolerance);
    std::string   nearest = "The nearest two nodes are " +
                          to_text(pairing.nearest_distance) + " apart";
    if (to_node && pairing.smallest_offset < std::numeric_limits<double>::max())
      nearest += ", the smallest tangential offset of opposed surfaces is " +
                 to_text(pairing.smallest_offset);
    const std::string check = ". Name two surfaces that face each other";
    if (to_node)
      throw InputError(
        path,
        "",
        "contact.no-pairs: node to node contact finds no nodes of First and "
        "Second that face each other",
        nearest + check +
          " and have the same nodes (Cells across, Axis elements, Axis nodes), "
          "or write Discretization = surface to surface.");
    throw InputError(
      path,
      "",
      "contact.no-pairs: no points of First and Second face each other within "
      "the search distance " +
        to_text(search_radius) + " along their normals",
      nearest + check + ".");
  }



  void
  check_no_penetration(const ContactPair &contact,
                       const Bodies      &bodies,
                       const bool         on_second,
                       const Gaps        &gaps)
  {
    const auto refuse = [&](const DeepPenetration &place,
                            const std::string     &how,
                            const std::string     &remedy) {
      throw InputError(
        "Contact " + contact.name,
        "",
        "contact.surface-behind: the surface '" + contact.first.surface +
          "' in First lies " + to_text(place.behind) + " behind '" +
          (contact.obstacle != nullptr ? contact.obstacle->name :
                                         contact.second.surface) +
          "' in Second, at " +
          to_text(on_second ? place.opposite : place.position) + how,
        remedy);
    };
    if (const DeepPenetration *place =
          first_inside(contact, bodies, on_second, gaps.deep_penetrations))
      refuse(
        *place,
        ", more than the depth of the cells there: the bodies overlap",
        "Move the bodies apart, or choose two surfaces that face each other.");
    if (gaps.gaps.empty() && !gaps.deep_penetrations.empty())
      refuse(
        gaps.deep_penetrations.front(),
        "",
        "Choose two surfaces that face each other, or move the bodies apart.");
  }
} // namespace lamella
