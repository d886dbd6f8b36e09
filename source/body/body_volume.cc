// SPDX-License-Identifier: LGPL-2.1-or-later

// Functions of a body's rows and element maps: volume integrals, samples.

#include <lamella/base/processes.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/cell_grid.h>
#include <lamella/body/fields.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature_lib.h>

#include <set>
#include <unordered_map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// As many as the products of two functions of these degrees take.
    QAnisotropic<3>
    gauss_points(const GridIntervals &degrees)
    {
      return QAnisotropic<3>(QGauss<1>(degrees[0] + 1),
                             QGauss<1>(degrees[1] + 1),
                             QGauss<1>(degrees[2] + 1));
    }



    /// The quantity that @p rows are of, for the displacement @p u.
    template <typename Values>
    void
    set_values(const std::vector<LinearFunctional> &rows,
               const Vector                        &u,
               Values                              &values)
    {
      for (unsigned int c = 0; c < rows.size(); ++c)
        values[c] = rows[c](u);
    }



    /// A callback with the Gauss points of an element and their weights JxW.
    using PointsCallback = std::function<void(const std::vector<Location> &,
                                              const std::vector<double> &)>;



    /// Calls @p use with the Gauss points of each element and weights JxW.
    void
    for_each_cell_by_points(const Body           &body,
                            const PointsCallback &use,
                            const bool            of_all_processes = false)
    {
      const CellGrid        grid(body.cells().output_degrees);
      const QAnisotropic<3> gauss = gauss_points(body.cells().output_degrees);
      const auto [begin, end]     = of_all_processes ?
                                      std::make_pair(0u, body.cells().n) :
                                      body.cells().own;
      for (unsigned int cell = begin; cell < end; ++cell)
        {
          const std::vector<Point<3>> x = grid.positions(body, cell);
          std::vector<Location>       locations;
          std::vector<double>         weights;
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              const Location::Place place{cell, gauss.point(q)};
              locations.push_back(
                {body.position(place), body.ply_at(place).ply, {place}});
              weights.push_back(
                gauss.weight(q) *
                std::abs(
                  determinant(unit_gradient(x, grid.evaluate(place.unit)))));
            }
          use(locations, weights);
        }
    }



    /// Returns the DoFs of all @p rows, ascending.
    std::vector<DofIndex>
    dofs_of(const std::vector<std::vector<LinearFunctional>> &rows)
    {
      std::set<DofIndex> dofs;
      for (const auto &at_point : rows)
        for (const LinearFunctional &row : at_point)
          for (const auto &entry : row.entries())
            dofs.insert(entry.first);
      return {dofs.begin(), dofs.end()};
    }



    /// Adds @p mass times the square of @p row to @p block, whose rows are its
    /// columns; @p place has the number of each of its DoFs.
    void
    add_square(const LinearFunctional                           &row,
               const double                                      mass,
               const std::unordered_map<DofIndex, unsigned int> &place,
               StiffnessBlock                                   &block)
    {
      for (const auto &[i, weight_i] : row.entries())
        for (const auto &[j, weight_j] : row.entries())
          block.values[place.at(i) * block.columns.size() + place.at(j)] +=
            mass * weight_i * weight_j;
    }



    /// Displacements @p u at nodes of @p grid on element @p cell of @p body
    /// less those of the first node: a translation gives exactly zero.
    std::vector<Tensor<1, 3>>
    relative_displacements(const Body        &body,
                           const CellGrid    &grid,
                           const unsigned int cell,
                           const Vector      &u)
    {
      std::vector<Location> nodes;
      for (const Point<3> &unit : grid.nodes())
        {
          const Location::Place place{cell, unit};
          nodes.push_back(
            {body.position(place), body.ply_at(place).ply, {place}});
        }
      std::vector<Tensor<1, 3>> v = body.displacements(nodes, u);
      for (unsigned int k = nodes.size(); k-- > 0;)
        v[k] -= v[0];
      return v;
    }
  } // namespace



  FieldSample
  Body::sample(const Location &location, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : location.places)
      {
        const std::vector<Location> one{
          {location.position, location.ply, {place}}};
        FieldSample &at = samples.emplace_back();
        set_values(rows(one, undisplaced)[0], u, at.displacement);
        set_values(rows(one, undisplaced, Quantity::strain)[0], u, at.strain);
        set_values(rows(one, undisplaced, Quantity::stress)[0], u, at.stress);
        set_values(rows(one, undisplaced, Quantity::stress, Frame::ply)[0],
                   u,
                   at.ply_stress);
      }
    return mean_sample(samples);
  }



  double
  Body::add_thermal_load(const Vector &, Vector &f) const
  {
    if (!is_heated())
      return 0.;
    Vector share(n_dofs());
    double energy = 0.;
    for_each_cell_by_points(
      *this,
      [&](const std::vector<Location> &locations,
          const std::vector<double>   &weights) {
        const auto strain = rows(locations, undisplaced, Quantity::strain),
                   held   = rows(locations, undisplaced, Quantity::stress),
                   held_ply =
                     rows(locations, undisplaced, Quantity::stress, Frame::ply);
        for (unsigned int q = 0; q < locations.size(); ++q)
          {
            // At no strain the stress is -C epsilon_0.
            for (unsigned int c = 0; c < strain[q].size(); ++c)
              strain[q][c].add_to(share, -weights[q] * held[q][c].constant());
            const double T    = temperature(locations[q].position);
            const auto &alpha = *plies()[locations[q].ply].properties.expansion;
            for (unsigned int k = 0; k < 3; ++k)
              energy -=
                0.5 * weights[q] * held_ply[q][k].constant() * T * alpha[k];
          }
      });
    sum_over_processes(share);
    f += share;
    return Utilities::MPI::sum(energy, communicator());
  }



  Vector
  Body::retract(const Vector &u, const Vector &change) const
  {
    Vector result = u;
    result += change;
    return result;
  }



  Tensor<2, 3>
  Body::rotation_at(const Location &, const Vector &) const
  {
    return unit_triad();
  }



  std::vector<Tensor<1, 3>>
  Body::displacements(const std::vector<Location> &locations,
                      const Vector                &u) const
  {
    std::vector<Tensor<1, 3>> result;
    for (const std::vector<LinearFunctional> &of : rows(locations, u))
      set_values(of, u, result.emplace_back());
    return result;
  }



  void
  for_each_cell_by_weight(const Body           &body,
                          const Tensor<1, 3>   &acceleration,
                          const ForcesCallback &use,
                          const bool            of_all_processes)
  {
    const std::vector<double> rho = densities(body);
    for_each_cell_by_points(
      body,
      [&](const std::vector<Location> &locations,
          const std::vector<double>   &weights) {
        std::vector<Tensor<1, 3>> forces;
        for (unsigned int q = 0; q < locations.size(); ++q)
          forces.push_back(weights[q] * rho[locations[q].ply] * acceleration);
        use(locations, forces);
      },
      of_all_processes);
  }



  void
  Body::add_weight(const Tensor<1, 3> &acceleration, Vector &f) const
  {
    const std::vector<Vector> motions = rigid_motions(undisplaced);
    Vector                    rigid(n_dofs());
    for (unsigned int c = 0; c < 3; ++c)
      rigid.add(acceleration[c], motions[c]);
    add_product_of_blocks(
      [&](const auto &use) { for_each_mass_block(undisplaced, true, use); },
      rigid,
      f);
  }



  Point<3>
  Inertia::center() const
  {
    return mass > 0. ? Point<3>(first / mass) : Point<3>();
  }



  // Steiner's theorem: second moments about the center, then their trace.
  SymmetricTensor<2, 3>
  Inertia::about_center() const
  {
    const SymmetricTensor<2, 3> moments =
      second - mass * symmetrize(outer_product(center(), center()));
    return trace(moments) * unit_symmetric_tensor<3>() - moments;
  }



  Inertia
  inertia_of(const Bodies &bodies)
  {
    Inertia sum;
    for (const auto &body : bodies)
      {
        const std::vector<double> rho = densities(*body);
        for_each_cell_by_points(
          *body,
          [&](const std::vector<Location> &locations,
              const std::vector<double>   &weights) {
            for (unsigned int q = 0; q < locations.size(); ++q)
              {
                const Tensor<1, 3> x = locations[q].position;
                const double       m = weights[q] * rho[locations[q].ply];
                sum.mass += m;
                sum.first += m * x;
                sum.second += m * symmetrize(outer_product(x, x));
              }
          });
      }
    sum.mass   = Utilities::MPI::sum(sum.mass, communicator());
    sum.first  = Utilities::MPI::sum(sum.first, communicator());
    sum.second = Utilities::MPI::sum(sum.second, communicator());
    return sum;
  }



  void
  Body::for_each_mass_block(const Vector        &u,
                            const bool           with_values,
                            const BlockCallback &use) const
  {
    const std::vector<double> rho = densities(*this);
    for_each_cell_by_points(
      *this,
      [&](const std::vector<Location> &locations,
          const std::vector<double>   &weights) {
        const auto     rows = this->rows(locations, u);
        StiffnessBlock block;
        block.rows = block.columns = dofs_of(rows);
        block.columns_ascend       = true;
        if (with_values)
          {
            std::unordered_map<DofIndex, unsigned int> place;
            for (unsigned int k = 0; k < block.rows.size(); ++k)
              place[block.rows[k]] = k;
            block.values.assign(place.size() * place.size(), 0.);
            for (unsigned int q = 0; q < locations.size(); ++q)
              for (const LinearFunctional &row : rows[q])
                add_square(row,
                           weights[q] * rho[locations[q].ply],
                           place,
                           block);
          }
        use(block);
      });
  }



  Deformation
  Body::deformation(const Vector &u) const
  {
    Deformation result;
    Vector      f(n_dofs());
    add_internal_forces(u, f);
    result.energy = 0.5 * (u * f);

    const CellGrid        grid(cells().output_degrees);
    const QAnisotropic<3> gauss = gauss_points(cells().output_degrees);
    const auto [begin, end]     = cells().own;
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const auto x = grid.positions(*this, cell);
        const auto v = relative_displacements(*this, grid, cell, u);
        for (const Point<3> &point : gauss.get_points())
          {
            const auto         functions = grid.evaluate(point);
            const Tensor<2, 3> gradient =
              unit_gradient(v, functions) * invert(unit_gradient(x, functions));
            const Point<3> curl(gradient[2][1] - gradient[1][2],
                                gradient[0][2] - gradient[2][0],
                                gradient[1][0] - gradient[0][1]);
            result.max_rotation =
              std::max(result.max_rotation, 0.5 * curl.norm());
          }
      }
    result.max_rotation =
      Utilities::MPI::max(result.max_rotation, communicator());
    return result;
  }
} // namespace lamella
