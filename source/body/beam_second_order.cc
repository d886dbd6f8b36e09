// SPDX-License-Identifier: LGPL-2.1-or-later

// Second-order terms of a beam: stretch by deflection, geometric stiffness.

#include <lamella/base/processes.h>
#include <lamella/body/beam_geometric_stiffness.h>
#include <lamella/body/second_order.h>

#include <deal.II/fe/fe_dgq.h>

namespace lamella
{
  using namespace dealii;

  /// SecondOrder of a Beam, in the beam's axes.
  class BeamSecondOrder : public SecondOrder
  {
  public:
    BeamSecondOrder(const Beam &beam, const Vector &u)
      : beam(beam)
      , u(u)
      , geometric(beam)
      , stretch(beam.axis().integration_points().size(), 0.)
    {
      sample_stretch();
      interpolate_stretch();
    }

    void
    add_load(Vector &f) const override
    {
      // A stretch of 1 does the same work on the fields everywhere along the
      // axis: the column of S_01 and S_11 at the translation along it.
      const Section &section = beam.section();
      SectionForces  unit(section.n_fields(), 1);
      for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
        for (const unsigned int p : {0, 1})
          unit.work[p == 0 ? FieldPart::value : FieldPart::derivative](alpha,
                                                                       0) =
            section.S(p, 1).el(alpha, RigidField::translation_y);

      beam.along_axis().add_forces(
        [&](const unsigned int cell, const SectionOperator &section_operator) {
          const FieldParts column =
            on_list(beam.fields(), section_operator.fields(), unit).work;
          const unsigned int n_points = beam.along_axis().n_stations();
          SectionForces      forces(section_operator.fields().size(), n_points);
          for (unsigned int p = 0; p < FieldPart::n; ++p)
            for (unsigned int k = 0; k < n_points; ++k)
              for (unsigned int a = 0; a < section_operator.fields().size();
                   ++a)
                forces.work[p](a, k) =
                  -stretch[cell * n_points + k] * column[p](a, 0);
          return forces;
        },
        f);
    }

    double
    solve(const Vector &v) override
    {
      double energy = 0.;
      beam.along_axis().for_each_element(
        [&](const unsigned int cell, const SectionOperator &section_operator) {
          FieldParts q =
            beam.along_axis().on_element(cell, section_operator.fields(), v);
          for (unsigned int k = 0; k < beam.along_axis().n_stations(); ++k)
            q[FieldPart::derivative](RigidField::translation_y, k) +=
              stretch[cell * beam.along_axis().n_stations() + k];
          energy += beam.along_axis().energy(cell, section_operator.forces(q));
        });

      Vector both = u;
      both += v;
      auto q = geometric.coefficients(both);
      for (unsigned int k = 0; k < sampled.size(); ++k)
        q[FieldPart::derivative](k, RigidField::translation_y) += sampled[k];
      geometric.set_stress(q);
      return Utilities::MPI::sum(energy, communicator());
    }

    void
    add_geometric_forces(const Vector &w, Vector &f) const override
    {
      geometric.add_forces(w, f);
    }
    double
    largest_short_wave_ratio() const override
    {
      return geometric.largest_short_wave_ratio();
    }

  private:
    /// Computes e_2 at the stations.
    void
    sample_stretch()
    {
      // Means of u_x and u_z over the section for a unit of each field.
      std::vector<double> mean_x(beam.section().n_fields(), 0.),
        mean_z    = mean_x;
      double area = 0.;
      beam.section().for_each_point(
        [&](const SectionPoint &point, const double weight) {
          area += weight;
          for (unsigned int a = 0; a < point.fields->size(); ++a)
            {
              mean_x[(*point.fields)[a]] += weight * point.value[a][0];
              mean_z[(*point.fields)[a]] += weight * point.value[a][2];
            }
        });

      const auto q = geometric.coefficients(u);
      for (unsigned int k = 0; k < geometric.stations().size(); ++k)
        {
          double slope_x = 0., slope_z = 0.;
          for (unsigned int alpha = 0; alpha < mean_x.size(); ++alpha)
            {
              const double derivative = q[FieldPart::derivative](k, alpha);
              slope_x += mean_x[alpha] / area * derivative;
              slope_z += mean_z[alpha] / area * derivative;
            }
          sampled.push_back(0.5 * (slope_x * slope_x + slope_z * slope_z));
        }
    }

    /// Interpolates e_2 to the integration points.
    void
    interpolate_stretch()
    {
      const Axis                   &axis = beam.axis();
      const FE_DGQArbitraryNodes<1> between(geometric.quadrature());
      const unsigned int            n_points = stretch.size() / axis.n_cells();
      for (unsigned int k = 0; k < sampled.size(); ++k)
        {
          const unsigned int cell = geometric.stations()[k].cell;
          for (unsigned int i = cell * n_points; i < (cell + 1) * n_points; ++i)
            {
              const double eta =
                (axis.integration_points()[i].y - axis.cell_begin(cell)) /
                (axis.cell_end(cell) - axis.cell_begin(cell));
              stretch[i] +=
                sampled[k] *
                between.shape_value(k % geometric.quadrature().size(),
                                    Point<1>(eta));
            }
        }
    }

    const Beam            &beam;
    const Vector           u;
    BeamGeometricStiffness geometric;
    /// e_2 at the stations and at own integration points of the axis (else 0).
    std::vector<double> sampled, stretch;
  };



  std::unique_ptr<SecondOrder>
  Beam::second_order(const Vector &u) const
  {
    return std::make_unique<BeamSecondOrder>(*this, u);
  }
} // namespace lamella
