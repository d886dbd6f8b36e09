// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_contact_surface_h
#define lamella_report_contact_surface_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/recover/results.h>
#include <lamella/report/vtu_file.h>
#include <lamella/solve/structure.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /// Mesh of the contact points of a contact for visualization: quadrilaterals
  /// between points on the SlaveSurface, and isolated points.
  class ContactSurface
  {
  public:
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Keeps references to both arguments, which must outlive this object. @p
    /// contact is between bodies of @p structure.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Returns the contact points (indices) of quadrilaterals in cyclic order.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Indices of the contact points that belong to no quadrilateral.
    const std::vector<unsigned int> &
    isolated_points() const
    {
      return alone;
    }

    /// Returns the mesh on the deformed slave body with the data @p rows of a
    /// load step: the columns of contact_NAME.csv at the points (`active` as
    /// `status`), and `separation`, the vector to the paired point on the
    /// master surface. @p u are the displacements of all bodies.
    VtuGrid
    grid(const BlockVector &u, const std::vector<ContactRow> &rows) const;

    /// Writes grid() for load step @p step to contact_NAME_STEP.vtu in @p
    /// directory and returns the name of the file. Throws InputError on
    /// failure. Must be called by one process only.
    std::string
    write_vtu(const std::string             &directory,
              const unsigned int             step,
              const BlockVector             &u,
              const std::vector<ContactRow> &rows) const;

  private:
    /// Returns the location of each contact point on the slave body.
    std::vector<Location>
    point_locations() const;

    const ContactInterface    &contact;
    const Structure           &structure;
    std::vector<Quadrilateral> quads;
    std::vector<unsigned int>  alone;
    /// Locations of contact points on the slave body, and of the paired points
    /// on the master body, if it is deformable.
    std::vector<Location> first_locations, second_locations;
  };
} // namespace lamella

#endif
