// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/pairing_checks.h>

#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
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
