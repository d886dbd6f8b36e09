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
  /// Mesh of the points of a contact, for pictures only: the grid cells of its
  /// SlaveSurface with points at all four corners, and other points alone.
  class ContactSurface
  {
  public:
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Refers to both arguments; @p contact is on bodies of @p structure.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Numbers of the contact's points, with the corners in cyclic order.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Numbers of the points in no quadrilateral.
    const std::vector<unsigned int> &
    isolated_points() const
    {
      return alone;
    }

    /// Returns the surface on the displaced first body. It has the columns of
    /// contact_NAME.csv at its points (`active` as `status`) and `separation`,
    /// the vector to the displaced partner (gap times normal for a rigid
    /// obstacle). @p rows are the contact's in a load step and @p u the
    /// displacements of the scene.
    VtuGrid
    grid(const BlockVector &u, const std::vector<ContactRow> &rows) const;

    /// Writes grid() of load step @p step as @p directory/contact_NAME_STEP.vtu
    /// for ParaView. Returns the file's name without the folder. Throws
    /// InputError on failure. Called by one process.
    std::string
    write_vtu(const std::string             &directory,
              const unsigned int             step,
              const BlockVector             &u,
              const std::vector<ContactRow> &rows) const;

  private:
    /// Returns the location of each point on the slave body.
    std::vector<Location>
    point_locations() const;

    const ContactInterface &contact;
    const Structure        &structure;
    /// quadrilaterals() and isolated_points().
    std::vector<Quadrilateral> quads;
    std::vector<unsigned int>  alone;
    /// Locations of points on the first body, on the second if deformable.
    std::vector<Location> first_locations, second_locations;
  };
} // namespace lamella

#endif
