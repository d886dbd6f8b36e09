// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_pair_h
#define lamella_contact_contact_pair_h

#include <lamella/base/linear_algebra.h>
#include <lamella/base/names.h>
#include <lamella/conditions/expression.h>
#include <lamella/conditions/load_factor.h>
#include <lamella/conditions/region.h>

#include <deal.II/base/point.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace lamella
{
  /// A rigid obstacle, the second side of contacts: a floor (half space behind
  /// a plane) or a roller (infinite circular cylinder), in prescribed motion or
  /// pressed by a given force along a guide (GuidedObstacle).
  struct Obstacle
  {
    /// Shape of an obstacle; `undefined` until it is set.
    enum class Shape
    {
      undefined,
      plane,
      cylinder
    };

    /// Name in `subsection Obstacle NAME`, and in `Second` of contacts.
    std::string name;
    Shape       shape = Shape::undefined; ///< Plane or cylinder.
    /// Initial position of a point of the plane or of the cylinder axis.
    dealii::Point<3> point;
    /// Unit normal out of the half space, or direction of the cylinder axis.
    dealii::Tensor<1, 3> direction;
    /// Radius of the cylinder [length]; unused by a plane.
    double radius = 0.;
    /// Prescribed translation at load factor 1 [length], scene axes.
    dealii::Tensor<1, 3> displacement;
    /// Index of the load history of the displacement (LoadFactor::of()).
    unsigned int history = 0;

    /// Force at load factor 1 in place of `displacement` [force], scene axes;
    /// zero if the motion is prescribed.
    dealii::Tensor<1, 3> force = {};
    /// Index of the GuidedObstacle whose DoF is the displacement along `force`;
    /// empty if the motion is prescribed.
    std::optional<unsigned int> body = {};

    /// Returns the displacement [length] at load factor @p factor and, for an
    /// obstacle under a force, displacements @p u of all bodies. Without its
    /// block in @p u (temporary models), the obstacle is not displaced.
    dealii::Tensor<1, 3>
    displacement_at(const LoadFactor &factor, const BlockVector &u) const
    {
      dealii::Tensor<1, 3> moved = factor.of(history) * displacement;
      if (body && *body < u.n_blocks())
        moved += u.block(*body)[0] * guide();
      return moved;
    }

    /// Returns the unit vector along `force`.
    dealii::Tensor<1, 3>
    guide() const
    {
      return force / force.norm();
    }

    /// Returns true if the obstacle never moves.
    bool
    is_fixed() const
    {
      return displacement.norm() == 0. && !body;
    }

    /// Returns the largest depth at which the nearest surface point is unique:
    /// the radius of a cylinder, infinity for a plane.
    double
    depth() const
    {
      return shape == Shape::plane ? std::numeric_limits<double>::infinity() :
                                     radius;
    }

    /// Returns the component of @p v normal to the cylinder axis.
    dealii::Tensor<1, 3>
    across_axis(const dealii::Tensor<1, 3> &v) const
    {
      return v - (v * direction) * direction;
    }
  };

  /// Names of the shapes of obstacles in parameter files.
  template <>
  struct Names<Obstacle::Shape>
  {
    static constexpr NameOf<Obstacle::Shape> all[] = {
      {Obstacle::Shape::plane, "plane"},
      {Obstacle::Shape::cylinder, "cylinder"}}; ///< Value and name.
  };

  /// Intersection of a line with a surface.
  struct Hit
  {
    dealii::Point<3>     position; ///< Position, scene axes.
    dealii::Tensor<1, 3> normal;   ///< Outward unit normal of the surface.
    /// Distance along the line [length], negative against its direction: a gap.
    double distance = 0.;
  };

  /// Returns the nearest intersection, in either direction, of the line x + t
  /// d, with unit vector d, and the surface of the undisplaced @p obstacle, at
  /// which the line enters the obstacle against its outward normal:
  ///   plane:     t = (p - x) . N / (d . N),
  ///   cylinder:  |r + t e| = R, the smaller root t,
  /// with point p, direction N and radius R of the obstacle, and the components
  /// r and e of x - p and d normal to the axis. The result is empty if the line
  /// is parallel to the surface, leaves the half space, or misses the cylinder.
  std::optional<Hit>
  meet(const Obstacle             &obstacle,
       const dealii::Point<3>     &x,
       const dealii::Tensor<1, 3> &d);

  /// Returns true if @p x is inside the undisplaced @p obstacle.
  bool
  contains(const Obstacle &obstacle, const dealii::Point<3> &x);

  /// Enforcement of contact constraints. An active constraint satisfies g + a
  /// lambda = 0 with gap g, force lambda and compliance a = 1 / eps for
  /// `penalty` (parameter eps [force / length]), else a = 0. Constraints of
  /// ties are always active, in all three directions.
  enum class Enforcement
  {
    undefined,
    penalty,              ///< lambda = eps max(0, -g): bodies penetrate
    augmented_lagrangian, ///< penalty about a multiplier estimate, improved
                          ///< until there is no penetration
    exact,                ///< Lagrange multipliers: g >= 0
    tied                  ///< Lagrange multipliers: no relative displacement
  };

  /// Names of the enforcement methods in parameter files.
  template <>
  struct Names<Enforcement>
  {
    static constexpr NameOf<Enforcement> all[] = {
      {Enforcement::penalty, "penalty"},
      {Enforcement::augmented_lagrangian, "augmented lagrangian"},
      {Enforcement::exact, "exact"},
      {Enforcement::tied, "tied"}}; ///< Value and name of each method.
  };

  /// Unit of a penalty parameter. A small penalty permits penetration; a large
  /// one increases rounding errors (doc/theory/penalty.md).
  enum class PenaltyKind
  {
    undefined,
    automatic, ///< a multiple of the local stiffness of the cells in contact
    per_node,  ///< force / length, as in Eq. 23 of Nagaraj et al. 2020
    per_area   ///< force / length^3, times the tributary area: mesh-independent
  };

  /// Names of units of a numeric penalty; `auto` needs no unit.
  template <>
  struct Names<PenaltyKind>
  {
    /// Value and name of each unit.
    static constexpr NameOf<PenaltyKind> all[] =
      {{PenaltyKind::per_area, "area"}, {PenaltyKind::per_node, "node"}};
  };

  /// Penalty parameter of a contact, as given in a scene file.
  struct Penalty
  {
    /// Unit of `value`. Must be set before row_penalty().
    PenaltyKind kind = PenaltyKind::undefined;
    /// Positive penalty; if `automatic`, a multiple of the local stiffness.
    double value = 0.;
  };

  /// Adhesive layer between tied surfaces, linear elastic and without volume:
  /// traction = modulus / thickness times relative displacement.
  struct Adhesive
  {
    double thickness = 0., ///< Thickness [length]; zero: no adhesive.
      modulus        = 0., ///< Modulus in the normal direction.
      shear_modulus  = 0.; ///< Shear modulus [force / length^2].
  };

  /// Stiffness E_n A / h [force / length] of the cell behind one side of a
  /// contact constraint: a bar of modulus E_n, cross section A and length h.
  struct LocalStiffness
  {
    double normal_modulus = 0., ///< Modulus along the normal [force/length^2].
      area                = 0., ///< Tributary area [length^2].
      depth               = 0.; ///< Cell depth along the normal [length].
  };

  /// Returns the penalty parameter of one constraint [force / length]:
  ///   automatic   value * min over both sides of E_n A / h
  ///   per_node    value
  ///   per_area    value * A, A that of @p first (both sides have the same)
  /// with the members of @p penalty, and the normal modulus E_n, tributary area
  /// A and cell depth h > 0 of @p first and @p second. Supports do not enter.
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second);

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
    Adhesive                    adhesive; ///< Adhesive layer of tied surfaces.
    /// Part of the slave surface with constraints: facets at whose center the
    /// expression is not zero; null for all.
    std::shared_ptr<const Expression> where;

    /// Returns true for tied surfaces.
    bool
    is_tied() const
    {
      return enforcement == Enforcement::tied;
    }

    /// Returns true if constraints have slips: with friction, and of ties.
    bool
    has_slips() const
    {
      return friction > 0. || is_tied();
    }
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
