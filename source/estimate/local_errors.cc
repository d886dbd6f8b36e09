// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/recover/sampler.h>
#include <lamella/scene/scene.h>

#include <algorithm>
#include <numeric>

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



    /// Returns the beams of a model by the numbers of its bodies.
    std::vector<const Beam *>
    beams_in(const Simulation &simulation)
    {
      return beams_of(simulation.model().structure().bodies());
    }



    /// Returns @p u of one model on the nodes of another; bodies other than
    /// beams are identical in both.
    BlockVector
    moved(const Simulation &from, const BlockVector &u, const Simulation &to)
    {
      BlockVector result  = to.model().structure().zero();
      const auto  sources = beams_in(from), targets = beams_in(to);
      for (unsigned int b = 0; b < sources.size(); ++b)
        if (sources[b] != nullptr)
          result.block(b) = transferred(*sources[b], u.block(b), *targets[b]);
        else
          result.block(b) = u.block(b);
      return result;
    }



    /// Returns the size of the resultant on the second side of contact
    /// @p contact, from the forces of all rows.
    double
    resultant(const BuiltScene          &model,
              const unsigned int         contact,
              const std::vector<double> &forces)
    {
      const auto           of_rows = model.rows().of_contact(contact, forces);
      dealii::Tensor<1, 3> sum;
      for (unsigned int k = 0; k < of_rows.size(); ++k)
        sum += of_rows[k] * model.interfaces()[contact].points[k].normal;
      return sum.norm();
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



  bool
  Localization::is_possible(const Simulation &coarse, const Simulation &fine)
  {
    const auto ones = beams_in(coarse), others = beams_in(fine);
    for (unsigned int b = 0; b < ones.size(); ++b)
      {
        const Beam *const one = ones[b], *const other = others[b];
        if (one != nullptr && other != nullptr ?
              one->section().n_fields() != other->section().n_fields() :
              coarse.model().structure().bodies()[b]->n_dofs() !=
                fine.model().structure().bodies()[b]->n_dofs())
          return false;
      }
    return true;
  }



  Localization::Localization(const Simulation &coarse, const Simulation &fine)
    : coarse(coarse)
    , fine(fine)
    , factor(fine.results().last().load_factor)
    , dual(fine, [this](const unsigned int support, const unsigned int c) {
      return moved(this->coarse,
                   GoalDual::influence_of_support(
                     this->coarse.model().structure(), support, c),
                   this->fine);
    })
  {
    const State          &state = fine.results().last().state;
    const State          &rough = coarse.results().last().state;
    const BlockVector     u     = moved(coarse, rough.u, fine);
    const GapConstraints &rows  = fine.model().rows();
    std::vector<double>   forces(rows.size(), 0.);
    if (!state.force.empty() && !rough.force.empty())
      for (const unsigned int r : dual.active_rows())
        {
          const unsigned int c = rows.contact_of_row(r).first;
          forces[r]            = state.force[r] *
                      resultant(coarse.model(), c, rough.force) /
                      resultant(fine.model(), c, state.force);
        }
    residual = fine.model().structure().residual(u, factor, state.rest);
    const std::vector<unsigned int> &active = dual.active_rows();
    mismatch.reinit(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const unsigned int r = active[k];
        rows[r].add_to(residual, forces[r]);
        mismatch[k] =
          -(rows[r].gap(u, factor) + law_compliance(rows[r]) * forces[r]);
      }
  }



  void
  Localization::add_elements(const unsigned int body,
                             const Vector      &share,
                             LocalErrors       &result) const
  {
    const Beam &rough = *beams_in(coarse)[body], &finer = *beams_in(fine)[body];
    const Axis &axis   = rough.axis();
    const double near  = arithmetic::same_position_along * axis.length();
    const auto   first = result.elements.size();
    for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
      result.elements.push_back({body,
                                 axis.cell_begin(cell),
                                 axis.cell_end(cell),
                                 0.,
                                 rough.n_dofs_of_cell(cell)});
    for (unsigned int node = 0; node < finer.axis().n_nodes(); ++node)
      {
        double error = 0.;
        for (unsigned int k = 0; k < finer.dofs().fields(node).size(); ++k)
          error += share[finer.dofs().first(node) + k];
        const auto cells = axis.locate(finer.axis().nodes()[node], near);
        for (const auto &cell : cells)
          result.elements[first + cell.first].error += error / cells.size();
      }
  }



  std::optional<LocalErrors>
  Localization::errors(const NamedQuantity &goal, const double change) const
  {
    const auto functional = dual.derivative(goal);
    if (!functional)
      return std::nullopt;
    const GoalDual::Pair z     = dual.solve(*functional);
    BlockVector          local = z.u;
    local -= moved(coarse, moved(fine, z.u, coarse), fine);
    LocalErrors result;
    const auto  all = beams_in(fine);
    for (unsigned int b = 0; b < all.size(); ++b)
      if (all[b] != nullptr)
        {
          Vector share = residual.block(b);
          share.scale(local.block(b));
          add_elements(b, share, result);
        }
    const double sum =
      std::accumulate(result.elements.begin(),
                      result.elements.end(),
                      0.,
                      [](const double so_far, const ElementError &element) {
                        return so_far + element.error;
                      });
    result.contact = residual * z.u - sum;
    for (unsigned int k = 0; k < mismatch.size(); ++k)
      result.contact -= z.force[k] * mismatch[k];
    result.remainder = change - sum - result.contact;
    return result;
  }



  LocalErrors
  distribute_to_finer(const LocalErrors &errors, const Simulation &finer)
  {
    const std::vector<const Beam *> beams  = beams_in(finer);
    LocalErrors                     result = errors;
    result.elements.clear();
    for (const ElementError &whole : errors.elements)
      {
        const Beam &beam  = *beams[whole.body];
        const Axis &axis  = beam.axis();
        const auto  first = result.elements.size();
        for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
          {
            const double begin = axis.cell_begin(cell),
                         end = axis.cell_end(cell), middle = (begin + end) / 2.;
            if (middle > whole.begin && middle < whole.end)
              result.elements.push_back(
                {whole.body, begin, end, 0., beam.n_dofs_of_cell(cell)});
          }
        for (auto k = first; k < result.elements.size(); ++k)
          result.elements[k].error =
            whole.error / (result.elements.size() - first);
      }
    return result;
  }



  std::vector<std::optional<LocalErrors>>
  errors_of(const RunGoals   &goals,
            const Simulation &run,
            const Simulation &finer)
  {
    std::vector<std::optional<LocalErrors>> result;
    if (!Localization::is_possible(run, finer))
      return result;
    const ResultNumbers numbers(finer.results());
    const Localization  localization(run, finer);
    for (const NamedQuantity &quantity : goals.quantities())
      result.push_back(
        quantity.of == ObjectKind::mode ?
          std::nullopt :
          localization.errors(quantity,
                              numbers.value(quantity) -
                                goals.numbers().value(quantity)));
    return result;
  }
} // namespace lamella
