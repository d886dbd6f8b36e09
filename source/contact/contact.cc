// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/contact/contact.h>
#include <lamella/contact/pass_through.h>

#include <algorithm>

// Contact in the current configuration (Wriggers, Computational Contact
// Mechanics, Springer 2006, Ch. 4 to 9; mortar integrals as in Puso and
// Laursen, Comput. Methods Appl. Mech. Eng. 193 (2004) 601-629):
//   pair()              searches pairs of facing points on displaced surfaces,
//   move()              projects the slave points again, which gives the gaps
//                       and their exact gradients,
//   pairing_is_valid()  compares with a new search,
//   begin_step()        stores reference points, from which slips are measured.
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
    // Limits of small sliding over a row's spacing, of small rotations [rad],
    // and the share of a row's area that counts as found.
    constexpr double small_sliding = 0.1, small_rotation = 0.1, most_of = 0.9;

    // Ratio to the curvature of a roller above which a body starts to wrap
    // around it. Bodies with bending strains below 2 % stay below it, on
    // rollers of up to twelve times their thickness.
    constexpr double wrapping_onset = 0.5;



    // Key of a row by its undeformed position, which pairings do not change.
    std::array<double, 3>
    key(const ContactInterface::Point &point)
    {
      const Point<3> &x = place_of(point);
      return {{x[0], x[1], x[2]}};
    }



    /// Sets the normals of unpaired rows of @p interface to the current ones of
    /// their own side, @p surface.
    void
    orient_outward(const MeshSurface               &surface,
                   const SlaveSurface              *functions,
                   const std::vector<GapPoint>     &points,
                   const std::vector<GapIntegrals> &integrals,
                   ContactInterface                &interface)
    {
      for (unsigned int q = 0; q < points.size(); ++q)
        for (const auto &[row, weight] : shares_of(functions, q, points[q]))
          if (integrals[row].area == 0.)
            {
              const auto &[facet, st] = points[q].slave;
              const FacetMap    &map  = surface.facets()[facet].map;
              const Tensor<1, 3> n    = map.outward(map(st));
              interface.points[row].normal =
                (interface.points_on_second ? -1. : 1.) * n / n.norm();
            }
    }
  } // namespace



  // Pairs the undeformed bodies, then stores the initial overlap that `adjust`
  // subtracts from all later gaps.
  Contact::Contact(const ContactPair &contact,
                   const Bodies      &bodies,
                   ContactInterface  &interface)
    : undeformed(contact, bodies)
    , interface(interface)
    , search_radius(search_radius_of(contact, bodies))
    , search(undeformed.contact(), bodies)
  {
    pair_undeformed();
    if (bodies[contact.first.body]->has_finite_rotations())
      search_radius =
        std::max(search_radius, automatic_search_distance(contact, bodies));
    undeformed.set_discretization(interface.discretization,
                                  interface.points_on_second ?
                                    SlaveSide::second :
                                    SlaveSide::first);
    if (contact.friction > 0.)
      assemble_slips(undeformed);
    if (contact.overclosure == Overclosure::adjust)
      {
        find_points();
        const auto before =
          integrate(undeformed, master_points_at_rest(), points);
        for (unsigned int k = 0; k < before.size(); ++k)
          removed_overlap[key(interface.points[k])] =
            std::max(0., -before[k].gap);
      }
    if (lines != nullptr && !bodies[contact.first.body]->has_finite_rotations())
      update_lines();
  }



  // Moves the lines' points in the undeformed state (u = 0, t = 0).
  void
  Contact::update_lines()
  {
    std::vector<types::global_dof_index> sizes;
    for (const auto &body : undeformed.bodies())
      sizes.push_back(body->n_dofs());
    move(BlockVector(sizes),
         LoadFactor(0.,
                    std::vector<double>(undeformed.obstacle()->history, 0.)));
  }



  // Pairs anew without displacements, for the start and for restarts.
  void
  Contact::pair_undeformed()
  {
    interface = make_interface_within(undeformed,
                                      search_radius_of(undeformed.contact(),
                                                       undeformed.bodies()));
    reduce_to_lines();
    points.clear();
  }



  // Line contact on a roller: one row per line along the body.
  void
  Contact::reduce_to_lines()
  {
    lines.reset();
    if (interface.discretization == Discretization::line_to_roller)
      lines = std::make_unique<CylinderContactLines>(*undeformed.surface(false),
                                                     *undeformed.obstacle(),
                                                     interface);
  }



  // Gap points: the quadrature points of weighted gaps, or one point per row
  // with its pairing, from the locations of the interface.
  void
  Contact::find_points()
  {
    if (!points.empty())
      return;
    points = interface.sampled;
    if (interface.discretization == Discretization::surface_to_surface)
      return;
    const bool         on_second = interface.points_on_second;
    const MeshSurface &slave     = *undeformed.surface(on_second),
                      *master    = undeformed.surface(!on_second);
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
  }



  // Slip rows need the integrals even without motion.
  void
  Contact::find_integrals()
  {
    find_points();
    if (integrals.empty())
      integrals = integrate(undeformed, master_points_at_rest(), points);
  }



  // Mortar integrals of all rows at the projections on @p sides.
  std::vector<GapIntegrals>
  Contact::integrate(const ContactSides        &sides,
                     const MasterPoints         master_points,
                     std::vector<GapPoint>     &on,
                     const SlipReference *const reference) const
  {
    return integrate_gaps(sides,
                          interface.points_on_second,
                          functions(),
                          interface.rows.size(),
                          master_points,
                          search_radius,
                          on,
                          reference);
  }



  // Weighted gaps have hat functions, one-point rows have none.
  const SlaveSurface *
  Contact::functions() const
  {
    return interface.discretization == Discretization::surface_to_surface ?
             interface.surface.get() :
             nullptr;
  }



  // Searches on displaced surfaces. New points get the weights of the
  // undeformed area dA = dA_now |X_,s x X_,t| / |x_,s x x_,t|, as rows are
  // material.
  void
  Contact::pair(const BlockVector &u, const LoadFactor &factor)
  {
    const ContactSides at(undeformed, u, factor);
    interface      = make_interface_within(at, search_radius);
    pairing_u      = u;
    pairing_factor = factor;
    reduce_to_lines();
    points.clear();
    find_points();
    // Ratio of the undeformed to the current area element at each point.
    // Weights are undeformed areas.
    const MeshSurface &before = *undeformed.surface(interface.points_on_second),
                      &now    = *at.surface(interface.points_on_second);
    const auto density = [](const MeshSurface &on, const GapPoint &point) {
      const FacetMap &map = on.facets()[point.slave.facet].map;
      return map.outward(map(point.slave.st)).norm();
    };
    if (interface.discretization == Discretization::surface_to_surface)
      for (GapPoint &point : points)
        point.area *= density(before, point) / density(now, point);
    if (step_begin.sides != nullptr)
      hold();
    move(u, factor);
  }



  // Closest-point projection of each slave point (Wriggers, Sec. 4.1). As the
  // distance vector is normal to the master surface, the motion of the
  // projection does not enter the gradient of the gap.
  void
  Contact::move(const BlockVector &u, const LoadFactor &factor)
  {
    find_points();
    const ContactSides at(undeformed, u, factor);
    if (lines != nullptr)
      lines->follow(*at.surface(false), *at.obstacle(), points);
    integrals = integrate(at,
                          master_points(),
                          points,
                          step_begin.sides == nullptr ? nullptr : &step_begin);
    write(at, u, factor);
  }



  // The slips of the step start at zero at the current state.
  void
  Contact::begin_step(const BlockVector &u, const LoadFactor &factor)
  {
    if (undeformed.contact().friction == 0.)
      return;
    step_begin_u = u;
    step_begin.sides =
      std::make_unique<const ContactSides>(undeformed, step_begin_u, factor);
    hold();
    for (GapIntegrals &row : integrals)
      row.slip_increment = Tensor<1, 3>();
    offset_slips(u, factor);
  }



  // Reference points of the slips: pairs of material points that face each
  // other at the beginning of the step.
  void
  Contact::hold()
  {
    const ContactSides   &then = *step_begin.sides;
    std::vector<GapPoint> on   = points;
    if (lines != nullptr)
      lines->follow(*then.surface(false), *then.obstacle(), on);
    step_begin.points = slip_reference_points(
      then, interface.points_on_second, master_points(), search_radius, on);
  }



  // Projections depend on the path, as each starts from the last facet.
  ContactHistory
  Contact::memory() const
  {
    return {pairing_u, pairing_factor, points, interface.discretization};
  }



  // Pairs in the state of the last pairing, then moves to the current state, as
  // the original run did.
  void
  Contact::restore(const ContactHistory &known,
                   const BlockVector    &u,
                   const LoadFactor     &factor)
  {
    step_begin = SlipReference();
    undeformed.set_discretization(known.discretization,
                                  undeformed.contact().slave_side);
    if (known.u.n_blocks() > 0)
      pair(known.u, known.factor);
    else if (pairing_u.n_blocks() > 0)
      pair_undeformed();
    pairing_u      = known.u;
    pairing_factor = known.factor;
    points         = known.points;
    move(u, factor);
    // Repeated projections differ by rounding from the stored ones.
    points = known.points;
  }



  // B(u)^T lambda at another displacement: the projections of active points are
  // computed again, and forces act at the trace nodes of both sides,
  //   f_slave -= w_j lambda + P_j lambda_t,  f_master += v_k lambda + ....
  // Used for the geometric contact stiffness by differences (Newton).
  bool
  Contact::add_forces_at(const BlockVector               &u,
                         const LoadFactor                &factor,
                         const ArrayView<const double>   &lambda,
                         const std::vector<Tensor<1, 2>> &shear,
                         BlockVector                     &f) const
  {
    const ContactSides        at(undeformed, u, factor);
    std::vector<GapPoint>     all = points, pressed;
    std::vector<unsigned int> numbers;
    if (lines != nullptr)
      lines->follow(*at.surface(false), *at.obstacle(), all);
    for (unsigned int q = 0; q < all.size(); ++q)
      for (const auto &[row, weight] : shares_of(functions(), q, all[q]))
        if (lambda[row] != 0.)
          {
            pressed.push_back(all[q]);
            numbers.push_back(row);
            break;
          }
    // Rows of single points are renumbered here.
    const bool is_point = functions() == nullptr;
    const auto there    = integrate(at, master_points(), pressed);
    std::array<std::map<unsigned int, Tensor<1, 3>>, 2> forces;
    const unsigned int        n_rows = is_point ? numbers.size() : there.size();
    const double              sign   = interface.points_on_second ? -1. : 1.;
    std::vector<unsigned int> first;
    if (!shear.empty())
      first = first_points();
    for (unsigned int k = 0; k < n_rows; ++k)
      {
        const unsigned int row   = is_point ? numbers[k] : k;
        const double       force = lambda[row];
        if (force != 0. && there[k].area == 0.)
          return false;
        // Force on the master side; n points towards it.
        Tensor<1, 3> along;
        if (!shear.empty() && force != 0.)
          {
            const auto t =
              tangents_at(at, all[first[row]], sign * there[k].normal);
            along = sign * (shear[row][0] * t[0] + shear[row][1] * t[1]);
          }
        Tensor<1, 3> on_obstacle = force * there[k].normal;
        for (const auto &[node, of] : there[k].slave)
          {
            forces[0][node] -= force * of.normal + of.tangential * along;
            on_obstacle += of.tangential * along;
          }
        ContactConstraint on_guide;
        add_guided_part(on_obstacle, on_guide);
        on_guide.add_to(f, 1.);
        for (const auto &[node, of] : there[k].master)
          forces[1][node] += force * of.normal + of.tangential * along;
      }
    add_forces_of_nodes(at, forces, f);
    return true;
  }



  // Forces on trace nodes become generalized forces by the displacement rows.
  void
  Contact::add_forces_of_nodes(
    const ContactSides                                        &at,
    const std::array<std::map<unsigned int, Tensor<1, 3>>, 2> &forces,
    BlockVector                                               &f) const
  {
    for (const bool opposes : {false, true})
      {
        const bool second = opposes != interface.points_on_second;
        std::vector<unsigned int> nodes;
        for (const auto &[node, force] : forces[opposes])
          nodes.push_back(node);
        if (nodes.empty())
          continue;
        Vector &on =
          f.block(second ? *interface.second_body : interface.first_body);
        const auto row = at.trace_rows(second, nodes);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          for (unsigned int c = 0; c < 3; ++c)
            row[k][c].add_to(on, forces[opposes].at(nodes[k])[c]);
      }
  }



  // Positions for output: undeformed, the opposite place at the largest weight.
  void
  Contact::set_constraint_positions()
  {
    const bool         on_second = interface.points_on_second;
    const MeshSurface *other     = undeformed.surface(!on_second);
    // Largest weight so far of a point of each row.
    std::vector<double> most(interface.rows.size(), 0.);
    for (unsigned int q = 0; q < points.size(); ++q)
      for (const auto &[row, weight] : shares_of(functions(), q, points[q]))
        {
          ContactInterface::Point &at = interface.points[row];
          const auto &[own, place]    = points[q].slave;
          (on_second ? at.second : at.first) =
            lines == nullptr ?
              place_of(at) :
              undeformed.surface(on_second)->facets()[own].map(place).position;
          if (const auto &[facet, st] = points[q].master;
              other != nullptr && weight > most[row])
            {
              most[row] = weight;
              // A projection may be slightly beyond a side of its facet.
              (on_second ? at.first : at.second) =
                other->facets()[facet]
                  .map({std::clamp(st[0], 0., 1.), std::clamp(st[1], 0., 1.)})
                  .position;
            }
        }
  }



  // Mortar weights of the gap with the signs of First (-) and Second (+).
  ConstraintGeometry
  Contact::geometry(const bool second) const
  {
    ConstraintGeometry side;
    side.places          = undeformed.trace_locations(second);
    const bool   carries = second == interface.points_on_second;
    const double sign    = carries ? -1. : 1.;
    for (const GapIntegrals &row : integrals)
      {
        side.weights.emplace_back();
        for (const auto &[number, node] : carries ? row.slave : row.master)
          side.weights.back().emplace_back(number, sign * node.normal);
      }
    return side;
  }



  // The DoF of an obstacle under a given force.
  void
  Contact::add_guided_part(const Tensor<1, 3> &direction,
                           ContactConstraint  &row) const
  {
    if (interface.obstacle != nullptr)
      for (auto &part : guided_part(*interface.obstacle,
                                    direction,
                                    undeformed.bodies().size()))
        row.parts.push_back(std::move(part));
  }



  // Rows of the gap constraints: B = W R with the mortar weights W and the
  // displacement rows R of the trace nodes, and the tangent plane of the gap.
  void
  Contact::write(const ContactSides &sides,
                 const BlockVector  &u,
                 const LoadFactor   &factor)
  {
    const Bodies &bodies  = undeformed.bodies();
    const auto    rows_on = [&](const bool second, const unsigned int body) {
      ConstraintGeometry &side = second ? interface.second : interface.first;
      side                     = geometry(second);
      return body_rows(body,
                       bodies[body]->n_dofs(),
                       sides.trace_rows(second),
                       side);
    };
    const auto                  first = rows_on(false, interface.first_body);
    std::vector<BodyFunctional> second;
    if (interface.second_body)
      second = rows_on(true, *interface.second_body);
    set_constraint_positions();
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        GapConstraint &row = interface.rows[k];
        row.parts.clear();
        if (integrals[k].area > 0.)
          row.parts = {first[k]};
        if (integrals[k].area > 0. && interface.second_body)
          row.parts.push_back(second[k]);
        if (integrals[k].area > 0.)
          add_guided_part(integrals[k].normal, row);
        set_tangent_plane(k, u, factor);
      }
    orient_outward(*sides.surface(interface.points_on_second),
                   functions(),
                   points,
                   integrals,
                   interface);
    if (undeformed.contact().friction == 0.)
      return;
    assemble_slips(sides);
    offset_slips(u, factor);
  }



  // The first point of a row represents its facet for the tangents.
  std::vector<unsigned int>
  Contact::first_points() const
  {
    std::vector<unsigned int> first(interface.rows.size());
    for (unsigned int q = points.size(); q-- > 0;)
      for (const auto &[row, weight] : shares_of(functions(), q, points[q]))
        first[row] = q;
    return first;
  }



  // Tangents are convected with the slave surface, so that shear forces rotate
  // with the body.
  Tangents
  Contact::tangents_at(const ContactSides &sides,
                       const GapPoint     &point,
                       const Tensor<1, 3> &n) const
  {
    if (!sides.are_displaced())
      return tangents_of(n);
    const auto &[facet, st] = point.slave;
    const bool second       = interface.points_on_second;
    return convected_tangents(undeformed.surface(second)->facets()[facet].map,
                              sides.surface(second)->facets()[facet].map,
                              st,
                              n);
  }



  // Slip rows along both tangents; the motion of an obstacle enters by the
  // average of (I - n n).
  void
  Contact::assemble_slips(const ContactSides &sides)
  {
    find_integrals();
    const auto            first = first_points();
    std::vector<Tangents> along;
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      along.push_back(
        tangents_at(sides, points[first[k]], interface.points[k].normal));
    const auto parts = slip_constraints(sides, along);
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        GapConstraint &row = interface.rows[k];
        row.friction       = undeformed.contact().friction;
        SymmetricTensor<2, 3> across;
        for (const auto &[number, node] : integrals[k].slave)
          across += node.tangential;
        row.slips.clear();
        for (unsigned int a = 0; a < 2; ++a)
          {
            SlipConstraint slip;
            slip.parts   = parts[k][a];
            slip.tangent = along[k][a];
            slip.history = row.history;
            if (interface.obstacle != nullptr)
              slip.rate =
                slip.tangent * (across * interface.obstacle->displacement);
            add_guided_part(across * slip.tangent, slip);
            row.slips.push_back(slip);
          }
      }
  }



  // g(v, s) = g_0 + b . v + s g_rate with g_0 such that it is the current gap
  // at the state (u, t): the linearization for Newton's method.
  void
  Contact::set_tangent_plane(const unsigned int k,
                             const BlockVector &u,
                             const LoadFactor  &factor)
  {
    const GapIntegrals      &of    = integrals[k];
    GapConstraint           &row   = interface.rows[k];
    ContactInterface::Point &point = interface.points[k];
    row.gap_rate                   = 0.;
    if (of.area == 0.)
      {
        row.initial_gap = search_radius;
        return;
      }
    if (interface.obstacle != nullptr)
      row.gap_rate = of.normal * interface.obstacle->displacement;
    point.normal          = interface.points_on_second ? -of.normal : of.normal;
    const auto   adjusted = removed_overlap.find(key(point));
    const double gap =
      of.gap + (adjusted == removed_overlap.end() ? 0. : adjusted->second);
    row.initial_gap = gap - row.jump(u) - factor.of(row.history) * row.gap_rate;
  }



  // Constant of the slip rows such that their value at the state is the slip
  // since the beginning of the step (slip_increment_of()).
  void
  Contact::offset_slips(const BlockVector &u, const LoadFactor &factor)
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



  // Weights P_k t_a with the sign of the side, times the displacement rows.
  std::vector<BodyFunctional>
  Contact::slip_constraints_on(const ContactSides          &sides,
                               const bool                   second,
                               const std::vector<Tangents> &tangents,
                               const unsigned int           a) const
  {
    const unsigned int body =
      second ? *interface.second_body : interface.first_body;
    const bool         carries = second == interface.points_on_second;
    ConstraintGeometry side;
    for (unsigned int k = 0; k < integrals.size(); ++k)
      {
        const Tensor<1, 3> t = (second ? 1. : -1.) * tangents[k][a];
        side.weights.emplace_back();
        for (const auto &[number, node] :
             carries ? integrals[k].slave : integrals[k].master)
          side.weights.back().emplace_back(number, node.tangential * t);
      }
    return body_rows(body,
                     undeformed.bodies()[body]->n_dofs(),
                     sides.trace_rows(second),
                     side);
  }



  std::vector<std::array<std::vector<BodyFunctional>, 2>>
  Contact::slip_constraints(const ContactSides          &sides,
                            const std::vector<Tangents> &tangents) const
  {
    std::vector<std::array<std::vector<BodyFunctional>, 2>> slip(
      integrals.size());
    for (const bool second : {false, true})
      for (unsigned int a = 0; a < 2; ++a)
        if (!second || interface.second_body)
          {
            const auto rows = slip_constraints_on(sides, second, tangents, a);
            for (unsigned int k = 0; k < rows.size(); ++k)
              slip[k][a].push_back(rows[k]);
          }
    return slip;
  }



  std::vector<std::array<std::vector<BodyFunctional>, 2>>
  Contact::slip_constraints()
  {
    find_integrals();
    std::vector<Tangents> tangents;
    for (const ContactInterface::Point &point : interface.points)
      tangents.push_back(tangents_of(point.normal));
    return slip_constraints(undeformed, tangents);
  }



  // Largest undeformed distance between stored and current projections per row.
  std::vector<double>
  Contact::projection_drift(const std::vector<GapPoint> &now) const
  {
    std::vector<double> off(interface.rows.size(), 0.);
    const MeshSurface  *other = undeformed.surface(!interface.points_on_second);
    const auto          place = [other](const GapPoint &point) {
      const auto &[facet, st] = point.master;
      return other->facets()[facet].map(st).position;
    };
    for (unsigned int q = 0; other != nullptr && q < points.size(); ++q)
      {
        const double by = place(points[q]).distance(place(now[q]));
        for (const auto &[row, weight] : shares_of(functions(), q, points[q]))
          off[row] = std::max(off[row], by);
      }
    return off;
  }



  // A new search on the current surfaces, compared by slave nodes.
  unsigned int
  Contact::count_missing_constraints(const ContactSides &sides,
                                     const double        touching) const
  {
    unsigned int count = 0;
    try
      {
        const ContactInterface fresh =
          make_interface_within(sides, search_radius);
        for (const AdditionalConstraint &row :
             additional_constraints(interface, fresh, most_of))
          count += fresh.rows[row.found].initial_gap < touching;
      }
    catch (const InputError &)
      {
        // No point faces the other side: lost rows are counted elsewhere.
      }
    return count;
  }



  // A row is lost without a projection, or has drifted if the projection has
  // moved by more than a tenth of the spacing or its normal by 0.1 rad.
  PairingChange
  Contact::pairing_is_valid(const BlockVector               &u,
                            const LoadFactor                &factor,
                            const std::vector<unsigned int> &active)
  {
    // move() finds the points next to a roller.
    if (lines != nullptr)
      return {};
    find_points();
    const ContactSides    at(undeformed, u, factor);
    const double          touching = -arithmetic::negligible * u.linfty_norm();
    std::vector<GapPoint> on       = points;
    const auto            now      = integrate(at, MasterPoints::projected, on);
    const std::vector<double> off  = projection_drift(on);
    PairingChange             stale;
    for (unsigned int k = 0; k < now.size(); ++k)
      {
        const ContactInterface::Point &point = interface.points[k];
        const bool                     carries_force =
          std::binary_search(active.begin(), active.end(), k);
        if (now[k].area == 0.)
          {
            stale.lost += carries_force;
            continue;
          }
        const Tensor<1, 3> n =
          interface.points_on_second ? -now[k].normal : now[k].normal;
        if ((carries_force || now[k].gap < touching) &&
            (off[k] > small_sliding * point.spacing ||
             (n - point.normal).norm() > small_rotation))
          ++stale.drifted;
      }
    stale.missing_constraints = count_missing_constraints(at, touching);
    return stale;
  }



  // Rows beyond a given search distance would be missing without notice.
  void
  Contact::require_found(const BlockVector               &u,
                         const LoadFactor                &factor,
                         const std::vector<unsigned int> &active)
  {
    // The nearest line is found at any distance from the roller.
    if (lines == nullptr)
      search.check(interface, u, factor, active);
  }



  // Curvature ratio of body and roller at the active rows.
  bool
  Contact::wraps_around(const BlockVector               &u,
                        const LoadFactor                &factor,
                        const std::vector<unsigned int> &active) const
  {
    if (interface.obstacle == nullptr ||
        interface.obstacle->shape != Obstacle::Shape::cylinder)
      return false;
    std::vector<Point<3>> places;
    for (const unsigned int k : active)
      places.push_back(place_of(interface.points[k]));
    const ContactSides at(undeformed, u, factor);
    return CylinderContactLines::curvature(*at.obstacle(),
                                           *undeformed.surface(false),
                                           *at.surface(false),
                                           places) > wrapping_onset;
  }



  // A line on a roller becomes an arc when the surface wraps around it.
  bool
  Contact::switch_to_points()
  {
    if (!is_automatic())
      return false;
    undeformed.set_discretization(Discretization::surface_to_surface,
                                  SlaveSide::first);
    return true;
  }



  // Faces do not constrain nodes of ends that slide over them.
  std::optional<EndPenetration>
  Contact::end_penetration(const BlockVector &u, const LoadFactor &factor) const
  {
    // Overlap removed by `adjust` is no penetration.
    if (interface.obstacle != nullptr || !removed_overlap.empty())
      return {};
    const ContactSides now(undeformed, u, factor);
    return deepest_node(paired_sides(now), now, search_radius, true);
  }



  // Small rotations pair along undeformed normals.
  const ContactSides &
  Contact::paired_sides(const ContactSides &now) const
  {
    return undeformed.bodies()[interface.first_body]->has_finite_rotations() ?
             now :
             undeformed;
  }



  // Penetration between points, which the constraints do not prevent.
  std::optional<CylinderPenetration>
  Contact::cylinder_penetration(const BlockVector &u,
                                const LoadFactor  &factor) const
  {
    const Obstacle *const obstacle = interface.obstacle.get();
    if (lines != nullptr || !removed_overlap.empty() ||
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
    if (interface.obstacle != nullptr)
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
