// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_surplus_h
#define lamella_body_beam_surplus_h

#include <lamella/body/beam.h>
#include <lamella/section/hierarchical_surplus.h>

#include <vector>

namespace lamella
{
  /// Interval of a beam axis that is one axis element of a coarser mesh.
  struct AxisSpan
  {
    double begin        = 0., ///< Axial position of the start [length].
      end               = 0.; ///< Axial position of the end [length].
    unsigned int degree = 0;  ///< Polynomial degree of the coarser element.
  };

  /// Indicator of the discretization error of a beam of theory LE-p (Lagrange
  /// polynomials of degree p in section cells): the difference between its
  /// displacement u and the interpolant of u in a coarser discretization, of
  /// lower section degree or with longer axis elements. No coarser model is
  /// solved. The beam must outlive this object.
  class BeamSurplus
  {
  public:
    /// Returns true if all nodes of @p beam have all functions of LE-2 or
    /// higher and no modes (combinations of section functions).
    static bool
    is_possible(const Beam &beam);

    /// Constructs the indicator of @p beam; requires is_possible(@p beam).
    explicit BeamSurplus(const Beam &beam);

    /// Returns the degree p of the Lagrange polynomials of the section (LE-p).
    unsigned int
    section_degree() const
    {
      return of_section.degree();
    }

    /// Returns the displacement @p u minus its interpolant of degree @p q in
    /// each section cell, where 0 < @p q < section_degree().
    Vector
    in_section(const Vector &u, const unsigned int q) const;

    /// Returns the displacement @p u minus its interpolant along the axis at
    /// the Gauss-Lobatto points of the coarser axis elements @p spans.
    Vector
    along_axis(const Vector &u, const std::vector<AxisSpan> &spans) const;

  private:
    /// Subtracts the interpolant of @p u in the element @p span from @p result.
    void
    subtract_interpolation(const AxisSpan &span,
                           const Vector   &u,
                           Vector         &result) const;

    const Beam         &beam;
    HierarchicalSurplus of_section;
  };

  /// Returns the displacement @p u of the beam @p from, interpolated to the
  /// nodes of @p to, another axial mesh of the same beam. At a node y,
  /// amplitudes of section functions alpha are u_alpha(y) = sum_i N_i(y)
  /// u_(i,alpha), with the axis shape functions N_i of @p from. Functions that
  /// @p to lacks at the node are dropped. Modes (combinations of functions) are
  /// fitted by least squares. Throws NumericsError for linearly dependent
  /// modes.
  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to);
} // namespace lamella

#endif
