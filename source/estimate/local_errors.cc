// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/beam_transfer.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/recover/box_points.h>

#include <algorithm>
#include <numeric>

namespace lamella
{
  using Of = NamedQuantity::Of;

  namespace
  {
    /// The beams of a model, by the numbers of its bodies.
    std::vector<const Beam *>
    beams_in(const Simulation &simulation)
    {
      return beams_of(simulation.model().structure().bodies());
    }



    /// @p u of one model on the nodes of another; bodies that are no beams are
    /// the same in both.
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



    /// The size of the resultant on the second side of the contact number
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



    /// What a column of probes.csv is the component @p component of; none for
    /// others than displacements, strains and stresses.
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
      constexpr unsigned int strains = 3, stresses = 9, of_ply = 15, end = 21;
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



  bool
  Localisation::is_possible(const Simulation &coarse, const Simulation &fine)
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



  Localisation::Localisation(const Simulation &coarse, const Simulation &fine)
    : coarse(coarse)
    , fine(fine)
    , factor(fine.results().last().load_factor)
    , active(fine.results().last().state.active)
  {
    const State        &state = fine.results().last().state;
    const State        &rough = coarse.results().last().state;
    const BlockVector   u     = on_fine(rough.u);
    const GapRows      &rows  = fine.model().rows();
    std::vector<double> forces(rows.size(), 0.);
    if (!state.force.empty() && !rough.force.empty())
      for (const unsigned int r : active)
        {
          const unsigned int c = rows.in_contact(r).first;
          forces[r]            = state.force[r] *
                      resultant(coarse.model(), c, rough.force) /
                      resultant(fine.model(), c, state.force);
        }
    residual = fine.model().structure().residual(u, factor, state.rest);
    mismatch.reinit(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const unsigned int r = active[k];
        rows[r].add_to(residual, forces[r]);
        mismatch[k] =
          -(rows[r].gap(u, factor) + law_softness(rows[r]) * forces[r]);
      }
  }



  BlockVector
  Localisation::on_fine(const BlockVector &u) const
  {
    return moved(coarse, u, fine);
  }



  BlockVector
  Localisation::on_coarse(const BlockVector &u) const
  {
    return moved(fine, u, coarse);
  }



  Localisation::Derivative
  Localisation::zero() const
  {
    return {fine.model().structure().zero(), Vector(active.size())};
  }



  std::optional<Localisation::Derivative>
  Localisation::derivative(const NamedQuantity &goal) const
  {
    switch (goal.of)
      {
        case Of::probe:
          return at_probe(goal);
        case Of::support:
          return of_support(goal);
        case Of::contact:
          return of_contact(goal);
        case Of::measure:
          return of_measure(goal);
        default:
          return std::nullopt;
      }
  }



  std::optional<Localisation::Derivative>
  Localisation::at_probe(const NamedQuantity &goal) const
  {
    const auto   component = component_of(goal.column);
    const auto  &probes    = fine.model().scene().probes;
    const Probe &probe     = *std::find_if(probes.begin(),
                                       probes.end(),
                                       [&goal](const Probe &candidate) {
                                         return candidate.name == goal.name;
                                       });
    if (!component)
      return std::nullopt;
    const Body &body   = *fine.model().structure().bodies()[probe.body];
    Derivative  result = zero();
    for (const BoxPoints &points :
         box_points(body, probe.position, probe.box, "Probe " + probe.name))
      if (goal.ply == 0 || points.front().second.ply + 1 == goal.ply)
        {
          for (const auto &[weight, location] : points)
            body.rows({location}, component->quantity, component->frame)
              .front()[component->component]
              .add_to(result.u.block(probe.body), weight);
          return result;
        }
    return std::nullopt;
  }



