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
   *
   * Stresses and displacement gradients are sampled at a tensor product of
   * Gauss points: degree() points along each axis element (the stations) and,
   * in each cell of the section, one point a direction less than its stiffness
   * takes. These are Barlow's points, where stresses are most accurate. The
   * forces apply the transpose of the map from coefficients to gradients,
   *   u_,x = sum_a q_a Phi_a,x,  u_,y = sum_a q_a' Phi_a,
   *   u_,z = sum_a q_a Phi_a,z,
   * to s_ij u_,j, one component of u at a time: most fields have only one.
   *
   * Refers to the beam. Each process has the stations of its own elements.
   */
  class BeamGeometricStiffness
  {
  public:
    explicit BeamGeometricStiffness(const Beam &beam);

    /// The coefficients of each FieldPart: a row a station, a column a field of
    /// the section.
    using Coefficients =
      std::array<dealii::LAPACKFullMatrix<double>, FieldPart::n>;

    /// Those of the displacement @p w of the beam.
    Coefficients
    coefficients(const Vector &w) const;

    /// Takes as s the stress that the strains of @p q make, with that of heat.
    void
    set_stress(const Coefficients &q);

    /// f += K_G @p w. Collective.
    void
    add_forces(const Vector &w, Vector &f) const;

    /// The largest short_wave_ratio() of all sampled points. Collective.
    double
    short_waves() const;

    /// Gauss points of own axis elements, element by element.
    const std::vector<AxisPoint> &
    stations() const
    {
      return along;
    }

    /// Where they are on [0, 1] of each element.
    const dealii::QGauss<1> &
    quadrature() const
    {
      return samples;
    }

  private:
    /// The fields of a cell of the section that have one component of u, with
    /// its values and its derivatives along x and z: a row a point (those along
    /// z below those along x), a column a field.
    struct Component
    {
      std::vector<unsigned int>        fields;
      dealii::LAPACKFullMatrix<double> value, derivatives;
    };

    struct Cell
    {
      std::vector<SectionPoint> points;
      /// The area that each point stands for.
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
    /// volume that it stands for, where @p area is its share of the section.
    void
    find_stress(const Coefficients &q,
                const SectionPoint &point,
                const double        area,
                Voigt              *at_point);
    /// Adds the forces of the stress @p of_cell on the fields of one of its
    /// components to @p work.
    void
    add_work(const Component    &component,
             const Voigt        *of_cell,
             const Coefficients &q,
             Coefficients       &work) const;
    /// Adds what @p work does to the nodes to @p f.
    void
    add_on_nodes(const Coefficients &work, Vector &f) const;

    const Beam &beam;
    /// Those of the beam's FieldSpace.
    FieldColumns            modes;
    const dealii::QGauss<1> samples;
    /// The stations, with the length that each stands for.
    std::vector<AxisPoint> along;
    std::vector<double>    lengths;
    std::vector<Cell>      cells;
    /// Of each point of the section, cell by cell, the stress at all stations
    /// times the volume that it stands for.
    std::vector<Voigt> stress;
    /// short_waves() of this process.
    double largest_wave = 0.;
  };
} // namespace lamella

#endif
