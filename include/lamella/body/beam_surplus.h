// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_surplus_h
#define lamella_body_beam_surplus_h

#include <lamella/body/beam.h>
#include <lamella/section/hierarchical_surplus.h>

#include <vector>

namespace lamella
{
  /// Elements of an axis of one degree, from @p begin to @p end [length].
  struct AxisSpan
  {
    double       begin = 0., end = 0.;
    unsigned int degree = 0;
  };

  /// The part of the displacement u of a beam of LE-p on elements of degree r
  /// that coarser models do not have: (1 - L) u, with L_q the interpolation of
  /// HierarchicalSurplus at every node, and (1 - M) u, with M the interpolation
  /// at Gauss-Lobatto points of several spans of the axis. No coarser model is
  /// solved. Refers to the beam.
  class BeamSurplus
  {
  public:
    /// Returns true if @p beam is of LE-2 or more with all fields of the
    /// section at every node, and no modes.
    static bool
    is_possible(const Beam &beam);

    /// Constructs the surplus of a beam that is_possible().
    explicit BeamSurplus(const Beam &beam);

    /// Returns p.
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    /// Returns (1 - L_q) u, 0 < @p q < section_degree().
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// Returns (1 - M) u; @p spans divide the axis at element ends.
    Vector
    along_axis(const Vector &u, const std::vector<AxisSpan> &spans) const;

  private:
    /// Subtracts the interpolant of @p u at nodes in @p span from @p result.
    void
    subtract_interpolation(const AxisSpan &span,
                           const Vector   &u,
                           Vector         &result) const;

    const Beam         &beam;
    HierarchicalSurplus of_section;
  };
} // namespace lamella

#endif
