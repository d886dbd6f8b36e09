// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_surplus_h
#define lamella_body_beam_surplus_h

#include <lamella/body/beam.h>
#include <lamella/section/hierarchical_surplus.h>

#include <vector>

namespace lamella
{
  /// A piece of an axis with polynomials of one degree, an element or several
  /// as one, from @p begin to @p end [length].
  struct AxisSpan
  {
    double       begin = 0., end = 0.;
    unsigned int degree = 0;
  };

  /**
   * What the displacement u of a beam of LE-p on elements of degree r along the
   * axis has beyond poorer models of it: (1 - L) u, with L_q the interpolation
   * of HierarchicalSurplus at every node, and M that in each of several spans
   * of the axis at the Gauss-Lobatto points of its degree. A poorer model's own
   * answer is not asked for. Refers to the beam.
   */
  class BeamSurplus
  {
  public:
    /// Whether @p beam is of LE-2 or more, all fields of the section at
    /// every node.
    static bool
    is_possible(const Beam &beam);

    /// is_possible().
    explicit BeamSurplus(const Beam &beam);

    /// p.
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    /// (1 - L_q) u, 0 < @p q < section_degree().
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// (1 - M) u with the interpolation in @p spans, which lie one behind the
    /// other from the start of the axis to its end, ends of elements between
    /// them.
    Vector
    along_axis(const Vector &u, const std::vector<AxisSpan> &spans) const;

  private:
    /// Takes from @p result what the interpolation of @p u in @p span has at
    /// the nodes inside of it.
    void
    take_interpolation(const AxisSpan &span,
                       const Vector   &u,
                       Vector         &result) const;

    const Beam         &beam;
    HierarchicalSurplus of_section;
  };
} // namespace lamella

#endif
