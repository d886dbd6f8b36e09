// SPDX-License-Identifier: LGPL-2.1-or-later

// Internal forces of the geometrically exact beam and their derivative. With
// the measures z = (Q, Q', r') of a station, local unknowns x (r and spin of
// each node), frame strains e(z) and L = dz/dx:
//   f = sum_stations w L^T (de/dz)^T s,            s = D e,
//   K = sum_stations w L^T [(de/dz)^T D (de/dz) + s_c d2e_c/dz2] L
//       + curvature of the unit quaternions,
// the Hessian of the energy along geodesics of SO(3), symmetric in any state
// (Simo, Comput. Methods Appl. Mech. Eng. 96 (1992) 189-200). One station fewer
// than nodes per element avoids shear and membrane locking (Simo and Vu-Quoc,
// Comput. Methods Appl. Mech. Eng. 58 (1986) 79-116).

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/processes.h>
#include <lamella/body/geometrically_exact_beam.h>

#include <algorithm>

// Strains are invariant to |Q| and objective; their first two derivatives by z
// are exact (frame_strains()), so K is the consistent tangent.
namespace lamella
{
  using namespace dealii;

  // L of node i: r' = N_i' r_i, Q = N_i q_i, Q' = N_i' q_i, with dq = (0,
  // theta) q / 2 for a spin theta.
  GeometricallyExactBeam::ByNode
  GeometricallyExactBeam::by_node(const Element     &element,
                                  const AxisPoint   &point,
                                  const unsigned int i)
  {
    constexpr unsigned int of_dQ = 4, of_dr = 8;
    ByNode                 result;
    const auto             spin = spin_derivative(element.q[i]);
    for (unsigned int c = 0; c < 3; ++c)
      {
        result[of_dr + c][c] = point.dN[i];
        for (unsigned int a = 0; a < 4; ++a)
          {
            result[a][3 + c]         = point.N[i] * spin[a][c];
            result[of_dQ + a][3 + c] = point.dN[i] * spin[a][c];
          }
      }
    return result;
  }



  // s = D e with the constant law of the section.
  Vector
  GeometricallyExactBeam::stresses(const Law &law, const std::vector<double> &e)
  {
    const Vector strain(e.begin(), e.end());
    Vector       s(strain.size());
    law.D.vmult(s, strain);
    return s;
  }



  // Virtual work of the stresses, delta W = w s . delta e. Warpings enter e by
  // their values N_i a_i and derivatives N_i' a_i.
  void
  GeometricallyExactBeam::add_forces(const Station       &station,
                                     const Element       &element,
                                     const Vector        &s,
                                     std::vector<double> &f)
  {
    const Frame        frame = frame_at(station.point, element);
    const FrameStrains of    = frame_strains(frame.Q, frame.dQ, frame.dr, 1);
    const unsigned int m = element.a.front().size(), n = n_node_unknowns + m;
    // Work of the frame's stresses on the measures z, then by L on the
    // unknowns.
    Tensor<1, 11> on_measures;
    for (unsigned int c = 0; c < n_strains; ++c)
      on_measures += station.weight * s[c] * of.first[c];
    for (unsigned int i = 0; i < element.q.size(); ++i)
      {
        const ByNode L = by_node(element, station.point, i);
        for (unsigned int z = 0; z < L.size(); ++z)
          for (unsigned int c = 0; c < n_node_unknowns; ++c)
            f[i * n + c] += on_measures[z] * L[z][c];
        for (unsigned int a = 0; a < m; ++a)
          f[i * n + n_node_unknowns + a] +=
            station.weight * (station.point.N[i] * s[n_strains + a] +
                              station.point.dN[i] * s[n_strains + m + a]);
      }
  }



