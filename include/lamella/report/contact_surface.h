// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_contact_surface_h
#define lamella_report_contact_surface_h

#include <lamella/contact/gap_rows.h>
#include <lamella/recover/results.h>
#include <lamella/report/vtu_file.h>
#include <lamella/solve/structure.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The mesh that the points of a contact form: the cells of the grids of what
   * carries them (CarryingSurface) that have points at all four corners. Points
   * in none (with no paired neighbours) stand alone.
   *
   * It is a picture only, and nothing is computed from it. The neighbours are
   * searched for once, the surface is drawn in each load step.
   */
  class ContactSurface
  {
  public:
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Both are referred to and must outlive it; the bodies of @p structure are
    /// those that @p contact was made on.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Numbers of points in the contact, corners in a ring.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Numbers of the points in no quadrilateral.
    const std::vector<unsigned int> &
    lone_points() const
    {
      return alone;
    }

    /// The surface on the displaced first body (subtract `displacement` for
    /// the undeformed one) with the columns of contact_NAME.csv at its points
    /// (`active` as `status`), and `separation`, the vector to the displaced
    /// partner: gap times normal where that is on a rigid obstacle. @p rows are
    /// the contact's in a load step and @p u the displacements there, of the
    /// scene. Numbers are doubles.
    VtuGrid
    grid(const BlockVector &u, const std::vector<ContactRow> &rows) const;

    /// Writes grid() of the load step number @p step as
    /// @p directory/contact_NAME_STEP.vtu for ParaView. Returns the file's name
    /// without the folder. Throws InputError if it cannot be written. One
    /// process calls it.
    std::string
    write_vtu(const std::string             &directory,
              const unsigned int             step,
              const BlockVector             &u,
              const std::vector<ContactRow> &rows) const;

  private:
    /// Of each point its place on the body that carries it.
    std::vector<Location>
    places_of_points() const;

    const ContactInterface &contact;
    const Structure        &structure;
    /// quadrilaterals() and lone_points().
    std::vector<Quadrilateral> quads;
    std::vector<unsigned int>  alone;
    /// Of the points on the first body, and of those on the second if that
    /// deforms.
    std::vector<Location> first_places, second_places;
  };
} // namespace lamella

#endif
