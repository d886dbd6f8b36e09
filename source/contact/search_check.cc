// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/search_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of a row's area: less is rounding.
    constexpr double same_area = arithmetic::quadrature_tolerance;
    // Of the displacements: what is not rounding.
    constexpr double touching = arithmetic::negligible;
    // Of the widest gap of those that come to touch, with some room.
    constexpr double enough = 1.2;
  } // namespace



  std::vector<AdditionalConstraint>
  additional_constraints(const ContactInterface &own,
                         const ContactInterface &found,
                         const double            share)
  {
    const auto key = [](const ContactInterface::Point &point) {
      const Point<3> &x = place_of(point);
      return std::array<double, 3>{{x[0], x[1], x[2]}};
    };
    std::map<std::array<double, 3>, unsigned int> rows;
    for (unsigned int k = 0; k < own.points.size(); ++k)
      rows[key(own.points[k])] = k;
    std::vector<AdditionalConstraint> beside;
    for (unsigned int k = 0; k < found.points.size(); ++k)
      {
        const auto same = rows.find(key(found.points[k]));
        if (same == rows.end())
          beside.push_back({k, {}});
        else if (own.points[same->second].area < share * found.points[k].area)
          beside.push_back({k, same->second});
      }
    return beside;
  }



  SearchCheck::SearchCheck(const ContactPair &contact, const Bodies &bodies)
    : contact(contact)
    , bodies(bodies)
  {}



  void
  SearchCheck::extend_search(const double            new_search_radius,
                             const ContactInterface &interface)
  {
    search_radius    = new_search_radius;
    ContactPair same = contact;
    same.slave_side =
      interface.points_on_second ? SlaveSide::second : SlaveSide::first;
    ContactInterface all;
    try
      {
        all = make_interface_within(same, bodies, search_radius);
      }
    catch (const InputError &)
      {
        // Further away the surfaces do not suit each other, which may be why
        // there is a Search distance.
        return;
      }
    missing_constraints.clear();
    for (const auto &[k, own] :
         additional_constraints(interface, all, 1. - same_area))
      missing_constraints.push_back({all.rows[k], all.points[k].first, own});
  }



  void
  SearchCheck::check(const ContactInterface          &interface,
                     const BlockVector               &u,
                     const LoadFactor                &factor,
                     const std::vector<unsigned int> &active)
  {
    if (!contact.search_distance)
      return;
    // Two surfaces come nearer by no more than both move.
    const double obstacle =
      contact.obstacle == nullptr ?
        0. :
        contact.obstacle->displacement_at(factor, u).norm();
    const double needed = *contact.search_distance +
                          2. * std::sqrt(3.) * u.linfty_norm() + obstacle;
    const double most = std::max(*contact.search_distance,
                                 automatic_search_distance(contact, bodies));
    if (std::min(needed, most) > search_radius)
      extend_search(std::min(needed, most), interface);

    unsigned int             count   = 0;
    double                   deepest = 0., widest = *contact.search_distance;
    const MissingConstraint *worst = nullptr;
    for (const MissingConstraint &place : missing_constraints)
      {
        const double gap = place.row.gap(u, factor);
        const bool   touches =
          gap < -touching * u.linfty_norm() ||
          (place.seen &&
           std::binary_search(active.begin(), active.end(), *place.seen));
        if (!touches)
          continue;
        ++count;
        widest = std::max(widest, place.row.initial_gap);
        if (worst == nullptr || gap < deepest)
          {
            worst   = &place;
            deepest = gap;
          }
      }
    if (count == 0)
      return;
    throw NumericsError(
      "contact.search-distance-too-small: Contact " + contact.name +
      "/Search distance = " + to_text(*contact.search_distance) + ": " +
      std::to_string(count) +
      " points touch without a contact constraint: at the start they were "
      "further than Search distance from '" +
      interface.second_name + "', the deepest at " + to_text(worst->position) +
      (deepest < 0. ? ", penetration " + to_text(-deepest, 3) : "") +
      ". Increase Search distance to at least " + to_text(enough * widest, 2) +
      ", or write auto.");
  }
} // namespace lamella
