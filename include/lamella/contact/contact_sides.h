// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_sides_h
#define lamella_contact_contact_sides_h

#include <lamella/base/linear_algebra.h>
#include <lamella/base/linear_functional.h>
#include <lamella/body/body.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/search.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Search tree of the nodes at both end sections of an undeformed body.
  class BodyEnds
  {
  public:
    explicit BodyEnds(const Body &body); ///< Collects the end nodes.

    /// Returns true if an end node is at @p x, to 1e-9 of the body size.
    bool
    has(const dealii::Point<3> &x) const;

  private:
    double                        near = 0.;
    std::vector<dealii::Point<3>> nodes;
    PointSearch                   search;
  };

  /// Geometry of the two surfaces of a contact, undeformed or deformed, for
  /// pairing and constraints. Each surface is created at first use, in scene
  /// axes. Keeps references to the bodies, which must outlive this object.
  class ContactSides
  {
  public:
    /// Creates the undeformed surfaces, with an obstacle in initial position.
    ContactSides(const ContactPair &contact, const Bodies &bodies);

    /// Creates the surfaces of @p undeformed, which must outlive this object,
    /// displaced by @p u, with an obstacle at load factor @p factor.
    ContactSides(const ContactSides &undeformed,
                 const BlockVector  &u,
                 const LoadFactor   &factor);

    /// Returns the parameters of the contact, after set_discretization().
    const ContactPair &
    contact() const
    {
      return pair;
    }
    /// Returns all bodies of the scene.
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

    /// Returns true for deformed surfaces, false for undeformed ones.
    bool
    are_displaced() const
    {
      return undeformed != nullptr;
    }

    /// Returns the first or @p second surface; null for an obstacle.
    const MeshSurface *
    surface(const bool second) const;

    /// Returns the facets of the first or @p second surface in the part
    /// ContactPair::where of the undeformed body; empty if that is all.
    std::vector<bool>
    facets_of_part(const bool second) const;

    /// Returns the center of a facet of the first or @p second surface that the
    /// boundary of the part crosses, or an empty optional.
    std::optional<dealii::Point<3>>
    divided_facet(const bool second) const;

    /// Returns the obstacle at its current position; null between two bodies.
    std::shared_ptr<const Obstacle>
    obstacle() const
    {
      return standing;
    }

    /// Returns the nodes of the first or @p second surface with current
    /// positions and normals, and undeformed tributary areas; for edge contact,
    /// only nodes at body ends. Empty for an obstacle.
    std::vector<SurfacePoint>
    points(const bool second) const;

    /// Returns the nodes of the first or @p second surface at body ends.
    std::vector<SurfacePoint>
    end_points(const bool second) const;

    /// Returns the location in the body of each trace node of the first or @p
    /// second surface. Trace nodes are those of the displacements on facets.
    const std::vector<Location> &
    trace_locations(const bool second) const;
    /// Returns for each trace node of the first or @p second surface its three
    /// displacement components as functionals of (increments of) the DoFs. Only
    /// entries of @p nodes, and of earlier calls, are set.
    const std::vector<std::vector<LinearFunctional>> &
    trace_rows(const bool second, const std::vector<unsigned int> &nodes) const;

  private:
    /// Returns @p points of a surface, moved to their current positions.
    std::vector<SurfacePoint>
    displaced_points(const bool second, std::vector<SurfacePoint> points) const;

    const Region &
    region(const bool second) const
    {
      return second ? pair.second : pair.first;
    }

    /// Returns the displacements of the trace nodes of a displaced surface.
    std::vector<dealii::Tensor<1, 3>>
    trace_displacements(const bool second) const;

    ContactPair                     pair;
    const Bodies                   &all_bodies;
    const ContactSides             *undeformed = nullptr;
    BlockVector                     u; ///< Empty if undeformed.
    std::shared_ptr<const Obstacle> standing;

    mutable std::array<std::unique_ptr<const MeshSurface>, 2>         surfaces;
    mutable std::array<std::vector<Location>, 2>                      places;
    mutable std::array<std::vector<std::vector<LinearFunctional>>, 2> rows;
  };
} // namespace lamella

#endif