  std::optional<Localisation::Derivative>
  Localisation::of_support(const NamedQuantity &goal) const
  {
    // Moments refer to points: left to those who can do without a derivative.
    if (goal.column[0] != 'f')
      return std::nullopt;
    const Structure   &structure = coarse.model().structure();
    const auto        &supports  = fine.results().supports;
    const unsigned int support =
      std::find(supports.begin(), supports.end(), goal.name) - supports.begin();
    BlockVector w = structure.zero();
    for (unsigned int b = 0; b < w.n_blocks(); ++b)
      w.block(b) =
        structure.reduction(b).influence([&](const unsigned int row) {
          const PrescribedRow &p = structure.prescribed()[row];
          return p.support == support ? p.direction[goal.column[1] - 'x'] : 0.;
        });
    w                 = on_fine(w);
    Derivative result = zero();
    // K w, with the springs.
    result.u.add(1., fine.contact_solver().tangent().apply(w));
    for (unsigned int k = 0; k < active.size(); ++k)
      result.force[k] = -fine.model().rows()[active[k]].opening(w);
    return result;
  }



  std::optional<Localisation::Derivative>
  Localisation::of_measure(const NamedQuantity &goal) const
  {
    Derivative result = zero();
    double     sign   = 1.;
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



  std::optional<Localisation::Derivative>
  Localisation::of_contact(const NamedQuantity &goal) const
  {
    if (goal.column.size() != 2 || goal.column[0] != 'f' || goal.strip)
      return std::nullopt;
    Derivative result = zero();
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        const auto [c, row] = fine.model().rows().in_contact(active[k]);
        const ContactInterface &contact = fine.model().interfaces()[c];
        if (contact.name == goal.name)
          result.force[k] = contact.points[row].normal[goal.column[1] - 'x'];
      }
    return result;
  }



  Localisation::Derivative
  Localisation::dual(const Derivative &derivative) const
  {
    Derivative  result = zero(), correction = zero();
    BlockVector left = derivative.u;
    // Without active rows there are vectors without entries, which deal.II
    // refuses to calculate with.
    Vector right(derivative.force);
    for (double &value : right)
      value = -value;
    for (unsigned int round = 0; round < 2; ++round)
      {
        fine.contact_solver().solve_linear(
          active, left, right, correction.u, correction.force);
        result.u += correction.u;
        for (unsigned int k = 0; k < active.size(); ++k)
          result.force[k] += correction.force[k];
        left = derivative.u;
        left -= fine.contact_solver().tangent().apply(result.u);
        for (unsigned int k = 0; k < active.size(); ++k)
          {
            const GapRow &row = fine.model().rows()[active[k]];
            row.add_to(left, result.force[k]);
            right[k] = -derivative.force[k] - row.opening(result.u) -
                       law_softness(row) * result.force[k];
          }
      }
    return result;
  }



  void
  Localisation::add_elements(const unsigned int body,
                             const Vector      &share,
                             LocalErrors       &result) const
  {
    const Beam &rough = *beams_in(coarse)[body], &finer = *beams_in(fine)[body];
    const Axis &axis   = rough.axis();
    const double near  = arithmetic::same_place_along * axis.length();
    const auto   first = result.elements.size();
    for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
      {
        unsigned int dofs = 0;
        for (const unsigned int node : axis.nodes_of_cell(cell))
          dofs += rough.dofs().fields(node).size();
        result.elements.push_back(
          {body, axis.cell_begin(cell), axis.cell_end(cell), 0., dofs});
      }
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



  LocalErrors
  Localisation::of_elements(const BlockVector &z) const
  {
    BlockVector local = z;
    local -= on_fine(on_coarse(z));
    LocalErrors result;
    const auto  all = beams_in(fine);
    for (unsigned int b = 0; b < all.size(); ++b)
      if (all[b] != nullptr)
        {
          Vector share = residual.block(b);
          share.scale(local.block(b));
          add_elements(b, share, result);
        }
    return result;
  }



  std::optional<LocalErrors>
  Localisation::errors(const NamedQuantity &goal, const double change) const
  {
    const auto functional = derivative(goal);
    if (!functional)
      return std::nullopt;
    const Derivative z      = dual(*functional);
    LocalErrors      result = of_elements(z.u);
    const double     sum =
      std::accumulate(result.elements.begin(),
                      result.elements.end(),
                      0.,
                      [](const double so_far, const ElementError &element) {
                        return so_far + element.error;
                      });
    result.contact = residual * z.u - sum;
    for (unsigned int k = 0; k < active.size(); ++k)
      result.contact -= z.force[k] * mismatch[k];
    result.remainder = change - sum - result.contact;
    return result;
  }

} // namespace lamella
