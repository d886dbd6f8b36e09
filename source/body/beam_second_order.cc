// SPDX-License-Identifier: LGPL-2.1-or-later

// What the linear strain leaves out of a beam: the stretch of a line that
// deflects, and the forces of stress on sections that turn.

#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/body/second_order.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_dgq.h>

#include <array>

namespace lamella
{
  using namespace dealii;

  /// SecondOrder of a Beam, in the beam's axes.
  class BeamSecondOrder : public SecondOrder
  {
  public:
    BeamSecondOrder(const Beam &beam, const Vector &u);

    void
    add_load(Vector &f) const override;
    double
    settle(const Vector &v) override;
    void
    add_geometric_forces(const Vector &w, Vector &f) const override;

  private:
    using SectionForce = Beam::SectionForce;
    using AxisState    = Beam::AxisState;

    /// How a section moves as a whole, functionals of all fields of the space:
    /// the means of u_x and u_z, and the turn about the axis that fits its
    /// displacement best (least squares).
    enum Motion
    {
      along_x,
      along_z,
      turn,
      n_motions
    };

    /// What stress does to a section as a whole: N, V, and the moments of N
    /// about the centre of area, M_x = int s_yy x dA and M_z = int s_yy z dA.
    struct Resultants
    {
      double N = 0., V_x = 0., V_z = 0., M_x = 0., M_z = 0.;
    };

    void
    find_motions();
    void
    find_stretch();
    /// The sum over the fields of @p motion times @p coefficients.
    double
    of_section(const Motion               motion,
               const std::vector<double> &coefficients) const;
    /// Adds @p factor times what @p work, on the fields of the section, comes
    /// to, to @p resultants.
    void
    add_resultants(const double factor,
                   const double derivative_work[],
                   Resultants  &resultants) const;

    const Beam  &beam;
    const Vector u;
    const double h;
    /// Centre of area less the point that slopes are zero at (x, z), and the
    /// square of the polar radius of gyration about that centre.
    double centre_x = 0., centre_z = 0., radius_2 = 0.;

    std::array<std::vector<double>, n_motions> motions;
    /// e_2 and the resultants of s at each integration point of the axis; zero
    /// at those of other processes.
    std::vector<double>     stretch;
    std::vector<Resultants> stress;
  };



  BeamSecondOrder::BeamSecondOrder(const Beam &beam, const Vector &u)
    : beam(beam)
    , u(u)
    , h(beam.section().element().reference_length())
    , stretch(beam.axis().integration_points().size(), 0.)
    , stress(stretch.size())
  {
    find_motions();
    find_stretch();
  }



  void
  BeamSecondOrder::find_motions()
  {
    const Section &section = beam.section();
    double         area = 0., x_bar = 0., z_bar = 0.;
    section.for_each_point([&](const SectionPoint &point, const double weight) {
      area += weight;
      x_bar += weight * point.position[0];
      z_bar += weight * point.position[1];
    });
    x_bar /= area;
    z_bar /= area;

    for (auto &motion : motions)
      motion.assign(section.n_fields(), 0.);
    double polar = 0.;
    section.for_each_point([&](const SectionPoint &point, const double weight) {
      const double x = point.position[0] - x_bar, z = point.position[1] - z_bar;
      polar += weight * (x * x + z * z);
      for (unsigned int a = 0; a < point.fields->size(); ++a)
        {
          const unsigned int alpha = (*point.fields)[a];
          const auto        &value = point.value[a];
          motions[along_x][alpha] += weight / area * value[0];
          motions[along_z][alpha] += weight / area * value[2];
          motions[turn][alpha] += weight * (z * value[0] - x * value[2]);
          if (alpha == RigidField::slope_x)
            centre_x += weight / area * h * value[1];
          if (alpha == RigidField::slope_z)
            centre_z += weight / area * h * value[1];
        }
    });
    radius_2 = polar / area;
    for (double &weight : motions[turn])
      weight /= polar;
    for (auto &motion : motions)
      beam.fields().append_modes(motion);
  }



  double
  BeamSecondOrder::of_section(const Motion               motion,
                              const std::vector<double> &coefficients) const
  {
    double sum = 0.;
    for (unsigned int alpha = 0; alpha < coefficients.size(); ++alpha)
      sum += motions[motion][alpha] * coefficients[alpha];
    return sum;
  }



