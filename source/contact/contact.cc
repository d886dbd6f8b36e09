// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/contact/contact.h>
#include <lamella/contact/search_check.h>

#include <algorithm>

// Contact in the current configuration (Wriggers, Computational Contact
// Mechanics, Springer 2006, Ch. 4 to 9; mortar integrals as in Puso and
// Laursen, Comput. Methods Appl. Mech. Eng. 193 (2004) 601-629):
//   pair()        searches pairs of facing points on displaced surfaces,
//   evaluate()    projects the slave points again, which gives the gaps and
//                 their exact gradients,
//   begin_step()  stores reference points, from which slips are measured.
// A Contact does not change: constraints (ContactInterface) and pairing data
// (ContactHistory) are values, which these functions take and return.
// Gaps and slips of a row are averages over its points (integrate_gaps()) with
// weights of the undeformed area. Signs: First is side 1 of Eq. 16, whichever
// side is the slave.
//
// Gap and slips of row i with slave points x_q = x(X_q), their projections y_q
// and normals n_q, weights a_q phi_i(X_q) / A_i:
//   g_i   = sum_q (a_q phi_i / A_i) n_q . (y_q - x_q),
//   dg_i  = sum_q (a_q phi_i / A_i) n_q . (dy_q - dx_q)   at fixed (s, t),
//   s_i,a = sum_q (a_q phi_i / A_i) t_a . (I - n_q n_q) (slip of point q).
// Displacements of x_q and y_q are traces of the bodies, u = sum_k psi_k u_k.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Share of a row's area that counts as found.
    constexpr double most_of = 0.9;

    // Ratio to the curvature of a roller above which a body starts to wrap
    // around it. Bodies with bending strains below 2 % stay below it, on
    // rollers of up to twelve times their thickness.
    constexpr double wrapping_onset = 0.5;
  } // namespace



  // Pairs the undeformed bodies, then stores the initial overlap that `adjust`
  // subtracts from all later gaps.
  Contact::Contact(const ContactPair &contact,
                   const Bodies      &bodies,
                   ContactInterface  &interface,
                   ContactHistory    &history)
    : undeformed(contact, bodies)
    , search_radius(
        std::max(search_radius_of(contact, bodies),
                 bodies[contact.first.body]->has_finite_rotations() ?
                   automatic_search_distance(contact, bodies) :
                   0.))
  {
    interface = pair_undeformed(history);
    undeformed.set_discretization(interface.discretization,
                                  interface.points_on_second ?
                                    SlaveSide::second :
                                    SlaveSide::first);
    if (contact.has_slips() || contact.overclosure == Overclosure::adjust)
      {
        std::vector<GapPoint> points    = points_of(interface);
        const MasterPoints    opposites = undeformed.is_edge_contact() ?
                                            MasterPoints::projected :
                                            MasterPoints::paired;
        const auto            at_rest =
          integrate(interface, undeformed, opposites, points);
        if (contact.has_slips())
          set_slips({undeformed, undeformed, points, at_rest}, interface);
        if (contact.overclosure == Overclosure::adjust)
          for (unsigned int k = 0; k < at_rest.size(); ++k)
            removed_overlap[interface.rows[k].slave_node] =
              std::max(0., -at_rest[k].gap);
      }
    // Points of lines are those nearest to the roller (u = 0, t = 0).
    if (history.lines != nullptr &&
        !bodies[contact.first.body]->has_finite_rotations())
      {
        std::vector<types::global_dof_index> sizes;
        for (const auto &body : undeformed.bodies())
          sizes.push_back(body->n_dofs());
        const LoadFactor none(
          0., std::vector<double>(undeformed.obstacle()->history, 0.));
        interface =
          evaluate(BlockVector(sizes), none, std::move(interface), history);
      }
  }



  // Pairs without displacements, for the start and for restarts.
  ContactInterface
  Contact::pair_undeformed(ContactHistory &history) const
  {
    history                    = ContactHistory();
    ContactInterface interface = make_interface_within(
      undeformed, search_radius_of(undeformed.contact(), undeformed.bodies()));
    reduce_to_lines(interface, history);
    return interface;
  }



  // Line contact on a roller: one row per line along the body.
  void
  Contact::reduce_to_lines(ContactInterface &interface,
                           ContactHistory   &history) const
  {
    history.discretization = interface.discretization;
    history.lines.reset();
    if (interface.discretization == Discretization::line_to_roller)
      history.lines =
        std::make_shared<const CylinderContactLines>(*undeformed.surface(false),
                                                     *undeformed.obstacle(),
                                                     interface);
  }



  // Gap points: the quadrature points of weighted gaps, or one point per row
  // with its pairing, from the locations of the interface.
  std::vector<GapPoint>
  Contact::points_of(const ContactInterface &interface) const
  {
    if (interface.discretization == Discretization::surface_to_surface)
      return interface.sampled;
    std::vector<GapPoint> points;
    const bool            on_second = interface.points_on_second;
    const MeshSurface    &slave     = *undeformed.surface(on_second),
                      *master       = undeformed.surface(!on_second);
    const ConstraintGeometry &beyond =
      on_second ? interface.first : interface.second;
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        const ContactInterface::Point &at = interface.points[k];
        const Tensor<1, 3>             n  = on_second ? -at.normal : at.normal;
        GapPoint                       point;
        const auto                     here = slave.place_of(at.node, n);
        AssertThrow(here, ExcInternalError());
        point.slave        = *here;
        point.master.facet = numbers::invalid_unsigned_int;
        if (master != nullptr)
          {
            const auto there = master->place_of(beyond.places[k], -n);
            AssertThrow(there, ExcInternalError());
            point.master = *there;
          }
        points.push_back(point);
      }
    return points;
  }



  // Mortar integrals of all rows at the projections on @p sides.
  std::vector<GapIntegrals>
  Contact::integrate(const ContactInterface    &interface,
                     const ContactSides        &sides,
                     const MasterPoints         master_points,
                     std::vector<GapPoint>     &on,
                     const SlipReference *const reference) const
  {
    return integrate_gaps(sides,
                          interface.points_on_second,
                          functions_of(interface),
                          interface.rows.size(),
                          master_points,
                          search_radius,
                          on,
                          reference);
  }



  // Searches on displaced surfaces. New points get the weights of the
  // undeformed area dA = dA_now |X_,s x X_,t| / |x_,s x x_,t|, as rows are
  // material.
  ContactInterface
  Contact::pair(const BlockVector &u,
                const LoadFactor  &factor,
                ContactHistory    &history) const
  {
    ContactSides at(undeformed, u, factor);
    at.set_discretization(history.discretization,
                          undeformed.contact().slave_side);
    ContactInterface interface = make_interface_within(at, search_radius);
    history.u                  = u;
    history.factor             = factor;
    reduce_to_lines(interface, history);
    history.points = points_of(interface);
    // Ratio of the undeformed to the current area element at each point.
    // Weights are undeformed areas.
    const MeshSurface &before = *undeformed.surface(interface.points_on_second),
                      &now    = *at.surface(interface.points_on_second);
    const auto density = [](const MeshSurface &on, const GapPoint &point) {
      const FacetMap &map = on.facets()[point.slave.facet].map;
      return map.outward(map(point.slave.st)).norm();
    };
    if (interface.discretization == Discretization::surface_to_surface)
      for (GapPoint &point : history.points)
        point.area *= density(before, point) / density(now, point);
    if (history.step_begin.sides != nullptr)
      hold(interface, history);
    return evaluate(u, factor, std::move(interface), history);
  }



  // Closest-point projection of each slave point (Wriggers, Sec. 4.1). As the
  // distance vector is normal to the master surface, the motion of the
  // projection does not enter the gradient of the gap.
  ContactInterface
  Contact::evaluate(const BlockVector &u,
                    const LoadFactor  &factor,
                    ContactInterface   interface,
                    ContactHistory    &history) const
  {
    if (history.points.empty())
      history.points = points_of(interface);
    const ContactSides at(undeformed, u, factor);
    if (history.lines != nullptr)
      history.lines->follow(*at.surface(false), *at.obstacle(), history.points);
    const std::vector<GapIntegrals> integrals =
      integrate(interface,
                at,
                master_points(interface),
                history.points,
                history.step_begin.sides == nullptr ? nullptr :
                                                      &history.step_begin);
    const EvaluatedPoints evaluated{undeformed, at, history.points, integrals};
    set_gaps(evaluated, u, factor, search_radius, removed_overlap, interface);
    if (undeformed.contact().has_slips())
      {
        set_slips(evaluated, interface);
        offset_slips(integrals, u, factor, interface);
      }
    return interface;
  }



  // The slips of the step start at zero at the current state.
  void
  Contact::begin_step(const BlockVector &u,
                      const LoadFactor  &factor,
                      ContactHistory    &history,
                      ContactInterface  &interface) const
  {
    if (!undeformed.contact().has_slips())
      return;
    history.step_begin.sides =
      std::make_shared<const ContactSides>(undeformed, u, factor);
    hold(interface, history);
    offset_slips(std::vector<GapIntegrals>(interface.rows.size()),
                 u,
                 factor,
                 interface);
  }



  // Reference points of the slips: pairs of material points that face each
  // other at the beginning of the step.
  void
  Contact::hold(const ContactInterface &interface,
                ContactHistory         &history) const
  {
    const ContactSides   &then = *history.step_begin.sides;
    std::vector<GapPoint> on   = history.points;
    if (history.lines != nullptr)
      history.lines->follow(*then.surface(false), *then.obstacle(), on);
    history.step_begin.points =
      slip_reference_points(then,
                            interface.points_on_second,
                            master_points(interface),
                            search_radius,
                            on);
  }



  // Pairs in the state of the last pairing, then moves to the current state, as
  // the original run did.
  ContactInterface
  Contact::restore(const ContactHistory &known,
                   const BlockVector    &u,
                   const LoadFactor     &factor,
                   ContactHistory       &history) const
  {
    ContactInterface interface;
    if (known.u.n_blocks() > 0)
      {
        history                = ContactHistory();
        history.discretization = known.discretization;
        interface              = pair(known.u, known.factor, history);
      }
    else
      interface = pair_undeformed(history);
    const std::vector<GapPoint> points =
      known.points.empty() ? points_of(interface) : known.points;
    history.points = points;
    interface      = evaluate(u, factor, std::move(interface), history);
    // Repeated projections differ by rounding from the stored ones.
    history.points = points;
    return interface;
  }



  // Points without weight for a loaded constraint get no area.
  ContactInterface
  Contact::evaluate_loaded(const BlockVector             &u,
                           const LoadFactor              &factor,
                           ContactInterface               interface,
                           ContactHistory                 history,
                           const ArrayView<const double> &forces) const
  {
    history.step_begin = SlipReference();
    for (unsigned int q = 0; q < history.points.size(); ++q)
      {
        const auto shares =
          shares_of(functions_of(interface), q, history.points[q]);
        if (!interface.is_tied() &&
            std::all_of(shares.begin(), shares.end(), [&](const auto &share) {
              return forces[share.first] == 0.;
            }))
          history.points[q].area = 0.;
      }
    return evaluate(u, factor, std::move(interface), history);
  }



  // A new search on the current surfaces, compared by slave nodes.
  unsigned int
  Contact::count_missing_constraints(const BlockVector      &u,
                                     const LoadFactor       &factor,
                                     const ContactInterface &interface) const
  {
    ContactSides at(undeformed, u, factor);
    at.set_discretization(interface.discretization,
                          undeformed.contact().slave_side);
    const double touching = -arithmetic::negligible * u.linfty_norm();
    unsigned int count    = 0;
    try
      {
        const ContactInterface fresh = make_interface_within(at, search_radius);
        for (const AdditionalConstraint &row :
             additional_constraints(interface, fresh, most_of))
          count += fresh.rows[row.found].initial_gap < touching;
      }
    catch (const InputError &)
      {
        // No point faces the other side: nothing is missing.
      }
    return count;
  }



  // Curvature ratio of body and roller at the active rows.
  bool
  Contact::wraps_around(const BlockVector               &u,
                        const LoadFactor                &factor,
                        const ContactInterface          &interface,
                        const std::vector<unsigned int> &active) const
  {
    if (interface.obstacle == nullptr ||
        interface.obstacle->shape != Obstacle::Shape::cylinder)
      return false;
    const ContactSides at(undeformed, u, factor);
    return std::any_of(active.begin(), active.end(), [&](const unsigned int k) {
      return CylinderContactLines::curvature(*at.obstacle(),
                                             *undeformed.surface(false),
                                             *at.surface(false),
                                             place_of(interface.points[k])) >
             wrapping_onset;
    });
  }



  // Faces do not constrain nodes of ends that slide over them.
  std::optional<EndPenetration>
  Contact::end_penetration(const BlockVector &u, const LoadFactor &factor) const
  {
    // Overlap removed by `adjust` is no penetration.
    if (undeformed.obstacle() != nullptr || !removed_overlap.empty())
      return {};
    const ContactSides now(undeformed, u, factor);
    return deepest_node(paired_sides(now), now, search_radius, true);
  }



  // Small rotations pair along undeformed normals.
  const ContactSides &
  Contact::paired_sides(const ContactSides &now) const
  {
    return undeformed.bodies()[undeformed.contact().first.body]
               ->has_finite_rotations() ?
             now :
             undeformed;
  }



  // Penetration between points, which the constraints do not prevent.
  std::optional<CylinderPenetration>
  Contact::cylinder_penetration(const BlockVector      &u,
                                const LoadFactor       &factor,
                                const ContactInterface &interface) const
  {
    const Obstacle *const obstacle = interface.obstacle.get();
    if (interface.discretization == Discretization::line_to_roller ||
        !removed_overlap.empty() ||
        (obstacle != nullptr && obstacle->shape != Obstacle::Shape::cylinder))
      return {};
    const ContactSides now(undeformed, u, factor);
    if (obstacle == nullptr)
      {
        const auto node =
          deepest_node(paired_sides(now), now, search_radius, false);
        if (!node)
          return {};
        // The place on the body that is penetrated, undeformed, for refinement
        // there.
        const auto &[facet, st]  = node->at;
        const MeshSurface &faced = *undeformed.surface(!node->second);
        return CylinderPenetration{faced.facets()[facet].map(st).position,
                                   node->depth,
                                   !node->second};
      }
    return CylinderContactLines::deepest_in(*now.obstacle(),
                                            *undeformed.surface(false),
                                            *now.surface(false));
  }



  // Continuous collision test in four parts of the step, as a projection may
  // exist only on the way.
  bool
  Contact::passes_through(const BlockVector &before,
                          const LoadFactor  &from,
                          const BlockVector &u,
                          const LoadFactor  &to) const
  {
    const ContactSides then(undeformed, before, from), now(undeformed, u, to);
    if (undeformed.obstacle() != nullptr)
      return lamella::passes_through({*then.surface(false), *then.obstacle()},
                                     {*now.surface(false), *now.obstacle()});
    // What `adjust` has taken out of gaps is no depth.
    if (!removed_overlap.empty() || !may_pass_through(then, now))
      return false;
    // Bodies that approach from the side have their first projection on the
    // way.
    constexpr unsigned int parts   = 4;
    BlockVector            reached = before;
    for (unsigned int k = 1; k <= parts; ++k)
      {
        BlockVector next = before;
        next.sadd(1. - double(k) / parts, double(k) / parts, u);
        if (lamella::passes_through(ContactSides(undeformed, reached, to),
                                    ContactSides(undeformed, next, to)))
          return true;
        reached = next;
      }
    return false;
  }
} // namespace lamella
