// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/goal_dual.h>
#include <lamella/recover/box_points.h>
#include <lamella/scene/scene.h>

#include <algorithm>

namespace lamella
{
  using ObjectKind = NamedQuantity::ObjectKind;

  namespace
  {
    /// Component that a column of probes.csv is; none for columns other than
    /// displacements, strains and stresses.
    struct Component
    {
      Quantity     quantity;
      Frame        frame;
      unsigned int component;
    };

    std::optional<Component>
    component_of(const std::string &column)
    {
      const auto        &names = field_names();
      const unsigned int n =
        std::find(names.begin(), names.end(), column) - names.begin();
      // First number of each kind among the names.
      enum : unsigned int
      {
        strains  = 3,
        stresses = 9,
        of_ply   = 15,
        end      = 21
      };
      if (n < strains)
        return Component{Quantity::displacement, Frame::scene, n};
      if (n < stresses)
        return Component{Quantity::strain, Frame::scene, n - strains};
      if (n < of_ply)
        return Component{Quantity::stress, Frame::scene, n - stresses};
      if (n < end)
        return Component{Quantity::stress, Frame::ply, n - of_ply};
      return std::nullopt;
    }
  } // namespace



  GoalDual::GoalDual(const Simulation &model, Influence given)
    : model(model)
    , influence(std::move(given))
    , active(model.results().last().state.active)
  {
    if (!influence)
      influence = [&model](const unsigned int support, const unsigned int c) {
        return influence_of_support(model.model().structure(), support, c);
      };
  }



  GoalDual::GoalDual(const Simulation &model, std::vector<unsigned int> rows)
    : GoalDual(model)
  {
    active = std::move(rows);
  }



  BlockVector
  GoalDual::influence_of_support(const Structure   &structure,
                                 const unsigned int support,
                                 const unsigned int direction)
  {
    BlockVector w = structure.zero();
    for (unsigned int b = 0; b < w.n_blocks(); ++b)
      w.block(b) =
        structure.reduction(b).influence([&](const unsigned int row) {
          const PrescribedFunctional &p = structure.prescribed()[row];
          return p.support == support ? p.direction[direction] : 0.;
        });
    return w;
  }



  GoalDual::Pair
  GoalDual::zero() const
  {
    return {model.model().structure().zero(), Vector(active.size())};
  }



  std::optional<GoalDual::Pair>
  GoalDual::derivative(const NamedQuantity &goal) const
  {
    if (first_with_friction(model.model().scene()) != nullptr)
      return std::nullopt;
    switch (goal.of)
      {
        case ObjectKind::probe:
          return at_probe(goal);
        case ObjectKind::support:
          return of_support(goal);
        case ObjectKind::contact:
          return of_contact(goal);
        case ObjectKind::measure:
          return of_measure(goal);
        default:
          return std::nullopt;
      }
  }



  std::optional<GoalDual::Pair>
  GoalDual::at_probe(const NamedQuantity &goal) const
  {
    const auto   component = component_of(goal.column);
    const auto  &probes    = model.model().scene().probes;
    const Probe &probe     = *std::find_if(probes.begin(),
                                       probes.end(),
                                       [&goal](const Probe &candidate) {
                                         return candidate.name == goal.name;
                                       });
    if (!component)
      return std::nullopt;
    const Body &body   = *model.model().structure().bodies()[probe.body];
    Pair        result = zero();
    for (const BoxPoints &points :
         box_points(body, probe.position, probe.box, "Probe " + probe.name))
      if (goal.ply == 0 || points.front().second.ply + 1 == goal.ply)
        {
          for (const auto &[weight, location] : points)
            body
              .rows({location},
                    undisplaced,
                    component->quantity,
                    component->frame)
              .front()[component->component]
              .add_to(result.u.block(probe.body), weight);
          return result;
        }
    return std::nullopt;
  }



  std::optional<BlockVector>
  GoalDual::lifting(const NamedQuantity &goal) const
  {
    if (goal.of != ObjectKind::support || goal.column[0] != 'f')
      return std::nullopt;
    const auto &supports = model.results().supports;
    return influence(std::find(supports.begin(), supports.end(), goal.name) -
                       supports.begin(),
                     goal.column[1] - 'x');
  }



  std::optional<GoalDual::Pair>
  GoalDual::of_support(const NamedQuantity &goal) const
  {
    // Moments depend on a reference point; they have no derivative here.
    if (goal.column[0] != 'f')
      return std::nullopt;
    const BlockVector w      = *lifting(goal);
    Pair              result = zero();
    // K w, with the springs.
    result.u.add(1., model.linear_system().tangent().apply(w));
    for (unsigned int k = 0; k < active.size(); ++k)
      result.force[k] = -model.model().rows()[active[k]].jump(w);
    return result;
  }



  std::optional<GoalDual::Pair>
  GoalDual::of_measure(const NamedQuantity &goal) const
  {
    Pair   result = zero();
    double sign   = 1.;
    for (const NamedQuantity &term : goal.terms)
      {
        const auto part = at_probe(term);
        if (!part)
          return std::nullopt;
        result.u.add(sign / goal.over, part->u);
        sign = -1.;
      }
    return result;
  }



  std::optional<GoalDual::Pair>
  GoalDual::of_contact(const NamedQuantity &goal) const
  {
    if (goal.column.size() != 2 || goal.column[0] != 'f' || goal.strip)
      return std::nullopt;
    Pair result = zero();
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const auto [c, row] = model.model().rows().contact_of_row(active[k]);
        const ContactInterface &contact = model.model().interfaces()[c];
        if (contact.name == goal.name)
          result.force[k] = contact.points[row].normal[goal.column[1] - 'x'];
      }
    return result;
  }



  GoalDual::Pair
  GoalDual::solve(const Pair &derivative) const
  {
    Pair        result = zero(), correction = zero();
    BlockVector left = derivative.u;
    // deal.II does not compute with empty vectors (no active rows).
    Vector right(derivative.force);
    for (double &value : right)
      value = -value;
    for (unsigned int round = 0; round < 2; ++round)
      {
        model.linear_system().solve_linear(
          active, left, right, correction.u, correction.force);
        result.u += correction.u;
        for (unsigned int k = 0; k < active.size(); ++k)
          result.force[k] += correction.force[k];
        left = derivative.u;
        left -= model.linear_system().tangent().apply(result.u);
        for (unsigned int k = 0; k < active.size(); ++k)
          {
            const GapConstraint &row = model.model().rows()[active[k]];
            row.add_to(left, result.force[k]);
            right[k] = -derivative.force[k] - row.jump(result.u) -
                       law_compliance(row) * result.force[k];
          }
      }
    return result;
  }
} // namespace lamella
