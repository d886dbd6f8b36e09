// SPDX-License-Identifier: LGPL-2.1-or-later

// What the linear strain leaves out of a solid: the quadratic strain of its
// rotations, and the forces of stress on material that turns.

#include <lamella/base/processes.h>
#include <lamella/body/second_order.h>
#include <lamella/body/solid.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_dgq.h>

namespace lamella
{
  using namespace dealii;

  /// SecondOrder of a Solid, in the body's axes.
  class SolidSecondOrder : public SecondOrder
  {
  public:
    SolidSecondOrder(const Solid &solid, const Vector &u)
      : solid(solid)
      , u(u)
      , samples(solid.degree())
      , between(QGauss<1>(solid.degree()))
      , stretch(solid.mesh.cells().size())
      , stress(stretch.size())
    {
      for_each_sample([&](const unsigned int cell,
                          unsigned int,
                          const HexahedronPoint &point,
                          const std::vector<Voigt> &,
                          const ElasticLaw &) {
        const Gradient H = solid.gradient_at(cell, point, u);
        stretch[cell].push_back(quadratic_strain(0.5 * (H - transpose(H))));
      });
    }

    void
    add_load(Vector &f) const override
    {
      Vector share(f.size());
      solid.for_each_gauss_point([&](const unsigned int        cell,
                                     const HexahedronPoint    &point,
                                     const std::vector<Voigt> &B,
                                     const ElasticLaw         &law) {
        const Voigt stress = law.stiffness() * stretch_at(cell, point.unit);
        const std::vector<DofIndex> dofs = solid.dofs_of(cell);
        for (unsigned int d = 0; d < dofs.size(); ++d)
          share[dofs[d]] -= point.JxW * (B[d] * stress);
      });
      sum_over_processes(share);
      f += share;
    }

    double
    solve(const Vector &v) override
    {
      const auto strain_of = [&](const std::vector<Voigt> &B,
                                 const unsigned int        cell,
                                 const Vector             &of) {
        const std::vector<double> w = solid.relative_displacements(cell, of);
        Voigt                     strain;
        for (unsigned int d = 0; d < w.size(); ++d)
          strain += w[d] * B[d];
        return strain;
      };
      double energy = 0.;
      solid.for_each_gauss_point([&](const unsigned int        cell,
                                     const HexahedronPoint    &point,
                                     const std::vector<Voigt> &B,
                                     const ElasticLaw         &law) {
        energy += point.JxW * law.energy_density(stretch_at(cell, point.unit) +
                                                 strain_of(B, cell, v));
      });
      for (std::vector<Voigt> &of_cell : stress)
        of_cell.clear();
      for_each_sample([&](const unsigned int        cell,
                          const unsigned int        s,
                          const HexahedronPoint    &point,
                          const std::vector<Voigt> &B,
                          const ElasticLaw &) {
        const ElasticLaw law = solid.law_at(cell, point.unit, point.position);
        stress[cell].push_back(law.stress(
          stretch[cell][s] + strain_of(B, cell, v) + strain_of(B, cell, u)));
        largest_wave =
          std::max(largest_wave,
                   short_wave_ratio(stress[cell].back(), law.stiffness()));
      });
      return Utilities::MPI::sum(energy, communicator());
    }

    void
    add_geometric_forces(const Vector &w, Vector &f) const override
    {
      Vector share(f.size());
      for_each_sample([&](const unsigned int     cell,
                          const unsigned int     s,
                          const HexahedronPoint &point,
                          const std::vector<Voigt> &,
                          const ElasticLaw &) {
        const std::vector<DofIndex> dofs = solid.dofs_of(cell);
        const Tensor<2, 3> force = point.JxW * stress_tensor(stress[cell][s]) *
                                   solid.gradient_at(cell, point, w);
        for (unsigned int d = 0; d < dofs.size(); ++d)
          for (unsigned int i = 0; i < 3; ++i)
            share[dofs[d]] += force[i][d % 3] * point.gradients[d / 3][i];
      });
      sum_over_processes(share);
      f += share;
    }

    double
    largest_short_wave_ratio() const override
    {
      return Utilities::MPI::max(largest_wave, communicator());
    }

  private:
    using Samples = std::vector<std::vector<Voigt>>;

    /// Solid::for_each_point() with the samples.
    template <typename Use>
    void
    for_each_sample(const Use &use) const
    {
      solid.for_each_point(
        [this](const Hexahedron::Nodes &nodes) {
          std::vector<HexahedronPoint> points;
          for (unsigned int s = 0; s < samples.size(); ++s)
            {
              points.push_back(solid.element.evaluate(nodes, samples.point(s)));
              points.back().JxW =
                samples.weight(s) * determinant(points.back().jacobian);
            }
          return points;
        },
        use);
    }

    /// e_2 of @p cell at @p unit, between its samples.
    Voigt
    stretch_at(const unsigned int cell, const Point<3> &unit) const
    {
      Voigt e;
      for (unsigned int s = 0; s < samples.size(); ++s)
        e += between.shape_value(s, unit) * stretch[cell][s];
      return e;
    }

    const Solid                  &solid;
    const Vector                  u;
    const QGauss<3>               samples;
    const FE_DGQArbitraryNodes<3> between;
    /// e_2 and the stress s of each cell's samples; empty for cells of others.
    Samples stretch, stress;
    /// Value of largest_short_wave_ratio() on this process.
    double largest_wave = 0.;
  };



  std::unique_ptr<SecondOrder>
  Solid::second_order(const Vector &u) const
  {
    return std::make_unique<SolidSecondOrder>(*this, u);
  }
} // namespace lamella
