// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_geometric_stiffness_h
#define lamella_body_beam_geometric_stiffness_h

#include <lamella/body/beam.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * The geometric stiffness K_G of a beam's stress field s, in the beam's axes,
   *   v . K_G w = int s_ij v_k,i w_k,j dV.
   * Stresses and displacement gradients are sampled at a tensor product of
   * Gauss points: degree() along each axis element (the stations) and, in each
   * cell of the section, one per direction fewer than its stiffness has. At
   * these Barlow points stresses are most accurate. The forces apply to s_ij
   * u_,j the transpose of the map from coefficients to gradients,
   *   u_,x = sum_a q_a Phi_a,x,  u_,y = sum_a q_a' Phi_a,
   *   u_,z = sum_a q_a Phi_a,z,
   * one component of u at a time, since most fields have only one. Refers to
   * the beam. Each process has the stations of its own elements.
   */
  class BeamGeometricStiffness
  {
  public:
    explicit BeamGeometricStiffness(const Beam &beam);

    /// Coefficients of each FieldPart: a row per station, a column per field.
    using Coefficients =
      std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

    /// Returns the coefficients of the displacement @p w of the beam.
    Coefficients
    coefficients(const Vector &w) const;

    /// Sets s to the stress of the strains of @p q, including thermal stress.
    void
    set_stress(const Coefficients &q);

    /// Adds K_G @p w to @p f. Collective.
    void
    add_forces(const Vector &w, Vector &f) const;

    /// Returns the largest short_wave_ratio() of all points. Collective.
    double
    largest_short_wave_ratio() const;

    /// Returns the Gauss points of own axis elements, element by element.
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
    /// Fields of a section cell with one component of u: values and
    /// derivatives, a row per point (those along z below those along x), a
    /// column per field.
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
    /// Sets the functions of component @p c of @p cell at its point @p p.
    void
    set_functions(const unsigned int    c,
                  const unsigned int    p,
                  const FunctionValues &f,
                  Cell                 &cell) const;
    /// Sets the stress at @p point of the section at all stations, times the
    /// integration weight there (@p area in the section).
    void
    find_stress(const Coefficients &q,
                const SectionPoint &point,
                const double        area,
                Voigt              *at_point);
    /// Adds to @p work the forces of @p of_cell on the fields of @p component.
    void
    add_work(const Component    &component,
             const Voigt        *of_cell,
             const Coefficients &q,
             Coefficients       &work) const;
    /// Adds the nodal forces of @p work to @p f.
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
    /// Stress at all stations, times the weight, for each point of the section.
    std::vector<Voigt> stress;
    /// Value of largest_short_wave_ratio() on this process.
    double largest_wave = 0.;
  };
} // namespace lamella

#endif
