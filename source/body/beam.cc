// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/linear/block_factorisation.h>
#include <lamella/linear/factorisation.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<std::vector<unsigned int>>
    all_fields(const Section &section, const Axis &axis)
    {
      std::vector<unsigned int> fields(section.n_fields());
      std::iota(fields.begin(), fields.end(), 0);
      return std::vector<std::vector<unsigned int>>(axis.n_nodes(), fields);
    }
  } // namespace



  Beam::Beam(const std::string             &name,
             std::shared_ptr<const Section> section,
             std::shared_ptr<const Axis>    axis,
             const Placement               &placement)
    : Beam(name, section, axis, placement, all_fields(*section, *axis))
  {}



  Beam::Beam(const std::string                            &name,
             std::shared_ptr<const Section>                section,
             std::shared_ptr<const Axis>                   axis,
             const Placement                              &placement,
             const std::vector<std::vector<unsigned int>> &fields_of_node)
    : Beam(name,
           std::make_shared<FieldSpace>(std::move(section)),
           std::move(axis),
           placement,
           fields_of_node,
           "")
  {}



  Beam::Beam(const std::string                            &name,
             std::shared_ptr<const FieldSpace>             given,
             std::shared_ptr<const Axis>                   axis,
             const Placement                              &placement,
             const std::vector<std::vector<unsigned int>> &fields_of_node,
             const std::string                            &theory)
    : Body(name)
    , space(std::move(given))
    , beam_section(space->shared_section())
    , beam_axis(std::move(axis))
    , placement(placement)
    , dof_map(fields_of_node, space->n_fields())
    , label(theory)
  {
    for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
      dense_cells.push_back(is_dense(cell));
    if (n_processes() > beam_axis->n_nodes())
      throw InputError("Body " + name,
                       "",
                       "has " + std::to_string(beam_axis->n_nodes()) +
                         " nodes along its axis, too few to share among " +
                         std::to_string(n_processes()) + " processes",
                       "Start fewer processes, or take more Axis elements.");
    if (beam_section->theory().kind == Theory::Kind::EBBT)
      constrain_to_kirchhoff();
    kirchhoff.close();
  }



  void
  Beam::constrain_to_kirchhoff()
  {
    Assert(beam_axis->degree() == 3, ExcMessage("EBBT needs B4 elements."));
    const double h = beam_section->element().reference_length();
    // Deflections with the slope of the section that follows each.
    const std::array<std::array<unsigned int, 2>, 2> planes{
      {{{RigidField::translation_x, RigidField::slope_x}},
       {{RigidField::translation_z, RigidField::slope_z}}}};
    for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
      {
        const double L =
          beam_axis->cell_end(cell) - beam_axis->cell_begin(cell);
        std::vector<unsigned int> nodes = beam_axis->nodes_of_cell(cell);
        std::sort(nodes.begin(), nodes.end());
        for (const auto &[w, a] : planes)
          for (const unsigned int inside : {nodes[1], nodes[2]})
            {
              const double t =
                (beam_axis->nodes()[inside] - beam_axis->cell_begin(cell)) / L;
              const double H2 = t * t * (3. - 2. * t), H2_t = 6. * t * (1. - t);
              const double H1   = t * (1. - t) * (1. - t);
              const double H3   = -t * t * (1. - t);
              const double H1_t = (1. - t) * (1. - 3. * t),
                           H3_t = t * (3. * t - 2.);
              const std::array<DofIndex, 4> ends{{dof_map.first(nodes[0]) + w,
                                                  dof_map.first(nodes[3]) + w,
                                                  dof_map.first(nodes[0]) + a,
                                                  dof_map.first(nodes[3]) + a}};
              const auto                    tie = [&](const DofIndex               dof,
                                   const std::array<double, 4> &weights) {
                kirchhoff.add_line(dof);
                for (unsigned int k = 0; k < 4; ++k)
                  kirchhoff.add_entry(dof, ends[k], weights[k]);
              };
              tie(dof_map.first(inside) + w,
                  {{1. - H2, H2, -L / h * H1, -L / h * H3}});
              tie(dof_map.first(inside) + a,
                  {{h / L * H2_t, -h / L * H2_t, H1_t, H3_t}});
            }
      }
  }



  std::string
  Beam::theory() const
  {
    const std::string on_axis = ", " + std::to_string(beam_axis->n_cells()) +
                                " B" + std::to_string(beam_axis->degree() + 1);
    if (!label.empty())
      return label + on_axis;
    const Theory      &theory   = beam_section->theory();
    const unsigned int complete = (theory.order + 1) * (theory.order + 2) / 2;
    const unsigned int n        = beam_section->element().n_functions();
    const std::string  left_out =
      theory.kind == Theory::Kind::TE && n < complete ?
         " (" + std::to_string(complete - n) + " of " +
          std::to_string(complete) +
          " polynomials depend on the others on this section)" :
         "";
    return theory.name() + left_out + on_axis;
  }



  double
  Beam::stiffness_entries() const
  {
    const Matrix      &S   = beam_section->S(0, 0);
    const unsigned int all = beam_section->n_fields();
    // Lists of fields of the section are as sparse as its matrices.
    using List = std::vector<unsigned int>;
    std::map<std::pair<const List *, const List *>, double> sparse;
    const auto entries_between = [&](const unsigned int i,
                                     const unsigned int j) {
      const List &rows = dof_map.fields(i);
      const auto [known, is_new] =
        sparse.try_emplace({&rows, &dof_map.fields(j)}, 0.);
      if (is_new)
        for (const unsigned int a : rows)
          for (auto entry = S.begin(a); entry != S.end(a); ++entry)
            known->second += dof_map.place(j, entry->column()) >= 0;
      return known->second;
    };
    double sum = 0.;
    for (const auto &entry : beam_axis->A(0, 0))
      {
        const List &row    = dof_map.fields(entry.row()),
                   &column = dof_map.fields(entry.column());
        sum +=
          row.back() < all && column.back() < all ?
            entries_between(entry.row(), entry.column()) :
            std::min(double(row.size()) * column.size(),
                     S.n_nonzero_elements() +
                       space->n_dense() * double(row.size() + column.size()));
      }
    return sum;
  }



  std::unique_ptr<LinearSolver>
  Beam::make_solver(const Constraints             &constraints,
                    const std::vector<SpringTerm> &springs,
                    const SolverKind               asked,
                    const SolverMonitor           &monitor) const
  {
    if (asked != SolverKind::automatic || n_processes() > 1 ||
        std::find(dense_cells.begin(), dense_cells.end(), false) !=
          dense_cells.end())
      return Body::make_solver(constraints, springs, asked, monitor);
    DenseBlocks blocks;
    for (unsigned int node = 0; node < dof_map.n_nodes(); ++node)
      blocks.first.push_back(dof_map.first(node));
    blocks.first.push_back(dof_map.n_dofs());
    for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
      blocks.cliques.push_back(beam_axis->nodes_of_cell(cell));
    try
      {
        return factorise_blocks(stiffness_terms(springs),
                                blocks,
                                constraints,
                                "body '" + name() + "'",
                                monitor);
      }
    catch (const NotPositiveDefinite &error)
      {
        throw_with_place(error);
      }
  }



  IndexSet
  Beam::owned_dofs() const
  {
    const auto [begin, end] = beam_axis->own_nodes();
    IndexSet owned(n_dofs());
    if (begin < end)
      owned.add_range(dof_map.first(begin),
                      dof_map.first(end - 1) + dof_map.fields(end - 1).size());
    return owned;
  }



  unsigned int
  Beam::dof_level(const DofIndex dof) const
  {
    return space->level(dof_map.field_of(dof));
  }



  std::vector<double>
  Beam::dof_sizes() const
  {
    const std::vector<double> of_field = space->sizes();
    std::vector<double>       sizes;
    for (unsigned int node = 0; node < dof_map.n_nodes(); ++node)
      for (const unsigned int alpha : dof_map.fields(node))
        sizes.push_back(of_field[alpha]);
    return sizes;
  }



  Point<3>
  Beam::dof_position(const DofIndex dof) const
  {
    const double   y = beam_axis->nodes()[dof_map.node_of(dof)];
    const Point<2> c = beam_section->element().centre();
    return placement.to_scene({c[0], y, c[1]});
  }



  Point<3>
  Beam::centre() const
  {
    const Point<2> c = beam_section->element().centre();
    return placement.to_scene({c[0], 0.5 * beam_axis->length(), c[1]});
  }



  double
  Beam::size() const
  {
    return std::max(0.5 * beam_axis->length(),
                    beam_section->element().reference_length());
  }



  BoundingBox<3>
  Beam::bounding_box() const
  {
    std::vector<Point<3>> corners;
    for (const Point<2> &v :
         beam_section->element().section_mesh().mesh.get_vertices())
      for (const double y : {0., beam_axis->length()})
        corners.push_back(placement.to_scene({v[0], y, v[1]}));
    return BoundingBox<3>(corners);
  }



  std::vector<Vector>
  Beam::rigid_motions() const
  {
    const double        h      = beam_section->element().reference_length();
    const double        middle = 0.5 * beam_axis->length();
    std::vector<Vector> motions(6, Vector(n_dofs()));
    for (unsigned int m = 0; m < 6; ++m)
      {
        Tensor<1, 3> direction;
        direction[m % 3]        = 1.;
        const Tensor<1, 3> v    = placement.vector_to_body(direction);
        const bool         turn = m >= 3;
        for (unsigned int node = 0; node < dof_map.n_nodes(); ++node)
          {
            const auto set = [&](const unsigned int alpha, const double value) {
              if (alpha < beam_section->n_fields() &&
                  dof_map.place(node, alpha) >= 0)
                motions[m][dof_map.first(node) + dof_map.place(node, alpha)] =
                  value;
            };
            // v x (0, y - middle, 0) moves the axis; the rest turns sections.
            const double arm = beam_axis->nodes()[node] - middle;
            set(RigidField::translation_x, turn ? -v[2] * arm : v[0]);
            set(RigidField::translation_y, turn ? 0. : v[1]);
            set(RigidField::translation_z, turn ? v[0] * arm : v[2]);
            set(RigidField::slope_x, turn ? h * v[2] : 0.);
            set(RigidField::slope_z, turn ? -h * v[0] : 0.);
            set(RigidField::rotation_y, turn ? h * v[1] : 0.);
          }
      }
    return motions;
  }



  std::vector<RigidMotion>
  Beam::missing_motions() const
  {
    if (!beam_section->theory().is_classical())
      return {};
    // The turn about the axis.
    const Tensor<1, 3> axis = placement.axes[1];
    return {{{0., 0., 0., axis[0], axis[1], axis[2]}}};
  }



  void
  Beam::for_each_stiffness_block(
    const bool                                         with_values,
    const std::function<void(const StiffnessBlock &)> &use) const
  {
    std::vector<FactorRow> axis_rows;
    for (unsigned int node = 0; node < beam_axis->n_nodes(); ++node)
      axis_rows.push_back(factor_row(
        [this](const unsigned int m) -> auto & {
          return m < 4 ? beam_axis->A(m / 2, m % 2) : beam_axis->A_shear();
        },
        node,
        [](const unsigned int) { return true; }));
    std::vector<bool> carried(space->n_fields(), false);
    for (unsigned int node = 0; node < dof_map.n_nodes(); ++node)
      for (const unsigned int alpha : dof_map.fields(node))
        carried[alpha] = true;
    const auto section_rows = space->rows(carried);

    // A block is a row of the Kronecker products.
    StiffnessBlock block;
    block.rows.resize(1);
    block.columns_ascend    = true;
    const auto [begin, end] = beam_axis->own_nodes();
    for (unsigned int i = begin; i < end; ++i)
      for (unsigned int k = 0; k < dof_map.fields(i).size(); ++k)
        {
          const FactorRow &section_row = section_rows[dof_map.fields(i)[k]];
          block.rows[0]                = dof_map.first(i) + k;
          block.columns.clear();
          block.values.clear();
          for (unsigned int m = 0; m < axis_rows[i].columns.size(); ++m)
            {
              const unsigned int           j = axis_rows[i].columns[m];
              const std::array<double, 5> &A = axis_rows[i].entries[m];
              for (unsigned int b = 0; b < section_row.columns.size(); ++b)
                {
                  const int place = dof_map.place(j, section_row.columns[b]);
                  if (place < 0)
                    continue;
                  block.columns.push_back(dof_map.first(j) + place);
                  const std::array<double, 5> &S = section_row.entries[b];
                  if (with_values)
                    block.values.push_back(A[0] * S[0] + A[1] * S[1] +
                                           A[2] * S[2] + A[3] * S[3] +
                                           (A[4] - A[0]) * S[4]);
                }
            }
          use(block);
        }
  }



  bool
  Beam::is_dense(const unsigned int cell) const
  {
    if (space->n_modes() == 0 || beam_axis->has_assumed_shear())
      return false;
    for (const unsigned int node : beam_axis->nodes_of_cell(cell))
      for (const unsigned int alpha : dof_map.fields(node))
        if (space->dense_number(alpha) == space->n_dense())
          return false;
    return true;
  }



  Beam::AxisState
  Beam::axis_state(const AxisPoint &point, const Vector &u) const
  {
    AxisState state = list_state(point, u);
    space->expand(state.value);
    space->expand(state.shear_value);
    space->expand(state.derivative);
    return state;
  }



  Beam::AxisState
  Beam::list_state(const AxisPoint &point, const Vector &u) const
  {
    const auto &nodes = beam_axis->nodes_of_cell(point.cell);
    AxisState   state(space->n_fields());
    // Derivatives are taken of the differences to the first node: a rigid
    // translation then has none, to the last bit.
    std::vector<double> first(space->n_fields(), 0.);
    for (unsigned int k = 0; k < dof_map.fields(nodes[0]).size(); ++k)
      first[dof_map.fields(nodes[0])[k]] = u[dof_map.first(nodes[0]) + k];

    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        // A field that only some nodes carry vanishes at the others, so there
        // its difference to the first node counts, too.
        for (unsigned int alpha = 0; alpha < first.size(); ++alpha)
          state.derivative[alpha] -= point.dN[i] * first[alpha];
        const auto &fields = dof_map.fields(nodes[i]);
        for (unsigned int k = 0; k < fields.size(); ++k)
          {
            const double value = u[dof_map.first(nodes[i]) + k];
            state.value[fields[k]] += point.N[i] * value;
            state.shear_value[fields[k]] += point.N_shear[i] * value;
            state.derivative[fields[k]] += point.dN[i] * value;
          }
      }
    return state;
  }



  Beam::PointState
  Beam::point_state(const SectionPoint &point, const AxisState &state)
  {
    PointState result;
    for (unsigned int a = 0; a < point.fields->size(); ++a)
      {
        const unsigned int alpha = (*point.fields)[a];
        result.displacement += state.value[alpha] * point.value[a];
        result.slope += state.derivative[alpha] * point.value[a];
        result.twist += state.value[alpha] * point.twist[a];
        for (unsigned int c = 0; c < 6; ++c)
          result.strain[c] +=
            (is_transverse_shear(c) ? state.shear_value : state.value)[alpha] *
              point.in_plane[a][c] +
            state.derivative[alpha] * point.along[a][c];
      }
    return result;
  }



  std::pair<unsigned int, unsigned int>
  Beam::own_points() const
  {
    const auto [begin, end] = beam_axis->own_cells();
    const unsigned int n =
      beam_axis->integration_points().size() / beam_axis->n_cells();
    return {n * begin, n * end};
  }



  namespace
  {
    // A slope of the section shears it as the slope of the axis does: their sum
    // is formed before anything multiplies it, and is small where both are not.
    constexpr std::array<std::array<unsigned int, 2>, 2> slopes_of_axis{
      {{{RigidField::translation_x, RigidField::slope_x}},
       {{RigidField::translation_z, RigidField::slope_z}}}};
  } // namespace



  void
  Beam::force_by_moments(const unsigned int         k,
                         const Vector              &u,
                         const std::vector<double> &stretch,
                         SectionForce              &force) const
  {
    const double       h        = beam_section->element().reference_length();
    const unsigned int n_fields = beam_section->n_fields();
    const AxisState state = axis_state(beam_axis->integration_points()[k], u);
    std::array<Vector, 3> strain;
    for (unsigned int p = 0; p < 3; ++p)
      {
        const std::vector<double> &part = p == 0 ? state.value :
                                          p == 1 ? state.shear_value :
                                                   state.derivative;
        strain[p].reinit(n_fields);
        std::copy(part.begin(), part.end(), strain[p].begin());
      }
    for (const auto &[translation, slope] : slopes_of_axis)
      {
        strain[2][translation] += strain[1][slope] / h;
        strain[1][slope] = 0.;
      }
    if (!stretch.empty())
      strain[2][RigidField::translation_y] += stretch[k];
    force.energy = 0.;
    for (unsigned int p = 0; p < 3; ++p)
      {
        force.work[p].reinit(n_fields);
        for (unsigned int q = 0; q < 3; ++q)
          beam_section->moments(p, q).vmult(force.work[p],
                                            strain[q],
                                            /*adding=*/true);
        force.energy += 0.5 * (force.work[p] * strain[p]);
      }
    for (const auto &[translation, slope] : slopes_of_axis)
      force.work[1][slope] = force.work[2][translation] / h;
  }



  void
  Beam::make_products(const unsigned int cell, DenseProducts &products) const
  {
    std::vector<unsigned int> fields;
    for (const unsigned int node : beam_axis->nodes_of_cell(cell))
      {
        const auto               &list = dof_map.fields(node);
        std::vector<unsigned int> both;
        std::set_union(fields.begin(),
                       fields.end(),
                       list.begin(),
                       list.end(),
                       std::back_inserter(both));
        fields.swap(both);
      }
    if (fields == products.fields)
      return;
    const unsigned int n = fields.size();
    products.S.reinit(2 * n, 2 * n);
    for (const unsigned int q : {0, 1})
      for (unsigned int b = 0; b < n; ++b)
        for (const unsigned int p : {0, 1})
          {
            const double *const column =
              &space->dense_S(p, q)(0, space->dense_number(fields[b]));
            for (unsigned int a = 0; a < n; ++a)
              products.S(p * n + a, q * n + b) =
                column[space->dense_number(fields[a])];
          }
    products.fields = std::move(fields);
  }



  LAPACKFullMatrix<double>
  Beam::states_of_element(const unsigned int               cell,
                          const std::vector<unsigned int> &fields,
                          const Vector                    &u,
                          const std::vector<double>       &stretch) const
  {
    const auto              &points = beam_axis->integration_points();
    const auto              &nodes  = beam_axis->nodes_of_cell(cell);
    const unsigned int       m      = points.size() / beam_axis->n_cells();
    const unsigned int       n      = fields.size();
    LAPACKFullMatrix<double> states(2 * n, m);
    for (unsigned int a = 0; a < n; ++a)
      {
        const auto at_node = [&](const unsigned int node) {
          const int place = dof_map.place(node, fields[a]);
          return place < 0 ? 0. : u[dof_map.first(node) + place];
        };
        // As in list_state().
        const double first = at_node(nodes[0]);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const double value = at_node(nodes[i]);
            for (unsigned int k = 0; k < m; ++k)
              {
                const AxisPoint &point = points[m * cell + k];
                states(a, k) += point.N[i] * value;
                states(n + a, k) += point.dN[i] * (value - first);
              }
          }
      }
    // The rigid fields are the first of every dense list.
    for (unsigned int k = 0; k < m && !stretch.empty(); ++k)
      states(n + RigidField::translation_y, k) += stretch[m * cell + k];
    return states;
  }



  void
  Beam::forces_of_dense_element(const unsigned int         cell,
                                const Vector              &u,
                                const std::vector<double> &stretch,
                                DenseProducts             &products,
                                const UseOfForce          &use) const
  {
    make_products(cell, products);
    const auto              &fields = products.fields;
    const unsigned int       n      = fields.size();
    const double             h = beam_section->element().reference_length();
    LAPACKFullMatrix<double> states =
                               states_of_element(cell, fields, u, stretch),
                             works(states);
    for (unsigned int k = 0; k < states.n(); ++k)
      for (const auto &[translation, slope] : slopes_of_axis)
        {
          states(n + translation, k) += states(slope, k) / h;
          states(slope, k) = 0.;
        }
    products.S.mmult(works, states);

    SectionForce force;
    for (Vector &work : force.work)
      work.reinit(space->n_fields());
    for (unsigned int k = 0; k < states.n(); ++k)
      {
        force.energy = 0.;
        for (unsigned int a = 0; a < 2 * n; ++a)
          force.energy += 0.5 * states(a, k) * works(a, k);
        for (const auto &[translation, slope] : slopes_of_axis)
          works(slope, k) = works(n + translation, k) / h;
        for (unsigned int a = 0; a < n; ++a)
          {
            force.work[0][fields[a]] = works(a, k);
            force.work[2][fields[a]] = works(n + a, k);
          }
        use(cell * states.n() + k, force);
      }
  }



  void
  Beam::for_each_smooth_force(const Vector              &u,
                              const std::vector<double> &stretch,
                              const UseOfForce          &use) const
  {
    const bool    by_moments = beam_section->spans_the_section();
    SectionForce  force;
    DenseProducts products;
    const auto [begin, end] = beam_axis->own_cells();
    const unsigned int n_points =
      beam_axis->integration_points().size() / beam_axis->n_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      if (by_moments)
        for (unsigned int k = cell * n_points; k < (cell + 1) * n_points; ++k)
          {
            force_by_moments(k, u, stretch, force);
            use(k, force);
          }
      else if (dense_cells[cell])
        forces_of_dense_element(cell, u, stretch, products, use);
  }



  void
  Beam::add_section_force(const unsigned int  k,
                          const SectionForce &force,
                          Vector             &share) const
  {
    const AxisPoint &point  = beam_axis->integration_points()[k];
    const double     weight = beam_axis->integration_weights()[k];
    const auto      &nodes  = beam_axis->nodes_of_cell(point.cell);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int m = 0; m < dof_map.fields(nodes[i]).size(); ++m)
        {
          const unsigned int alpha = dof_map.fields(nodes[i])[m];
          share[dof_map.first(nodes[i]) + m] +=
            weight * (point.N[i] * force.work[0][alpha] +
                      point.N_shear[i] * force.work[1][alpha] +
                      point.dN[i] * force.work[2][alpha]);
        }
  }



  void
  Beam::add_internal_forces(const Vector &u, Vector &f) const
  {
    Vector share(f.size());
    for_each_section_force(
      u, {}, [&](const unsigned int k, const SectionForce &force) {
        add_section_force(k, force, share);
      });
    sum_over_processes(share);
    f += share;
  }



  void
  Beam::for_each_force_by_points(const Vector              &u,
                                 const std::vector<double> &stretch,
                                 const UseOfForce          &use) const
  {
    const auto        &section_points  = beam_section->integration_points();
    const auto        &section_weights = beam_section->integration_weights();
    const unsigned int n_fields        = beam_section->n_fields();
    // Of each field, what multiplies and what collects its part of each strain:
    // transverse shear strains may have values of their own.
    std::vector<std::array<double, 6>> values(n_fields), work(n_fields);
    std::vector<double>                derivative_work(n_fields);
    SectionForce                       force;
    const auto [begin, end] = own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const AxisPoint &axis_point = beam_axis->integration_points()[k];
        if (dense_cells[axis_point.cell])
          continue;
        AxisState state = axis_state(axis_point, u);
        if (!stretch.empty())
          state.derivative[RigidField::translation_y] += stretch[k];
        force.energy = 0.;
        for (unsigned int alpha = 0; alpha < n_fields; ++alpha)
          {
            for (unsigned int c = 0; c < 6; ++c)
              values[alpha][c] = (is_transverse_shear(c) ? state.shear_value :
                                                           state.value)[alpha];
            work[alpha].fill(0.);
            derivative_work[alpha] = 0.;
          }
        for (unsigned int s = 0; s < section_points.size(); ++s)
          {
            const SectionPoint &point = section_points[s];
            Voigt               strain;
            for (unsigned int a = 0; a < point.fields->size(); ++a)
              {
                const unsigned int alpha = (*point.fields)[a];
                for (unsigned int c = 0; c < 6; ++c)
                  strain[c] += values[alpha][c] * point.in_plane[a][c] +
                               state.derivative[alpha] * point.along[a][c];
              }
            const Voigt stress =
              section_weights[s] * beam_section->law_at_point(s).stress(strain);
            force.energy += 0.5 * (stress * strain);
            for (unsigned int a = 0; a < point.fields->size(); ++a)
              {
                const unsigned int alpha = (*point.fields)[a];
                for (unsigned int c = 0; c < 6; ++c)
                  work[alpha][c] += point.in_plane[a][c] * stress[c];
                derivative_work[alpha] += point.along[a] * stress;
              }
          }
        // Of each part the work on the section's fields, then on the modes.
        std::array<std::vector<double>, 3> parts;
        for (unsigned int alpha = 0; alpha < n_fields; ++alpha)
          {
            const auto &w = work[alpha];
            parts[0].push_back(w[0] + w[1] + w[2] + w[4]);
            parts[1].push_back(w[3] + w[5]);
            parts[2].push_back(derivative_work[alpha]);
          }
        for (unsigned int p = 0; p < 3; ++p)
          {
            space->append_modes(parts[p]);
            force.work[p].reinit(parts[p].size(), true);
            std::copy(parts[p].begin(), parts[p].end(), force.work[p].begin());
          }
        use(k, force);
      }
  }



  Deformation
  Beam::deformation(const Vector &u) const
  {
    constexpr unsigned int enough = 200;
    Deformation            result;
    const auto            &section_points = beam_section->integration_points();
    const unsigned int     stride =
      std::max<std::size_t>(1, section_points.size() / enough);
    const auto [begin, end] = own_points();
    for (unsigned int k = begin; k < end; ++k)
      {
        const AxisPoint &axis_point = beam_axis->integration_points()[k];
        const AxisState  state      = axis_state(axis_point, u);
        // Dense fields are smooth over the section: a few of its points tell
        // how far it turns.
        const bool by_points =
          !beam_section->spans_the_section() && !dense_cells[axis_point.cell];
        const unsigned int step = dense_cells[axis_point.cell] ? stride : 1;
        for (unsigned int s = 0; s < section_points.size(); s += step)
          {
            const SectionPoint &point = section_points[s];
            const PointState    at    = point_state(point, state);
            if (by_points)
              result.energy +=
                beam_axis->integration_weights()[k] *
                beam_section->integration_weights()[s] *
                beam_section->law_at_point(s).energy_density(at.strain);
            // curl u / 2 with d u_y / dz = gamma_yz - d u_z / dy and so on.
            const Point<3> rotation(at.slope[2] - 0.5 * at.strain[5],
                                    at.twist,
                                    0.5 * at.strain[3] - at.slope[0]);
            result.max_rotation =
              std::max(result.max_rotation, rotation.norm());
          }
      }
    for_each_smooth_force(
      u, {}, [&](const unsigned int k, const SectionForce &force) {
        result.energy += beam_axis->integration_weights()[k] * force.energy;
      });
    result.energy = Utilities::MPI::sum(result.energy, communicator());
    result.max_rotation =
      Utilities::MPI::max(result.max_rotation, communicator());
    return result;
  }
} // namespace lamella
