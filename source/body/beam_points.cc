// SPDX-License-Identifier: LGPL-2.1-or-later

// The points of a beam: where they are, and which rows they give.

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/body/beam.h>
#include <lamella/body/fields.h>
#include <lamella/body/line_crossings.h>


#include <optional>

namespace lamella
{
  using namespace dealii;

  Location
  Beam::location(const Point<3>    &position,
                 const unsigned int axis_cell,
                 const double       eta,
                 const unsigned int section_cell,
                 const Point<2>    &unit) const
  {
    return {position,
            beam_section->cell_ply(section_cell),
            {{axis_cell * beam_section->n_cells() + section_cell,
              {unit[0], eta, unit[1]}}}};
  }



  double
  Beam::position_tolerance() const
  {
    return std::max(arithmetic::same_in_element * beam_section->extents().first,
                    arithmetic::same_position_along * beam_axis->length());
  }



  std::vector<std::vector<Location>>
  Beam::locate(const std::vector<Point<3>> &points) const
  {
    const double                       near = position_tolerance();
    std::vector<std::vector<Location>> result;
    for (const Point<3> &point : points)
      {
        const Point<3> x          = placement.to_body(point);
        const auto     on_axis    = beam_axis->locate(x[1], near);
        const auto     in_section = beam_section->locate({x[0], x[2]}, near);
        std::map<unsigned int, Location> by_ply;
        for (const auto &[section_cell, unit] : in_section)
          for (const auto &[axis_cell, eta] : on_axis)
            {
              const Location one =
                location(point, axis_cell, eta, section_cell, unit);
              Location &all = by_ply[one.ply];
              all.position  = point;
              all.ply       = one.ply;
              all.places.push_back(one.places[0]);
            }
        result.emplace_back();
        for (const auto &[ply, place] : by_ply)
          result.back().push_back(place);
      }
    return result;
  }



  Point<3>
  Beam::position(const Location::Place &place) const
  {
    const unsigned int axis_cell = place.cell / beam_section->n_cells();
    const Point<2>     x         = beam_section->element()
                         .evaluate(place.cell % beam_section->n_cells(),
                                   {place.unit[0], place.unit[2]})
                         .position;
    const double begin = beam_axis->cell_begin(axis_cell),
                 end   = beam_axis->cell_end(axis_cell);
    return placement.to_scene(
      {x[0], begin + place.unit[1] * (end - begin), x[1]});
  }



  PlyAndAxes
  Beam::ply_at(const Location::Place &place) const
  {
    const unsigned int cell = place.cell % beam_section->n_cells();
    const Point<2>     x    = beam_section->element()
                         .map(cell, {place.unit[0], place.unit[2]})
                         .position;
    return {beam_section->cell_ply(cell), beam_section->ply_axes(cell, x)};
  }



  Cells
  Beam::cells() const
  {
    const CrossSectionElement &element = beam_section->element();
    const Theory              &theory  = beam_section->theory();
    // Shapes are cubic at most.
    const unsigned int n = beam_section->n_cells(), p = element.degree(),
                       along = beam_axis->degree(),
                       across =
                         std::min(element.trace_degree(), std::max(p, 3u)),
                       smooth = theory.is_layerwise() ? p : 0;
    const auto [begin, end]   = beam_axis->own_cells();
    // Kirchhoff's rotation -w' and bending strains are one degree below w.
    return {
      beam_axis->n_cells() * n,
      {begin * n, end * n},
      {{p, along, p}},
      {{across, along, across}},
      {{smooth, theory.keeps_sections_normal() ? along - 1 : along, smooth}}};
  }



  GridIntervals
  Beam::recovery_degrees_of(const unsigned int cell) const
  {
    GridIntervals degrees = cells().recovery_degrees;
    for (const unsigned int node :
         beam_axis->nodes_of_cell(cell / beam_section->n_cells()))
      if (const unsigned int q = degree_at(node);
          q < beam_section->element().degree())
        for (const unsigned int d : {0, 2})
          degrees[d] = std::min(degrees[d], q);
    return degrees;
  }



  namespace
  {
    /// What a field and the functions N, N^, N' of a node make of a quantity.
    struct FieldValue
    {
      std::array<double, 6> by_N{}, by_shear{}, by_derivative{};
    };



    /// Of each of the fields at @p point, in the frame of the rows.
    std::vector<FieldValue>
    values_of_fields(const SectionPoint &point,
                     const Quantity      quantity,
                     const Placement    &placement,
                     const StrainMap    &to_frame)
    {
      std::vector<FieldValue> values(point.fields->size());
      for (unsigned int a = 0; a < values.size(); ++a)
        if (quantity == Quantity::displacement)
          {
            const Tensor<1, 3> v = placement.vector_to_scene(point.value[a]);
            for (unsigned int c = 0; c < 3; ++c)
              values[a].by_N[c] = v[c];
          }
        else
          {
            std::array<Voigt, 3> parts;
            for (unsigned int c = 0; c < 6; ++c)
              parts[is_transverse_shear(c) ? 1 : 0][c] = point.in_plane[a][c];
            parts[2] = point.along[a];
            for (Voigt &part : parts)
              part = to_frame.matrix * part;
            for (unsigned int c = 0; c < 6; ++c)
              {
                values[a].by_N[c]          = parts[0][c];
                values[a].by_shear[c]      = parts[1][c];
                values[a].by_derivative[c] = parts[2][c];
              }
          }
      return values;
    }



