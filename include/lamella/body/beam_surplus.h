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

  /// Indicator of discretization errors of a beam of theory LE-p: the
  /// hierarchical surplus, i.e. the difference between its displacement u and
  /// the interpolant of u in a coarser discretization, of lower section degree
  /// or with coarser axis elements. No coarser model is solved. Keeps a
  /// reference to the beam.
  class BeamSurplus
  {
  public:
    /// Returns true if @p beam has LE-2 or higher at every node and no modes.
    static bool
    is_possible(const Beam &beam);

    /// Constructs the indicator of @p beam, for which is_possible() must hold.
    explicit BeamSurplus(const Beam &beam);

    /// Returns the degree p of LE-p.
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    /// Returns @p u minus its interpolant of degree @p q in each section cell,
    /// where 0 < @p q < section_degree() (HierarchicalSurplus).
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// Returns @p u minus its interpolant along the axis at the Gauss-Lobatto
    /// points of the coarser axis elements @p spans.
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
