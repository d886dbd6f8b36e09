// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
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



    /// Adds up rows of one body.
    class RowSum
    {
    public:
      explicit RowSum(const DofIndex n_dofs)
        : weights(n_dofs, 0.)
        , is_touched(n_dofs, false)
      {}

      void
      add(const Row &row, const double factor)
      {
        for (const auto &[dof, weight] : row.entries())
          {
            if (!is_touched[dof])
              touched.push_back(dof);
            is_touched[dof] = true;
            weights[dof] += factor * weight;
          }
      }

      /// The sum; it begins anew.
      Row
      take()
      {
        std::sort(touched.begin(), touched.end());
        Row row;
        for (const DofIndex dof : touched)
          {
            row.add(dof, weights[dof]);
            weights[dof]    = 0.;
            is_touched[dof] = false;
          }
        touched.clear();
        return row;
      }

    private:
      std::vector<double>   weights;
      std::vector<bool>     is_touched;
      std::vector<DofIndex> touched;
    };



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



    /// The rows of @p side on the body @p index; @p places as those of the
    /// side, in this body's elements.
    std::vector<BodyRow>
    body_rows(const unsigned int           index,
              const Body                  &body,
              const std::vector<Location> &places,
              const RowGeometry           &side)
    {
      const auto           at = body.rows(places, Quantity::displacement);
      RowSum               sum(body.n_dofs());
      std::vector<BodyRow> rows;
      for (const RowGeometry::Weights &weights : side.weights)
        {
          for (const auto &[k, w] : weights)
            for (unsigned int c = 0; c < 3; ++c)
              sum.add(at[k][c], w[c]);
          rows.push_back({index, sum.take()});
        }
      return rows;
    }



    /// The two surfaces of a contact.
    struct Surfaces
    {
      std::unique_ptr<const MeshSurface>     first, second;
      std::unique_ptr<const ObstacleSurface> obstacle;
    };



    Surfaces
    make_surfaces(const ContactPair &contact, const Bodies &bodies)
    {
      Surfaces surfaces;
      surfaces.first =
        std::make_unique<MeshSurface>(*bodies[contact.first.body],
                                      contact.first.surface);
      if (contact.obstacle != nullptr)
        surfaces.obstacle = std::make_unique<ObstacleSurface>(contact.obstacle);
      else
        surfaces.second =
          std::make_unique<MeshSurface>(*bodies[contact.second.body],
                                        contact.second.surface);
      return surfaces;
    }



    /// Whether the second side has the finer grid where the two face each
    /// other. Equal grids: the body that comes first, so that it does not
    /// matter which side is called First.
    bool
    second_is_finer(const ContactPair &contact,
                    const Surfaces    &surfaces,
                    const double       reach)
    {
      const double first =
                     cells_facing(*surfaces.first, *surfaces.second, reach),
                   second =
                     cells_facing(*surfaces.second, *surfaces.first, reach);
      if (std::abs(first - second) > same_grid * (first + second))
        return second > first;
      return contact.second.body < contact.first.body;
    }



    bool
    points_on_second(const ContactPair &contact,
                     const Surfaces    &surfaces,
                     const double       reach)
    {
      Assert(contact.points_on != PointsOn::undefined,
             ExcMessage("The side that carries the points was never set."));
      if (contact.obstacle != nullptr ||
          contact.discretisation == Discretisation::node_to_node ||
          contact.points_on == PointsOn::first)
        return false;
      return contact.points_on == PointsOn::second ||
             second_is_finer(contact, surfaces, reach);
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
    pair_nodes(const ContactPair &contact,
               const Bodies      &bodies,
               const double       reach)
    {
      NodePairs nodes;
      nodes.first =
        bodies[contact.first.body]->surface_points(contact.first.surface);
      nodes.second =
        bodies[contact.second.body]->surface_points(contact.second.surface);
      nodes.pairing =
        pair_node_to_node(nodes.first, nodes.second, contact.tolerance, reach);
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
      const Surfaces surfaces = make_surfaces(contact, bodies);
      nodes.beside =
        count_facing(nodes.first, first_paired, *surfaces.second, reach);
      nodes.beside_second =
        count_facing(nodes.second, second_paired, *surfaces.first, reach);
      return nodes;
    }



    /// @p contact with the discretisation that `automatic` is on these bodies.
    ContactPair
    decided(ContactPair contact, const Bodies &bodies, const double reach)
    {
      if (contact.discretisation != Discretisation::automatic)
        return contact;
      contact.discretisation = Discretisation::surface_to_surface;
      if (contact.obstacle != nullptr)
        return contact;
      const NodePairs nodes = pair_nodes(contact, bodies, reach);
      if (!nodes.pairing.pairs.empty() &&
          nodes.beside + nodes.beside_second == 0)
        contact.discretisation = Discretisation::node_to_node;
      return contact;
    }



    /// Pairs of nodes in the form of weighted gaps.
    Gaps
    node_to_node(const ContactPair &contact,
                 const Bodies      &bodies,
                 const double       reach,
                 ContactInterface  &interface)
    {
      const NodePairs nodes         = pair_nodes(contact, bodies, reach);
      const auto &[first, second]   = std::tie(nodes.first, nodes.second);
      const Pairing &pairing        = nodes.pairing;
      interface.unpaired_second     = pairing.unpaired_second;
      interface.beside_nodes        = nodes.beside;
      interface.beside_nodes_second = nodes.beside_second;
      if (nodes.beside + nodes.beside_second > 0)
        interface.notes.push_back(
          "contact " + contact.name + ": " + std::to_string(nodes.beside) +
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
    find_gaps(const ContactPair &contact,
              const Bodies      &bodies,
              const double       reach,
              ContactInterface  &interface)
    {
      if (contact.discretisation == Discretisation::node_to_node)
        {
          Assert(contact.obstacle == nullptr,
                 ExcMessage("An obstacle has no nodes."));
          return node_to_node(contact, bodies, reach, interface);
        }
      const Surfaces surfaces    = make_surfaces(contact, bodies);
      interface.points_on_second = points_on_second(contact, surfaces, reach);
      Sides sides;
      sides.reach         = reach;
      sides.carrying      = surfaces.first.get();
      sides.opposing_mesh = surfaces.second.get();
      if (interface.points_on_second)
        std::swap(sides.carrying, sides.opposing_mesh);
      sides.opposing = sides.opposing_mesh;
      if (contact.obstacle != nullptr)
        sides.opposing = surfaces.obstacle.get();

      if (sides.opposing_mesh != nullptr)
        (interface.points_on_second ? interface.unpaired :
                                      interface.unpaired_second) =
          nodes_facing_nothing(*sides.opposing_mesh, *sides.carrying, reach);
      Assert(contact.discretisation != Discretisation::undefined,
             ExcMessage("The discretisation was never set."));
      if (contact.discretisation == Discretisation::surface_to_surface)
        return weighted_gaps(sides);
      const Region &carrying =
        interface.points_on_second ? contact.second : contact.first;
      return pair_node_to_surface(
        sides, bodies[carrying.body]->surface_points(carrying.surface));
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
      const auto           first = body_rows(contact.first.body,
                                   *bodies[contact.first.body],
                                   interface.first.places,
                                   interface.first);
      std::vector<BodyRow> second;
      if (contact.obstacle == nullptr)
        second = body_rows(contact.second.body,
                           *bodies[contact.second.body],
                           interface.second.places,
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



  ContactInterface
  make_interface(const ContactPair &contact, const Bodies &bodies)
  {
    const std::string path = "Contact " + contact.name;
    check_surface(*bodies[contact.first.body],
                  contact.first.surface,
                  path + "/First");
    if (contact.obstacle == nullptr)
      check_surface(*bodies[contact.second.body],
                    contact.second.surface,
                    path + "/Second");
    return interface_within(contact,
                            bodies,
                            contact.search_distance ?
                              *contact.search_distance :
                              automatic_search_distance(contact, bodies));
  }



  ContactInterface
  interface_within(const ContactPair &given,
                   const Bodies      &bodies,
                   const double       reach)
  {
    const ContactPair contact = decided(given, bodies, reach);
    ContactInterface  interface;
    interface.name           = contact.name;
    interface.discretisation = contact.discretisation;
    interface.first_body     = contact.first.body;
    if (contact.obstacle == nullptr)
      interface.second_body = contact.second.body;
    interface.obstacle    = contact.obstacle;
    interface.second_name = contact.obstacle != nullptr ?
                              contact.obstacle->name :
                              bodies[contact.second.body]->name();

    const Gaps gaps = find_gaps(contact, bodies, reach, interface);
    check_not_passed(contact, bodies, interface.points_on_second, gaps);
    if (gaps.gaps.empty())
      fail_without_pairs(contact, bodies, reach);
    (interface.points_on_second ? interface.unpaired_second :
                                  interface.unpaired) = gaps.unpaired;
    add_rows(contact, bodies, gaps, interface);
    interface.surface =
      gaps.surface != nullptr ? gaps.surface : surface_of(interface, bodies);
    remove_overclosure(contact, interface);
    return interface;
  }
} // namespace lamella
