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
  /// Mesh of the contact points on a slave surface for visualization:
  /// quadrilaterals between neighboring points, and isolated points.
  class ContactSurface
  {
  public:
    /// Indices of the four contact points at its corners, in cyclic order.
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Keeps references to @p contact and to the @p structure of its bodies.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Returns the quadrilaterals of the mesh as indices of contact points.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Returns the indices of the contact points outside of quadrilaterals.
    const std::vector<unsigned int> &
    isolated_points() const
    {
      return alone;
    }

    /// Returns the mesh, deformed by the displacements @p u of all bodies. Data
    /// at each point are its results in @p rows (columns of the file
    /// contact_NAME.csv) and `separation`, the vector to the point on the
    /// master surface with which it is paired.
    VtuGrid
    grid(const BlockVector &u, const std::vector<ContactRow> &rows) const;

    /// Writes the mesh with the results of load step @p step to the file
    /// contact_NAME_STEP.vtu in @p directory and returns its name. Throws
    /// InputError on failure. Must be called by one process only.
    std::string
    write_vtu(const std::string             &directory,
              const unsigned int             step,
              const BlockVector             &u,
              const std::vector<ContactRow> &rows) const;

  private:
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