  // Loop over elements of this process and stations; forces on local unknowns
  // go to the DoFs with the factors of the rigid fields. Their sum over the
  // processes is the result.
  void
  GeometricallyExactBeam::add_internal_forces(const Vector &u, Vector &f) const
  {
    Vector share(f.size());
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const Element               at      = element(cell, u);
        const std::vector<LocalDof> numbers = local_dofs(cell);
        std::vector<double>         local(numbers.size(), 0.);
        for (const Station &station : stations[cell])
          add_forces(station,
                     at,
                     stresses(*laws[cell],
                              strains(frame_at(station.point, at))),
                     local);
        add_local(numbers, local, share);
      }
    sum_over_processes(share);
    f += share;
  }



  // ---- heat

  // D e_0 of the thermal strain at the stations, including the part on
  // kappa_y^2 / 2 (the fiber stretch under twist).
  std::vector<Vector>
  GeometricallyExactBeam::thermal_stresses(const unsigned int cell) const
  {
    std::vector<double> places;
    for (const Station &station : stations[cell])
      places.push_back(station.point.y);
    const std::vector<unsigned int> &list = laws[cell]->fields;
    const FieldParts                 work =
      on_list(fields(), list, thermal_forces({places})[0]).work;
    const std::vector<double> on_twist = thermal_stress_on_twist(places);
    std::vector<Vector>       result;
    for (unsigned int k = 0; k < places.size(); ++k)
      {
        std::vector<double> s = on_strains(list, work, k);
        s[n_strains - 1]      = on_twist[k];
        result.emplace_back(s.begin(), s.end());
      }
    return result;
  }



  // int sigma_T . (strain of kappa_y^2 / 2 = 1) dA at places on the axis.
  std::vector<double>
  GeometricallyExactBeam::thermal_stress_on_twist(
    const std::vector<double> &places) const
  {
    std::vector<double> sums(places.size(), 0.);
    for_each_thermal_point(
      [&](const SectionPoint &point, const Voigt &, const Voigt &stress) {
        const double work = stress * twist_strain(point);
        for (unsigned int k = 0; k < places.size(); ++k)
          sums[k] += temperature_at(point, places[k]) * work;
      });
    return sums;
  }



  // f = (de/du)^T D e_0, whose direction follows the sections.
  double
  GeometricallyExactBeam::add_thermal_load(const Vector &u, Vector &f) const
  {
    // The undeformed sections have the load and the energy of linear theory.
    if (u.size() == 0)
      return Beam::add_thermal_load(u, f);
    Vector share(f.size());
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end && is_heated(); ++cell)
      {
        const Element               at      = element(cell, u);
        const std::vector<LocalDof> numbers = local_dofs(cell);
        const std::vector<Vector>   s       = thermal_stresses(cell);
        std::vector<double>         local(numbers.size(), 0.);
        for (unsigned int k = 0; k < s.size(); ++k)
          add_forces(stations[cell][k], at, s[k], local);
        add_local(numbers, local, share);
      }
    sum_over_processes(share);
    f += share;
    return 0.;
  }



  // Geometric stiffness of constant stresses D e_0, second derivatives of e
  // only.
  void
  GeometricallyExactBeam::for_each_thermal_block(const Vector        &u,
                                                 const BlockCallback &use) const
  {
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end && is_heated(); ++cell)
      {
        const Element               at      = element(cell, u);
        const std::vector<LocalDof> numbers = local_dofs(cell);
        const std::vector<Vector>   s       = thermal_stresses(cell);
        LAPACKFullMatrix<double>    K(numbers.size(), numbers.size());
        for (unsigned int k = 0; k < s.size(); ++k)
          {
            const Station &station = stations[cell][k];
            const Frame    frame   = frame_at(station.point, at);
            OfFrame        of_frame{};
            std::copy_n(s[k].begin(), n_strains, of_frame.begin());
            add_stress_tangent(station,
                               at,
                               frame_strains(frame.Q, frame.dQ, frame.dr),
                               by_nodes(station, at),
                               of_frame,
                               Tensor<2, 11>(),
                               K);
          }
        use(block_of(numbers, K));
      }
  }



  // ---- the tangent

  // Mixed integration point strategy (Magisano, Leonetti and Garcea, Comput.
  // Methods Appl. Mech. Eng. 313 (2017) 986-1005): the geometric stiffness uses
  // the stresses D (e + de/du du) of the linearization at the last iterate.
  GeometricallyExactBeam::OfFrame
  GeometricallyExactBeam::predicted(const Station             &station,
                                    const Law                 &law,
                                    const Element             &before,
                                    const std::vector<double> &change)
  {
    const unsigned int m = law.warpings.size(), n = n_node_unknowns + m;
    const Frame        frame = frame_at(station.point, before);
    const FrameStrains of    = frame_strains(frame.Q, frame.dQ, frame.dr, 1);
    // Linearized strains at the new iterate.
    std::vector<double> there = strains(frame, of);
    for (unsigned int i = 0; i < before.q.size(); ++i)
      {
        const ByNode  L = by_node(before, station.point, i);
        Tensor<1, 11> dz;
        for (unsigned int z = 0; z < L.size(); ++z)
          for (unsigned int c = 0; c < n_node_unknowns; ++c)
            dz[z] += L[z][c] * change[i * n + c];
        for (unsigned int c = 0; c < n_strains; ++c)
          there[c] += of.first[c] * dz;
        for (unsigned int a = 0; a < m; ++a)
          {
            const double by = change[i * n + n_node_unknowns + a];
            there[n_strains + a] += station.point.N[i] * by;
            there[n_strains + m + a] += station.point.dN[i] * by;
          }
      }
    OfFrame s{};
    for (unsigned int c = 0; c < n_strains; ++c)
      for (unsigned int k = 0; k < there.size(); ++k)
        s[c] += law.D(c, k) * there[k];
    return s;
  }



  // Material part with the law D, geometric part with the stresses s, and the
  // coupling of frame strains with warpings.
  void
  GeometricallyExactBeam::add_frame_tangent(const Station            &station,
                                            const Law                &law,
                                            const Element            &element,
                                            const OfFrame            &s,
                                            LAPACKFullMatrix<double> &K)
  {
    const Frame               frame = frame_at(station.point, element);
    const FrameStrains        of = frame_strains(frame.Q, frame.dQ, frame.dr);
    const unsigned int        m = law.warpings.size(), n = n_node_unknowns + m;
    const std::vector<ByNode> by = by_nodes(station, element);
    add_stress_tangent(
      station, element, of, by, s, square_of_strains(law, of), K);
    for (unsigned int a = 0; a < 2 * m; ++a)
      {
        Tensor<1, 11> coupled;
        for (unsigned int c = 0; c < n_strains; ++c)
          coupled += station.weight * law.D(c, n_strains + a) * of.first[c];
        const auto &N = a < m ? station.point.N : station.point.dN;
        add_coupling(coupled, by, N, n_node_unknowns + a % m, n, K);
      }
  }



  // L of all nodes of the element.
  std::vector<GeometricallyExactBeam::ByNode>
  GeometricallyExactBeam::by_nodes(const Station &station,
                                   const Element &element)
  {
    std::vector<ByNode> by;
    for (unsigned int i = 0; i < element.q.size(); ++i)
      by.push_back(by_node(element, station.point, i));
    return by;
  }



  // Second derivative by the measures z, condensed by L, plus the second
  // derivative of each unit quaternion along a geodesic, on spins' diagonals:
  // d2q = -|theta|^2 q / 4 adds -q . (dW/dq) / 4.
  void
  GeometricallyExactBeam::add_stress_tangent(const Station             &station,
                                             const Element             &element,
                                             const FrameStrains        &of,
                                             const std::vector<ByNode> &by,
                                             const OfFrame             &s,
                                             Tensor<2, 11> by_measures,
                                             LAPACKFullMatrix<double> &K)
  {
    const unsigned int n = n_node_unknowns + element.a.front().size();
    Tensor<1, 11>      stress;
    for (unsigned int c = 0; c < n_strains; ++c)
      {
        by_measures += s[c] * of.second[c];
        stress += station.weight * s[c] * of.first[c];
      }
    by_measures *= station.weight;
    for (unsigned int j = 0; j < by.size(); ++j)
      {
        add_rigid_tangent(by_measures, by, j, n, K);
        Quaternion by_q;
        for (unsigned int a = 0; a < 4; ++a)
          by_q[a] = station.point.N[j] * stress[a] +
                    station.point.dN[j] * stress[4 + a];
        const double curved = along_geodesic(by_q, element.q[j]);
        for (unsigned int c = 3; c < n_node_unknowns; ++c)
          K(j * n + c, j * n + c) += curved;
      }
  }



  // (de/dz)^T D (de/dz), the material part in the measures.
  Tensor<2, 11>
  GeometricallyExactBeam::square_of_strains(const Law          &law,
                                            const FrameStrains &of)
  {
    Tensor<2, 11> result;
    for (unsigned int c = 0; c < n_strains; ++c)
      {
        Tensor<1, 11> D_first;
        for (unsigned int d = 0; d < n_strains; ++d)
          D_first += law.D(c, d) * of.first[d];
        result += outer_product(of.first[c], D_first);
      }
    return result;
  }



  // K_ij += L_i^T H L_j for the columns of node j.
  void
  GeometricallyExactBeam::add_rigid_tangent(const Tensor<2, 11> &by_measures,
                                            const std::vector<ByNode> &by,
                                            const unsigned int         j,
                                            const unsigned int         n,
                                            LAPACKFullMatrix<double>  &K)
  {
    for (unsigned int c = 0; c < n_node_unknowns; ++c)
      {
        Tensor<1, 11> column;
        for (unsigned int z = 0; z < 11; ++z)
          column[z] = by[j][z][c];
        column = by_measures * column;
        for (unsigned int i = 0; i < by.size(); ++i)
          for (unsigned int z = 0; z < 11; ++z)
            for (unsigned int d = 0; d < n_node_unknowns; ++d)
              K(i * n + d, j * n + c) += by[i][z][d] * column[z];
      }
  }



  // Off-diagonal blocks of a warping with all r and spins, symmetric.
  void
  GeometricallyExactBeam::add_coupling(const Tensor<1, 11>       &coupled,
                                       const std::vector<ByNode> &by,
                                       const std::vector<double> &N,
                                       const unsigned int         warping,
                                       const unsigned int         n,
                                       LAPACKFullMatrix<double>  &K)
  {
    for (unsigned int i = 0; i < by.size(); ++i)
      for (unsigned int d = 0; d < n_node_unknowns; ++d)
        {
          double by_spin = 0.;
          for (unsigned int z = 0; z < 11; ++z)
            by_spin += by[i][z][d] * coupled[z];
          for (unsigned int j = 0; j < by.size(); ++j)
            {
              K(i * n + d, j * n + warping) += by_spin * N[j];
              K(j * n + warping, i * n + d) += by_spin * N[j];
            }
        }
  }



  // Warpings enter linearly: Kronecker products of axis integrals and D.
  void
  GeometricallyExactBeam::add_warping_tangent(const unsigned int        cell,
                                              LAPACKFullMatrix<double> &K) const
  {
    // The first row of the warpings.
    constexpr unsigned int w   = n_strains;
    const Law             &law = *laws[cell];
    const unsigned int     m = law.warpings.size(), n = n_node_unknowns + m,
                       n_nodes = axis().nodes_of_cell(cell).size();
    for (unsigned int i = 0; m > 0 && i < n_nodes; ++i)
      for (unsigned int j = 0; j < n_nodes; ++j)
        {
          double NN = 0., NdN = 0., dNN = 0., dNdN = 0.;
          for (const auto &[point, weight] : stations[cell])
            {
              NN += weight * point.N[i] * point.N[j];
              NdN += weight * point.N[i] * point.dN[j];
              dNN += weight * point.dN[i] * point.N[j];
              dNdN += weight * point.dN[i] * point.dN[j];
            }
          for (unsigned int a = 0; a < m; ++a)
            for (unsigned int b = 0; b < m; ++b)
              K(i * n + n_node_unknowns + a, j * n + n_node_unknowns + b) +=
                NN * law.D(w + a, w + b) + NdN * law.D(w + a, w + m + b) +
                dNN * law.D(w + m + a, w + b) +
                dNdN * law.D(w + m + a, w + m + b);
        }
  }



  // The state before the correction, retract(u, -du), is the point of the
  // linearization whose stresses are predicted.
  void
  GeometricallyExactBeam::for_each_stiffness_block(
    const Vector        &u,
    const Vector        &correction,
    const bool           with_values,
    const BlockCallback &use) const
  {
    // The linear stiffness, as e.g. for the size of forces and for rounding.
    if (u.size() == 0)
      return Beam::for_each_stiffness_block(u, correction, with_values, use);
    Vector back = correction;
    back *= -1.;
    const Vector came_from  = with_values ? retract(u, back) : Vector();
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const std::vector<LocalDof> numbers = local_dofs(cell);
        LAPACKFullMatrix<double>    K;
        if (with_values)
          {
            const Law    &law    = *laws[cell];
            const Element at     = element(cell, u),
                          before = element(cell, came_from);
            std::vector<double> change;
            for (const LocalDof &local : numbers)
              change.push_back(
                local.exists() ? correction[local.dof] / local.factor : 0.);
            K.reinit(numbers.size(), numbers.size());
            for (const Station &station : stations[cell])
              add_frame_tangent(
                station, law, at, predicted(station, law, before, change), K);
            add_warping_tangent(cell, K);
          }
        use(block_of(numbers, K));
      }
  }


  // Strains between stations are interpolated from the stations, where they are
  // superconvergent (Barlow points).
  GeometricallyExactBeam::SectionState
  GeometricallyExactBeam::output_state(const AxisPoint &on_axis,
                                       const Vector    &u) const
  {
    const unsigned int        cell = on_axis.cell, n = stations[cell].size();
    const double              begin = axis().cell_begin(cell);
    const std::vector<double> weights =
      gauss_projection(n,
                       n - 1,
                       (on_axis.y - begin) / (axis().cell_end(cell) - begin));
    SectionState state = section_state(on_axis, u);
    for (std::vector<double> *part :
         {&state.e, &state.value, &state.derivative})
      part->assign(part->size(), 0.);
    const auto add = [](const double weight, const auto &from, auto &to) {
      for (unsigned int i = 0; i < to.size(); ++i)
        to[i] += weight * from[i];
    };
    for (unsigned int k = 0; k < n; ++k)
      {
        const SectionState at = section_state(stations[cell][k].point, u);
        add(weights[k], at.e, state.e);
        add(weights[k], at.value, state.value);
        add(weights[k], at.derivative, state.derivative);
      }
    return state;
  }
} // namespace lamella
