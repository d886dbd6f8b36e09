// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/moving_contacts.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  ActiveConstraintShift::ActiveConstraintShift(
    const std::vector<ContactInterface> &contacts,
    const State                         &state,
    const unsigned int                   n_bodies,
    const double                         share)
    : of_bodies(n_bodies)
    , softened(contacts)
  {
    const GapConstraints all(contacts);
    for (const unsigned int number : state.active)
      {
        const auto [c, k]  = all.contact_of_row(number);
        GapConstraint &row = softened[c].rows[k];
        if (state.force[number] <= 0. || row.parts.size() != 1)
          continue;
        const double spring = share * row.penalty;
        shift.push_back({number, spring});
        of_bodies[row.parts[0].body].emplace_back(row.parts[0].row, spring);
        if (row.enforcement == Enforcement::penalty)
          row.penalty -= spring;
      }
  }



  void
  ActiveConstraintShift::remove_shift(const BlockVector &u,
                                      const LoadFactor  &factor,
                                      State             &state) const
  {
    const GapConstraints all = rows();
    for (const auto &[row, spring] : shift)
      state.force[row] += spring * all[row].gap(u, factor);
  }



  void
  ActiveConstraintShift::apply_shift(const BlockVector &u,
                                     const LoadFactor  &factor,
                                     State             &state) const
  {
    const GapConstraints all = rows();
    for (const auto &[row, spring] : shift)
      if (state.force[row] > 0.)
        {
          const double force =
            state.force[row] - spring * all[row].gap(u, factor);
          state.force[row] = std::max(0., force);
        }
    state.active.erase(std::remove_if(state.active.begin(),
                                      state.active.end(),
                                      [&](const unsigned int row) {
                                        return state.force[row] <= 0. &&
                                               !all[row].is_tied();
                                      }),
                       state.active.end());
  }



  namespace
  {
    const Contacts no_contacts;
  } // namespace



  MovingContacts::MovingContacts(std::vector<ContactInterface> interfaces,
                                 std::vector<ContactHistory>   histories,
                                 const Contacts               &contact_objects)
    : all(std::move(interfaces))
    , pairings(std::move(histories))
    , initial_pairings(pairings)
    , contact_objects(contact_objects)
    , numbered(all)
  {}



  MovingContacts::MovingContacts(const GapConstraints &fixed)
    : contact_objects(no_contacts)
    , numbered(fixed)
  {}



  void
  MovingContacts::lose(const unsigned int c, const std::string &how)
  {
    lost = "Contact " + all[c].name + " is lost" + how;
    throw NumericsError(
      "solve.contact-lost: A contact cannot be followed any further. " + lost);
  }



  bool
  MovingContacts::ends_have_constraints(const unsigned int c) const
  {
    const auto slave = [](const ContactInterface &contact) {
      return contact.points_on_second ? contact.second_body :
                                        contact.first_body;
    };
    const auto master = [](const ContactInterface &contact) {
      return contact.points_on_second ? contact.first_body :
                                        contact.second_body;
    };
    return std::any_of(all.begin(), all.end(), [&](const auto &other) {
      return other.discretization == Discretization::edge_to_surface &&
             slave(other) == master(all[c]) && master(other) == slave(all[c]);
    });
  }



  bool
  MovingContacts::has_contact_force(const unsigned int c,
                                    const State       &state) const
  {
    const auto bodies = [](const ContactInterface &contact) {
      return std::minmax(contact.first_body, *contact.second_body);
    };
    return std::any_of(state.active.begin(),
                       state.active.end(),
                       [&](const unsigned int row) {
                         const auto &by =
                           all[numbered.contact_of_row(row).first];
                         return by.second_body && bodies(by) == bodies(all[c]);
                       });
  }



  std::vector<ContactHistory>
  MovingContacts::memory() const
  {
    std::vector<ContactHistory> known = pairings;
    for (ContactHistory &one : known)
      {
        one.lines      = nullptr;
        one.step_begin = SlipReference();
      }
    return known;
  }



  void
  MovingContacts::restore(const std::vector<ContactHistory> &known,
                          const BlockVector                 &u,
                          const LoadFactor                  &factor)
  {
    if (contact_objects.empty())
      return;
    AssertDimension(known.size(), contact_objects.size());
    for (unsigned int c = 0; c < contact_objects.size(); ++c)
      all[c] = contact_objects[c]->restore(known[c], u, factor, pairings[c]);
    numbered = GapConstraints(all);
  }



  void
  MovingContacts::move(State &state, const LoadFactor &factor)
  {
    if (state.friction.empty())
      return move_rows(state, factor);
    std::vector<std::array<Tensor<1, 2>, 3>> along;
    FrictionState                           &of = state.friction;
    for (unsigned int r = 0; r < numbered.size(); ++r)
      along.push_back({{along_tangents(numbered[r], of.shear[r]),
                        along_tangents(numbered[r], of.direction[r]),
                        along_tangents(numbered[r], of.before[r])}});
    move_rows(state, factor);
    for (unsigned int r = 0; r < numbered.size(); ++r)
      {
        // Points without a contact force have no friction.
        const double bears = state.force[r] != 0. || numbered[r].is_tied();
        of.shear[r]        = bears * in_scene(numbered[r], along[r][0]);
        of.direction[r]    = bears * in_scene(numbered[r], along[r][1]);
        of.before[r]       = in_scene(numbered[r], along[r][2]);
      }
  }



  void
  MovingContacts::move_rows(State &state, const LoadFactor &factor)
  {
    for (unsigned int c = 0; c < contact_objects.size(); ++c)
      all[c] = contact_objects[c]->evaluate(state.u,
                                            factor,
                                            std::move(all[c]),
                                            pairings[c]);
    if (!contact_objects.empty())
      numbered = GapConstraints(all);
    std::vector<unsigned int> facing;
    for (const unsigned int row : state.active)
      if (const unsigned int c = numbered.contact_of_row(row).first;
          !numbered[row].parts.empty())
        facing.push_back(row);
      else if (ends_have_constraints(c))
        {
          state.force[row] = 0.;
          release.insert(c);
          lost =
            "Contact " + all[c].name +
            " is lost: a contact point with a force has slid off the other "
            "surface at an end, and no edge contact covers that end.";
        }
      else
        release_facing(c);
    state.active = facing;
  }



  void
  MovingContacts::release_facing(const unsigned int c)
  {
    const std::string how =
      ": a contact point with a force has slid off the other surface. If this "
      "happens at an end of the other body, add a contact of that end with "
      "Discretization = edge to surface.";
    if (all[c].second_body && contact_objects[c]->parameters().is_automatic)
      throw MissingEnds("solve.contact-lost: Contact " + all[c].name +
                          " is lost" + how,
                        {{c, !all[c].points_on_second}});
    lose(c, how);
  }



  void
  MovingContacts::begin_step(State &state, const LoadFactor &factor)
  {
    release.clear();
    lost.clear();
    // Its shear forces are where they were.
    move_rows(state, factor);
    for (unsigned int c = 0; c < contact_objects.size(); ++c)
      {
        contact_objects[c]->begin_step(state.u, factor, pairings[c], all[c]);
        if (pairings[c].lines != nullptr &&
            contact_objects[c]->wraps_around(
              state.u, factor, all[c], numbered.local_rows_of(c, state.active)))
          lost = "Contact " + all[c].name +
                 ", line to roller, is no line: the body bends around '" +
                 all[c].second_name +
                 "'. Write Discretization = auto or surface to surface.";
      }
  }



  void
  MovingContacts::add_forces(const State &state, BlockVector &f) const
  {
    for (const unsigned int row : state.active)
      add_force(numbered[row],
                state.force[row],
                state.friction.empty() ? Tensor<1, 3>() :
                                         state.friction.shear[row],
                f);
  }



  bool
  MovingContacts::add_forces_at(const State       &state,
                                const BlockVector &u,
                                const LoadFactor  &factor,
                                BlockVector       &f) const
  {
    for (unsigned int c = 0; c < contact_objects.size(); ++c)
      {
        const auto force  = numbered.of_contact(c, state.force);
        const auto shears = numbered.of_contact(c, state.friction.shear);
        const ContactInterface there = contact_objects[c]->evaluate_loaded(
          u, factor, all[c], pairings[c], force);
        for (unsigned int k = 0; k < force.size(); ++k)
          {
            if (force[k] == 0. && !all[c].is_tied())
              continue;
            if (there.rows[k].parts.empty())
              return false;
            Tensor<1, 3> shear;
            if (!state.friction.empty())
              shear = in_scene(there.rows[k],
                               along_tangents(all[c].rows[k], shears[k]));
            add_force(there.rows[k], force[k], shear, f);
          }
      }
    return true;
  }



  double
  MovingContacts::law_error(const State &state, const LoadFactor &factor) const
  {
    double largest = 0.;
    for (unsigned int row = 0; row < numbered.size(); ++row)
      {
        const double g = numbered[row].gap(state.u, factor);
        largest        = std::max(largest,
                           state.force[row] == 0. && !numbered[row].is_tied() ?
                                    -g :
                                    std::abs(g + law_compliance(numbered[row]) *
                                            state.force[row]));
        if ((state.force[row] != 0. || numbered[row].is_tied()) &&
            !state.friction.empty())
          largest = std::max(largest,
                             friction_error(numbered[row], row, state, factor));
      }
    return largest;
  }



  bool
  MovingContacts::find_loads(State &state, const LoadFactor &factor)
  {
    if (contact_objects.empty())
      return false;
    std::vector<std::pair<unsigned int, unsigned int>> points;
    for (unsigned int r = 0; r < numbered.size(); ++r)
      points.push_back(numbered.material_point(r));
    // The slips of the step, before surfaces are paired anew.
    for (unsigned int r = 0; r < state.friction.shear.size(); ++r)
      {
        const auto [c, k]      = numbered.contact_of_row(r);
        FrictionHistory &point = state.friction.history[points[r]];
        point.position         = place_of(all[c].points[k]);
        point.slid = slip_in_step(numbered[r], r, state, factor).norm();
      }
    bool any = false;
    for (unsigned int c = 0; c < all.size(); ++c)
      {
        // evaluate() finds the points next to a roller; a line on it becomes an
        // arc when the surface wraps around it.
        const bool is_line = pairings[c].lines != nullptr;
        if (is_line ? !contact_objects[c]->parameters().is_automatic ||
                        !contact_objects[c]->wraps_around(
                          state.u,
                          factor,
                          all[c],
                          numbered.local_rows_of(c, state.active)) :
                      contact_objects[c]->count_missing_constraints(
                        state.u, factor, all[c]) == 0)
          continue;
        if (is_line)
          pairings[c].discretization = Discretization::surface_to_surface;
        any = true;
        pair(c, state, factor);
      }
    if (any)
      renumber(points, state);
    return any;
  }



  void
  MovingContacts::renumber(
    const std::vector<std::pair<unsigned int, unsigned int>> &before,
    State                                                    &state)
  {
    numbered = GapConstraints(all);
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> row_of;
    for (unsigned int r = 0; r < before.size(); ++r)
      row_of[before[r]] = r;
    std::vector<unsigned int> from, active;
    for (unsigned int r = 0; r < numbered.size(); ++r)
      {
        const auto known = row_of.find(numbered.material_point(r));
        from.push_back(known == row_of.end() ? numbers::invalid_unsigned_int :
                                               known->second);
        if (std::binary_search(state.active.begin(),
                               state.active.end(),
                               from.back()))
          active.push_back(r);
      }
    const auto move = [&from](auto &values) {
      auto moved = values;
      moved.assign(from.size(), {});
      for (unsigned int r = 0; r < from.size(); ++r)
        if (from[r] != numbers::invalid_unsigned_int)
          moved[r] = values[from[r]];
      values = std::move(moved);
    };
    state.active = active;
    move(state.force);
    if (state.friction.empty())
      return;
    for (auto *values : {&state.friction.shear,
                         &state.friction.direction,
                         &state.friction.before})
      move(*values);
  }



  void
  MovingContacts::check_kept(const BlockVector &before,
                             const LoadFactor  &from,
                             const State       &state,
                             const LoadFactor  &to)
  {
    for (unsigned int c = 0; c < contact_objects.size(); ++c)
      if (contact_objects[c]->passes_through(before, from, state.u, to))
        lose(c,
             ": its body passed through '" + all[c].second_name +
               "' in one step.");
    for (const unsigned int c : release)
      if (!has_contact_force(c, state))
        throw NumericsError(
          "solve.contact-lost: A contact cannot be followed any further. " +
          lost);
  }



  void
  MovingContacts::pair(const unsigned int c,
                       const State       &state,
                       const LoadFactor  &factor)
  {
    try
      {
        all[c] = contact_objects[c]->pair(state.u, factor, pairings[c]);
      }
    catch (const InputError &)
      {
        numbered = GapConstraints(all);
        lose(c,
             " at load factor " + to_text(factor.of_scene()) +
               ": no point faces its other surface any more.");
      }
  }
} // namespace lamella
