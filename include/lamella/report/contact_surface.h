// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_contact_surface_h
#define lamella_report_contact_surface_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/results.h>
#include <lamella/solve/structure.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The mesh that the points of a contact form: where those of the side that
   * carries them lie on a grid on a face of an element, as nodes of a Lagrange
   * body and grids of Taylor bodies do, neighbours span quadrilaterals. Points
   * in none (with no paired neighbours) stand alone.
   */
  class ContactSurface
  {
  public:
    using Quadrilateral = std::array<unsigned int, 4>;

    /// Both are referred to.
    ContactSurface(const ContactInterface &contact, const Structure &structure);

    /// Numbers of points, corners in a ring.
    const std::vector<Quadrilateral> &
    quadrilaterals() const
    {
      return quads;
    }

    /// Points in no quadrilateral.
    const std::vector<unsigned int> &
    lone_points() const
    {
      return alone;
    }

    /**
     * Writes @p directory/contact_NAME_STEP.vtu for ParaView: the surface on
     * the displaced first body (subtract `displacement` for the undeformed
     * one) with the columns of contact_NAME.csv at its points (`active` as
     * `status`), and `separation`, the vector to the displaced partner: gap
     * times normal where that is on a rigid obstacle. What is drawn is the
     * contact's @p rows in the load step number @p step and the displacements
     * @p u there. Numbers are doubles in text. Returns the file's name.
     */
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
    /// Of the points on the first body, and of those on the second if that
    /// deforms.
    std::vector<Location> first_places, second_places;
  };
} // namespace lamella

#endif
