// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/surface_topology.h>
#include <lamella/recover/face_tractions.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  FaceTractions::FaceTractions(const std::vector<Load>    &all_loads,
                               const LoadFactor           &factor,
                               const std::vector<Support> &supports)
  {
    for (const Support &support : supports)
      held.insert(held.end(), support.on.begin(), support.on.end());
    // Couples act on ends, temperatures on no face.
    for (const Load &load : all_loads)
      if (!load.couple && load.temperature.empty())
        for (const Region &region : load.on)
          if (region.kind == Region::Kind::surface)
            loads.push_back({region,
                             std::make_shared<const Traction>(load),
                             factor.of(load.history)});
  }



  void
  FaceTractions::add_contact(const ContactInterface              &contact,
                             const ArrayView<const double>       &forces,
                             const ArrayView<const Tensor<1, 3>> &shears)
  {
    contacts.push_back({&contact, ContactTraction(contact, forces, shears)});
  }



  bool
  FaceTractions::is_free(const Body &body, const Face &face) const
  {
    constexpr double same_way = 0.9;
    const auto       is_on    = [&](const Region &region) {
      if (region.body != face.body)
        return false;
      if (region.kind != Region::Kind::surface)
        return region.kind == Region::Kind::body;
      const auto facets = surface_facets(body, region.surface);
      return std::any_of(
        facets.begin(), facets.end(), [&](const SurfaceFacet &facet) {
          const auto middle = body.surface_point(facet, Point<2>(0.5, 0.5));
          return middle.normal * face.normal > same_way &&
                 std::abs((middle.position - face.origin) * face.normal) <
                   face.tolerance;
        });
    };
    return std::none_of(held.begin(), held.end(), is_on) &&
           std::none_of(loads.begin(),
                        loads.end(),
                        [&](const SurfaceLoad &load) {
                          return is_on(load.region);
                        }) &&
           !OnFace(*this, face).has_contacts();
  }



  FaceTractions::OnFace::OnFace(const FaceTractions &all, const Face &face)
    : all(all)
    , face(face)
  {
    // Of the angle between the normals of a contact and a face.
    constexpr double same_way = 0.9;
    const auto       is_on_face =
      [&](const Point<3> &x, const Tensor<1, 3> &normal, const bool outwards) {
        return std::abs((x - face.origin) * face.normal) <= face.tolerance &&
               normal * face.normal * (outwards ? 1. : -1.) >=
                 same_way * normal.norm();
      };
    for (const LoadedContact &pressed : all.contacts)
      {
        const bool is_first  = pressed.contact->first_body == face.body,
                   is_second = pressed.contact->second_body == face.body;
        double side          = 0.;
        double reach         = face.tolerance;
        for (const ContactInterface::Point &point : pressed.contact->points)
          {
            if (point.normal.norm() == 0.)
              continue;
            const bool of_first = is_first &&
                                  is_on_face(point.first, point.normal, true),
                       of_second =
                         is_second &&
                         is_on_face(point.second, point.normal, false);
            if (!of_first && !of_second)
              continue;
            side  = of_second ? 1. : -1.;
            reach = std::max(reach, 2. * point.first.distance(point.second));
          }
        if (side != 0.)
          contacts.push_back({&pressed.traction, reach, side});
      }
  }



  Tensor<1, 3>
  FaceTractions::OnFace::operator()(const Point<3> &x) const
  {
    Tensor<1, 3> t;
    for (const SurfaceLoad &load : all.loads)
      if (load.region.body == face.body && load.region.covers(face.surface))
        t += load.factor * (*load.traction)(x, face.normal);
    for (const ContactOnFace &contact : contacts)
      {
        const ContactTraction::Value value =
          contact.traction->on_line(x, face.normal, contact.reach);
        t += contact.side * value.shear - value.pressure * face.normal;
      }
    return t;
  }
} // namespace lamella
