// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_geometric_stiffness_h
#define lamella_body_beam_geometric_stiffness_h

#include <lamella/body/beam.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <vector>

namespace lamella
{
  /// The geometric stiffness K_G of a beam with the stress s: for displacements
  /// v and w in body axes,
  ///   v . K_G w = int s_ij v_k,i w_k,j dV.
  /// Stresses and displacement gradients are evaluated at Barlow points, where
  /// stresses are most accurate: as many Gauss points along an axis element as
  /// its degree ("stations"), and one fewer per direction of a section cell
  /// than for the stiffness. Section functions Phi_a with amplitudes q_a give
  ///   u_,x = sum_a q_a Phi_a,x,  u_,y = sum_a q_a' Phi_a,
  ///   u_,z = sum_a q_a Phi_a,z.
  /// The forces K_G u apply the transpose of this map to s_ij u_,j. The beam
  /// must outlive this object. Each process computes its own axis elements.
  class BeamGeometricStiffness
  {
  public:
    /// Evaluates the section functions of @p beam at all Barlow points.
    explicit BeamGeometricStiffness(const Beam &beam);

    /// Amplitudes of section functions and their axial derivatives (FieldPart);
    /// one row per station (axis point), one column per function.
    using Coefficients =
      std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

    /// Returns the amplitudes of section functions at the stations (axis points
    /// of this process) for the displacement @p w, a vector of DoFs.
    Coefficients
    coefficients(const Vector &w) const;

    /// Computes the stress s, with thermal stress, from the amplitudes @p q of
    /// the section functions; K_G is the geometric stiffness for s.
    void
    set_stress(const Coefficients &q);

    /// Adds the geometric stiffness K_G times @p w to @p f. Collective.
    void
    add_forces(const Vector &w, Vector &f) const;

    /// Returns the largest short_wave_ratio() in the beam, the ratio of
    /// compressive stress to shear modulus. Collective.
    double
    largest_short_wave_ratio() const;

    /// Returns the axis points of this process (stations), by elements.
    const std::vector<AxisPoint> &
    stations() const
    {
      return along;
    }

    /// Returns the Gauss rule of the stations (axis points) on an axis element.
    const dealii::QGauss<1> &
    quadrature() const
    {
      return samples;
    }

  private:
    /// Section functions with a nonzero displacement component (x, y or z) in a
    /// section cell: values and derivatives, one column per function and one
    /// row per point (derivatives by z below those by x).
    struct Component
    {
      std::vector<unsigned int>        fields;
      dealii::LAPACKFullMatrix<double> value, derivatives;
    };

    struct Cell
    {
      std::vector<SectionPoint> points;
      /// Integration weights of the points (areas).
      std::vector<double>      areas;
      std::array<Component, 3> components;
    };

    void
    add_cell(const unsigned int           number,
             const dealii::Quadrature<2> &quadrature);
    /// Sets component @p c of the section functions at point @p p of @p cell.
    void
    set_functions(const unsigned int    c,
                  const unsigned int    p,
                  const FunctionValues &f,
                  Cell                 &cell) const;
    /// Sets @p at_point to the stress at @p point of the section at each
    /// station, times the integration weight (@p area times length).
    void
    find_stress(const Coefficients &q,
                const SectionPoint &point,
                const double        area,
                Voigt              *at_point);
    /// Adds to @p work the section forces on functions of @p component, for
    /// stresses @p of_cell of a section cell and amplitudes @p q.
    void
    add_work(const Component    &component,
             const Voigt        *of_cell,
             const Coefficients &q,
             Coefficients       &work) const;
    /// Adds the nodal forces due to the section forces @p work to @p f.
    void
    add_on_nodes(const Coefficients &work, Vector &f) const;

    const Beam &beam;
    /// Modes (combinations of section functions) of the beam, one per column.
    FieldColumns            modes;
    const dealii::QGauss<1> samples;
    /// Axis points of this process, with their integration weights (lengths).
    std::vector<AxisPoint> along;
    std::vector<double>    lengths;
    std::vector<Cell>      cells;
    /// Stress times integration weight at all axis and section points.
    std::vector<Voigt> stress;
    /// Largest short_wave_ratio() in the elements of this process.
    double largest_wave = 0.;
  };
} // namespace lamella

#endif
