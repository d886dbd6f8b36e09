// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/body/surface_topology.h>
#include <lamella/recover/plausibility.h>

#include <boost/geometry/index/rtree.hpp>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Fibers, resins and metals fail at smaller strains than the first; no
    // intended load causes strains below the second.
    constexpr double large_strain = 0.02, small_strain = arithmetic::negligible;
    constexpr std::size_t enough = 500;
    // Share of the depth of the cell below: bodies side by side bulge by a
    // thousandth of their thickness.
    constexpr double deep = 0.1;
  } // namespace



  Plausibility::Plausibility(const Structure                     &structure,
                             const Units                         &units,
                             const std::vector<ContactInterface> &interfaces)
    : structure(structure)
    , bodies(structure.bodies())
    , units(units)
  {
    for (const ContactInterface &contact : interfaces)
      if (contact.second_body)
        contacts.insert(std::minmax(contact.first_body, *contact.second_body));
  }



  std::vector<SurfacePoint>
  Plausibility::sample_nodes(const unsigned int b) const
  {
    const std::vector<SurfacePoint> points = bodies[b]->surface_points("all");
    std::vector<SurfacePoint>       some;
    for (std::size_t k = 0; k < points.size(); k += points.size() / enough + 1)
      some.push_back(points[k]);
    return some;
  }



  std::vector<SurfacePoint>
  Plausibility::face_points(const unsigned int b) const
  {
    // Interior points of facets, three each way, since sides may be flush.
    const std::vector<SurfaceFacet> facets = surface_facets(*bodies[b], "all");
    const std::size_t               stride = 9 * facets.size() / enough + 1;
    std::vector<SurfacePoint>       points;
    for (std::size_t k = 0; k < 9 * facets.size(); k += stride)
      {
        const std::size_t row = k % 9 / 3;
        points.push_back(bodies[b]->surface_point(
          facets[k / 9], {(1 + 2 * row) / 6., (1 + 2 * (k % 3)) / 6.}));
      }
    return points;
  }



  double
  Plausibility::depth(const Point<3> &X, const unsigned int b) const
  {
    // The nearest point may belong to the adjacent side.
    constexpr double    around = 2.;
    const SurfacePoint &there =
      *std::min_element(faces[b].begin(),
                        faces[b].end(),
                        [&X](const SurfacePoint &one, const SurfacePoint &two) {
                          return one.position.distance_square(X) <
                                 two.position.distance_square(X);
                        });
    const double reach = around * there.position.distance(X);
    double       least = reach;
    for (const SurfacePoint &point : faces[b])
      if (const Tensor<1, 3> d = point.position - X; d.norm() <= reach)
        least = std::min(least, std::abs(d * point.normal));
    return least > deep * there.depth ? least : 0.;
  }



  Plausibility::Extreme
  Plausibility::deepest(const CurrentBody &a,
                        const CurrentBody &b,
                        const unsigned int number_of_b,
                        const Vector      &u) const
  {
    constexpr unsigned int iterations = 6;
    const Body            &body       = *bodies[number_of_b];
    std::vector<Point<3>>  x, X;
    const auto             tree = pack_rtree_of_indices(b.places);
    for (const Point<3> &place : a.places)
      if (b.box.point_inside(place))
        {
          const auto k =
            *tree.qbegin(boost::geometry::index::nearest(place, 1));
          x.push_back(place);
          X.push_back(faces[number_of_b][k].position -
                      transpose(b.rotations[k]) * (b.places[k] - place));
        }
    for (unsigned int i = 0; i < iterations && !x.empty(); ++i)
      {
        const auto            found = body.locate(X);
        std::vector<Point<3>> x_inside, X_inside;
        for (unsigned int k = 0; k < x.size(); ++k)
          if (!found[k].empty())
            {
              const FieldSample at = body.sample(found[k].front(), u);
              x_inside.push_back(x[k]);
              X_inside.push_back(X[k] - transpose(at.rotation) *
                                          (X[k] + at.displacement - x[k]));
            }
        x = x_inside;
        X = X_inside;
      }
    Extreme    found;
    const auto inside = body.locate(X);
    for (unsigned int k = 0; k < x.size(); ++k)
      if (!inside[k].empty())
        found.take(depth(X[k], number_of_b), x[k]);
    return found;
  }



  bool
  Plausibility::are_nested(const Body &a, const Body &b) const
  {
    std::vector<Point<3>> middles;
    const unsigned int    n = a.cells().n;
    for (unsigned int cell = 0; cell < n; cell += n / enough + 1)
      middles.push_back(a.position({cell, Point<3>(0.5, 0.5, 0.5)}));
    const auto found = b.locate(middles);
    return std::any_of(found.begin(), found.end(), [](const auto &at) {
      return !at.empty();
    });
  }



  void
  Plausibility::add_overlaps(const std::vector<CurrentBody> &moved,
                             const BlockVector              &u,
                             std::vector<std::string>       &sentences) const
  {
    Extreme                               worst;
    std::pair<unsigned int, unsigned int> who;
    unsigned int                          n_pairs = 0;
    for (unsigned int a = 0; a < moved.size(); ++a)
      for (unsigned int b = a + 1; b < moved.size(); ++b)
        if (contacts.count({a, b}) == 0 &&
            moved[a].box.get_neighbor_type(moved[b].box) !=
              NeighborType::not_neighbors)
          {
            const Extreme one   = deepest(moved[a], moved[b], b, u.block(b)),
                          other = deepest(moved[b], moved[a], a, u.block(a)),
                          &most = one.value > other.value ? one : other;
            if (most.value == 0. || are_nested(*bodies[a], *bodies[b]) ||
                are_nested(*bodies[b], *bodies[a]))
              continue;
            ++n_pairs;
            if (most.value > worst.value)
              {
                worst = most;
                who   = {a, b};
              }
          }
    if (n_pairs > 0)
      sentences.push_back(
        "recover.overlap-without-contact: bodies " + bodies[who.first]->name() +
        " and " + bodies[who.second]->name() + " overlap by " +
        to_text(worst.value, 2) +
        (units.length.empty() ? "" : " " + units.length) + " at " +
        to_text(worst.place) +
        (n_pairs > 1 ?
           ", and so do " + std::to_string(n_pairs - 1) + " other pairs" :
           "") +
        ": these bodies have no contact, so they penetrate each other. Add a "
        "Contact of the two surfaces");
  }



  Plausibility::CurrentBody
  Plausibility::make_current_body(const Vector                    &u,
                                  const unsigned int               b,
                                  const std::vector<SurfacePoint> &points) const
  {
    CurrentBody moved;
    for (const SurfacePoint &point : points)
      {
        const FieldSample at = bodies[b]->sample(point.location, u);
        for (unsigned int c = 0; c < 6; ++c)
          moved.strain.take(std::abs(at.strain[c]), point.position);
        moved.displacement.take(at.displacement.norm(), point.position);
        moved.places.push_back(point.position + at.displacement);
        moved.rotations.push_back(at.rotation);
      }
    moved.box = BoundingBox<3>(moved.places);
    return moved;
  }



  void
  Plausibility::add_unit_warnings(const std::vector<CurrentBody> &moved,
                                  const bool                      is_rigid,
                                  std::vector<std::string> &sentences) const
  {
    const std::string remedy =
      ". Check loads and displacements, and that all numbers are in Units = " +
      units.length + ", " + units.force + " (stresses in " + units.stress + ")";
    double largest = 0.;
    for (unsigned int b = 0; b < moved.size(); ++b)
      {
        const Body    &body         = *bodies[b];
        const Extreme &strain       = moved[b].strain,
                      &displacement = moved[b].displacement;
        largest                     = std::max(largest, strain.value);
        // Body::size() is half the largest extension.
        const double length = 2. * body.size();
        if (strain.value > large_strain)
          sentences.push_back(
            "recover.implausible-strain: strains of body " + body.name() +
            " reach " + to_text(100. * strain.value, 2) + " % at " +
            to_text(strain.place) +
            "; few solids are linear elastic beyond 2 %" + remedy);
        if (displacement.value > length)
          sentences.push_back(
            "recover.implausible-displacement: body " + body.name() +
            " moves by " + to_text(displacement.value, 3) + " " + units.length +
            " at " + to_text(displacement.place) +
            ", more than the length of the body, " + to_text(length, 3) + " " +
            units.length + remedy);
      }
    if (!is_rigid && largest < small_strain && largest > arithmetic::rounding)
      sentences.push_back("recover.implausible-strain: strains are at most " +
                          to_text(largest, 2) +
                          "; realistic loads cause larger strains" + remedy);
  }



  void
  Plausibility::add_rigid_motion(const std::vector<CurrentBody> &moved,
                                 std::vector<std::string> &sentences) const
  {
    const auto farthest =
      std::max_element(moved.begin(),
                       moved.end(),
                       [](const CurrentBody &a, const CurrentBody &b) {
                         return a.displacement.value < b.displacement.value;
                       });
    const bool is_driven = std::any_of(structure.prescribed().begin(),
                                       structure.prescribed().end(),
                                       [](const PrescribedFunctional &row) {
                                         return row.value != 0. || row.rotation;
                                       });
    if (!is_driven && !structure.is_heated() &&
        farthest->displacement.value >
          arithmetic::decimal_tolerance * structure.size())
      sentences.push_back(
        "recover.rigid-motion: body " +
        bodies[farthest - moved.begin()]->name() + " moves by " +
        to_text(farthest->displacement.value, 3) + " at " +
        to_text(farthest->displacement.place) +
        " without strains: no support or contact prevents this rigid-body "
        "motion. Check the positions of contacts and supports");
  }



  std::vector<std::string>
  Plausibility::plausibility_warnings(const BlockVector &u,
                                      const Checks      &checks,
                                      const bool         last)
  {
    const bool is_rigid =
      std::none_of(checks.energies.begin(),
                   checks.energies.end(),
                   [](const double energy) { return energy != 0.; });
    // Obstacles under a given force have no elements.
    const unsigned int n =
      std::count_if(bodies.begin(), bodies.end(), [](const auto &body) {
        return body->cells().n > 0;
      });
    std::vector<std::string> sentences;
    const auto               current_points =
      [&](std::vector<std::vector<SurfacePoint>> &known,
          const auto                             &points_of) {
        std::vector<CurrentBody> moved;
        for (unsigned int b = 0; b < n; ++b)
          {
            if (known.size() == b)
              known.push_back((this->*points_of)(b));
            moved.push_back(make_current_body(u.block(b), b, known[b]));
          }
        return moved;
      };
    if (!units.length.empty() || is_rigid)
      {
        const auto moved = current_points(nodes, &Plausibility::sample_nodes);
        if (!units.length.empty())
          add_unit_warnings(moved, is_rigid, sentences);
        if (is_rigid && last)
          add_rigid_motion(moved, sentences);
      }
    if (n * (n - 1) / 2 > contacts.size())
      add_overlaps(current_points(faces, &Plausibility::face_points),
                   u,
                   sentences);
    return sentences;
  }
} // namespace lamella
