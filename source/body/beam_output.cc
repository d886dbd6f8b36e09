// SPDX-License-Identifier: LGPL-2.1-or-later

// The fields of a beam at points, for probes, lines, contours and pictures.

#include <lamella/base/arithmetic.h>
#include <lamella/body/beam.h>
#include <lamella/body/fields.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  Beam::PointState
  Beam::point_state(const SectionPoint &point,
                    const AxisPoint    &on_axis,
                    const Vector       &u) const
  {
    // The fields that live there, to which what modes are made of is added.
    const unsigned int        n      = point.fields->size();
    std::vector<unsigned int> fields = *point.fields;
    for (unsigned int j = 0; j < space->n_modes(); ++j)
      fields.push_back(space->first_mode() + j);
    FieldParts q =
      along_axis().at(ArrayView<const AxisPoint>(&on_axis, 1), fields, u);
    for (LAPACKFullMatrix<double> &part : q)
      for (unsigned int j = 0; j < space->n_modes(); ++j)
        if (const double factor = part(n + j, 0); factor != 0.)
          for (unsigned int a = 0; a < n; ++a)
            part(a, 0) += factor * space->mode(j)[fields[a]];

    PointState result;
    for (unsigned int a = 0; a < n; ++a)
      {
        result.displacement += q[FieldPart::value](a, 0) * point.value[a];
        for (unsigned int c = 0; c < 6; ++c)
          result.strain[c] +=
            q[is_transverse_shear(c) ? FieldPart::shear_value :
                                       FieldPart::value](a, 0) *
              point.in_plane[a][c] +
            q[FieldPart::derivative](a, 0) * point.along[a][c];
      }
    return result;
  }



  FieldSample
  Beam::sample_at(const SectionPoint &point,
                  const AxisPoint    &on_axis,
                  const Vector       &u) const
  {
    PointState       state = point_state(point, on_axis, u);
    const ElasticLaw law =
      law_at(point.cell,
             point.position,
             placement.to_scene(
               {point.position[0], on_axis.y, point.position[1]}));
    state.strain += beam_section->completion_of_initial(point.cell,
                                                        point.position,
                                                        law.initial_strain());
    return sample_of(state.displacement,
                     state.strain,
                     placement,
                     beam_section->ply_axes(point.cell, point.position),
                     law);
  }



  std::vector<FieldSample>
  Beam::samples_at(const std::vector<SectionPoint> &points,
                   const std::vector<AxisPoint>    &places,
                   const Vector                    &u) const
  {
    std::vector<FieldSample> samples;
    for (const AxisPoint &on_axis : places)
      for (const SectionPoint &point : points)
        samples.push_back(sample_at(point, on_axis, u));
    return samples;
  }



  FieldSample
  Beam::sample(const Location &location, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : location.places)
      {
        const unsigned int section_cell = place.cell % beam_section->n_cells();
        const SectionPoint point =
          beam_section->evaluate(section_cell, {place.unit[0], place.unit[2]});
        const AxisPoint on_axis =
          beam_axis->evaluate(place.cell / beam_section->n_cells(),
                              place.unit[1]);
        samples.push_back(sample_at(point, on_axis, u));
      }
    return mean_sample(samples);
  }



  std::vector<std::vector<double>>
  Beam::coefficients_of_element(const unsigned int cell, const Vector &u) const
  {
    const auto                      &nodes = beam_axis->nodes_of_cell(cell);
    std::vector<std::vector<double>> q;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        q.emplace_back(space->n_fields(), 0.);
        for (unsigned int k = 0; k < dof_map.fields(nodes[i]).size(); ++k)
          q[i][dof_map.fields(nodes[i])[k]] = u[dof_map.first(nodes[i]) + k];
        if (i > 0)
          for (unsigned int k = 0; k < dof_map.fields(nodes[0]).size(); ++k)
            q[i][dof_map.fields(nodes[0])[k]] -= u[dof_map.first(nodes[0]) + k];
      }
    for (std::vector<double> &coefficients : q)
      space->expand(coefficients);
    return q;
  }



  Beam::AxisStates
  Beam::axis_states(const unsigned int         cell,
                    const std::vector<double> &etas,
                    const Vector              &u) const
  {
    const auto         q = coefficients_of_element(cell, u);
    const unsigned int m = etas.size(), n_fields = beam_section->n_fields();
    AxisStates         states;
    for (std::vector<double> *part :
         {&states.value, &states.shear_value, &states.derivative})
      part->assign(n_fields * m, 0.);
    for (unsigned int j = 0; j < m; ++j)
      {
        const AxisPoint point = beam_axis->evaluate(cell, etas[j]);
        states.y.push_back(point.y);
        const auto all = [](const std::vector<double> &N) {
          return std::accumulate(N.begin(), N.end(), 0.);
        };
        for (unsigned int i = 0; i < q.size(); ++i)
          {
            const double N = i == 0 ? all(point.N) : point.N[i],
                         N_shear =
                           i == 0 ? all(point.N_shear) : point.N_shear[i],
                         dN = i == 0 ? 0. : point.dN[i];
            for (unsigned int alpha = 0; alpha < n_fields; ++alpha)
              {
                states.value[alpha * m + j] += N * q[i][alpha];
                states.shear_value[alpha * m + j] += N_shear * q[i][alpha];
                states.derivative[alpha * m + j] += dN * q[i][alpha];
              }
          }
      }
    return states;
  }



  struct Beam::GridPoint
  {
    /// A number that is not zero in what makes kinematics of coefficients: it
    /// multiplies that of field @p alpha and counts for component @p row, of
    /// which 0 to 2 are displacements and 3 to 8 strains.
    struct Entry
    {
      unsigned int alpha, row;
      double       factor;
    };
    unsigned int    cell;
    Point<2>        position;
    ElasticLaw      law;
    SampleRotations rotations;
    /// Of value, shear_value and derivative.
    std::array<std::vector<Entry>, 3> entries;
  };



  std::vector<Beam::GridPoint>
  Beam::grid_points(const unsigned int section_cell,
                    const unsigned int n_xi,
                    const unsigned int n_eta) const
  {
    std::vector<GridPoint> points;
    for (unsigned int k = 0; k <= n_eta; ++k)
      for (unsigned int i = 0; i <= n_xi; ++i)
        {
          const SectionPoint at =
            beam_section->evaluate(section_cell,
                                   {double(i) / n_xi, double(k) / n_eta});
          points.push_back(
            {section_cell,
             at.position,
             beam_section->law(section_cell, at.position),
             SampleRotations(placement,
                             beam_section->ply_axes(section_cell, at.position)),
             {}});
          const auto add = [&](const unsigned int part,
                               const unsigned int a,
                               const unsigned int row,
                               const double       factor) {
            if (factor != 0.)
              points.back().entries[part].push_back(
                {(*at.fields)[a], row, factor});
          };
          for (unsigned int a = 0; a < at.fields->size(); ++a)
            {
              for (unsigned int c = 0; c < 3; ++c)
                add(0, a, c, at.value[a][c]);
              for (unsigned int c = 0; c < 6; ++c)
                {
                  add(is_transverse_shear(c), a, 3 + c, at.in_plane[a][c]);
                  add(2, a, 3 + c, at.along[a][c]);
                }
            }
        }
    return points;
  }



  FieldSample
  Beam::grid_sample(const GridPoint    &point,
                    const Tensor<1, 3> &displacement,
                    Voigt               strain,
                    const Point<3>     &x) const
  {
    if (!is_heated())
      return point.rotations.sample(displacement,
                                    strain,
                                    point.law.stress(strain));
    const ElasticLaw law = law_at(point.cell, point.position, x);
    strain += beam_section->completion_of_initial(point.cell,
                                                  point.position,
                                                  law.initial_strain());
    return point.rotations.sample(displacement, strain, law.stress(strain));
  }



  void
  Beam::sample_grid(const std::vector<GridPoint> &points,
                    const unsigned int            n_xi,
                    const AxisStates             &states,
                    OutputCell                   &cell) const
  {
    const unsigned int m = states.y.size();
    cell.positions.resize(points.size() * m);
    cell.samples.resize(points.size() * m);
    const std::array<const double *, 3> parts{{states.value.data(),
                                               states.shear_value.data(),
                                               states.derivative.data()}};
    std::vector<double>                 rows;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const GridPoint &point = points[p];
        rows.assign(9 * m, 0.);
        for (unsigned int part = 0; part < 3; ++part)
          for (const GridPoint::Entry &entry : point.entries[part])
            for (unsigned int j = 0; j < m; ++j)
              rows[entry.row * m + j] +=
                entry.factor * parts[part][entry.alpha * m + j];
        for (unsigned int j = 0; j < m; ++j)
          {
            const unsigned int at =
              (p / (n_xi + 1) * m + j) * (n_xi + 1) + p % (n_xi + 1);
            cell.positions[at] = placement.to_scene(
              {point.position[0], states.y[j], point.position[1]});
            Tensor<1, 3> displacement;
            Voigt        strain;
            for (unsigned int c = 0; c < 3; ++c)
              displacement[c] = rows[c * m + j];
            for (unsigned int c = 0; c < 6; ++c)
              strain[c] = rows[(3 + c) * m + j];
            cell.samples[at] =
              grid_sample(point, displacement, strain, cell.positions[at]);
          }
      }
  }



  OutputCell
  Beam::empty_output_cell(const unsigned int section_cell) const
  {
    const Triad axes = beam_section->ply_axes(
      section_cell,
      beam_section->element().map(section_cell, {0.5, 0.5}).position);
    OutputCell cell;
    cell.ply        = beam_section->cell_ply(section_cell);
    cell.fiber      = placement.vector_to_scene(axes[0]);
    cell.ply_normal = placement.vector_to_scene(axes[2]);
    return cell;
  }



  std::vector<OutputCell>
  Beam::cut_axis_cell(const unsigned int axis_cell,
                      const double       eta,
                      const unsigned int n,
                      const Vector      &u) const
  {
    const AxisStates        states = axis_states(axis_cell, {eta}, u);
    std::vector<OutputCell> cells;
    for (unsigned int c = 0; c < beam_section->n_cells(); ++c)
      {
        cells.push_back(empty_output_cell(c));
        sample_grid(grid_points(c, n, n), n, states, cells.back());
      }
    return cells;
  }



  std::vector<OutputCell>
  Beam::cut(const double position, const unsigned int n, const Vector &u) const
  {
    const auto places =
      beam_axis->locate(position,
                        arithmetic::same_position_along * beam_axis->length());
    std::vector<OutputCell> cells;
    if (!places.empty())
      cells = cut_axis_cell(places[0].first, places[0].second, n, u);
    if (places.size() == 2)
      {
        // Between two elements the mean of both, as in a probe.
        const auto other =
          cut_axis_cell(places[1].first, places[1].second, n, u);
        for (unsigned int c = 0; c < cells.size(); ++c)
          for (unsigned int k = 0; k < cells[c].samples.size(); ++k)
            {
              FieldSample       &a = cells[c].samples[k];
              const FieldSample &b = other[c].samples[k];
              const double largest = std::max(a.stress.norm(), b.stress.norm());
              a.jump =
                largest > 0. ? (a.stress - b.stress).norm() / largest : 0.;
              a.strain     = 0.5 * (a.strain + b.strain);
              a.stress     = 0.5 * (a.stress + b.stress);
              a.ply_stress = 0.5 * (a.ply_stress + b.ply_stress);
            }
      }
    return cells;
  }



  void
  Beam::for_each_sampled_cell(const GridIntervals      &n,
                              const Vector             &u,
                              const OutputCellCallback &use) const
  {
    const unsigned int n_cells = beam_section->n_cells(), in_line = n[0] + 1,
                       in_cell = in_line * (n[2] + 1);
    std::vector<SectionPoint> points;
    std::vector<OutputCell>   cells;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        cells.push_back(empty_output_cell(c));
        for (unsigned int k = 0; k <= n[2]; ++k)
          for (unsigned int i = 0; i < in_line; ++i)
            points.push_back(
              beam_section->evaluate(c, {double(i) / n[0], double(k) / n[2]}));
      }
    const auto [begin, end] = beam_axis->own_cells();
    for (unsigned int axis_cell = begin; axis_cell < end; ++axis_cell)
      {
        std::vector<AxisPoint> places;
        for (unsigned int j = 0; j <= n[1]; ++j)
          places.push_back(beam_axis->evaluate(axis_cell, double(j) / n[1]));
        const std::vector<FieldSample> samples = samples_at(points, places, u);
        for (unsigned int c = 0; c < n_cells; ++c)
          {
            OutputCell cell = cells[c];
            for (unsigned int k = 0; k <= n[2]; ++k)
              for (unsigned int j = 0; j < places.size(); ++j)
                for (unsigned int i = 0; i < in_line; ++i)
                  {
                    const unsigned int p = c * in_cell + k * in_line + i;
                    const Point<2>    &x = points[p].position;
                    cell.positions.push_back(
                      placement.to_scene({x[0], places[j].y, x[1]}));
                    cell.samples.push_back(samples[j * points.size() + p]);
                  }
            use((axis_cell - begin) * n_cells + c, cell);
          }
      }
  }



  void
  Beam::for_each_output_cell(const GridIntervals      &n,
                             const Vector             &u,
                             const OutputCellCallback &use) const
  {
    std::vector<double> etas;
    for (unsigned int j = 0; j <= n[1]; ++j)
      etas.push_back(double(j) / n[1]);
    const auto [begin, end] = beam_axis->own_cells();
    std::vector<AxisStates> states;
    for (unsigned int axis_cell = begin; axis_cell < end; ++axis_cell)
      states.push_back(axis_states(axis_cell, etas, u));

    for (unsigned int c = 0; c < beam_section->n_cells(); ++c)
      {
        const std::vector<GridPoint> points = grid_points(c, n[0], n[2]);
        OutputCell                   cell   = empty_output_cell(c);
        for (unsigned int k = 0; k < states.size(); ++k)
          {
            sample_grid(points, n[0], states[k], cell);
            use(k * beam_section->n_cells() + c, cell);
          }
      }
  }
} // namespace lamella
