// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_surplus_h
#define lamella_body_beam_surplus_h

#include <lamella/body/beam.h>
#include <lamella/section/hierarchical_surplus.h>

namespace lamella
{
  /**
   * What the displacement u of a beam of LE-p on elements of degree r along the
   * axis has beyond poorer models of it: (1 - L) u, with L_q the interpolation
   * of HierarchicalSurplus at every node, and M_q that in each element of the
   * axis at the Gauss-Lobatto points of degree q. A poorer model's own answer
   * is not asked for. Refers to the beam.
   */
  class BeamSurplus
  {
  public:
    /// Whether @p beam is of LE-2 or more and B3 or B4, all fields of the
    /// section at every node.
    static bool
    is_possible(const Beam &beam);

    /// is_possible().
    explicit BeamSurplus(const Beam &beam);

    /// The degrees of section and axis.
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    unsigned int
    axis_degree() const
    {
      return beam.axis().degree();
    }

    /// (1 - L_q) u, 0 < @p q < section_degree().
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// (1 - M_q) u, 0 < @p q < axis_degree().
    Vector
    along_axis(const Vector &u, const unsigned int q) const;

  private:
    const Beam         &beam;
    HierarchicalSurplus of_section;
  };
} // namespace lamella

#endif