  void
  BeamSecondOrder::find_stretch()
  {
    const Axis                   &axis = beam.axis();
    const QGauss<1>               samples(axis.degree());
    const FE_DGQArbitraryNodes<1> between(samples);
    const unsigned int            n_points = stretch.size() / axis.n_cells();
    const auto [begin, end]                = axis.own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      for (unsigned int s = 0; s < samples.size(); ++s)
        {
          const AxisState state =
            beam.list_state(axis.evaluate(cell, samples.point(s)[0]), u);
          const double slope_x = of_section(along_x, state.derivative),
                       slope_z = of_section(along_z, state.derivative);
          for (unsigned int k = cell * n_points; k < (cell + 1) * n_points; ++k)
            {
              const double eta =
                (axis.integration_points()[k].y - axis.cell_begin(cell)) /
                (axis.cell_end(cell) - axis.cell_begin(cell));
              stretch[k] += 0.5 * (slope_x * slope_x + slope_z * slope_z) *
                            between.shape_value(s, Point<1>(eta));
            }
        }
  }



  void
  BeamSecondOrder::add_load(Vector &f) const
  {
    // A stretch of 1 does the same work on the fields everywhere along the
    // axis: the column of S_01 and S_11 at the translation along it.
    const Section      &section = beam.section();
    const unsigned int  n       = section.n_fields();
    std::vector<double> value(n), derivative(n);
    for (unsigned int alpha = 0; alpha < n; ++alpha)
      {
        value[alpha] = section.S(0, 1).el(alpha, RigidField::translation_y);
        derivative[alpha] =
          section.S(1, 1).el(alpha, RigidField::translation_y);
      }
    beam.fields().append_modes(value);
    beam.fields().append_modes(derivative);

    Vector       share(f.size());
    SectionForce force;
    for (Vector &work : force.work)
      work.reinit(value.size());
    const auto [begin, end] = beam.own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        for (unsigned int alpha = 0; alpha < value.size(); ++alpha)
          {
            force.work[0][alpha] = -stretch[k] * value[alpha];
            force.work[2][alpha] = -stretch[k] * derivative[alpha];
          }
        beam.add_section_force(k, force, share);
      }
    sum_over_processes(share);
    f += share;
  }



  void
  BeamSecondOrder::add_resultants(const double factor,
                                  const double derivative_work[],
                                  Resultants  &resultants) const
  {
    const double N = factor * derivative_work[RigidField::translation_y];
    resultants.N += N;
    resultants.V_x += factor * derivative_work[RigidField::translation_x];
    resultants.V_z += factor * derivative_work[RigidField::translation_z];
    resultants.M_x +=
      factor * h * derivative_work[RigidField::slope_x] - N * centre_x;
    resultants.M_z +=
      factor * h * derivative_work[RigidField::slope_z] - N * centre_z;
  }



  double
  BeamSecondOrder::settle(const Vector &v)
  {
    stress.assign(stretch.size(), {});
    double     energy = 0.;
    const auto add    = [&](const unsigned int k, const SectionForce &force) {
      add_resultants(1., force.work[2].begin(), stress[k]);
    };
    beam.for_each_section_force(
      v, stretch, [&](const unsigned int k, const SectionForce &force) {
        energy += beam.axis().integration_weights()[k] * force.energy;
        add(k, force);
      });
    beam.for_each_section_force(u, {}, add);
    if (beam.is_heated())
      {
        const auto         works = beam.works_of_heat().first;
        const unsigned int begin = beam.own_points().first;
        for (unsigned int k = 0; k < works.size(); ++k)
          add_resultants(-1., works[k][2].data(), stress[begin + k]);
      }
    return Utilities::MPI::sum(energy, communicator());
  }



  void
  BeamSecondOrder::add_geometric_forces(const Vector &w, Vector &f) const
  {
    Vector       share(f.size());
    SectionForce force;
    for (Vector &work : force.work)
      work.reinit(motions[turn].size());
    const auto [begin, end] = beam.own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const Resultants &s = stress[k];
        const AxisState   state =
          beam.list_state(beam.axis().integration_points()[k], w);
        const double slope_x  = of_section(along_x, state.derivative),
                     slope_z  = of_section(along_z, state.derivative),
                     twist    = of_section(turn, state.derivative),
                     phi      = of_section(turn, state.value);
        const double on_x     = s.N * slope_x + s.M_z * twist + s.V_z * phi,
                     on_z     = s.N * slope_z - s.M_x * twist - s.V_x * phi,
                     on_twist = s.N * radius_2 * twist + s.M_z * slope_x -
                                s.M_x * slope_z,
                     on_turn = s.V_z * slope_x - s.V_x * slope_z;
        for (unsigned int alpha = 0; alpha < motions[turn].size(); ++alpha)
          {
            force.work[0][alpha] = on_turn * motions[turn][alpha];
            force.work[2][alpha] = on_x * motions[along_x][alpha] +
                                   on_z * motions[along_z][alpha] +
                                   on_twist * motions[turn][alpha];
          }
        beam.add_section_force(k, force, share);
      }
    sum_over_processes(share);
    f += share;
  }



  std::unique_ptr<SecondOrder>
  Beam::second_order(const Vector &u) const
  {
    return std::make_unique<BeamSecondOrder>(*this, u);
  }
} // namespace lamella
