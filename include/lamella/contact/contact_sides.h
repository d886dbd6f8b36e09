// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_sides_h
#define lamella_contact_contact_sides_h

#include <lamella/base/linear_algebra.h>
#include <lamella/base/linear_functional.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/mesh_surface.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Geometry of the two surfaces of a contact, undeformed or deformed, for
  /// pairing and constraints. Each surface is created at first use, in scene
  /// axes. Keeps references to the bodies, which must outlive this object.
  class ContactSides
  {
  public:
    /// Creates the undeformed sides, with the obstacle at its initial position.
    ContactSides(const ContactPair &contact, const Bodies &bodies);

    /// Creates the sides displaced by @p u from @p undeformed, which must
    /// outlive this object, with the obstacle at load factor @p factor.
    ContactSides(const ContactSides &undeformed,
                 const BlockVector  &u,
                 const LoadFactor   &factor);

    const ContactPair &
    contact() const
    {
      return pair;
    }
    const Bodies &
    bodies() const
    {
      return all_bodies;
    }

    /// Sets the discretization and slave side that `automatic` has chosen.
    void
    set_discretization(const Discretization discretization,
                       const SlaveSide      slave_side)
    {
      pair.discretization = discretization;
      pair.slave_side     = slave_side;
    }

    /// Returns true for edge contact, whose gaps are along master normals.
    bool
    is_edge_contact() const
    {
      return pair.discretization == Discretization::edge_to_surface;
    }

    bool
    are_displaced() const
    {
      return undeformed != nullptr;
    }

    /// Returns the surface of a side; null if the second side is an obstacle.
    const MeshSurface *
    surface(const bool second) const;

    /// Returns the obstacle at its current position; null for two bodies.
    std::shared_ptr<const Obstacle>
    obstacle() const
    {
      return standing;
    }

    /// Returns the surface nodes of a side with current positions and normals,
    /// and undeformed tributary areas; for edge contact, only those at body
    /// ends. Empty for an obstacle.
    std::vector<SurfacePoint>
    points(const bool second) const;

    /// Returns the surface points at body ends, for any discretization.
    std::vector<SurfacePoint>
    end_points(const bool second) const;

    /// Return, for each trace node of surface(), its location in the body, and
    /// its three displacement components as functionals of the DoFs (of their
    /// increments at finite rotations).
    const std::vector<Location> &
    trace_locations(const bool second) const;
    const std::vector<std::vector<LinearFunctional>> &
    trace_rows(const bool second) const;
    /// Returns trace_rows() of the trace nodes @p numbers only.
    std::vector<std::vector<LinearFunctional>>
    trace_rows(const bool                       second,
               const std::vector<unsigned int> &numbers) const;

  private:
    /// Returns @p points of a side, moved to their current positions.
    std::vector<SurfacePoint>
    displaced_points(const bool second, std::vector<SurfacePoint> points) const;

    const Region &
    region(const bool second) const
    {
      return second ? pair.second : pair.first;
    }

    /// Returns the displacements of the trace nodes of a displaced side.
    std::vector<dealii::Tensor<1, 3>>
    trace_displacements(const bool second) const;

    ContactPair                     pair;
    const Bodies                   &all_bodies;
    const ContactSides             *undeformed = nullptr;
    const BlockVector              *u          = nullptr;
    std::shared_ptr<const Obstacle> standing;

    mutable std::array<std::unique_ptr<const MeshSurface>, 2>         surfaces;
    mutable std::array<std::vector<Location>, 2>                      places;
    mutable std::array<std::vector<std::vector<LinearFunctional>>, 2> rows;
  };
} // namespace lamella

#endif
