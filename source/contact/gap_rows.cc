// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/gap_rows.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// factor * n . u at @p point.
    BodyRow
    normal_displacement(const unsigned int      index,
                        const std::vector<Row> &displacement,
                        const Tensor<1, 3>     &n,
                        const double            factor)
    {
      BodyRow part{index, {}};
      for (unsigned int c = 0; c < 3; ++c)
        part.row.add(displacement[c], factor * n[c]);
      part.row.compress();
      return part;
    }



    LocalStiffness
    local_stiffness(const SurfacePoint &point)
    {
      return {point.normal_modulus, point.area, point.depth};
    }



    [[noreturn]] void
    fail_without_pairs(const ContactPair &contact, const Pairing &pairing)
    {
      std::string message = "Contact " + contact.name +
                            ": no nodes of First and Second face each "
                            "other (node to node). The nearest two are " +
                            to_text(pairing.nearest_distance) + " apart";
      if (pairing.smallest_offset < std::numeric_limits<double>::max())
        message += ", the best sideways offset between opposed surfaces is " +
                   to_text(pairing.smallest_offset);
      throw InputError(
        message + ". Check that First and Second name the surfaces that "
                  "look at each other, and give both the same nodes (cells "
                  "across, axis elements, axis nodes).");
    }



    /// Surfaces that lie behind each other by more than the cells below them
    /// are deep do not look at each other: they are swapped or misnamed.
    void
    check_not_passed(const ContactPair               &contact,
                     const Pairing                   &pairing,
                     const std::vector<SurfacePoint> &first,
                     const std::vector<SurfacePoint> &second)
    {
      for (const PointPair &pair : pairing.pairs)
        if (-pair.initial_gap >
            std::min(first[pair.first].depth, second[pair.second].depth))
          throw InputError(
            "Contact " + contact.name + ": the surface '" +
            contact.first.surface + "' of First lies " +
            to_text(-pair.initial_gap) + " behind '" + contact.second.surface +
            "' of Second, at " + to_text(first[pair.first].position) +
            ". Name the two surfaces that look at each other, or move the "
            "bodies apart.");
    }
  } // namespace



  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies)
  {
    // The one pairing and the one law that there are so far.
    Assert(contact.discretisation == Discretisation::node_to_node,
           ExcNotImplemented());
    Assert(contact.enforcement == Enforcement::penalty, ExcNotImplemented());

    const Body &first  = *bodies[contact.first.body];
    const Body &second = *bodies[contact.second.body];
    check_surface(first, contact.first.surface, "Contact " + contact.name);
    check_surface(second, contact.second.surface, "Contact " + contact.name);
    const auto    points_1 = first.surface_points(contact.first.surface);
    const auto    points_2 = second.surface_points(contact.second.surface);
    const Pairing pairing =
      pair_node_to_node(points_1, points_2, contact.tolerance);
    if (pairing.pairs.empty())
      fail_without_pairs(contact, pairing);

    std::vector<Location> locations_1, locations_2;
    for (const PointPair &pair : pairing.pairs)
      {
        locations_1.push_back(points_1[pair.first].location);
        locations_2.push_back(points_2[pair.second].location);
      }
    const auto rows_1 = first.rows(locations_1, Quantity::displacement);
    const auto rows_2 = second.rows(locations_2, Quantity::displacement);

    check_not_passed(contact, pairing, points_1, points_2);

    ContactInterface interface;
    interface.name        = contact.name;
    interface.first_body  = contact.first.body;
    interface.second_body = contact.second.body;
    interface.second_name = second.name();
    interface.unpaired    = pairing.unpaired;
    for (unsigned int k = 0; k < pairing.pairs.size(); ++k)
      {
        const PointPair    &pair = pairing.pairs[k];
        const SurfacePoint &a    = points_1[pair.first],
                           &b    = points_2[pair.second];
        GapRow row;
        row.parts = {
          {normal_displacement(contact.first.body, rows_1[k], pair.normal, -1.),
           normal_displacement(
             contact.second.body, rows_2[k], pair.normal, 1.)}};
        row.initial_gap = pair.initial_gap;
        row.enforcement = contact.enforcement;
        row.penalty =
          row_penalty(contact.penalty, local_stiffness(a), local_stiffness(b));
        interface.rows.push_back(std::move(row));
        interface.points.push_back(
          {a.position, b.position, pair.normal, a.area});
      }
    return interface;
  }
} // namespace lamella
