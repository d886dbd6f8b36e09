// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_hierarchical_surplus_h
#define lamella_section_hierarchical_surplus_h

#include <lamella/base/row.h>
#include <lamella/section/section.h>

#include <deal.II/lac/sparse_direct.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * What the displacement of a section of LE-p has beyond LE-q,
   *   (1 - L_q) v,
   * with L_q the interpolation cell by cell at the Gauss-Lobatto points of
   * degree q. On each cell that drops the integrated Legendre polynomials of
   * the degrees above q in a direction, which vanish there; neighbours agree on
   * the side between them. (No projection over the section: where a core is
   * soft beside its faces, the least squares of the whole would move the faces
   * to please the core.)
   *
   * Whatever the basis: nodal values are made of numbers for the section's
   * fields and these of those,
   *   E c' = (1 - L_q) c at the nodes,
   * with E factorised once. Refers to the section.
   */
  class HierarchicalSurplus
  {
  public:
    /// Whether @p section has nodes that fix its fields: layer-wise ones.
    static bool
    is_possible(const Section &section);

    /// Of an LE-p of @p section, p above 1. is_possible().
    explicit HierarchicalSurplus(const Section &section);

    unsigned int
    degree() const
    {
      return section.element().degree();
    }

    /// Takes the part in LE-@p q out of the numbers @p c for the section's
    /// fields; @p q from 1 to degree() - 1.
    void
    keep_beyond(const unsigned int q, Vector &c) const;

  private:
    /// The displacement at a place of @p cell, a row a component, of numbers
    /// for the fields.
    std::array<Row, 3>
    displacement(const unsigned int cell, const dealii::Point<2> &unit) const;
    /// The same of the interpolation in degree @p q.
    std::array<Row, 3>
    interpolated(const unsigned int      cell,
                 const dealii::Point<2> &unit,
                 const unsigned int      q) const;
    /// E, which it factorises.
    void
    factorise(const std::vector<EdgePoint> &nodes);

    const Section &section;
    /// Turns displacements at the nodes into numbers for the fields.
    dealii::SparseDirectUMFPACK from_nodes;
    /// (1 - L_q) c at the nodes, three rows each, of q = 1 ... degree() - 1.
    std::vector<std::vector<Row>> beyond;
  };
} // namespace lamella

#endif
