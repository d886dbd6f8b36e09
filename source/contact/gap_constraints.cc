// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/pairing.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // A difference in the number of cells that is none.
    constexpr double same_grid = arithmetic::same_value;



    /// One side of @p gaps, with @p sign, the sign of u there in the gap.
    ConstraintGeometry
    geometry(const std::vector<Location>    &places,
             const std::vector<WeightedGap> &gaps,
             ConstraintGeometry::Weights WeightedGap::*weights,
             const double                              sign)
    {
      ConstraintGeometry result;
      result.places = places;
      for (const WeightedGap &gap : gaps)
        {
          result.weights.push_back(gap.*weights);
          for (auto &[place, weight] : result.weights.back())
            weight *= sign;
        }
      return result;
    }



    /// The rows of @p side, whose places are in the cells of @p body.
    std::vector<BodyFunctional>
    rows_on(const unsigned int        index,
            const Body               &body,
            const ConstraintGeometry &side)
    {
      return body_rows(index,
                       body.n_dofs(),
                       body.rows(side.places, undisplaced),
                       side);
    }



    /// Whether the second side has the finer grid where the two face each
    /// other. Equal grids: the body that comes first, so that it does not
    /// matter which side is called First.
    bool
    is_second_finer(const ContactSides &sides, const double search_radius)
    {
      const MeshSurface &a = *sides.surface(false), &b = *sides.surface(true);
      const ContactPair &contact = sides.contact();
      const double       first   = count_facing_cells(a, b, search_radius),
                   second        = count_facing_cells(b, a, search_radius);
      if (std::abs(first - second) > same_grid * (first + second))
        return second > first;
      return contact.second.body < contact.first.body;
    }



    bool
    points_on_second(const ContactSides &sides, const double search_radius)
    {
      const ContactPair &contact = sides.contact();
      Assert(contact.slave_side != SlaveSide::undefined,
             ExcMessage("The side that carries the points was never set."));
      if (contact.obstacle != nullptr ||
          contact.discretization == Discretization::node_to_node ||
          contact.slave_side == SlaveSide::first)
        return false;
      return contact.slave_side == SlaveSide::second ||
             (!sides.is_edge_contact() &&
              is_second_finer(sides, search_radius));
    }



    Gaps
    find_gaps(const ContactSides &at,
              const double        search_radius,
              ContactInterface   &interface)
    {
      if (interface.discretization == Discretization::node_to_node)
        {
          Assert(at.contact().obstacle == nullptr,
                 ExcMessage("An obstacle has no nodes."));
          return node_to_node(at, search_radius, interface);
        }
      const bool on_second       = points_on_second(at, search_radius);
      interface.points_on_second = on_second;
      ContactSurfacePair sides;
      sides.search_radius = search_radius;
      sides.slave         = at.surface(on_second);
      sides.master_mesh   = at.surface(!on_second);
      sides.master        = sides.master_mesh;
      sides.edge_contact  = at.is_edge_contact();
      sides.part          = at.facets_of_part(on_second);
      std::optional<ObstacleSurface> obstacle;
      if (at.obstacle() != nullptr)
        {
          sides.master = &obstacle.emplace(at.obstacle());
          if (at.are_displaced())
            sides.max_obstacle_depth = at.obstacle()->depth();
        }
      else if (!sides.edge_contact)
        (on_second ? interface.unpaired : interface.unpaired_second) =
          count_unpaired_nodes(*sides.master_mesh, *sides.slave, search_radius);
      Assert(interface.discretization != Discretization::undefined,
             ExcMessage("The discretization was never set."));
      return interface.discretization == Discretization::surface_to_surface ?
               weighted_gaps(sides) :
               pair_node_to_surface(sides, at.points(on_second));
    }



    /// Removes those of the nodal @p gaps, each with one place on either side,
    /// whose slave nodes are not in the part of the surface.
    void
    keep_part(const ContactSides &at, const bool on_second, Gaps &gaps)
    {
      const std::vector<bool> part = at.facets_of_part(on_second);
      if (part.empty())
        return;
      const MeshSurface &slave = *at.surface(on_second);
      std::vector<bool>  is_kept(slave.grid_nodes().size(), false);
      for (unsigned int f = 0; f < part.size(); ++f)
        for (const unsigned int node : slave.facets()[f].grid_nodes)
          is_kept[node] = is_kept[node] || part[f];
      unsigned int n = 0;
      for (unsigned int k = 0; k < gaps.gaps.size(); ++k)
        if (is_kept[gaps.gaps[k].slave_node])
          {
            gaps.gaps[n] = gaps.gaps[k];
            for (auto *const weights :
                 {&gaps.gaps[n].slave_weights, &gaps.gaps[n].master_weights})
              for (auto &[place, weight] : *weights)
                place = n;
            gaps.slave[n] = gaps.slave[k];
            if (!gaps.master.empty())
              gaps.master[n] = gaps.master[k];
            ++n;
          }
      gaps.gaps.resize(n);
      gaps.slave.resize(n);
      gaps.master.resize(std::min<std::size_t>(n, gaps.master.size()));
    }



    /// Throws InputError if the slave surface has no facet in the part.
    void
    check_part(const ContactSides &at, const ContactInterface &interface)
    {
      const std::vector<bool> part =
        at.facets_of_part(interface.points_on_second);
      if (!part.empty() &&
          std::find(part.begin(), part.end(), true) == part.end())
        throw InputError(
          "Contact " + interface.name + "/Where",
          at.contact().where->as_text(),
          "contact.empty-part: the condition holds at the center "
          "of no element of the slave side",
          "Check the condition; x, y, z are coordinates of the "
          "scene. Or use shorter elements.");
    }



    /// A note if Where cuts through elements.
    void
    note_divided_facet(const ContactSides &at, ContactInterface &interface)
    {
      const auto center = at.divided_facet(interface.points_on_second);
      if (center)
        interface.notes.push_back(
          "contact.divided-element: contact " + interface.name +
          ": the boundary of Where crosses elements, for example at " +
          to_text(*center) +
          ". Where holds or not for whole elements, by their centers. Let an "
          "element end at this boundary");
    }



    /// The row of @p gap but for its parts.
    GapConstraint
    row_of(const WeightedGap &gap, const ContactPair &contact)
    {
      GapConstraint row;
      if (contact.obstacle != nullptr)
        {
          row.gap_rate = gap.normal * contact.obstacle->displacement;
          row.history  = contact.obstacle->history;
        }
      // Bodies that touch have a gap of rounding only.
      const double rounding =
        arithmetic::rounding * (gap.position.norm() + gap.opposite.norm());
      row.initial_gap = std::abs(gap.gap) < rounding ? 0. : gap.gap;
      row.enforcement = contact.enforcement;
      row.penalty     = row_penalty(contact.penalty, gap.slave, gap.master);
      row.slave_node  = gap.slave_node;
      if (const Adhesive &layer = contact.adhesive; layer.thickness > 0.)
        row.adhesive = {{layer.thickness / (layer.modulus * gap.area),
                         layer.thickness / (layer.shear_modulus * gap.area)}};
      return row;
    }



    ContactInterface::Point
    point_of(const WeightedGap &gap, const bool on_second)
    {
      return {on_second ? gap.opposite : gap.position,
              on_second ? gap.position : gap.opposite,
              on_second ? -gap.normal : gap.normal,
              gap.area,
              gap.angle,
              gap.spacing,
              gap.node};
    }



    void
    add_rows(const ContactPair &contact,
             const Bodies      &bodies,
             const Gaps        &gaps,
             ContactInterface  &interface)
    {
      const bool on_second = interface.points_on_second;
      interface.slave_surface =
        (on_second ? contact.second : contact.first).surface;
      ConstraintGeometry &slave =
                           on_second ? interface.second : interface.first,
                         &master =
                           on_second ? interface.first : interface.second;
      slave = geometry(gaps.slave, gaps.gaps, &WeightedGap::slave_weights, -1.);
      if (contact.obstacle == nullptr)
        master =
          geometry(gaps.master, gaps.gaps, &WeightedGap::master_weights, 1.);
      const auto                  first = rows_on(contact.first.body,
                                 *bodies[contact.first.body],
                                 interface.first);
      std::vector<BodyFunctional> second;
      if (contact.obstacle == nullptr)
        second = rows_on(contact.second.body,
                         *bodies[contact.second.body],
                         interface.second);
      for (unsigned int k = 0; k < gaps.gaps.size(); ++k)
        {
          const WeightedGap &gap = gaps.gaps[k];
          GapConstraint      row = row_of(gap, contact);
          row.parts              = {first[k]};
          if (contact.obstacle == nullptr)
            row.parts.push_back(second[k]);
          else
            for (auto &part :
                 guided_part(*contact.obstacle, gap.normal, bodies.size()))
              row.parts.push_back(std::move(part));
          interface.rows.push_back(std::move(row));
          interface.points.push_back(point_of(gap, on_second));
        }
    }



    /// What carries the rows of pairs of nodes, or of nodes against a surface.
    std::shared_ptr<const SlaveSurface>
    surface_of(const ContactInterface &interface, const Bodies &bodies)
    {
      std::vector<SlaveNode> nodes;
      for (const ContactInterface::Point &point : interface.points)
        nodes.push_back({point.node, point.normal});
      const unsigned int body = interface.points_on_second ?
                                  *interface.second_body :
                                  interface.first_body;
      return std::make_shared<const SlaveSurface>(
        make_nodal_slave_surface(*bodies[body],
                                 interface.slave_surface,
                                 nodes,
                                 interface.discretization ==
                                   Discretization::node_to_node));
    }
  } // namespace



  GapConstraints::GapConstraints(const std::vector<ContactInterface> &contacts)
  {
    firsts.push_back(0);
    for (const ContactInterface &contact : contacts)
      {
        for (const GapConstraint &row : contact.rows)
          rows.push_back(&row);
        firsts.push_back(rows.size());
      }
  }



  GapConstraints::GapConstraints(const std::vector<GapConstraint> &all)
    : firsts{0, static_cast<unsigned int>(all.size())}
  {
    for (const GapConstraint &row : all)
      rows.push_back(&row);
  }



  bool
  GapConstraints::has_friction() const
  {
    return std::any_of(rows.begin(),
                       rows.end(),
                       [](const GapConstraint *const row) {
                         return row->friction > 0.;
                       });
  }



  bool
  GapConstraints::has_slips() const
  {
    return std::any_of(rows.begin(),
                       rows.end(),
                       [](const GapConstraint *const row) {
                         return !row->slips.empty() || row->is_tied();
                       });
  }



  std::vector<unsigned int>
  GapConstraints::with_ties(const std::vector<unsigned int> &some) const
  {
    std::vector<unsigned int> result;
    for (unsigned int r = 0; r < size(); ++r)
      if (rows[r]->is_tied() || std::binary_search(some.begin(), some.end(), r))
        result.push_back(r);
    return result;
  }



  std::pair<unsigned int, unsigned int>
  GapConstraints::contact_of_row(const unsigned int row) const
  {
    AssertIndexRange(row, size());
    const auto next = std::upper_bound(firsts.begin(), firsts.end(), row);
    return {next - firsts.begin() - 1, row - *(next - 1)};
  }



  std::vector<unsigned int>
  GapConstraints::local_rows_of(const unsigned int               contact,
                                const std::vector<unsigned int> &some) const
  {
    std::vector<unsigned int> result;
    for (const unsigned int row : some)
      if (row >= firsts[contact] && row < firsts[contact + 1])
        result.push_back(row - firsts[contact]);
    return result;
  }



  std::vector<BodyFunctional>
  guided_part(const Obstacle     &obstacle,
              const Tensor<1, 3> &direction,
              const unsigned int  n_bodies)
  {
    if (!obstacle.body || *obstacle.body >= n_bodies)
      return {};
    BodyFunctional part{*obstacle.body, {}};
    // A guide along a plane must not couple by rounding.
    if (const double share = direction * obstacle.guide();
        std::abs(share) > arithmetic::rounding * direction.norm())
      part.row.add(0, share);
    return {part};
  }



  double
  automatic_search_distance(const ContactPair &contact, const Bodies &bodies)
  {
    // Body::size() is half the largest extension.
    const double first = 2. * bodies[contact.first.body]->size();
    return contact.obstacle != nullptr ?
             first :
             std::min(first, 2. * bodies[contact.second.body]->size());
  }



  double
  search_radius_of(const ContactPair &contact, const Bodies &bodies)
  {
    const std::string path = "Contact " + contact.name;
    check_surface(*bodies[contact.first.body],
                  contact.first.surface,
                  path + "/First");
    if (contact.obstacle == nullptr)
      check_surface(*bodies[contact.second.body],
                    contact.second.surface,
                    path + "/Second");
    return contact.search_distance ? *contact.search_distance :
                                     automatic_search_distance(contact, bodies);
  }



  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies)
  {
    return make_interface_within(contact,
                                 bodies,
                                 search_radius_of(contact, bodies));
  }



  ContactInterface
  make_interface_within(const ContactPair &contact,
                        const Bodies      &bodies,
                        const double       search_radius)
  {
    return make_interface_within(ContactSides(contact, bodies), search_radius);
  }



  ContactInterface
  make_interface_within(const ContactSides &sides, const double search_radius)
  {
    const Bodies &bodies   = sides.bodies();
    ContactPair   contact  = sides.contact();
    contact.discretization = choose_discretization(sides, search_radius);
    ContactInterface interface;
    interface.name           = contact.name;
    interface.discretization = contact.discretization;
    interface.first_body     = contact.first.body;
    if (contact.obstacle == nullptr)
      interface.second_body = contact.second.body;
    interface.obstacle    = contact.obstacle;
    interface.second_name = contact.obstacle != nullptr ?
                              contact.obstacle->name :
                              bodies[contact.second.body]->name();

    Gaps gaps = find_gaps(sides, search_radius, interface);
    check_part(sides, interface);
    if (!sides.are_displaced())
      check_no_penetration(contact, bodies, interface.points_on_second, gaps);
    if (gaps.gaps.empty())
      throw_no_pairs(contact, bodies, search_radius);
    if (gaps.surface == nullptr)
      for (WeightedGap &gap : gaps.gaps)
        gap.slave_node = sides.surface(interface.points_on_second)
                           ->grid_node(gap.node, gap.normal);
    if (gaps.surface == nullptr)
      keep_part(sides, interface.points_on_second, gaps);
    if (!sides.are_displaced())
      note_divided_facet(sides, interface);
    (interface.points_on_second ? interface.unpaired_second :
                                  interface.unpaired) = gaps.unpaired;
    add_rows(contact, bodies, gaps, interface);
    interface.surface =
      gaps.surface != nullptr ? gaps.surface : surface_of(interface, bodies);
    interface.sampled = std::move(gaps.points);
    if (!sides.are_displaced())
      treat_initial_gaps(contact, interface);
    return interface;
  }
} // namespace lamella
