// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_pair_h
#define lamella_contact_contact_pair_h

#include <lamella/conditions/region.h>
#include <lamella/contact/enforcement.h>
#include <lamella/contact/obstacle.h>

#include <memory>
#include <optional>
#include <string>

namespace lamella
{
  /// How the gap function (Eq. 16) is sampled along two surfaces.
  /// doc/contact.md compares the three on patch tests: only the last one passes
  /// with any meshes.
  enum class Discretisation
  {
    undefined,
    automatic,          ///< node to node where all nodes match, else surface to
                        ///< surface: make_interface() decides
    node_to_node,       ///< nodes that face each other
    node_to_surface,    ///< nodes of one side against the other side's surface
    surface_to_surface, ///< gaps averaged with hat functions of one side
    edge_to_surface,    ///< nodes of one side where its body ends against the
                        ///< other side's surface, whichever way that faces the
                        ///< edge
    line_to_roller ///< of beams that turn the line that is nearest to the axis
                   ///< of a cylinder, a row a station along that
  };

  template <>
  struct Names<Discretisation>
  {
    static constexpr NameOf<Discretisation> all[] = {
      {Discretisation::automatic, "auto"},
      {Discretisation::node_to_node, "node to node"},
      {Discretisation::node_to_surface, "node to surface"},
      {Discretisation::surface_to_surface, "surface to surface"},
      {Discretisation::edge_to_surface, "edge to surface"},
      {Discretisation::line_to_roller, "line to roller"}};
  };

  /// What becomes of bodies that overlap from the start. An overlap is g_init <
  /// 0. One that is deeper than the cells below is no overclosure but an
  /// InputError, whatever this says.
  enum class Overclosure
  {
    undefined,
    push_apart, ///< contact forces push them apart: an interference fit
    adjust,     ///< the overlap is taken out of the gaps, without strain
    refuse      ///< an error
  };

  template <>
  struct Names<Overclosure>
  {
    static constexpr NameOf<Overclosure> all[] = {
      {Overclosure::push_apart, "push apart"},
      {Overclosure::adjust, "adjust"},
      {Overclosure::refuse, "error"}};
  };

  /// Which side carries the points of `node to surface`, the hat functions of
  /// `surface to surface` and the edges of `edge to surface`. In the words of
  /// mortar methods that is the slave (non-mortar) side. Unused by `node to
  /// node`.
  enum class PointsOn
  {
    undefined,
    automatic, ///< the side with the finer grid where the two face each other;
               ///< of edges the first
    first,
    second
  };

  template <>
  struct Names<PointsOn>
  {
    static constexpr NameOf<PointsOn> all[] = {{PointsOn::automatic, "auto"},
                                               {PointsOn::first, "first"},
                                               {PointsOn::second, "second"}};
  };

  /**
   * Two surfaces that may touch, and rub, as a scene says it: what
   * ContactParameters::parse() reads and make_interface() turns into gap rows.
   * Lengths are those of the scene, surfaces are named and not yet looked for.
   *
   * First and Second decide signs, nothing else: n of Eq. 16 is the outward
   * normal of First.
   */
  struct ContactPair
  {
    /// As in `subsection Contact NAME`; messages, tables and files are named by
    /// it.
    std::string name;
    /// Surfaces of two different bodies; `second` is unused with an obstacle.
    Region first, second;
    /// A rigid obstacle in the place of `second`, if not null. It has no nodes:
    /// `node to node`, `edge to surface` and points on the second side are not
    /// for it.
    std::shared_ptr<const Obstacle> obstacle;

    /// These two have to be set: `undefined` fails an assertion.
    Discretisation discretisation = Discretisation::undefined;
    Enforcement    enforcement    = Enforcement::undefined;
    Overclosure    overclosure    = Overclosure::push_apart;
    PointsOn       points_on      = PointsOn::automatic;
    /// Of `augmented lagrangian` and `exact`, too, where it is no part of the
    /// law but sets how fast estimates of the force become right.
    Penalty penalty;
    /// How far sideways facing nodes may be off, over the root of their
    /// tributary area (no unit): of `node to node` only, see
    /// pair_node_to_node().
    double tolerance = 1e-6;
    /// Places further apart than this along the normal are not paired; none for
    /// automatic_search_distance(). [length]
    std::optional<double> search_distance;
    /// Coulomb's coefficient mu; 0 without friction.
    double friction = 0.;
    /// Marks a discretization that `auto` chose. `surface to surface` replaces
    /// a `line to roller` when more than a line touches; an `edge to surface`
    /// joins `surface to surface` where an end of a body presses.
    bool is_automatic = false;
    /// The number of the contact whose ends of a body this one is for, of which
    /// its force is a part.
    std::optional<unsigned int> part_of;
  };

  /// Whether the nodes of both sides are paired, or would be if they matched.
  inline bool
  may_pair_nodes(const ContactPair &contact)
  {
    return contact.obstacle == nullptr &&
           (contact.discretisation == Discretisation::node_to_node ||
            contact.discretisation == Discretisation::automatic);
  }
} // namespace lamella

#endif
