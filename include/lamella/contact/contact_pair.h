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
  /// Discretization of the gap function, Eq. 16 of Nagaraj et al. 2020. Only
  /// `surface to surface` passes patch tests on arbitrary meshes.
  enum class Discretization
  {
    undefined,
    automatic,          ///< node to node if all nodes match, else surface to
                        ///< surface (make_interface())
    node_to_node,       ///< pairs of facing nodes
    node_to_surface,    ///< slave nodes against the master surface
    surface_to_surface, ///< gaps averaged with slave hat functions
    edge_to_surface,    ///< slave nodes at the ends of the body against the
                        ///< master surface, in any direction
    line_to_roller ///< the line of a finite-rotation beam nearest to a cylinder
                   ///< axis, one constraint per position along the axis
  };

  /// Names of gap discretizations in parameter files.
  template <>
  struct Names<Discretization>
  {
    static constexpr NameOf<Discretization> all[] = {
      {Discretization::automatic, "auto"},
      {Discretization::node_to_node, "node to node"},
      {Discretization::node_to_surface, "node to surface"},
      {Discretization::surface_to_surface, "surface to surface"},
      {Discretization::edge_to_surface, "edge to surface"},
      {Discretization::line_to_roller, "line to roller"}}; ///< Value and name.
  };

  /// Treatment of an initial overlap of the bodies (negative initial gap). An
  /// overlap deeper than a cell is always an InputError.
  enum class Overclosure
  {
    undefined,
    resolve, ///< contact forces resolve it: an interference fit
    adjust,  ///< it is subtracted from the gaps, without strain
    refuse   ///< it is an InputError
  };

  /// Names of treatments of initial overlap in parameter files.
  template <>
  struct Names<Overclosure>
  {
    static constexpr NameOf<Overclosure> all[] = {
      {Overclosure::resolve, "resolve"},
      {Overclosure::adjust, "adjust"},
      {Overclosure::refuse, "error"}}; ///< Value and name of each treatment.
  };

  /// Slave (nonmortar) side of a contact, on which contact forces are unknowns.
  enum class SlaveSide
  {
    undefined,
    automatic, ///< the side with the finer grid where the two face each other;
               ///< the first for edges
    first,
    second
  };

  /// Names of the slave side in parameter files.
  template <>
  struct Names<SlaveSide>
  {
    /// Value and name of each choice.
    static constexpr NameOf<SlaveSide> all[] = {{SlaveSide::automatic, "auto"},
                                                {SlaveSide::first, "first"},
                                                {SlaveSide::second, "second"}};
  };

  /// Parameters of a contact between two named surfaces, as read by
  /// ContactParameters::parse(). The order of the surfaces determines signs
  /// only: the contact normal is the outward normal of the first.
  struct ContactPair
  {
    /// Name in `subsection Contact NAME`, used in messages, tables and files.
    std::string name;
    Region      first, ///< Surface of a body.
      second;          ///< Surface of another body; unused with an obstacle.
    /// Rigid obstacle in place of `second`, or null. It has no nodes, so `node
    /// to node`, `edge to surface` and a slave side are excluded.
    std::shared_ptr<const Obstacle> obstacle;

    /// Discretization of the gap function. Must be set.
    Discretization discretization = Discretization::undefined;
    /// Multiplier or penalty method that enforces the contact. Must be set.
    Enforcement enforcement = Enforcement::undefined;
    Overclosure overclosure = Overclosure::resolve; ///< Treats initial overlap.
    SlaveSide   slave_side  = SlaveSide::automatic; ///< Side with constraints.
    /// Penalty parameter. For multiplier methods it affects convergence only.
    Penalty penalty;
    /// For `node to node`: nodes form a pair if their tangential offset is at
    /// most this fraction of the root of their tributary area.
    double tolerance = 1e-6;
    /// Distance beyond which points get no constraint [length]; empty: `auto`.
    std::optional<double> search_distance;
    /// Coulomb friction coefficient mu; 0 for frictionless contact.
    double friction = 0.;
    /// True if `auto` chose the discretization: `line to roller` then becomes
    /// `surface to surface` once contact extends beyond a line, and an `edge to
    /// surface` contact is added at body ends. False if the scene gives it.
    bool is_automatic = false;
    /// For an `edge to surface` contact added at body ends: index of the
    /// contact of the surfaces, in whose output it is included; else empty.
    std::optional<unsigned int> part_of;
  };

  /// Returns true if the discretization is, or may become, `node to node`.
  inline bool
  may_pair_nodes(const ContactPair &contact)
  {
    return contact.obstacle == nullptr &&
           (contact.discretization == Discretization::node_to_node ||
            contact.discretization == Discretization::automatic);
  }
} // namespace lamella

#endif
