// SPDX-License-Identifier: LGPL-2.1-or-later

// Points of the geometrically exact beam, x = X_c + r + R (X - X_c + Phi a):
// positions, rows of displacements, tangents of forces, and samples (kinematics
// of Simo, Comput. Methods Appl. Mech. Eng. 49 (1985) 55-70, with warping as in
// Simo and Vu-Quoc, Int. J. Solids Struct. 27 (1991) 371-393). With the offset
// v = X - X_c + Phi a, the interpolated Q = sum N_i q_i and forces F at points:
//   displacement  u = r + (R - 1) (X - X_c) + R Phi a,
//   rows          B = dx/d(r_i, theta_i, a_i)             (by_local()),
//   forces        f = B^T F,
//   tangent       df/d(r_i, theta_i, a_i) = F . d2x       (add_force()).
// Contacts and loads act through B; the tangent of B^T F is the part of the
// geometric stiffness that belongs to forces off the axis.

#include <lamella/body/fields.h>
#include <lamella/body/geometrically_exact_beam.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  // ---- a section in a state

  // Section fields with the strains as axial derivatives of rigid fields:
  //   u_x' = Gamma_x, u_y' = Gamma_y, u_z' = Gamma_z,
  //   (u_y,z)' = -kappa_x, (rotation about y)' = kappa_y, (u_y,x)' = kappa_z.
  // Rigid fields themselves are zero in section axes; modes of the section
  // space add their values a and derivatives a'.
  GeometricallyExactBeam::SectionState
  GeometricallyExactBeam::section_state(const unsigned int cell,
                                        const Frame       &frame) const
  {
    SectionState state{frame, strains(frame), {}, {}, {}};
    state.value.assign(section().n_fields(), 0.);
    state.derivative.assign(section().n_fields(), 0.);
    const auto set = [&](const unsigned int alpha, const double by) {
      if (alpha < section().n_fields())
        state.derivative[alpha] = by;
    };
    set(RigidField::translation_x, state.e[0]);
    set(RigidField::translation_y, state.e[1]);
    set(RigidField::translation_z, state.e[2]);
    set(RigidField::slope_z, -h * state.e[3]);
    set(RigidField::rotation_y, h * state.e[4]);
    set(RigidField::slope_x, h * state.e[5]);
    const std::vector<unsigned int> &warpings = laws[cell]->warpings;
    for (unsigned int a = 0; a < warpings.size(); ++a)
      {
        const double *mode = fields().mode(warpings[a] - fields().first_mode());
        for (unsigned int alpha = 0; alpha < section().n_fields(); ++alpha)
          {
            state.value[alpha] += mode[alpha] * frame.a[a];
            state.derivative[alpha] += mode[alpha] * frame.da[a];
          }
      }
    state.warping = state.value;
    return state;
  }



  GeometricallyExactBeam::SectionState
  GeometricallyExactBeam::section_state(const AxisPoint &on_axis,
                                        const Vector    &u) const
  {
    return section_state(on_axis.cell,
                         frame_at(on_axis, element(on_axis.cell, u)));
  }



  Tensor<1, 3>
  GeometricallyExactBeam::from_center(const SectionPoint &point) const
  {
    // The slope fields are (x - x_c) / h and (z - z_c) / h along y.
    const auto along = [&](const unsigned int alpha) {
      const auto found =
        std::find(point.fields->begin(), point.fields->end(), alpha);
      return found == point.fields->end() ?
               0. :
               point.value[found - point.fields->begin()][1];
    };
    return Tensor<1, 3>(
      {h * along(RigidField::slope_x), 0., h * along(RigidField::slope_z)});
  }



  // u in body axes; state.warping has the coefficients of Phi a by fields.
  Tensor<1, 3>
  GeometricallyExactBeam::displacement(const SectionPoint &point,
                                       const SectionState &state) const
  {
    const Tensor<2, 3> R = rotation_of(state.frame.Q);
    const Tensor<1, 3> X = from_center(point);
    Tensor<1, 3>       warping;
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      warping += state.warping[(*point.fields)[k]] * point.value[k];
    return state.frame.r + (R * X - X) + R * warping;
  }



  // ---- points of it

  // Columns of Phi: modes of the section space, combined from the fields of the
  // section cell (the CUF expansion F_tau).
  GeometricallyExactBeam::PointFields
  GeometricallyExactBeam::fields_at(const Location::Place &place) const
  {
    const unsigned int n = section().n_cells(), cell = place.cell / n;
    const SectionPoint point =
      section().evaluate(place.cell % n, {place.unit[0], place.unit[2]});
    PointFields result;
    result.on_axis = axis().evaluate(cell, place.unit[1]);
    result.X       = from_center(point);
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
  GeometricallyExactBeam::warping(const PointFields &at, const Frame &frame)
  {
    Tensor<1, 3> sum;
    for (unsigned int a = 0; a < at.Phi.size(); ++a)
      sum += frame.a[a] * at.Phi[a];
    return sum;
  }



  // Change of basis from body to scene axes, A^T R A.
  Tensor<2, 3>
  GeometricallyExactBeam::rotation_at(const Location &location,
                                      const Vector   &u) const
  {
    const Location::Place &place = location.places[0];
    const AxisPoint        point =
      axis().evaluate(place.cell / section().n_cells(), place.unit[1]);
    return transpose(placement.axes) *
           rotation_of(frame_at(point, element(point.cell, u)).Q) *
           placement.axes;
  }



  std::vector<Tensor<1, 3>>
  GeometricallyExactBeam::displacements(const std::vector<Location> &locations,
                                        const Vector                &u) const
  {
    // Cached states and points: surface nodes repeat few of each.
    std::map<std::pair<unsigned int, double>, SectionState> states;
    std::map<std::pair<unsigned int, std::array<double, 2>>, SectionPoint>
                              points;
    const unsigned int        n = section().n_cells();
    std::vector<Tensor<1, 3>> result;
    for (const Location &where : locations)
      {
        Tensor<1, 3> mean;
        for (const Location::Place &place : where.places)
          {
            const unsigned int cell = place.cell / n, c = place.cell % n;
            const Point<3>    &unit = place.unit;
            const auto [state, is_new_state] =
              states.try_emplace({cell, unit[1]});
            if (is_new_state)
              state->second = section_state(axis().evaluate(cell, unit[1]), u);
            const auto [point, is_new_point] =
              points.try_emplace({c, {{unit[0], unit[2]}}});
            if (is_new_point)
              point->second = section().evaluate(c, {unit[0], unit[2]});
            mean += displacement(point->second, state->second);
          }
        result.push_back(
          placement.vector_to_scene(mean / double(where.places.size())));
      }
    return result;
  }



  RotatedVector
  GeometricallyExactBeam::rotated_point(const PointFields &at,
                                        const Frame       &frame)
  {
    return rotated_vector(frame.Q, at.X + warping(at, frame));
  }



  // dx/dr = N_i, dx/dspin = d(R v)/dQ N_i dq_i, dx/da = R Phi N_i, with dq_i =
  // (0, theta_i) q_i / 2. Equal spins of all nodes sum to theta x R v.
  std::vector<Tensor<1, 3>>
  GeometricallyExactBeam::by_local(const PointFields &at,
                                   const Element     &element)
  {
    const std::vector<double> &N = at.on_axis.N;
    const RotatedVector of = rotated_point(at, frame_at(at.on_axis, element));
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



  // Rows in scene axes; a DoF is `factor` times its local unknown.
  void
  GeometricallyExactBeam::add_rows(const Location::Place         &place,
                                   const double                   share,
                                   const Vector                  &u,
                                   std::vector<LinearFunctional> &rows) const
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



  std::vector<std::vector<LinearFunctional>>
  GeometricallyExactBeam::rows(const std::vector<Location> &locations,
                               const Vector                &u,
                               const Quantity               quantity,
                               const lamella::Frame         frame) const
  {
    if (u.size() == 0 || quantity != Quantity::displacement)
      return Beam::rows(locations, u, quantity, frame);
    std::vector<std::vector<LinearFunctional>> result;
    for (const Location &where : locations)
      {
        std::vector<LinearFunctional> rows(3);
        for (const Location::Place &place : where.places)
          add_rows(place, 1. / where.places.size(), u, rows);
        for (LinearFunctional &row : rows)
          row.compress();
        result.push_back(std::move(rows));
      }
    return result;
  }



  // Second variation of the work F . x at fixed F. x is linear in r, and R v in
  // v, so only spin-spin and spin-warping blocks exist:
  //   K_ij = L_i^T H L_j + delta_ij c_i 1,   H = F . d2(R v)/d(Q, v)2,
  // with L_i = N_i dq_i/dtheta_i or N_i Phi. c_i is the curvature of the unit
  // sphere: along the geodesic exp(t theta) q the second derivative of q is
  // -|theta|^2 q / 4. This is the Hessian on SO(3), symmetric in any state
  // (Simo, Comput. Methods Appl. Mech. Eng. 96 (1992) 189-200).
  void
  GeometricallyExactBeam::add_force(const PointFields        &at,
                                    const Tensor<1, 3>       &force,
                                    const Element            &element,
                                    LAPACKFullMatrix<double> &K)
  {
    const std::vector<double> &N = at.on_axis.N;
    const unsigned int         n = n_node_unknowns + at.Phi.size();
    const RotatedVector of = rotated_point(at, frame_at(at.on_axis, element));
    // First and second derivative of the work F . R v by (Q, v), v = X + Phi a.
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



  // Row L_i^T H times the L_j of all nodes; the spin-warping block is also
  // added transposed, as add_force() visits spins only.
  void
  GeometricallyExactBeam::add_force_row(const PointFields        &at,
                                        const Element            &element,
                                        const Tensor<1, 7>       &row,
                                        const unsigned int        spin,
                                        LAPACKFullMatrix<double> &K)
  {
    const std::vector<double> &N = at.on_axis.N;
    const unsigned int         m = at.Phi.size(), n = n_node_unknowns + m;
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
            K(spin, j * n + n_node_unknowns + b) += by;
            K(j * n + n_node_unknowns + b, spin) += by;
          }
      }
  }



  void
  GeometricallyExactBeam::for_each_block_of_forces(
    const std::vector<Location>     &locations,
    const std::vector<Tensor<1, 3>> &forces,
    const Vector                    &u,
    const BlockCallback             &use) const
  {
    // Blocks by axis elements. The forces keep their directions in the scene; a
    // location on several elements has equal shares.
    std::map<unsigned int, LAPACKFullMatrix<double>> of_cells;
    const auto [begin, end] = axis().own_cells();
    for (unsigned int k = 0; k < locations.size(); ++k)
      for (const Location::Place &place : locations[k].places)
        {
          const unsigned int cell = place.cell / section().n_cells();
          if (cell < begin || cell >= end)
            continue;
          const PointFields at     = fields_at(place);
          auto             &matrix = of_cells[cell];
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



  // Wagner's strain, relaxed by warping in the section's plane; a rigid section
  // has the stretch r^2 of fibers, completed by its theory.
  Voigt
  GeometricallyExactBeam::twist_strain(const SectionPoint &point) const
  {
    return &section() == deformable_section.get() ?
             twist_stretch->strain(point) :
             stretch_of_fiber(section(), point);
  }



  // Small strain in section axes, plus kappa_y^2 / 2 times the fiber stretch,
  //   epsilon = sum_tau (q_tau D_s F_tau + q_tau' D_y F_tau)
  //             + kappa_y^2 / 2 epsilon_2
  // (the split of CUF; Carrera, Cinefra, Petrolo and Zappino, Finite Element
  // Analysis of Structures through Unified Formulation, Wiley 2014).
  Voigt
  GeometricallyExactBeam::strain_at(const SectionPoint &point,
                                    const SectionState &state) const
  {
    Voigt strain = state.e[n_strains - 1] * twist_strain(point);
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      {
        const unsigned int alpha = (*point.fields)[k];
        strain += state.value[alpha] * point.in_plane[k] +
                  state.derivative[alpha] * point.along[k];
      }
    return strain;
  }



  // Stress C (epsilon - epsilon_0) in section axes, which rotate by R: small
  // strains make it the Cauchy stress R^T sigma R.
  FieldSample
  GeometricallyExactBeam::sample_of_section(const SectionPoint &point,
                                            const double        y,
                                            const SectionState &state) const
  {
    const ElasticLaw law =
      law_at(point.cell,
             point.position,
             placement.to_scene({point.position[0], y, point.position[1]}));
    Voigt strain = strain_at(point, state);
    if (is_heated())
      strain += section().completion_of_initial(point.cell,
                                                point.position,
                                                law.initial_strain());
    FieldSample sample =
      sample_of(displacement(point, state),
                strain,
                placement,
                section().ply_axes(point.cell, point.position),
                law);
    sample.rotation = placement.rotation_in_scene(rotation_of(state.frame.Q));
    return sample;
  }



  FieldSample
  GeometricallyExactBeam::sample_at(const SectionPoint &point,
                                    const AxisPoint    &on_axis,
                                    const Vector       &u) const
  {
    return sample_of_section(point, on_axis.y, output_state(on_axis, u));
  }



  std::vector<FieldSample>
  GeometricallyExactBeam::samples_at(const std::vector<SectionPoint> &points,
                                     const std::vector<AxisPoint>    &places,
                                     const Vector                    &u) const
  {
    std::vector<FieldSample> samples;
    for (const AxisPoint &on_axis : places)
      {
        const SectionState state = output_state(on_axis, u);
        for (const SectionPoint &point : points)
          samples.push_back(sample_of_section(point, on_axis.y, state));
      }
    return samples;
  }



  // Largest principal strain; root mean square of the axial strain,
  //   (int epsilon_yy^2 dA / A)^(1/2);
  // and the change of stiffness by the change of shape, sum_k c_k kappa_k^2
  // (Brazier, Proc. R. Soc. Lond. A 116 (1927) 104-114; stiffening_by_shape()).
  void
  GeometricallyExactBeam::add_strains(const SectionState &state,
                                      Deformation        &deformation) const
  {
    const auto &points  = section().integration_points();
    const auto &weights = section().integration_weights();
    double      square = 0., area = 0., change = 0.;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Voigt strain = strain_at(points[k], state);
        for (const double value : eigenvalues(strain_tensor(strain)))
          deformation.max_strain =
            std::max(deformation.max_strain, std::abs(value));
        square += weights[k] * strain[1] * strain[1];
        area += weights[k];
      }
    for (unsigned int c = 0; c < 3; ++c)
      change += stiffening[c] * state.e[3 + c] * state.e[3 + c];
    deformation.max_rms_strain =
      std::max(deformation.max_rms_strain, std::sqrt(square / area));
    deformation.shape_change =
      std::max(deformation.shape_change, std::abs(change));
  }



  // Energy e . D e / 2, less e . D e_0 if heated, and extremes at stations:
  //   U = sum_stations w (s / 2 - s_0) . e,  s = D e,  s_0 = D e_0.
  Deformation
  GeometricallyExactBeam::deformation(const Vector &u) const
  {
    Deformation result;
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const Element             at = element(cell, u);
        const std::vector<Vector> thermal_factor =
          is_heated() ? thermal_stresses(cell) : std::vector<Vector>();
        for (unsigned int k = 0; k < stations[cell].size(); ++k)
          {
            const Station     &station = stations[cell][k];
            const SectionState state =
              section_state(cell, frame_at(station.point, at));
            const std::vector<double> &e = state.e;
            Vector                     s = stresses(*laws[cell], e);
            s *= 0.5;
            if (is_heated())
              s -= thermal_factor[k];
            result.energy += station.weight * (Vector(e.begin(), e.end()) * s);
            add_strains(state, result);
            result.max_rotation = std::max(
              result.max_rotation,
              rotation_vector_of(state.frame.Q / state.frame.Q.norm()).norm());
          }
      }
    return reduce_over_processes(result);
  }
} // namespace lamella
