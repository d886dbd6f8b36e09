// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/contact/search.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Points = std::vector<ContactInterface::Point>;

    /// The point of @p point on the body @p body of @p interface.
    const Point<3> &
    on_body(const ContactInterface        &interface,
            const ContactInterface::Point &point,
            const unsigned int             body)
    {
      return interface.first_body == body ? point.first : point.second;
    }



    bool
    same_bodies(const ContactInterface &a, const ContactInterface &b)
    {
      if (!a.second_body || !b.second_body)
        return !a.second_body && !b.second_body &&
               a.first_body == b.first_body && a.second_name == b.second_name;
      return (a.first_body == b.first_body &&
              *a.second_body == *b.second_body) ||
             (a.first_body == *b.second_body && *a.second_body == b.first_body);
    }



    /// Places of @p a that @p b holds apart, too, from nearly the same place.
    std::vector<Point<3>>
    shared_places(const ContactInterface &a,
                  const ContactInterface &b,
                  const Bodies           &bodies)
    {
      const unsigned int body = a.first_body;
      const double tolerance = arithmetic::same_position * bodies[body]->size();
      std::vector<Point<3>> positions, shared;
      for (const ContactInterface::Point &point : b.points)
        positions.push_back(on_body(b, point, body));
      const PointSearch search(positions);
      for (const ContactInterface::Point &point : a.points)
        for (const unsigned int k : search.nearest(point.first, 1))
          {
            const bool      turned = b.first_body != body;
            const Point<3> &partner =
              turned ? b.points[k].first : b.points[k].second;
            if (positions[k].distance(point.first) < tolerance &&
                partner.distance(point.second) < std::sqrt(point.area) &&
                (turned ? -1. : 1.) * point.normal * b.points[k].normal > 0.5)
              shared.push_back(point.first);
          }
      return shared;
    }



    /// Whether @p points lie on a line, up to @p tolerance.
    bool
    are_collinear(const std::vector<Point<3>> &points, const double tolerance)
    {
      Point<3> far = points.front();
      for (const Point<3> &point : points)
        if (point.distance(points.front()) > far.distance(points.front()))
          far = point;
      const double length = far.distance(points.front());
      if (length <= tolerance)
        return true;
      const Tensor<1, 3> d = (far - points.front()) / length;
      for (const Point<3> &point : points)
        {
          const Tensor<1, 3> r = point - points.front();
          if ((r - (r * d) * d).norm() > tolerance)
            return false;
        }
      return true;
    }



    std::vector<Tensor<1, 3>>
    displacements(const Body                  &body,
                  const std::vector<Point<3>> &points,
                  const Vector                &u,
                  const std::string           &path)
    {
      const auto rows = body.rows(locate_all(body, points, path), undisplaced);
      std::vector<Tensor<1, 3>> result(points.size());
      for (unsigned int k = 0; k < points.size(); ++k)
        for (unsigned int c = 0; c < 3; ++c)
          result[k][c] = rows[k][c](u);
      return result;
    }
  } // namespace



  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies)
  {
    const auto is_weighted = [](const ContactInterface &interface) {
      return interface.discretization == Discretization::surface_to_surface;
    };
    // The gap of an end is another one than the average of those around it.
    const auto differ = [&is_weighted](const ContactInterface &a,
                                       const ContactInterface &b) {
      return is_weighted(a) &&
             b.discretization == Discretization::edge_to_surface;
    };
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const ContactInterface &a = interfaces[i], &b = interfaces[j];
          if (!same_bodies(a, b) || differ(a, b) || differ(b, a))
            continue;
          const std::vector<Point<3>> shared = shared_places(a, b, bodies);
          if (shared.empty() || (is_weighted(a) && is_weighted(b) &&
                                 are_collinear(shared,
                                               arithmetic::parallel_sine *
                                                 bodies[a.first_body]->size())))
            continue;
          throw InputError(
            "Contact " + a.name,
            "",
            "contact.shared-points: this contact constrains the same " +
              std::to_string(shared.size()) + " points as Contact " + b.name +
              ", one of them on body '" + bodies[a.first_body]->name() +
              "' at " + to_text(shared.front()),
            "Name surfaces without common nodes, or remove a contact.");
        }
  }



  void
  check_node_matching(const std::vector<ContactInterface> &interfaces)
  {
    for (const ContactInterface &contact : interfaces)
      {
        const unsigned int pairs = contact.rows.size();
        if (contact.discretization != Discretization::node_to_node ||
            pairs >= std::min(contact.nonmatching_nodes,
                              contact.nonmatching_nodes_second))
          continue;
        throw InputError(
          "Contact " + contact.name + "/Discretization",
          name_of(contact.discretization),
          "contact.nonmatching-nodes: only " + std::to_string(pairs) +
            " nodes of First and Second face each other; " +
            std::to_string(contact.nonmatching_nodes) + " nodes of First and " +
            std::to_string(contact.nonmatching_nodes_second) +
            " of Second face no node of the other side and can penetrate it",
          "Write auto or surface to surface, or give both surfaces the same "
          "nodes (Cells across, Axis elements, Axis nodes).");
      }
  }



  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active)
  {
    const std::string     path = "Contact " + interface.name;
    std::vector<Point<3>> first, second;
    for (const unsigned int k : active)
      {
        first.push_back(interface.points[k].first);
        second.push_back(interface.points[k].second);
      }
    const auto                u_1 = displacements(*bodies[interface.first_body],
                                   first,
                                   u.block(interface.first_body),
                                   path);
    std::vector<Tensor<1, 3>> u_2(active.size());
    if (interface.second_body)
      u_2 = displacements(*bodies[*interface.second_body],
                          second,
                          u.block(*interface.second_body),
                          path);
    else
      u_2.assign(active.size(), interface.obstacle->displacement_at(factor, u));

    Sliding worst;
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const ContactInterface::Point &point = interface.points[active[k]];
        const Tensor<1, 3>             n = point.normal / point.normal.norm(),
                           d             = u_2[k] - u_1[k];
        const double along               = (d - (d * n) * n).norm();
        if (worst.spacing == 0. ||
            along / point.spacing > worst.distance / worst.spacing)
          worst = {along, point.spacing, point.first};
      }
    return worst;
  }



  std::vector<std::string>
  assumption_warnings(const ContactInterface          &interface,
                      const Bodies                    &bodies,
                      const BlockVector               &u,
                      const LoadFactor                &factor,
                      const std::vector<unsigned int> &active)
  {
    constexpr double large_sliding = 0.1, large_angle = 5. / 180. * numbers::PI;

    std::vector<std::string> notes;
    if (active.empty())
      return notes;
    const Sliding sliding =
      largest_sliding(interface, bodies, u, factor, active);
    if (sliding.distance > large_sliding * sliding.spacing)
      notes.push_back(
        "contact.large-sliding: contact " + interface.name + ": slip at " +
        to_text(sliding.position) + " is " + to_text(sliding.distance, 3) +
        ", " + to_text(sliding.distance / sliding.spacing, 2) +
        " times the distance between neighboring contact points, so "
        "small-sliding contact is not valid. Use Rotations = large");
    unsigned int worst = active.front();
    for (const unsigned int k : active)
      if (interface.points[k].angle > interface.points[worst].angle)
        worst = k;
    const double angle = interface.points[worst].angle;
    if (angle > large_angle)
      notes.push_back(
        "contact.normals-differ: contact " + interface.name +
        ": the normals of the two surfaces differ by " +
        to_text(180. / numbers::PI * angle, 2) +
        " degrees at the contact point " +
        to_text(interface.points[worst].first) +
        ". The mesh is too coarse there, or the curvature is too large for "
        "linear kinematics. Refine the mesh, or use Rotations = large");
    return notes;
  }



  namespace
  {
    /// Closes the gaps of ties; throws InputError if the surfaces are apart.
    void
    close_ties(const ContactPair &contact, ContactInterface &interface)
    {
      // Rotations times the distance of tied points are relative displacements:
      // beside the spacing of points, a gap is an error of this size.
      constexpr double negligible = 1e-3;
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          const double gap = interface.rows[k].initial_gap;
          if (std::abs(gap) > negligible * interface.points[k].spacing)
            throw InputError(
              "Contact " + contact.name + "/Enforcement",
              name_of(contact.enforcement),
              "contact.tied-apart: the surfaces are " +
                to_text(std::abs(gap), 3) +
                (gap > 0. ? " apart at " : " into each other at ") +
                to_text(interface.points[k].first) +
                ", and only surfaces that touch can be tied",
              "Move one of the bodies (Origin). An adhesive has no "
              "volume: leave no room for its thickness.");
          interface.rows[k].initial_gap = 0.;
        }
    }
  } // namespace



  void
  treat_initial_gaps(const ContactPair &contact, ContactInterface &interface)
  {
    if (contact.is_tied())
      return close_ties(contact, interface);
    Assert(contact.overclosure != Overclosure::undefined,
           ExcMessage("What becomes of an overlap was never set."));
    if (contact.overclosure == Overclosure::resolve)
      return;
    unsigned int deepest = 0;
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      if (interface.rows[k].initial_gap < interface.rows[deepest].initial_gap)
        deepest = k;
    const double gap = interface.rows[deepest].initial_gap;
    if (gap < 0. && contact.overclosure == Overclosure::refuse)
      throw InputError(
        "Contact " + contact.name + "/Overclosure",
        name_of(contact.overclosure),
        "contact.initial-overlap: the bodies overlap at the start by up to " +
          to_text(-gap) + ", at " + to_text(interface.points[deepest].first),
        "Move the bodies apart (Origin), or write Overclosure = resolve "
        "(contact forces push the bodies apart) or adjust (the overlap is "
        "subtracted from the gaps).");
    for (GapConstraint &row : interface.rows)
      row.initial_gap = std::max(0., row.initial_gap);
  }
} // namespace lamella
