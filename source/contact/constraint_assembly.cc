// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/contact.h>

#include <algorithm>
#include <set>
#include <utility>

// Constraints from mortar integrals: B = W R with the mortar weights W and the
// displacement rows R of the trace nodes. Signs: First is side 1 of Eq. 16 of
// Nagaraj et al. 2020, whichever side is the slave.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Sets the normals of unpaired rows of @p interface to the current ones of
    /// their own side.
    void
    orient_outward(const EvaluatedPoints &at, ContactInterface &interface)
    {
      for (unsigned int q = 0; q < at.points.size(); ++q)
        for (const auto &[row, weight] :
             shares_of(functions_of(interface), q, at.points[q]))
          if (weight > 0. && at.integrals[row].area == 0.)
            {
              const auto &[facet, st] = at.points[q].slave;
              const FacetMap &map =
                at.sides.surface(interface.points_on_second)
                  ->facets()[facet]
                  .map;
              const Tensor<1, 3> n = map.outward(map(st));
              interface.points[row].normal =
                (interface.points_on_second ? -1. : 1.) * n / n.norm();
            }
    }



    // Positions for output: undeformed, the opposite place at the largest
    // weight. Points on lines along the body move.
    void
    set_positions(const EvaluatedPoints &at, ContactInterface &interface)
    {
      const bool         on_second = interface.points_on_second;
      const MeshSurface *other     = at.undeformed.surface(!on_second),
                        *own       = at.undeformed.surface(on_second);
      const bool is_line =
        interface.discretization == Discretization::line_to_roller;
      // Largest weight so far of a point of each row.
      std::vector<double> most(interface.rows.size(), 0.);
      for (unsigned int q = 0; q < at.points.size(); ++q)
        for (const auto &[row, weight] :
             shares_of(functions_of(interface), q, at.points[q]))
          {
            ContactInterface::Point &to = interface.points[row];
            const auto &[facet, st]     = at.points[q].slave;
            (on_second ? to.second : to.first) =
              is_line ? own->facets()[facet].map(st).position : place_of(to);
            if (other == nullptr || weight <= most[row])
              continue;
            most[row]                        = weight;
            const auto &[opposite, st_there] = at.points[q].master;
            // A projection may be slightly beyond a side of its facet.
            (on_second ? to.first : to.second) =
              other->facets()[opposite]
                .map({std::clamp(st_there[0], 0., 1.),
                      std::clamp(st_there[1], 0., 1.)})
                .position;
          }
    }



    // Mortar weights of the gap with the signs of First (-) and Second (+).
    ConstraintGeometry
    gap_weights(const EvaluatedPoints  &at,
                const ContactInterface &interface,
                const bool              second)
    {
      ConstraintGeometry side;
      side.places          = at.undeformed.trace_locations(second);
      const bool   carries = second == interface.points_on_second;
      const double sign    = carries ? -1. : 1.;
      for (const GapIntegrals &row : at.integrals)
        {
          side.weights.emplace_back();
          for (const auto &[number, node] : carries ? row.slave : row.master)
            side.weights.back().emplace_back(number, sign * node.normal);
        }
      return side;
    }



    // Weights P_k t_a with the sign of the side.
    ConstraintGeometry
    slip_weights(const EvaluatedPoints       &at,
                 const ContactInterface      &interface,
                 const bool                   second,
                 const std::vector<Tangents> &tangents,
                 const unsigned int           a)
    {
      const bool         carries = second == interface.points_on_second;
      ConstraintGeometry side;
      for (unsigned int k = 0; k < at.integrals.size(); ++k)
        {
          const Tensor<1, 3> t = (second ? 1. : -1.) * tangents[k][a];
          side.weights.emplace_back();
          for (const auto &[number, node] :
               carries ? at.integrals[k].slave : at.integrals[k].master)
            side.weights.back().emplace_back(number, node.tangential * t);
        }
      return side;
    }



    /// Functionals of the first or @p second body with the weights @p side.
    std::vector<BodyFunctional>
    functionals(const EvaluatedPoints    &at,
                const ContactInterface   &interface,
                const bool                second,
                const ConstraintGeometry &side)
    {
      const unsigned int body =
        second ? *interface.second_body : interface.first_body;
      std::set<unsigned int> nodes;
      for (const ConstraintGeometry::Weights &weights : side.weights)
        for (const auto &[node, weight] : weights)
          nodes.insert(node);
      return body_rows(body,
                       at.undeformed.bodies()[body]->n_dofs(),
                       at.sides.trace_rows(second,
                                           {nodes.begin(), nodes.end()}),
                       side);
    }



    // The DoF of an obstacle under a given force.
    void
    add_guided_part(const ContactInterface &interface,
                    const unsigned int      n_bodies,
                    const Tensor<1, 3>     &direction,
                    ContactConstraint      &row)
    {
      if (interface.obstacle != nullptr)
        for (auto &part : guided_part(*interface.obstacle, direction, n_bodies))
          row.parts.push_back(std::move(part));
    }



    // Tangents are convected with the slave surface, so that shear forces
    // rotate with the body. The first point of a row represents its facet.
    std::vector<Tangents>
    tangents_of_rows(const EvaluatedPoints  &at,
                     const ContactInterface &interface)
    {
      const bool                second = interface.points_on_second;
      std::vector<unsigned int> first(interface.rows.size());
      for (unsigned int q = at.points.size(); q-- > 0;)
        for (const auto &[row, weight] :
             shares_of(functions_of(interface), q, at.points[q]))
          first[row] = q;
      std::vector<Tangents> tangents;
      for (unsigned int k = 0; k < first.size(); ++k)
        {
          const auto &[facet, st] = at.points[first[k]].slave;
          const Tensor<1, 3> &n   = interface.points[k].normal;
          tangents.push_back(
            at.sides.are_displaced() ?
              convected_tangents(
                at.undeformed.surface(second)->facets()[facet].map,
                at.sides.surface(second)->facets()[facet].map,
                st,
                n) :
              tangents_of(n));
        }
      return tangents;
    }
  } // namespace



  // g(v, s) = g_0 + b . v + s g_rate with g_0 such that it is the current gap
  // at the state (u, t): the linearization for Newton's method.
  void
  set_gaps(const EvaluatedPoints &at,
           const BlockVector     &u,
           const LoadFactor      &factor,
           const double           open,
           const GapOffsets      &offsets,
           ContactInterface      &interface)
  {
    set_positions(at, interface);
    interface.first  = gap_weights(at, interface, false);
    const auto first = functionals(at, interface, false, interface.first);
    std::vector<BodyFunctional> second;
    if (interface.second_body)
      {
        interface.second = gap_weights(at, interface, true);
        second           = functionals(at, interface, true, interface.second);
      }
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        const GapIntegrals      &of    = at.integrals[k];
        GapConstraint           &row   = interface.rows[k];
        ContactInterface::Point &point = interface.points[k];
        row.parts.clear();
        row.gap_rate    = 0.;
        row.initial_gap = open;
        if (of.area == 0.)
          continue;
        row.parts = {first[k]};
        if (interface.second_body)
          row.parts.push_back(second[k]);
        add_guided_part(interface,
                        at.undeformed.bodies().size(),
                        of.normal,
                        row);
        if (interface.obstacle != nullptr)
          row.gap_rate = of.normal * interface.obstacle->displacement;
        point.normal      = interface.points_on_second ? -of.normal : of.normal;
        const auto offset = offsets.find(row.slave_node);
        row.initial_gap   = of.gap +
                          (offset == offsets.end() ? 0. : offset->second) -
                          row.jump(u) - factor.of(row.history) * row.gap_rate;
      }
    orient_outward(at, interface);
  }



  // The motion of an obstacle enters by the average of (I - n n).
  void
  set_slips(const EvaluatedPoints &at, ContactInterface &interface)
  {
    const std::vector<Tangents> tangents = tangents_of_rows(at, interface);
    for (GapConstraint &row : interface.rows)
      row.slips.assign(2, SlipConstraint());
    for (const bool second : {false, true})
      for (unsigned int a = 0; a < 2; ++a)
        if (!second || interface.second_body)
          {
            const auto parts =
              functionals(at,
                          interface,
                          second,
                          slip_weights(at, interface, second, tangents, a));
            for (unsigned int k = 0; k < parts.size(); ++k)
              interface.rows[k].slips[a].parts.push_back(parts[k]);
          }
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        GapConstraint &row = interface.rows[k];
        row.friction       = at.undeformed.contact().friction;
        SymmetricTensor<2, 3> across;
        for (const auto &[number, node] : at.integrals[k].slave)
          across += node.tangential;
        for (unsigned int a = 0; a < 2; ++a)
          {
            SlipConstraint &slip = row.slips[a];
            slip.tangent         = tangents[k][a];
            slip.history         = row.history;
            if (interface.obstacle != nullptr)
              slip.rate =
                slip.tangent * (across * interface.obstacle->displacement);
            add_guided_part(interface,
                            at.undeformed.bodies().size(),
                            across * slip.tangent,
                            slip);
          }
      }
  }



  // Constant of the slip rows such that their value at the state is the slip
  // since the beginning of the step (slip_increment_of()).
  void
  offset_slips(const std::vector<GapIntegrals> &integrals,
               const BlockVector               &u,
               const LoadFactor                &factor,
               ContactInterface                &interface)
  {
    const double sign = interface.points_on_second ? -1. : 1.;
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      for (SlipConstraint &slip : interface.rows[k].slips)
        {
          slip.initial = 0.;
          slip.initial = sign * slip.tangent * integrals[k].slip_increment -
                         slip.slip(u, factor);
        }
  }
} // namespace lamella
