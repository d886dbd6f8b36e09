// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_rows.h>
#include <lamella/contact/weighted_gaps.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // A difference in the number of cells that is none.
    constexpr double same_grid = arithmetic::alike;



    /// One side of @p gaps, with @p sign, the sign of u there in the gap.
    RowGeometry
    geometry(const std::vector<Location>    &places,
             const std::vector<WeightedGap> &gaps,
             RowGeometry::Weights WeightedGap::*weights,
             const double                       sign)
    {
      RowGeometry result;
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
    std::vector<BodyRow>
    rows_on(const unsigned int index, const Body &body, const RowGeometry &side)
    {
      return body_rows(index,
                       body.n_dofs(),
                       body.rows(side.places, Quantity::displacement),
                       side);
    }



    /// Whether the second side has the finer grid where the two face each
    /// other. Equal grids: the body that comes first, so that it does not
    /// matter which side is called First.
    bool
    second_is_finer(const ContactSides &sides, const double reach)
    {
      const MeshSurface &a = *sides.surface(false), &b = *sides.surface(true);
      const ContactPair &contact = sides.contact();
      const double       first   = cells_facing(a, b, reach),
                   second        = cells_facing(b, a, reach);
      if (std::abs(first - second) > same_grid * (first + second))
        return second > first;
      return contact.second.body < contact.first.body;
    }



    bool
    points_on_second(const ContactSides &sides, const double reach)
    {
      const ContactPair &contact = sides.contact();
      Assert(contact.points_on != PointsOn::undefined,
             ExcMessage("The side that carries the points was never set."));
      if (contact.obstacle != nullptr ||
          contact.discretisation == Discretisation::node_to_node ||
          contact.points_on == PointsOn::first)
        return false;
      return contact.points_on == PointsOn::second ||
             second_is_finer(sides, reach);
    }



    [[noreturn]] void
    fail_without_pairs(const ContactPair &contact,
                       const Bodies      &bodies,
                       const double       reach)
    {
      const auto points = [&bodies](const Region &region) {
        return bodies[region.body]->surface_points(region.surface);
      };
      const std::string path = "Contact " + contact.name;
      if (contact.obstacle != nullptr)
        throw InputError(path,
                         "",
                         "nothing of First faces the obstacle '" +
                           contact.obstacle->name +
                           "' within Search distance " + to_text(reach),
                         "Check the surface's name and where the obstacle is.");
      const bool to_node =
        contact.discretisation == Discretisation::node_to_node;
      const Pairing pairing = pair_node_to_node(points(contact.first),
                                                points(contact.second),
                                                contact.tolerance);
      std::string   nearest = "The nearest two nodes are " +
                            to_text(pairing.nearest_distance) + " apart";
      if (to_node &&
          pairing.smallest_offset < std::numeric_limits<double>::max())
        nearest += ", the best sideways offset between opposed surfaces is " +
                   to_text(pairing.smallest_offset);
      const std::string check =
        ". Check that First and Second name the surfaces that look at each "
        "other";
      if (to_node)
        throw InputError(
          path,
          "",
          "no nodes of First and Second face each other (node to node)",
          nearest + check +
            ", and give both the same nodes (cells across, axis elements, axis "
            "nodes), or use surface to surface.");
      throw InputError(
        path,
        "",
        "nothing of First and Second faces each other within Search distance " +
          to_text(reach),
        nearest + check + ".");
    }



    bool
    is_in(const Body &body, const BoundingBox<3> &box, const Point<3> &x)
    {
      return box.point_inside(x) && !body.locate({x})[0].empty();
    }



    /// The first of @p places of which one side is in the body (or the
    /// obstacle) of the other; null if there is none.
    const DeepPlace *
    first_inside(const ContactPair            &contact,
                 const Bodies                 &bodies,
                 const bool                    on_second,
                 const std::vector<DeepPlace> &places)
    {
      if (places.empty())
        return nullptr;
      const Body
        &carrying = *bodies[(on_second ? contact.second : contact.first).body],
        &other =
          *bodies[(on_second || contact.obstacle != nullptr ? contact.first :
                                                              contact.second)
                    .body];
      const BoundingBox<3> box          = carrying.bounding_box(),
                           box_of_other = other.bounding_box();
      for (const DeepPlace &place : places)
        if (is_in(carrying, box, place.opposite) ||
            (contact.obstacle != nullptr ?
               contains(*contact.obstacle, place.position) :
               is_in(other, box_of_other, place.position)))
          return &place;
      return nullptr;
    }



    /// Places far behind each other either look away from each other through
    /// their own bodies, and then do not pair, or the bodies lie in each other.
    void
    check_not_passed(const ContactPair &contact,
                     const Bodies      &bodies,
                     const bool         on_second,
                     const Gaps        &gaps)
    {
      const auto refuse = [&](const DeepPlace   &place,
                              const std::string &how,
                              const std::string &remedy) {
        throw InputError(
          "Contact " + contact.name,
          "",
          "the surface '" + contact.first.surface + "' of First lies " +
            to_text(place.behind) + " behind '" +
            (contact.obstacle != nullptr ? contact.obstacle->name :
                                           contact.second.surface) +
            "' of Second, at " +
            to_text(on_second ? place.opposite : place.position) + how,
          remedy);
      };
      if (const DeepPlace *place =
            first_inside(contact, bodies, on_second, gaps.too_deep))
        refuse(
          *place,
          ", which is more than the cells there are deep: the bodies lie in "
          "each other",
          "Move the bodies apart, or name the two surfaces that look at each "
          "other.");
      if (gaps.gaps.empty() && !gaps.too_deep.empty())
        refuse(
          gaps.too_deep.front(),
          "",
          "Name the two surfaces that look at each other, or move the bodies "
          "apart.");
    }



    /// Nodes without a partner that face the other surface all the same.
    unsigned int
    count_facing(const std::vector<SurfacePoint> &points,
                 const std::vector<bool>         &is_paired,
                 const MeshSurface               &other,
                 const double                     reach)
    {
      unsigned int count = 0;
      for (unsigned int k = 0; k < points.size(); ++k)
        if (!is_paired[k] &&
            opposing_place(other, points[k].position, points[k].normal, reach))
          ++count;
      return count;
    }



    /// The nodes of both sides and which of them face each other.
    struct NodePairs
    {
      std::vector<SurfacePoint> first, second;
      Pairing                   pairing;
      /// Of either side, those without a partner that face the other surface.
      unsigned int beside = 0, beside_second = 0;
    };



    NodePairs
    pair_nodes(const ContactSides &sides, const double reach)
    {
      NodePairs nodes;
      nodes.first            = sides.points(false);
      nodes.second           = sides.points(true);
      nodes.pairing          = pair_node_to_node(nodes.first,
                                        nodes.second,
                                        sides.contact().tolerance,
                                        reach);
      const Pairing &pairing = nodes.pairing;
      if (pairing.pairs.empty() ||
          pairing.unpaired + pairing.unpaired_second == 0)
        return nodes;
      std::vector<bool> first_paired(nodes.first.size(), false),
        second_paired(nodes.second.size(), false);
      for (const PointPair &pair : pairing.pairs)
        {
          first_paired[pair.first]   = true;
          second_paired[pair.second] = true;
        }
      nodes.beside =
        count_facing(nodes.first, first_paired, *sides.surface(true), reach);
      nodes.beside_second =
        count_facing(nodes.second, second_paired, *sides.surface(false), reach);
      return nodes;
    }



    /// What the discretisation is on these bodies where it is `automatic`.
    Discretisation
    decided(const ContactSides &sides, const double reach)
    {
      const ContactPair &contact = sides.contact();
      if (contact.discretisation != Discretisation::automatic)
        return contact.discretisation;
      if (contact.obstacle != nullptr)
        return Discretisation::surface_to_surface;
      const NodePairs nodes = pair_nodes(sides, reach);
      return !nodes.pairing.pairs.empty() &&
                 nodes.beside + nodes.beside_second == 0 ?
               Discretisation::node_to_node :
               Discretisation::surface_to_surface;
    }



    /// Pairs of nodes in the form of weighted gaps.
    Gaps
    node_to_node(const ContactSides &sides,
                 const double        reach,
                 ContactInterface   &interface)
    {
      const NodePairs nodes         = pair_nodes(sides, reach);
      const auto &[first, second]   = std::tie(nodes.first, nodes.second);
      const Pairing &pairing        = nodes.pairing;
      interface.unpaired_second     = pairing.unpaired_second;
      interface.beside_nodes        = nodes.beside;
      interface.beside_nodes_second = nodes.beside_second;
      if (nodes.beside + nodes.beside_second > 0)
        interface.notes.push_back(
          "contact " + interface.name + ": " + std::to_string(nodes.beside) +
          " nodes of First and " + std::to_string(nodes.beside_second) +
          " of Second face the other surface, but none of its nodes, and can "
          "pass through it. Use Discretisation = auto or surface to surface, "
          "or give both surfaces the same nodes");

      Gaps result;
      result.unpaired = pairing.unpaired;
      for (const PointPair &pair : pairing.pairs)
        {
          const SurfacePoint &a = first[pair.first], &b = second[pair.second];
          if (is_too_deep(pair.initial_gap, a.depth, b.depth))
            {
              result.too_deep.push_back(
                {a.position, b.position, -pair.initial_gap});
              continue;
            }
          const unsigned int k    = result.gaps.size();
          const double       area = std::min(a.area, b.area);
          WeightedGap        gap;
          gap.node     = a.location;
          gap.position = a.position;
          gap.opposite = b.position;
          gap.normal   = pair.normal;
          gap.area     = area;
          gap.spacing  = std::sqrt(area);
          gap.gap      = pair.initial_gap;
          gap.angle =
            2. * std::asin(std::min(1., 0.5 * (a.normal + b.normal).norm()));
          gap.carrying         = {a.normal_modulus, area, a.depth};
          gap.opposing         = {b.normal_modulus, area, b.depth};
          gap.carrying_weights = {{k, pair.normal}};
          gap.opposing_weights = {{k, pair.normal}};
          result.carrying.push_back(a.location);
          result.opposing.push_back(b.location);
          result.gaps.push_back(std::move(gap));
        }
      return result;
    }



    Gaps
    find_gaps(const ContactSides &at,
              const double        reach,
              ContactInterface   &interface)
    {
      if (interface.discretisation == Discretisation::node_to_node)
        {
          Assert(at.contact().obstacle == nullptr,
                 ExcMessage("An obstacle has no nodes."));
          return node_to_node(at, reach, interface);
        }
      const bool on_second       = points_on_second(at, reach);
      interface.points_on_second = on_second;
      Sides sides;
      sides.reach         = reach;
      sides.carrying      = at.surface(on_second);
      sides.opposing_mesh = at.surface(!on_second);
      sides.opposing      = sides.opposing_mesh;
      std::optional<ObstacleSurface> obstacle;
      if (at.obstacle() != nullptr)
        sides.opposing = &obstacle.emplace(at.obstacle());
      else
        (on_second ? interface.unpaired : interface.unpaired_second) =
          nodes_facing_nothing(*sides.opposing_mesh, *sides.carrying, reach);
      Assert(interface.discretisation != Discretisation::undefined,
             ExcMessage("The discretisation was never set."));
      return interface.discretisation == Discretisation::surface_to_surface ?
               weighted_gaps(sides) :
               pair_node_to_surface(sides, at.points(on_second));
    }



    void
    add_rows(const ContactPair &contact,
             const Bodies      &bodies,
             const Gaps        &gaps,
             ContactInterface  &interface)
    {
      const bool on_second = interface.points_on_second;
      interface.carrying_surface =
        (on_second ? contact.second : contact.first).surface;
      RowGeometry &carrying = on_second ? interface.second : interface.first,
                  &opposing = on_second ? interface.first : interface.second;
      carrying =
        geometry(gaps.carrying, gaps.gaps, &WeightedGap::carrying_weights, -1.);
      if (contact.obstacle == nullptr)
        opposing = geometry(gaps.opposing,
                            gaps.gaps,
                            &WeightedGap::opposing_weights,
                            1.);
      const auto           first = rows_on(contact.first.body,
                                 *bodies[contact.first.body],
                                 interface.first);
      std::vector<BodyRow> second;
      if (contact.obstacle == nullptr)
        second = rows_on(contact.second.body,
                         *bodies[contact.second.body],
                         interface.second);
      for (unsigned int k = 0; k < gaps.gaps.size(); ++k)
        {
          const WeightedGap &gap = gaps.gaps[k];
          GapRow             row;
          row.parts = {first[k]};
          if (contact.obstacle == nullptr)
            row.parts.push_back(second[k]);
          else
            row.gap_rate = gap.normal * contact.obstacle->displacement;
          // Bodies that touch have a gap of rounding only.
          const double rounding =
            arithmetic::rounding * (gap.position.norm() + gap.opposite.norm());
          row.initial_gap = std::abs(gap.gap) < rounding ? 0. : gap.gap;
          row.enforcement = contact.enforcement;
          row.penalty =
            row_penalty(contact.penalty, gap.carrying, gap.opposing);
          interface.rows.push_back(std::move(row));
          if (on_second)
            interface.points.push_back({gap.opposite,
                                        gap.position,
                                        -gap.normal,
                                        gap.area,
                                        gap.angle,
                                        gap.spacing,
                                        gap.node});
          else
            interface.points.push_back({gap.position,
                                        gap.opposite,
                                        gap.normal,
                                        gap.area,
                                        gap.angle,
                                        gap.spacing,
                                        gap.node});
        }
    }



    /// What carries the rows of pairs of nodes, or of nodes against a surface.
    std::shared_ptr<const CarryingSurface>
    surface_of(const ContactInterface &interface, const Bodies &bodies)
    {
      std::vector<CarryingNode> nodes;
      for (const ContactInterface::Point &point : interface.points)
        nodes.push_back({point.node, point.normal});
      const unsigned int body = interface.points_on_second ?
                                  *interface.second_body :
                                  interface.first_body;
      return std::make_shared<const CarryingSurface>(
        surface_of_nodes(*bodies[body],
                         interface.carrying_surface,
                         nodes,
                         interface.discretisation ==
                           Discretisation::node_to_node));
    }



    void
    remove_overclosure(const ContactPair &contact, ContactInterface &interface)
    {
      Assert(contact.overclosure != Overclosure::undefined,
             ExcMessage("What becomes of an overlap was never set."));
      if (contact.overclosure == Overclosure::push_apart)
        return;
      unsigned int deepest = 0;
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        if (interface.rows[k].initial_gap < interface.rows[deepest].initial_gap)
          deepest = k;
      const double gap = interface.rows[deepest].initial_gap;
      if (gap < 0. && contact.overclosure == Overclosure::refuse)
        throw InputError("Contact " + contact.name + "/Overclosure",
                         name_of(contact.overclosure),
                         "the bodies overlap from the start by up to " +
                           to_text(-gap) + ", at " +
                           to_text(interface.points[deepest].first),
                         "Move them apart, or choose push apart or adjust.");
      for (GapRow &row : interface.rows)
        row.initial_gap = std::max(0., row.initial_gap);
    }
  } // namespace



  GapRows::GapRows(const std::vector<ContactInterface> &contacts)
  {
    firsts.push_back(0);
    for (const ContactInterface &contact : contacts)
      {
        for (const GapRow &row : contact.rows)
          rows.push_back(&row);
        firsts.push_back(rows.size());
      }
  }



  GapRows::GapRows(const std::vector<GapRow> &all)
    : firsts{0, static_cast<unsigned int>(all.size())}
  {
    for (const GapRow &row : all)
      rows.push_back(&row);
  }



  std::pair<unsigned int, unsigned int>
  GapRows::in_contact(const unsigned int row) const
  {
    AssertIndexRange(row, size());
    const auto next = std::upper_bound(firsts.begin(), firsts.end(), row);
    return {next - firsts.begin() - 1, row - *(next - 1)};
  }



  ArrayView<const double>
  GapRows::of_contact(const unsigned int         contact,
                      const std::vector<double> &values) const
  {
    AssertDimension(values.size(), size());
    return {values.data() + firsts[contact],
            firsts[contact + 1] - firsts[contact]};
  }



  std::vector<unsigned int>
  GapRows::of_contact(const unsigned int               contact,
                      const std::vector<unsigned int> &some) const
  {
    std::vector<unsigned int> result;
    for (const unsigned int row : some)
      if (row >= firsts[contact] && row < firsts[contact + 1])
        result.push_back(row - firsts[contact]);
    return result;
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
  search_reach(const ContactPair &contact, const Bodies &bodies)
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
    return interface_within(contact, bodies, search_reach(contact, bodies));
  }



  ContactInterface
  interface_within(const ContactPair &contact,
                   const Bodies      &bodies,
                   const double       reach)
  {
    return interface_within(ContactSides(contact, bodies), reach);
  }



  ContactInterface
  interface_within(const ContactSides &sides, const double reach)
  {
    const Bodies &bodies   = sides.bodies();
    ContactPair   contact  = sides.contact();
    contact.discretisation = decided(sides, reach);
    ContactInterface interface;
    interface.name           = contact.name;
    interface.discretisation = contact.discretisation;
    interface.first_body     = contact.first.body;
    if (contact.obstacle == nullptr)
      interface.second_body = contact.second.body;
    interface.obstacle    = contact.obstacle;
    interface.second_name = contact.obstacle != nullptr ?
                              contact.obstacle->name :
                              bodies[contact.second.body]->name();

    Gaps gaps = find_gaps(sides, reach, interface);
    if (!sides.have_moved())
      check_not_passed(contact, bodies, interface.points_on_second, gaps);
    if (gaps.gaps.empty())
      fail_without_pairs(contact, bodies, reach);
    (interface.points_on_second ? interface.unpaired_second :
                                  interface.unpaired) = gaps.unpaired;
    add_rows(contact, bodies, gaps, interface);
    interface.surface =
      gaps.surface != nullptr ? gaps.surface : surface_of(interface, bodies);
    interface.sampled = std::move(gaps.points);
    if (!sides.have_moved())
      remove_overclosure(contact, interface);
    return interface;
  }
} // namespace lamella
