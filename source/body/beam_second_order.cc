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
    /// Adds @p factor times the resultants of a stress at the stations of the
    /// axis element @p cell to stress, out of the work @p forces on the
    /// derivatives of the rigid fields, which every list begins with.
    void
    add_resultants(const double         factor,
                   const unsigned int   cell,
                   const SectionForces &forces);
    /// Resultants and turn at a station: the forces on w_x', w_z', phi', phi.
    Turn
    forces_on_turn(const Resultants &s, const Turn &at) const;
    /// Adds to @p f what @p forces on the motions of the nodes do.
    void
    add_on_fields(const NodalMotions &forces, Vector &f) const;

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
    const Section &section = beam.section();
    SectionForces  unit(section.n_fields(), 1);
    for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
      for (const unsigned int p : {0, 1})
        unit.work[p == 0 ? FieldPart::value : FieldPart::derivative](alpha, 0) =
          section.S(p, 1).el(alpha, RigidField::translation_y);

    beam.along_axis().add_forces(
      [&](const unsigned int cell, const SectionAnswer &answer) {
        const FieldParts column =
          on_list(beam.fields(), answer.fields(), unit).work;
        const unsigned int n_stations = beam.along_axis().n_stations();
        SectionForces      forces(answer.fields().size(), n_stations);
        for (unsigned int p = 0; p < FieldPart::n; ++p)
          for (unsigned int k = 0; k < n_stations; ++k)
            for (unsigned int a = 0; a < answer.fields().size(); ++a)
              forces.work[p](a, k) =
                -stretch[cell * n_stations + k] * column[p](a, 0);
        return forces;
      },
      f);
  }



  void
  BeamSecondOrder::add_resultants(const double         factor,
                                  const unsigned int   cell,
                                  const SectionForces &forces)
  {
    const auto &work = forces.work[FieldPart::derivative];
    for (unsigned int k = 0; k < work.n(); ++k)
      {
        Resultants  &sum = stress[cell * work.n() + k];
        const double N   = factor * work(RigidField::translation_y, k);
        sum.N += N;
        sum.V_x += factor * work(RigidField::translation_x, k);
        sum.V_z += factor * work(RigidField::translation_z, k);
        sum.M_x += factor * h * work(RigidField::slope_x, k) - N * centre_x;
        sum.M_z += factor * h * work(RigidField::slope_z, k) - N * centre_z;
      }
  }



  double
  BeamSecondOrder::settle(const Vector &v)
  {
    stress.assign(stretch.size(), {});
    double energy = 0.;
    beam.along_axis().for_each_element([&](const unsigned int   cell,
                                           const SectionAnswer &answer) {
      FieldParts q = beam.along_axis().on_element(cell, answer.fields(), v);
      for (unsigned int k = 0; k < beam.along_axis().n_stations(); ++k)
        q[FieldPart::derivative](RigidField::translation_y, k) +=
          stretch[cell * beam.along_axis().n_stations() + k];
      const SectionForces forces = answer.forces(q);
      energy += beam.along_axis().energy(cell, forces);
      add_resultants(1., cell, forces);
      add_resultants(1.,
                     cell,
                     answer.forces(
                       beam.along_axis().on_element(cell, answer.fields(), u)));
    });
    if (beam.is_heated())
      {
        const auto         heat  = beam.forces_of_heat();
        const unsigned int begin = beam.axis().own_cells().first;
        for (unsigned int c = 0; c < heat.size(); ++c)
          add_resultants(-1., begin + c, heat[c]);
      }
    return Utilities::MPI::sum(energy, communicator());
  }



  BeamSecondOrder::Turn
  BeamSecondOrder::forces_on_turn(const Resultants &s, const Turn &at) const
  {
    Turn on;
    on.slope_x = s.N * at.slope_x + s.M_z * at.twist + s.V_z * at.phi;
    on.slope_z = s.N * at.slope_z - s.M_x * at.twist - s.V_x * at.phi;
    on.twist =
      s.N * radius_2 * at.twist + s.M_z * at.slope_x - s.M_x * at.slope_z;
    on.phi = s.V_z * at.slope_x - s.V_x * at.slope_z;
    return on;
  }



  void
  BeamSecondOrder::add_geometric_forces(const Vector &w, Vector &f) const
  {
    const Axis        &axis     = beam.axis();
    const NodalMotions of_nodes = motions_of_nodes(w);
    NodalMotions       forces(of_nodes.size());
    const auto [begin, end] = beam.along_axis().own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const AxisPoint &point  = axis.integration_points()[k];
        const double     weight = axis.integration_weights()[k];
        const Turn  on    = forces_on_turn(stress[k], turn_at(point, of_nodes));
        const auto &nodes = axis.nodes_of_cell(point.cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            auto &force = forces[nodes[i]];
            force[along_x] += weight * point.dN[i] * on.slope_x;
            force[along_z] += weight * point.dN[i] * on.slope_z;
            force[turn] +=
              weight * (point.dN[i] * on.twist + point.N[i] * on.phi);
          }
      }
    add_on_fields(forces, f);
  }



  void
  BeamSecondOrder::add_on_fields(const NodalMotions &forces, Vector &f) const
  {
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
