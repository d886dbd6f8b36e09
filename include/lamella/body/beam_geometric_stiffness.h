// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_geometric_stiffness_h
#define lamella_body_beam_geometric_stiffness_h

#include <lamella/body/beam.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <vector>

namespace lamella
{
  /// The geometric stiffness K_G of a beam with stress s, in body axes,
  ///   v . K_G w = int s_ij v_k,i w_k,j dV.
  /// Stresses and displacement gradients are evaluated at Barlow points, where
  /// stresses are most accurate: Gauss points, as many as the degree along each
  /// axis element (stations) and one fewer per direction than for the stiffness
  /// in each section cell. With amplitudes q_a of section functions Phi_a,
  ///   u_,x = sum_a q_a Phi_a,x,  u_,y = sum_a q_a' Phi_a,
  ///   u_,z = sum_a q_a Phi_a,z,
  /// and the forces apply the transpose of this map to s_ij u_,j. Keeps a
  /// reference to the beam. Each process computes the stations of the axis
  /// elements that it owns.
  class BeamGeometricStiffness
  {
  public:
    explicit BeamGeometricStiffness(const Beam &beam);

    /// Amplitudes q and q': one row per station, one column per function.
    using Coefficients =
      std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

    /// Returns the amplitudes of the displacement @p w at all stations.
    Coefficients
    coefficients(const Vector &w) const;

    /// Sets the stress s to that for the amplitudes @p q, with thermal stress.
    void
    set_stress(const Coefficients &q);

    /// Adds K_G @p w to @p f. Collective.
    void
    add_forces(const Vector &w, Vector &f) const;

    /// Returns the largest short_wave_ratio() of all points. Collective.
    double
    largest_short_wave_ratio() const;

    /// Returns the stations of this process, element by element.
    const std::vector<AxisPoint> &
    stations() const
    {
      return along;
    }

    /// Returns the positions of the stations on [0, 1] of each element.
    const dealii::QGauss<1> &
    quadrature() const
    {
      return samples;
    }

  private:
    /// Section functions that have one component of u in a section cell: values
    /// and derivatives, one column per function and one row per point
    /// (derivatives by z below those by x).
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
    add_stations();
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
    /// stresses @p of_cell of a section cell and gradients of amplitudes @p q.
    void
    add_work(const Component    &component,
             const Voigt        *of_cell,
             const Coefficients &q,
             Coefficients       &work) const;
    /// Adds the nodal forces of the section forces @p work to @p f.
    void
    add_on_nodes(const Coefficients &work, Vector &f) const;

    const Beam &beam;
    /// Modes of the beam's SectionSpace.
    FieldColumns            modes;
    const dealii::QGauss<1> samples;
    /// Stations, with their integration weights (lengths).
    std::vector<AxisPoint> along;
    std::vector<double>    lengths;
    std::vector<Cell>      cells;
    /// Stress times integration weight at all stations, for each section point.
    std::vector<Voigt> stress;
    /// Largest short_wave_ratio() on this process.
    double largest_wave = 0.;
  };
} // namespace lamella

#endif
