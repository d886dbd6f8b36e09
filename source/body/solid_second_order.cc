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

  namespace
  {
    /// grad u of the displacements @p v of a hexahedron's nodes, by rows.
    Tensor<2, 3>
    gradient(const HexahedronPoint &point, const std::vector<double> &v)
    {
      Tensor<2, 3> H;
      for (unsigned int i = 0; i < point.gradients.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          H[c] += v[3 * i + c] * point.gradients[i];
      return H;
    }



    Voigt
    strain_of(const std::vector<Voigt> &B, const std::vector<double> &v)
    {
      Voigt strain;
      for (unsigned int d = 0; d < v.size(); ++d)
        strain += v[d] * B[d];
      return strain;
    }



    /// H_a^T H_a / 2 of the skew part H_a of @p H, engineering shear strains.
    Voigt
    strain_of_rotation(const Tensor<2, 3> &H)
    {
      const Tensor<2, 3> skew = 0.5 * (H - transpose(H));
      const Tensor<2, 3> E    = 0.5 * (transpose(skew) * skew);
      Voigt              e;
      e[0] = E[0][0];
      e[1] = E[1][1];
      e[2] = E[2][2];
      e[3] = 2. * E[0][1];
      e[4] = 2. * E[0][2];
      e[5] = 2. * E[1][2];
      return e;
    }



    Tensor<2, 3>
    tensor_of(const Voigt &s)
    {
      Tensor<2, 3> t;
      t[0][0] = s[0];
      t[1][1] = s[1];
      t[2][2] = s[2];
      t[0][1] = t[1][0] = s[3];
      t[0][2] = t[2][0] = s[4];
      t[1][2] = t[2][1] = s[5];
      return t;
    }
  } // namespace



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
      for (const Solid::Kind &kind : solid.kinds)
        if (!kind.own_cells.empty())
          for (const HexahedronPoint &point : sample_points(kind))
            for (const unsigned int cell : kind.own_cells)
              stretch[cell].push_back(strain_of_rotation(
                gradient(point, solid.relative_displacements(cell, u))));
    }

    void
    add_load(Vector &f) const override
    {
      Vector share(f.size());
      for_each_point([&](const unsigned int        cell,
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
      double energy = 0.;
      for_each_point([&](const unsigned int        cell,
                         const HexahedronPoint    &point,
                         const std::vector<Voigt> &B,
                         const ElasticLaw         &law) {
        energy +=
          point.JxW * law.energy_density(
                        stretch_at(cell, point.unit) +
                        strain_of(B, solid.relative_displacements(cell, v)));
      });
      for (const Solid::Kind &kind : solid.kinds)
        {
          if (kind.own_cells.empty())
            continue;
          const std::vector<HexahedronPoint> points = sample_points(kind);
          for (const unsigned int cell : kind.own_cells)
            stress[cell].clear();
          for (unsigned int s = 0; s < points.size(); ++s)
            {
              const std::vector<Voigt> B =
                solid.element.strains(points[s], kind.modes);
              for (const unsigned int cell : kind.own_cells)
                {
                  const ElasticLaw law =
                    solid.law_at(cell, points[s].unit, points[s].position);
                  stress[cell].push_back(law.stress(
                    stretch[cell][s] +
                    strain_of(B, solid.relative_displacements(cell, v)) +
                    strain_of(B, solid.relative_displacements(cell, u))));
                  largest_wave = std::max(largest_wave,
                                          short_wave_ratio(stress[cell].back(),
                                                           law.stiffness()));
                }
            }
        }
      return Utilities::MPI::sum(energy, communicator());
    }

    void
    add_geometric_forces(const Vector &w, Vector &f) const override
    {
      Vector share(f.size());
      for (const Solid::Kind &kind : solid.kinds)
        {
          if (kind.own_cells.empty())
            continue;
          const std::vector<HexahedronPoint> points = sample_points(kind);
          for (const unsigned int cell : kind.own_cells)
            {
              const std::vector<double> v =
                solid.relative_displacements(cell, w);
              const std::vector<DofIndex> dofs = solid.dofs_of(cell);
              for (unsigned int s = 0; s < points.size(); ++s)
                {
                  // Row by component, as grad w is.
                  const Tensor<2, 3> force = points[s].JxW *
                                             gradient(points[s], v) *
                                             tensor_of(stress[cell][s]);
                  for (unsigned int d = 0; d < dofs.size(); ++d)
                    share[dofs[d]] += force[d % 3] * points[s].gradients[d / 3];
                }
            }
        }
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

    /// The sample points of a hexahedron with weight times det(jacobian).
    std::vector<HexahedronPoint>
    sample_points(const Solid::Kind &kind) const
    {
      std::vector<HexahedronPoint> points;
      const Hexahedron::Nodes      nodes = solid.nodes_of(kind.cell);
      for (unsigned int s = 0; s < samples.size(); ++s)
        {
          points.push_back(solid.element.evaluate(nodes, samples.point(s)));
          points.back().JxW =
            samples.weight(s) * determinant(points.back().jacobian);
        }
      return points;
    }

    /// @p use (cell, point, B, law) for each own hexahedron at each of its
    /// quadrature points: strains there are B times relative displacements.
    template <typename Use>
    void
    for_each_point(const Use &use) const
    {
      for (const Solid::Kind &kind : solid.kinds)
        if (!kind.own_cells.empty())
          for (const HexahedronPoint &point :
               solid.element.quadrature_points(solid.nodes_of(kind.cell)))
            {
              const std::vector<Voigt> B =
                solid.element.strains(point, kind.modes);
              const ElasticLaw law = solid.law(kind.cell, point.position);
              for (const unsigned int cell : kind.own_cells)
                use(cell, point, B, law);
            }
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
