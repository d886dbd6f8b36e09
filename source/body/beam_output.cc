// SPDX-License-Identifier: LGPL-2.1-or-later

// The fields of a beam at points, for probes, lines, contours and pictures.

#include <lamella/base/arithmetic.h>
#include <lamella/body/beam.h>
#include <lamella/body/fields.h>

namespace lamella
{
  using namespace dealii;

  FieldSample
  Beam::field_sample(PointState          state,
                     const SectionPoint &point,
                     const Point<3>     &x) const
  {
    const ElasticLaw law = law_at(point.cell, point.position, x);
    state.strain += beam_section->completion_of_initial(point.cell,
                                                        point.position,
                                                        law.initial_strain());
    return sample_of(state.displacement,
                     state.strain,
                     placement,
                     beam_section->ply_axes(point.cell, point.position),
                     law);
  }



  namespace
  {
    /// FieldSpace::expand() for the fields @p fields of the section alone;
    /// nothing is cut off.
    template <typename Fields>
    void
    expand_at(const FieldSpace    &space,
              const Fields        &fields,
              std::vector<double> &coefficients)
    {
      if (space.n_modes() == 0)
        return;
      const unsigned int  n = coefficients.size() - space.n_modes();
      std::vector<double> expanded;
      for (const unsigned int alpha : fields)
        expanded.push_back(coefficients[alpha]);
      for (unsigned int j = 0; j < space.n_modes(); ++j)
        if (const double factor = coefficients[n + j]; factor != 0.)
          for (unsigned int a = 0; a < expanded.size(); ++a)
            expanded[a] += factor * space.mode(j)[fields[a]];
      for (unsigned int a = 0; a < expanded.size(); ++a)
        coefficients[fields[a]] = expanded[a];
    }
  } // namespace



  FieldSample
  Beam::sample(const Location &where, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : where.places)
      {
        const unsigned int section_cell = place.cell % beam_section->n_cells();
        const SectionPoint point =
          beam_section->evaluate(section_cell, {place.unit[0], place.unit[2]});
        const AxisPoint on_axis =
          beam_axis->evaluate(place.cell / beam_section->n_cells(),
                              place.unit[1]);
        AxisState state = list_state(on_axis, u);
        // Not axis_state(): a point needs some dozens of thousands of fields.
        expand_at(*space, *point.fields, state.value);
        expand_at(*space, *point.fields, state.shear_value);
        expand_at(*space, *point.fields, state.derivative);
        samples.push_back(
          field_sample(point_state(point, state),
                       point,
                       placement.to_scene(
                         {point.position[0], on_axis.y, point.position[1]})));
      }
    return mean_of(samples);
  }



  std::vector<OutputCell>
  Beam::sample_axis_cell(const unsigned int         axis_cell,
                         const std::vector<double> &etas,
                         const unsigned int         n,
                         const Vector              &u) const
  {
    std::vector<std::pair<double, AxisState>> states;
    for (const double eta : etas)
      {
        const AxisPoint point = beam_axis->evaluate(axis_cell, eta);
        states.emplace_back(point.y, axis_state(point, u));
      }

    std::vector<OutputCell> cells(beam_section->n_cells());
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      {
        const Triad axes = beam_section->ply_axes(
          cell, beam_section->element().map(cell, {0.5, 0.5}).position);
        cells[cell].ply        = beam_section->cell_ply(cell);
        cells[cell].fibre      = placement.vector_to_scene(axes[0]);
        cells[cell].ply_normal = placement.vector_to_scene(axes[2]);
        for (unsigned int k = 0; k <= n; ++k)
          {
            std::vector<SectionPoint> row;
            for (unsigned int i = 0; i <= n; ++i)
              row.push_back(
                beam_section->evaluate(cell, {double(i) / n, double(k) / n}));
            for (const auto &[y, state] : states)
              for (const SectionPoint &point : row)
                {
                  cells[cell].positions.push_back(placement.to_scene(
                    {point.position[0], y, point.position[1]}));
                  cells[cell].samples.push_back(
                    field_sample(point_state(point, state),
                                 point,
                                 cells[cell].positions.back()));
                }
          }
      }
    return cells;
  }



  std::vector<OutputCell>
  Beam::cut(const double position, const unsigned int n, const Vector &u) const
  {
    const auto places =
      beam_axis->locate(position,
                        arithmetic::same_place_along * beam_axis->length());
    std::vector<OutputCell> cells;
    if (!places.empty())
      cells = sample_axis_cell(places[0].first, {places[0].second}, n, u);
    if (places.size() == 2)
      {
        // Between two elements the mean of both, as in a probe.
        const auto other =
          sample_axis_cell(places[1].first, {places[1].second}, n, u);
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



  std::vector<OutputCell>
  Beam::output_cells(const unsigned int n, const Vector &u) const
  {
    std::vector<double> etas;
    for (unsigned int j = 0; j <= n; ++j)
      etas.push_back(double(j) / n);
    std::vector<OutputCell> cells;
    const auto [begin, end] = beam_axis->own_cells();
    for (unsigned int axis_cell = begin; axis_cell < end; ++axis_cell)
      for (OutputCell &cell : sample_axis_cell(axis_cell, etas, n, u))
        cells.push_back(std::move(cell));
    return cells;
  }
} // namespace lamella