    /// Of the mode that is the combination @p mode of the section's fields,
    /// of which @p fields have the values @p values.
    FieldValue
    combination(const std::vector<FieldValue>   &values,
                const std::vector<unsigned int> &fields,
                const double *const              mode)
    {
      FieldValue sum;
      for (unsigned int a = 0; a < values.size(); ++a)
        for (unsigned int c = 0; c < 6; ++c)
          {
            const double factor = mode[fields[a]];
            sum.by_N[c] += factor * values[a].by_N[c];
            sum.by_shear[c] += factor * values[a].by_shear[c];
            sum.by_derivative[c] += factor * values[a].by_derivative[c];
          }
      return sum;
    }



    /// Adds the parameters at which the segment a + t d, projected into the
    /// section, passes vertices or crosses the sides of @p element's cells.
    void
    add_section_breaks(const CrossSectionElement &element,
                       const Point<2>            &a,
                       const Tensor<1, 2>        &d,
                       const double               tolerance,
                       std::vector<double>       &breaks)
    {
      if (d.norm() <= tolerance)
        return;
      for (const auto &cell :
           element.section_mesh().mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->manifold_id() == numbers::flat_manifold_id)
            add_edge_crossings(cell->face(f)->vertex(0),
                               cell->face(f)->vertex(1),
                               a,
                               d,
                               tolerance,
                               breaks);
          else
            add_curve_crossings(
              [&](const double s) {
                return element.map(cell->active_cell_index(), face_point(f, s))
                  .position;
              },
              a,
              d,
              tolerance,
              breaks);
    }
  } // namespace



  void
  Beam::add_to_rows(const Location::Place         &place,
                    const Quantity                 quantity,
                    const StrainMap               &to_frame,
                    const double                   share,
                    std::vector<LinearFunctional> &rows) const
  {
    const AxisPoint axis_point =
      beam_axis->evaluate(place.cell / beam_section->n_cells(), place.unit[1]);
    const SectionPoint point =
      beam_section->evaluate(place.cell % beam_section->n_cells(),
                             {place.unit[0], place.unit[2]});
    const std::vector<FieldValue> values =
      values_of_fields(point, quantity, placement, to_frame);
    const auto add =
      [&](const unsigned int i, const DofIndex dof, const FieldValue &value) {
        for (unsigned int c = 0; c < rows.size(); ++c)
          rows[c].add(dof,
                      share * (axis_point.N[i] * value.by_N[c] +
                               axis_point.N_shear[i] * value.by_shear[c] +
                               axis_point.dN[i] * value.by_derivative[c]));
      };
    const auto &nodes = beam_axis->nodes_of_cell(axis_point.cell);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int a = 0; a < point.fields->size(); ++a)
        if (const int k = dof_map.place(nodes[i], (*point.fields)[a]); k >= 0)
          add(i, dof_map.first(nodes[i]) + k, values[a]);

    // A mode is on all cells; its value is looked at where a node carries it.
    for (unsigned int j = 0; j < space->n_modes(); ++j)
      {
        const unsigned int        alpha = space->first_mode() + j;
        std::optional<FieldValue> of_mode;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (const int k = dof_map.place(nodes[i], alpha); k >= 0)
            {
              if (!of_mode)
                of_mode = combination(values, *point.fields, space->mode(j));
              add(i, dof_map.first(nodes[i]) + k, *of_mode);
            }
      }
  }



  std::vector<std::vector<LinearFunctional>>
  Beam::rows(const std::vector<Location> &locations,
             const Vector &,
             const Quantity quantity,
             const Frame    frame) const
  {
    const unsigned int n = quantity == Quantity::displacement ? 3 : 6;
    std::vector<std::vector<LinearFunctional>> result;
    for (const Location &where : locations)
      {
        const Location::Place &first = where.places[0];
        const unsigned int     cell  = first.cell % beam_section->n_cells();
        const Point<2>         x     = beam_section->element()
                             .map(cell, {first.unit[0], first.unit[2]})
                             .position;
        const ElasticLaw law      = law_at(cell, x, position(first));
        const StrainMap  to_frame = make_strain_map(
          quantity, frame, placement, beam_section->ply_axes(cell, x), law);
        std::vector<LinearFunctional> rows(n);
        if (quantity != Quantity::displacement)
          {
            const Voigt constant =
              to_frame.constant +
              to_frame.matrix * beam_section->completion_of_initial(
                                  cell, x, law.initial_strain());
            for (unsigned int c = 0; c < n; ++c)
              rows[c].add_constant(constant[c]);
          }
        for (const Location::Place &place : where.places)
          add_to_rows(
            place, quantity, to_frame, 1. / where.places.size(), rows);
        for (LinearFunctional &row : rows)
          row.compress();
        result.push_back(std::move(rows));
      }
    return result;
  }



  std::vector<double>
  Beam::line_breaks(const Point<3> &from, const Point<3> &to) const
  {
    const Point<3>      a = placement.to_body(from), b = placement.to_body(to);
    const Tensor<1, 3>  d = b - a;
    std::vector<double> breaks;
    if (std::abs(d[1]) > position_tolerance())
      for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
        breaks.push_back((beam_axis->cell_end(cell) - a[1]) / d[1]);
    Tensor<1, 2> in_section;
    in_section[0] = d[0];
    in_section[1] = d[2];
    add_section_breaks(beam_section->element(),
                       {a[0], a[2]},
                       in_section,
                       position_tolerance(),
                       breaks);
    return merge_breaks(std::move(breaks));
  }



  unsigned int
  Beam::line_degree(const Point<3> &from, const Point<3> &to) const
  {
    const Tensor<1, 3> d   = placement.vector_to_body(to - from);
    const double tolerance = std::min(position_tolerance(), 1e-3 * d.norm());
    const unsigned int p   = beam_section->element().degree();
    return (std::abs(d[0]) > tolerance ? p : 0) +
           (std::abs(d[1]) > tolerance ? beam_axis->degree() : 0) +
           (std::abs(d[2]) > tolerance ? p : 0);
  }
} // namespace lamella
