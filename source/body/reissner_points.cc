// SPDX-License-Identifier: LGPL-2.1-or-later

// The points of a beam whose sections turn: where they are, what forces there
// do, and what is shown of them.

#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/body/reissner_beam.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  ReissnerBeam::PointFields
  ReissnerBeam::fields_at(const Location::Place &place) const
  {
    const unsigned int n = section().n_cells(), cell = place.cell / n;
    const SectionPoint point =
      section().evaluate(place.cell % n, {place.unit[0], place.unit[2]});
    PointFields result;
    result.on_axis = axis().evaluate(cell, place.unit[1]);
    // The slopes are (x - x_c) / h and (z - z_c) / h along y.
    const auto value = [&](const unsigned int alpha) {
      const auto found =
        std::find(point.fields->begin(), point.fields->end(), alpha);
      return found == point.fields->end() ?
               Tensor<1, 3>() :
               point.value[found - point.fields->begin()];
    };
    result.X[0] = h * value(RigidField::slope_x)[1];
    result.X[2] = h * value(RigidField::slope_z)[1];
    for (const unsigned int alpha : laws[cell]->warpings)
      {
        const double *mode = fields().mode(alpha - fields().first_mode());
        result.Phi.emplace_back();
        for (unsigned int a = 0; a < point.fields->size(); ++a)
          result.Phi.back() += mode[(*point.fields)[a]] * point.value[a];
      }
    return result;
  }



  Tensor<1, 3>
  ReissnerBeam::warping(const PointFields &at, const Frame &frame)
  {
    Tensor<1, 3> sum;
    for (unsigned int a = 0; a < at.Phi.size(); ++a)
      sum += frame.a[a] * at.Phi[a];
    return sum;
  }



  Tensor<1, 3>
  ReissnerBeam::displacement(const PointFields &at, const Frame &frame)
  {
    const Tensor<2, 3> R = rotation_of(frame.Q);
    return frame.r + (R * at.X - at.X) + R * warping(at, frame);
  }



  Tensor<2, 3>
  ReissnerBeam::turn_at(const Location &location, const Vector &u) const
  {
    const AxisPoint point = fields_at(location.places[0]).on_axis;
    return transpose(placement.axes) *
           rotation_of(frame_at(point, element(point.cell, u)).Q) *
           placement.axes;
  }



  std::vector<Tensor<1, 3>>
  ReissnerBeam::displacements(const std::vector<Location> &locations,
                              const Vector                &u) const
  {
    std::vector<Tensor<1, 3>> result;
    for (const Location &where : locations)
      {
        Tensor<1, 3> mean;
        for (const Location::Place &place : where.places)
          {
            const PointFields at   = fields_at(place);
            const unsigned    cell = at.on_axis.cell;
            mean += displacement(at, frame_at(at.on_axis, element(cell, u)));
          }
        result.push_back(
          placement.vector_to_scene(mean / double(where.places.size())));
      }
    return result;
  }



  TurnedVector
  ReissnerBeam::turned_point(const PointFields &at, const Frame &frame)
  {
    return turned_vector(frame.Q, at.X + warping(at, frame));
  }



  std::vector<Tensor<1, 3>>
  ReissnerBeam::by_local(const PointFields &at, const Element &element)
  {
    const std::vector<double> &N = at.on_axis.N;
    const TurnedVector of = turned_point(at, frame_at(at.on_axis, element));
    std::vector<Tensor<1, 3>> result;
    for (unsigned int i = 0; i < N.size(); ++i)
      {
        const auto spin = spin_derivative(element.q[i]);
        for (unsigned int c = 0; c < 3; ++c)
          {
            result.emplace_back();
            result.back()[c] = N[i];
          }
        for (unsigned int c = 0; c < 3; ++c)
          {
            result.emplace_back();
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int a = 0; a < 4; ++a)
                result.back()[k] += of.first[k][a] * N[i] * spin[a][c];
          }
        for (const Tensor<1, 3> &Phi : at.Phi)
          {
            result.emplace_back();
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int c = 0; c < 3; ++c)
                result.back()[k] += of.first[k][4 + c] * N[i] * Phi[c];
          }
      }
    return result;
  }



  void
  ReissnerBeam::add_rows(const Location::Place &place,
                         const double           share,
                         const Vector          &u,
                         std::vector<Row>      &rows) const
  {
    const PointFields           at      = fields_at(place);
    const std::vector<LocalDof> numbers = local_dofs(at.on_axis.cell);
    const auto                  by = by_local(at, element(at.on_axis.cell, u));
    for (unsigned int k = 0; k < numbers.size(); ++k)
      if (numbers[k].exists())
        {
          const Tensor<1, 3> v = placement.vector_to_scene(by[k]);
          for (unsigned int c = 0; c < 3; ++c)
            rows[c].add(numbers[k].dof, share * v[c] / numbers[k].factor);
        }
  }



  std::vector<std::vector<Row>>
  ReissnerBeam::rows_at(const std::vector<Location> &locations,
                        const Vector                &u) const
  {
    std::vector<std::vector<Row>> result;
    for (const Location &where : locations)
      {
        std::vector<Row> rows(3);
        for (const Location::Place &place : where.places)
          add_rows(place, 1. / where.places.size(), u, rows);
        for (Row &row : rows)
          row.compress();
        result.push_back(std::move(rows));
      }
    return result;
  }



  void
  ReissnerBeam::add_force(const PointFields        &at,
                          const Tensor<1, 3>       &force,
                          const Element            &element,
                          LAPACKFullMatrix<double> &K)
  {
    const std::vector<double> &N = at.on_axis.N;
    const unsigned int         n = n_of_node + at.Phi.size();
    const TurnedVector of = turned_point(at, frame_at(at.on_axis, element));
    // Of the work F . R (X + Phi a) by Q, and by Q and what R turns.
    Tensor<1, 7> first;
    Tensor<2, 7> second;
    for (unsigned int c = 0; c < 3; ++c)
      {
        first += force[c] * of.first[c];
        second += force[c] * of.second[c];
      }
    for (unsigned int i = 0; i < N.size(); ++i)
      {
        const auto spin = spin_derivative(element.q[i]);
        Quaternion by_q;
        for (unsigned int a = 0; a < 4; ++a)
          by_q[a] = N[i] * first[a];
        const double curved = along_geodesic(by_q, element.q[i]);
        for (unsigned int c = 0; c < 3; ++c)
          {
            Tensor<1, 7> row;
            for (unsigned int a = 0; a < 4; ++a)
              row += N[i] * spin[a][c] * second[a];
            K(i * n + 3 + c, i * n + 3 + c) += curved;
            add_force_row(at, element, row, i * n + 3 + c, K);
          }
      }
  }



  void
  ReissnerBeam::add_force_row(const PointFields        &at,
                              const Element            &element,
                              const Tensor<1, 7>       &row,
                              const unsigned int        spin,
                              LAPACKFullMatrix<double> &K)
  {
    const std::vector<double> &N = at.on_axis.N;
    const unsigned int         m = at.Phi.size(), n = n_of_node + m;
    for (unsigned int j = 0; j < N.size(); ++j)
      {
        const auto other = spin_derivative(element.q[j]);
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int a = 0; a < 4; ++a)
            K(spin, j * n + 3 + d) += row[a] * N[j] * other[a][d];
        for (unsigned int b = 0; b < m; ++b)
          {
            double by = 0.;
            for (unsigned int d = 0; d < 3; ++d)
              by += row[4 + d] * N[j] * at.Phi[b][d];
            K(spin, j * n + n_of_node + b) += by;
            K(j * n + n_of_node + b, spin) += by;
          }
      }
  }



  void
  ReissnerBeam::for_each_block_of_forces(
    const std::vector<Location>                       &locations,
    const std::vector<Tensor<1, 3>>                   &forces,
    const Vector                                      &u,
    const std::function<void(const StiffnessBlock &)> &use) const
  {
    // By elements of the axis.
    std::map<unsigned int, LAPACKFullMatrix<double>> of_cells;
    for (unsigned int k = 0; k < locations.size(); ++k)
      for (const Location::Place &place : locations[k].places)
        {
          const PointFields  at     = fields_at(place);
          const unsigned int cell   = at.on_axis.cell;
          auto              &matrix = of_cells[cell];
          if (matrix.m() == 0)
            {
              const unsigned int n = local_dofs(cell).size();
              matrix.reinit(n, n);
            }
          add_force(at,
                    placement.vector_to_body(forces[k]) /
                      double(locations[k].places.size()),
                    element(cell, u),
                    matrix);
        }
    for (const auto &[cell, matrix] : of_cells)
      use(block_of(local_dofs(cell), matrix));
  }



  Voigt
  ReissnerBeam::twist_strain(const SectionPoint &point) const
  {
    return &section() == deforming.get() ? twist_stretch->strain(point) :
                                           stretch_of_fibre(section(), point);
  }



  Voigt
  ReissnerBeam::strain_at(const SectionPoint        &point,
                          const unsigned int         cell,
                          const std::vector<double> &e) const
  {
    const std::vector<unsigned int> &warpings = laws[cell]->warpings;
    const unsigned int               m        = warpings.size();
    // The numbers of the section's fields: of value and of derivative.
    std::vector<double> value(section().n_fields(), 0.),
      derivative(section().n_fields(), 0.);
    const auto set = [&](const unsigned int alpha, const double by) {
      if (alpha < section().n_fields())
        derivative[alpha] = by;
    };
    set(RigidField::translation_x, e[0]);
    set(RigidField::translation_y, e[1]);
    set(RigidField::translation_z, e[2]);
    set(RigidField::slope_z, -h * e[3]);
    set(RigidField::rotation_y, h * e[4]);
    set(RigidField::slope_x, h * e[5]);
    Voigt strain = e[n_strains - 1] * twist_strain(point);
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      {
        const unsigned int alpha = (*point.fields)[k];
        for (unsigned int a = 0; a < m; ++a)
          {
            const double by =
              fields().mode(warpings[a] - fields().first_mode())[alpha];
            value[alpha] += by * e[n_strains + a];
            derivative[alpha] += by * e[n_strains + m + a];
          }
        strain +=
          value[alpha] * point.in_plane[k] + derivative[alpha] * point.along[k];
      }
    return strain;
  }



  FieldSample
  ReissnerBeam::sample_at(const SectionPoint &point,
                          const AxisPoint    &on_axis,
                          const Vector       &u) const
  {
    const Frame  frame = frame_at(on_axis, element(on_axis.cell, u));
    const double length =
      axis().cell_end(on_axis.cell) - axis().cell_begin(on_axis.cell);
    const Location::Place place{on_axis.cell * section().n_cells() + point.cell,
                                {point.unit[0],
                                 (on_axis.y - axis().cell_begin(on_axis.cell)) /
                                   length,
                                 point.unit[1]}};
    const ElasticLaw      law =
      law_at(point.cell,
             point.position,
             placement.to_scene(
               {point.position[0], on_axis.y, point.position[1]}));
    Voigt strain = strain_at(point, on_axis.cell, strains(frame));
    if (is_heated())
      strain += section().completion_of_initial(point.cell,
                                                point.position,
                                                law.initial_strain());
    FieldSample sample =
      sample_of(displacement(fields_at(place), frame),
                strain,
                placement,
                section().ply_axes(point.cell, point.position),
                law);
    sample.turn = placement.turn_in_scene(rotation_of(frame.Q));
    return sample;
  }



  void
  ReissnerBeam::add_strains(const unsigned int         cell,
                            const std::vector<double> &e,
                            Deformation               &deformation) const
  {
    const auto &points  = section().integration_points();
    const auto &weights = section().integration_weights();
    double      square = 0., area = 0., change = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Voigt strain = strain_at(points[k], cell, e);
        for (const double value : eigenvalues(strain_tensor(strain)))
          deformation.max_strain =
            std::max(deformation.max_strain, std::abs(value));
        square += weights[k] * strain[1] * strain[1];
        area += weights[k];
      }
    for (unsigned int c = 0; c < 3; ++c)
      change += stiffening[c] * e[3 + c] * e[3 + c];
    deformation.max_mean_strain =
      std::max(deformation.max_mean_strain, std::sqrt(square / area));
    deformation.shape_change =
      std::max(deformation.shape_change, std::abs(change));
  }



  Deformation
  ReissnerBeam::deformation(const Vector &u) const
  {
    Deformation result;
    for (unsigned int cell = 0; cell < axis().n_cells(); ++cell)
      {
        const Element             at = element(cell, u);
        const std::vector<Vector> of_heat =
          is_heated() ? heat_stresses(cell) : std::vector<Vector>();
        for (unsigned int k = 0; k < stations[cell].size(); ++k)
          {
            const Station            &station = stations[cell][k];
            const Frame               frame   = frame_at(station.point, at);
            const std::vector<double> e       = strains(frame);
            Vector                    s       = stresses(*laws[cell], e);
            s *= 0.5;
            if (is_heated())
              s -= of_heat[k];
            result.energy += station.weight * (Vector(e.begin(), e.end()) * s);
            add_strains(cell, e, result);
            result.max_rotation =
              std::max(result.max_rotation,
                       rotation_vector_of(frame.Q / frame.Q.norm()).norm());
          }
      }
    return over_processes(result);
  }
} // namespace lamella
