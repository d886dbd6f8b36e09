// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_surplus_h
#define lamella_body_beam_surplus_h

#include <lamella/body/beam.h>
#include <lamella/section/hierarchical_surplus.h>

#include <vector>

namespace lamella
{
  /// Range of a beam axis [length] with elements of equal degree.
  struct AxisSpan
  {
    double       begin = 0., end = 0.;
    unsigned int degree = 0;
  };

  /// Hierarchical surplus of a beam of theory LE-p, an indicator of
  /// discretization errors: the difference between its displacement u and the
  /// interpolant in a coarser model. L_q u interpolates in LE-q in every
  /// section (HierarchicalSurplus); M u interpolates along the axis at
  /// Gauss-Lobatto points of coarser elements. No coarser model is solved.
  /// Keeps a reference to the beam.
  class BeamSurplus
  {
  public:
    /// Returns true if @p beam has LE-2 or higher at every node and no modes.
    static bool
    is_possible(const Beam &beam);

    /// Requires is_possible().
    explicit BeamSurplus(const Beam &beam);

    /// Returns p.
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    /// Returns u - L_q u for 0 < @p q < section_degree().
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// Returns u - M u; @p spans are the coarser elements of M.
    Vector
    along_axis(const Vector &u, const std::vector<AxisSpan> &spans) const;

  private:
    /// Subtracts the interpolant of @p u in @p span from @p result.
    void
    subtract_interpolation(const AxisSpan &span,
                           const Vector   &u,
                           Vector         &result) const;

    const Beam         &beam;
    HierarchicalSurplus of_section;
  };
} // namespace lamella

#endif
