// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/surface_topology.h>
#include <lamella/contact/gap_integrals.h>
#include <lamella/export/calculix_mesh.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr double       largest_angle = 2. * numbers::PI / 180.;
    constexpr double       margin        = 0.05;
    constexpr unsigned int n_along_plane = 8; ///< Elements each way.



    struct Range
    {
      double begin = std::numeric_limits<double>::max(),
             end   = -std::numeric_limits<double>::max();

      void
      add(const double value)
      {
        begin = std::min(begin, value);
        end   = std::max(end, value);
      }

      double
      length() const
      {
        return end - begin;
      }

      void
      widen(const double by)
      {
        begin -= by;
        end += by;
      }

      double
      at(const double share) const
      {
        return begin + share * length();
      }
    };



    /// n_s x n_t hexahedra, their nodes where @p place puts the (s, t, depth)
    /// of the unit cube; depth 1 is the surface.
    ObstacleLayer
    grid(const unsigned int                                     n_s,
         const unsigned int                                     n_t,
         const std::function<Point<3>(double, double, double)> &place)
    {
      const CalculixElement                               element("C3D20R");
      std::map<std::array<unsigned int, 3>, unsigned int> numbers;
      ObstacleLayer                                       layer;
      for (unsigned int i = 0; i < n_s; ++i)
        for (unsigned int j = 0; j < n_t; ++j)
          {
            layer.elements.emplace_back();
            for (unsigned int k = 0; k < element.n_nodes(); ++k)
              {
                const Point<3>                   &unit = element.unit_node(k);
                const std::array<unsigned int, 3> halves{
                  {2 * i + static_cast<unsigned int>(2. * unit[0]),
                   2 * j + static_cast<unsigned int>(2. * unit[1]),
                   static_cast<unsigned int>(2. * unit[2])}};
                const auto [at, is_new] =
                  numbers.insert({halves, layer.nodes.size()});
                if (is_new)
                  layer.nodes.push_back(place(0.5 * halves[0] / n_s,
                                              0.5 * halves[1] / n_t,
                                              unit[2]));
                layer.elements.back().push_back(at->second);
              }
          }
      return layer;
    }



    ObstacleLayer
    plane_layer(const Obstacle &plane, const std::vector<Point<3>> &facing)
    {
      const Tensor<1, 3> n = plane.direction, e = tangents_of(n)[0],
                         f = cross_product_3d(n, e);
      Range s, t;
      for (const Point<3> &x : facing)
        {
          s.add((x - plane.point) * e);
          t.add((x - plane.point) * f);
        }
      const double larger = std::max(s.length(), t.length());
      s.widen(margin * larger + std::abs(plane.displacement * e));
      t.widen(margin * larger + std::abs(plane.displacement * f));
      return grid(n_along_plane,
                  n_along_plane,
                  [&](const double a, const double b, const double depth) {
                    return plane.point + s.at(a) * e + t.at(b) * f +
                           0.1 * larger * (depth - 1.) * n;
                  });
    }



    ObstacleLayer
    cylinder_layer(const Obstacle              &cylinder,
                   const std::vector<Point<3>> &facing)
    {
      const Tensor<1, 3> axis = cylinder.direction;
      // Angles are counted from the middle of what faces.
      Tensor<1, 3> middle;
      Range        along, angle;
      for (const Point<3> &x : facing)
        {
          const Tensor<1, 3> r = x - cylinder.point;
          middle += r - (r * axis) * axis;
          along.add(r * axis);
        }
      const Tensor<1, 3> up   = middle / middle.norm(),
                         side = cross_product_3d(axis, up);
      for (const Point<3> &x : facing)
        {
          const Tensor<1, 3> r = x - cylinder.point;
          angle.add(std::atan2(r * side, r * up));
        }
      const Tensor<1, 3> &u = cylinder.displacement;
      along.widen(margin * along.length() + std::abs(u * axis));
      angle.widen(margin * angle.length() +
                  std::abs(u * side) / cylinder.radius);
      const unsigned int n_s = std::ceil(angle.length() / largest_angle);
      // Ten times as long as wide.
      const unsigned int n_t =
        std::ceil(0.1 * along.length() / (cylinder.radius * largest_angle));
      return grid(n_s,
                  n_t,
                  [&](const double a, const double b, const double depth) {
                    const double r   = cylinder.radius * (0.9 + 0.1 * depth),
                                 phi = angle.at(a);
                    return cylinder.point + along.at(b) * axis +
                           r * (std::cos(phi) * up + std::sin(phi) * side);
                  });
    }
  } // namespace



  ObstacleLayer
  make_layer(const Obstacle &obstacle, const std::vector<Point<3>> &facing)
  {
    ObstacleLayer layer = obstacle.shape == Obstacle::Shape::plane ?
                            plane_layer(obstacle, facing) :
                            cylinder_layer(obstacle, facing);
    layer.displacement  = obstacle.displacement;
    return layer;
  }



  namespace
  {
    /// What decides which side is the slave, and how stiff the contact is.
    struct SideMeasures
    {
      double area = 0., ///< Mean area of a face.
        stiffness = 0.; ///< Automatic contact stiffness K.
    };



    /// K over E_n / h that suits @p body.
    double
    relative_stiffness(const Body &body)
    {
      const BoundingBox<3> box       = body.bounding_box();
      const auto [smallest, largest] = std::minmax(
        {box.side_length(0), box.side_length(1), box.side_length(2)});
      return 100. * std::min(1., 10. * smallest / largest);
    }

    SideMeasures
    measures_of(const Body &body, const std::string &surface)
    {
      SideMeasures                    result;
      const std::vector<SurfaceFacet> facets = surface_facets(body, surface);
      for (const SurfaceFacet &facet : facets)
        {
          const SurfacePoint middle =
            body.surface_point(facet, Point<2>(0.5, 0.5));
          result.area += middle.area / facets.size();
          result.stiffness =
            std::max(result.stiffness, middle.normal_modulus / middle.depth);
        }
      result.stiffness *= relative_stiffness(body);
      return result;
    }



    /// Where the normals of @p contact's first surface meet its obstacle.
    std::vector<Point<3>>
    facing_points_on_surface(const ContactPair &contact, const Bodies &bodies)
    {
      const Body           &body          = *bodies[contact.first.body];
      const double          search_radius = contact.search_distance ?
                                              *contact.search_distance :
                                              automatic_search_distance(contact, bodies);
      std::vector<Point<3>> places;
      for (const SurfaceFacet &facet :
           surface_facets(body, contact.first.surface))
        for (const double s : {0., 0.5, 1.})
          for (const double t : {0., 0.5, 1.})
            {
              const SurfacePoint from =
                body.surface_point(facet, Point<2>(t, s));
              const auto hit =
                meet(*contact.obstacle, from.position, from.normal);
              if (hit && std::abs(hit->distance) <= search_radius)
                places.push_back(hit->position);
            }
      if (places.empty())
        throw InputError(
          "Contact " + contact.name,
          "",
          "contact.no-pairs: no point of First faces the obstacle '" +
            contact.obstacle->name + "' within the search distance " +
            to_text(search_radius) + " along its normal",
          "Check the surface in First and the position of the obstacle.");
      return places;
    }



    void
    write_surface(std::ostream        &deck,
                  const std::string   &name,
                  const CalculixFaces &faces)
    {
      deck << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
      for (const auto &[element, face] : faces)
        deck << element << ", S" << calculix_face(face) << '\n';
    }



    /// Coulomb's law with @p coefficient, where it is not zero. It sticks as a
    /// spring: shear over slip is a tenth of pressure over penetration, @p
    /// stiffness; with as much CalculiX' iterations do not end.
    std::string
    friction(const double coefficient, const double stiffness)
    {
      constexpr double stick_slope = 0.1;
      return coefficient > 0. ?
               "*FRICTION\n" + calculix_number(coefficient) + ", " +
                 calculix_number(stick_slope * stiffness) + "\n" :
               "";
    }



    /// The lines that say how @p pair acts between the surfaces @p slave and @p
    /// master, under the @p name; @p stiffness is that of contact.
    std::string
    law_between(const ContactPair &pair,
                const std::string &name,
                const std::string &slave,
                const std::string &master,
                const double       stiffness)
    {
      const Adhesive   &layer = pair.adhesive;
      const std::string sides = slave + ", " + master + "\n";
      if (pair.is_tied() && layer.thickness == 0.)
        return "*TIE, NAME=" + name + ", ADJUST=NO\n" + sides;
      const std::string begin = "*SURFACE INTERACTION, NAME=" + name +
                                "\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=",
                        end = "*CONTACT PAIR, INTERACTION=" + name +
                              ", TYPE=SURFACE TO SURFACE\n" + sides;
      // Of tied contact the coefficient of friction is without effect.
      if (pair.is_tied())
        return begin + "TIED\n" +
               calculix_number(layer.modulus / layer.thickness) +
               "\n*FRICTION\n1., " +
               calculix_number(layer.shear_modulus / layer.thickness) + "\n" +
               end;
      return "** linear penalty in the place of the scene's enforcement\n" +
             begin + "LINEAR\n" + calculix_number(stiffness) + "\n" +
             friction(pair.friction, stiffness) + end;
    }



    /// Throws InputError for what a deck cannot say.
    void
    check_law(const ContactPair &pair, const std::string &path)
    {
      if (pair.where != nullptr)
        throw InputError(path + "/Where",
                         "",
                         "export.part-of-surface: contacts on a part of the "
                         "surfaces are not exported",
                         "Divide the body, or remove Where.");
      if (pair.overclosure == Overclosure::adjust)
        throw InputError(
          path + "/Overclosure",
          name_of(pair.overclosure),
          "export.overclosure-adjust: adjust subtracts the initial overlap "
          "from the gaps without moving nodes, which CalculiX cannot do",
          "Move the bodies apart, or write Overclosure = resolve.");
      if (pair.discretization == Discretization::edge_to_surface)
        throw InputError(
          path + "/Discretization",
          name_of(pair.discretization),
          "export.edge-contact: edge to surface contact is not exported, since "
          "contact between faces in CalculiX includes their edges",
          "Remove this contact from Contacts.");
    }
  } // namespace



  CalculixContacts::CalculixContacts(const Scene                 &scene,
                                     const CalculixMesh          &mesh,
                                     const std::optional<double> &stiffness)
    : scene(scene)
    , next_node(mesh.n_nodes() + 1)
    , next_element(mesh.n_elements() + 1)
  {
    for (unsigned int k = 0; k < scene.contacts.size(); ++k)
      {
        add(k, mesh);
        if (stiffness)
          list.back().stiffness = *stiffness;
      }
  }



  void
  CalculixContacts::add(const unsigned int k, const CalculixMesh &mesh)
  {
    const ContactPair &pair = scene.contacts[k];
    const std::string  path = "Contact " + pair.name;
    check_law(pair, path);
    const auto side = [&](const Region &region) -> const Body & {
      const Body &body = *mesh.bodies()[region.body];
      check_surface(body, region.surface, path);
      return body;
    };

    CalculixContact    contact;
    const SideMeasures first =
      measures_of(side(pair.first), pair.first.surface);
    contact.name      = pair.name;
    contact.slave     = mesh.faces(pair.first.body, pair.first.surface);
    contact.stiffness = first.stiffness;
    if (pair.obstacle != nullptr)
      add_layer(make_layer(*pair.obstacle,
                           facing_points_on_surface(pair, mesh.bodies())),
                contact);
    else
      {
        const SideMeasures second =
          measures_of(side(pair.second), pair.second.surface);
        contact.master    = mesh.faces(pair.second.body, pair.second.surface);
        contact.stiffness = std::min(first.stiffness, second.stiffness);
        contact.slave_is_second =
          pair.slave_side == SlaveSide::second ||
          (pair.slave_side == SlaveSide::automatic &&
           second.area < (1. - arithmetic::quadrature_tolerance) * first.area);
        if (contact.slave_is_second)
          std::swap(contact.slave, contact.master);
      }
    list.push_back(std::move(contact));
  }



  void
  CalculixContacts::add_layer(ObstacleLayer layer, CalculixContact &contact)
  {
    contact.layer         = std::move(layer);
    contact.first_node    = next_node;
    contact.first_element = next_element;
    // Face 5 of deal.II is CalculiX' second.
    for (unsigned int e = 0; e < contact.layer->elements.size(); ++e)
      contact.master.emplace_back(next_element + e, 5);
    next_node += contact.layer->nodes.size();
    next_element += contact.layer->elements.size();
  }



  std::string
  CalculixContacts::surface_name(const unsigned int k, const bool slave)
  {
    return "CONTACT" + std::to_string(k + 1) + (slave ? "_SLAVE" : "_MASTER");
  }



  void
  CalculixContacts::write_layer(std::ostream &deck, const unsigned int k) const
  {
    const CalculixContact &contact = list[k];
    const std::string      name    = "OBSTACLE" + std::to_string(k + 1);
    deck << "** " << name << " is the obstacle '"
         << scene.contacts[k].obstacle->name << "', rigid\n*NODE, NSET=" << name
         << '\n';
    for (unsigned int n = 0; n < contact.layer->nodes.size(); ++n)
      write_node(deck, contact.first_node + n, contact.layer->nodes[n]);
    deck << "*ELEMENT, TYPE=C3D20R, ELSET=" << name << '\n';
    for (unsigned int e = 0; e < contact.layer->elements.size(); ++e)
      {
        std::vector<unsigned int> nodes = contact.layer->elements[e];
        for (unsigned int &node : nodes)
          node += contact.first_node;
        write_element(deck, contact.first_element + e, nodes);
      }
    // All nodes are prescribed: any material will do.
    deck << "*MATERIAL, NAME=" << name << "\n*ELASTIC\n"
         << calculix_number(scene.materials.begin()->second.elastic.E1)
         << ", 0.3\n*DENSITY\n1.\n*SOLID SECTION, ELSET=" << name
         << ", MATERIAL=" << name << '\n';
  }



  void
  CalculixContacts::write_model(std::ostream &deck) const
  {
    for (unsigned int k = 0; k < list.size(); ++k)
      {
        const CalculixContact &contact = list[k];
        if (contact.layer)
          write_layer(deck, k);
        const std::string name   = "CONTACT" + std::to_string(k + 1),
                          slave  = surface_name(k, true),
                          master = surface_name(k, false);
        deck << "** " << name << " is the contact '" << contact.name
             << "', its slave the "
             << (contact.slave_is_second ? "second" : "first") << " side\n";
        write_surface(deck, slave, contact.slave);
        write_surface(deck, master, contact.master);
        deck << law_between(
          scene.contacts[k], name, slave, master, contact.stiffness);
      }
  }



  void
  CalculixContacts::write_step(std::ostream &deck, const double factor) const
  {
    for (unsigned int k = 0; k < list.size(); ++k)
      if (list[k].layer)
        {
          deck << "*BOUNDARY\n";
          for (unsigned int c = 0; c < 3; ++c)
            deck << "OBSTACLE" << k + 1 << ", " << c + 1 << ", " << c + 1
                 << ", "
                 << calculix_number(factor * list[k].layer->displacement[c])
                 << '\n';
        }
  }



  void
  CalculixContacts::write_output(std::ostream &deck) const
  {
    for (unsigned int k = 0; k < list.size(); ++k)
      if (const ContactPair &pair = scene.contacts[k];
          !pair.is_tied() || pair.adhesive.thickness > 0.)
        deck << "*CONTACT PRINT, SLAVE=" << surface_name(k, true)
             << ", MASTER=" << surface_name(k, false) << "\nCF, CSTR\n";
  }
} // namespace lamella
