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

    /// Of each node of the axis a number for each motion.
    using NodalMotions = std::vector<std::array<double, n_motions>>;
    /// How a section moves at a point of the axis: w_x', w_z', phi' and phi.
    struct Turn
    {
      double slope_x = 0., slope_z = 0., twist = 0., phi = 0.;
    };

    void
    find_motions();
    void
    find_stretch();
    NodalMotions
    motions_of_nodes(const Vector &w) const;
    Turn
    turn_at(const AxisPoint &point, const NodalMotions &w) const;
    /// Adds @p factor times the resultants of a stress to @p resultants, out of
    /// its work on the derivatives of the rigid fields.
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



  BeamSecondOrder::NodalMotions
  BeamSecondOrder::motions_of_nodes(const Vector &w) const
  {
    NodalMotions of_nodes(beam.axis().n_nodes());
    for (unsigned int node = 0; node < of_nodes.size(); ++node)
      {
        const auto &fields = beam.dofs().fields(node);
        for (unsigned int m = 0; m < fields.size(); ++m)
          for (unsigned int motion = 0; motion < n_motions; ++motion)
            of_nodes[node][motion] +=
              motions[motion][fields[m]] * w[beam.dofs().first(node) + m];
      }
    return of_nodes;
  }



  BeamSecondOrder::Turn
  BeamSecondOrder::turn_at(const AxisPoint &point, const NodalMotions &w) const
  {
    const auto &nodes = beam.axis().nodes_of_cell(point.cell);
    Turn        turn_here;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const auto &here = w[nodes[i]], &first = w[nodes[0]];
        // A translation has no slope, to the last bit.
        turn_here.slope_x += point.dN[i] * (here[along_x] - first[along_x]);
        turn_here.slope_z += point.dN[i] * (here[along_z] - first[along_z]);
        turn_here.twist += point.dN[i] * (here[turn] - first[turn]);
        turn_here.phi += point.N[i] * here[turn];
      }
    return turn_here;
  }



  void
  BeamSecondOrder::find_stretch()
  {
    const Axis                   &axis = beam.axis();
    const QGauss<1>               samples(axis.degree());
    const FE_DGQArbitraryNodes<1> between(samples);
    const unsigned int            n_points = stretch.size() / axis.n_cells();
    const auto [begin, end]                = axis.own_cells();
    const NodalMotions w                   = motions_of_nodes(u);
    for (unsigned int cell = begin; cell < end; ++cell)
      for (unsigned int s = 0; s < samples.size(); ++s)
        {
          const Turn at = turn_at(axis.evaluate(cell, samples.point(s)[0]), w);
          for (unsigned int k = cell * n_points; k < (cell + 1) * n_points; ++k)
            {
              const double eta =
                (axis.integration_points()[k].y - axis.cell_begin(cell)) /
                (axis.cell_end(cell) - axis.cell_begin(cell));
              stretch[k] +=
                0.5 * (at.slope_x * at.slope_x + at.slope_z * at.slope_z) *
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

    // What multiplies the two at each node.
    const Axis         &axis = beam.axis();
    std::vector<double> by_value(axis.n_nodes(), 0.), by_derivative(by_value);
    const auto [begin, end] = beam.own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const AxisPoint &point = axis.integration_points()[k];
        const double     e     = axis.integration_weights()[k] * stretch[k];
        const auto      &nodes = axis.nodes_of_cell(point.cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            by_value[nodes[i]] += e * point.N[i];
            by_derivative[nodes[i]] += e * point.dN[i];
          }
      }
    Vector share(f.size());
    for (unsigned int node = 0; node < axis.n_nodes(); ++node)
      {
        const auto &fields = beam.dofs().fields(node);
        for (unsigned int m = 0; m < fields.size(); ++m)
          share[beam.dofs().first(node) + m] -=
            by_value[node] * value[fields[m]] +
            by_derivative[node] * derivative[fields[m]];
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
    const Axis        &axis     = beam.axis();
    const NodalMotions of_nodes = motions_of_nodes(w);
    NodalMotions       forces(of_nodes.size());
    const auto [begin, end] = beam.own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const AxisPoint  &point  = axis.integration_points()[k];
        const double      weight = axis.integration_weights()[k];
        const Resultants &s      = stress[k];
        const Turn        at     = turn_at(point, of_nodes);
        const double      on_slope_x =
                       s.N * at.slope_x + s.M_z * at.twist + s.V_z * at.phi,
                     on_slope_z =
                       s.N * at.slope_z - s.M_x * at.twist - s.V_x * at.phi,
                     on_twist = s.N * radius_2 * at.twist + s.M_z * at.slope_x -
                                s.M_x * at.slope_z,
                     on_phi = s.V_z * at.slope_x - s.V_x * at.slope_z;
        const auto &nodes   = axis.nodes_of_cell(point.cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            auto &force = forces[nodes[i]];
            force[along_x] += weight * point.dN[i] * on_slope_x;
            force[along_z] += weight * point.dN[i] * on_slope_z;
            force[turn] +=
              weight * (point.dN[i] * on_twist + point.N[i] * on_phi);
          }
      }
    Vector share(f.size());
    for (unsigned int node = 0; node < forces.size(); ++node)
      {
        const auto &fields = beam.dofs().fields(node);
        for (unsigned int m = 0; m < fields.size(); ++m)
          for (unsigned int motion = 0; motion < n_motions; ++motion)
            share[beam.dofs().first(node) + m] +=
              motions[motion][fields[m]] * forces[node][motion];
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
