// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_contact_sides_h
#define lamella_contact_contact_sides_h

#include <lamella/base/linear_algebra.h>
#include <lamella/base/row.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/mesh_surface.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * The two surfaces of a contact where they stand in a state: undeformed, or
   * moved by displacements u of the bodies and the load factor of an obstacle.
   * All that pairing and gap rows ask about geometry; each part is made when
   * somebody asks for the first time.
   *
   * Refers to the bodies, which have to live longer. Scene axes.
   */
  class ContactSides
  {
  public:
    /// Undeformed, the obstacle before it moves.
    ContactSides(const ContactPair &contact, const Bodies &bodies);

    /// Those of @p undeformed, which has to live longer, displaced by @p u (a
    /// block a body), the obstacle at load factor @p factor: control points of
    /// all facets are moved by u at their trace nodes.
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

    /// What `automatic` in the contact has become, of the discretisation and of
    /// the side that carries the points: for those that are moved from here on.
    void
    decide(const Discretisation discretisation, const PointsOn points_on)
    {
      pair.discretisation = discretisation;
      pair.points_on      = points_on;
    }

    /// Whether rows are those of edges: their gaps are along the normals of the
    /// other side, at the feet.
    bool
    are_of_edges() const
    {
      return pair.discretisation == Discretisation::edge_to_surface;
    }

    bool
    have_moved() const
    {
      return undeformed != nullptr;
    }

    /// Null where Second is an obstacle.
    const MeshSurface *
    surface(const bool second) const;

    /// Where it stands; null where Second is a body.
    std::shared_ptr<const Obstacle>
    obstacle() const
    {
      return standing;
    }

    /// Body::surface_points() of a side, which are there, with their normals;
    /// locations and tributary areas stay those of the undeformed body. None of
    /// an obstacle. Of edges those alone at which the body starts or ends.
    std::vector<SurfacePoint>
    points(const bool second) const;

    /// Those at which the body starts or ends, whatever rows are of.
    std::vector<SurfacePoint>
    end_points(const bool second) const;

    /// Where each trace node of surface() is in its body, and the three rows of
    /// its displacement: made once, of the undeformed; of bodies whose rows
    /// turn, those of the state.
    const std::vector<Location> &
    trace_places(const bool second) const;
    const std::vector<std::vector<Row>> &
    trace_rows(const bool second) const;
    /// Those of the nodes @p numbers alone.
    std::vector<std::vector<Row>>
    trace_rows(const bool                       second,
               const std::vector<unsigned int> &numbers) const;

  private:
    /// @p points of a side where they stand.
    std::vector<SurfacePoint>
    standing_points(const bool second, std::vector<SurfacePoint> points) const;

    const Region &
    region(const bool second) const
    {
      return second ? pair.second : pair.first;
    }

    /// Where bodies have moved, those of the trace nodes.
    std::vector<dealii::Tensor<1, 3>>
    trace_displacements(const bool second) const;

    ContactPair                     pair;
    const Bodies                   &all_bodies;
    const ContactSides             *undeformed = nullptr;
    const BlockVector              *u          = nullptr;
    std::shared_ptr<const Obstacle> standing;

    mutable std::array<std::unique_ptr<const MeshSurface>, 2> surfaces;
    mutable std::array<std::vector<Location>, 2>              places;
    mutable std::array<std::vector<std::vector<Row>>, 2>      rows;
  };
} // namespace lamella

#endif
