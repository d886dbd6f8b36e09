// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/end_fields.h>
#include <lamella/adapt/graded_axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/beam.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/conditions/stabilisation.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lamella
{
  using namespace dealii;

  double
  first_element(const Section       &section,
                const HeldSection   &held,
                const EndFieldRules &rules)
  {
    const double H = section.extents().first;
    return std::clamp(held.element,
                      rules.shortest_element * H,
                      rules.longest_element * H);
  }



  namespace
  {
    constexpr unsigned int n_rigid = 6;



    /// A beam with all fields, its axis graded to the held end.
    std::unique_ptr<Beam>
    make_piece(const std::shared_ptr<const Section> &section,
               const HeldSection                    &held,
               const EndFieldRules                  &rules)
    {
      const double length = rules.length * section->extents().second;
      AxisMesh     axis;
      axis.length = length;
      axis.breaks = graded_breaks(length,
                                  {{held.goes_forward ? 0. : length,
                                    first_element(*section, held, rules)}});
      axis.elements.assign(axis.breaks.size() + 1, 1);
      return std::make_unique<Beam>("end",
                                    section,
                                    std::make_shared<const Axis>(axis),
                                    Placement());
    }



    /// The rows of @p held at the DoFs of @p piece.
    std::vector<PrescribedRow>
    rows_of(const HeldSection &held, const Beam &piece)
    {
      const unsigned int node =
        held.goes_forward ? 0 : piece.axis().n_nodes() - 1;
      std::vector<PrescribedRow> rows;
      for (const Row &row : held.rows)
        {
          PrescribedRow at_node;
          for (const auto &[field, weight] : row.entries())
            at_node.row.row.add(piece.dofs().first(node) + field, weight);
          rows.push_back(at_node);
        }
      return rows;
    }



    /// The tractions of the six states on the section: S_10 a + S_11 b.
    std::vector<Vector>
    tractions(const SaintVenant &states)
    {
      const Section      &section = states.of_section();
      std::vector<Vector> result;
      for (unsigned int k = 0; k < states.values().size(); ++k)
        {
          Vector load(section.n_fields());
          section.S(1, 0).vmult(load, states.values()[k]);
          section.S(1, 1).vmult_add(load, states.derivatives()[k]);
          result.push_back(load);
        }
      return result;
    }



    /// The section forces at the held end, in the order of SaintVenant::Force,
    /// of the section load @p load at the distance @p arm in y from it.
    Tensor<1, 6>
    forces_at_end(const Section &section, const Vector &load, const double arm)
    {
      namespace Rigid = RigidField;
      const double h  = section.element().reference_length();
      Tensor<1, 6> forces;
      forces[SaintVenant::F_x] = load[Rigid::translation_x];
      forces[SaintVenant::F_y] = load[Rigid::translation_y];
      forces[SaintVenant::F_z] = load[Rigid::translation_z];
      forces[SaintVenant::M_y] = h * load[Rigid::rotation_y];
      forces[SaintVenant::M_x] =
        arm * load[Rigid::translation_z] - h * load[Rigid::slope_z];
      forces[SaintVenant::M_z] =
        h * load[Rigid::slope_x] - arm * load[Rigid::translation_x];
      return forces;
    }



    /// Eigenvalues, ascending, and eigenvectors of the symmetric @p matrix.
    std::pair<Vector, FullMatrix<double>>
    eigenvalues_of(const LAPACKFullMatrix<double> &matrix)
    {
      LAPACKFullMatrix<double>              copy = matrix;
      std::pair<Vector, FullMatrix<double>> result;
      const double                          bound =
        2. * matrix.frobenius_norm() + arithmetic::above_zero;
      copy.set_property(LAPACKSupport::symmetric);
      copy.compute_eigenvalues_symmetric(
        -bound, bound, 0., result.first, result.second);
      return result;
    }



    /// The rigid motions of @p piece that @p rows leave free.
    std::vector<Vector>
    free_motions(const Beam &piece, const std::vector<PrescribedRow> &rows)
    {
      std::vector<Vector> rigid = piece.rigid_motions();
      for (Vector &motion : rigid)
        motion /= motion.linfty_norm();
      LAPACKFullMatrix<double> gram(n_rigid, n_rigid);
      for (const PrescribedRow &row : rows)
        {
          std::array<double, n_rigid> value;
          for (unsigned int j = 0; j < n_rigid; ++j)
            value[j] = row.row.row(rigid[j]);
          for (unsigned int i = 0; i < n_rigid; ++i)
            for (unsigned int j = 0; j < n_rigid; ++j)
              gram(i, j) += value[i] * value[j];
        }
      const auto [values, vectors] = eigenvalues_of(gram);
      std::vector<Vector> result;
      for (unsigned int k = 0; k < n_rigid; ++k)
        if (values[k] <= arithmetic::rounding_of_results * values[n_rigid - 1])
          {
            Vector motion(piece.n_dofs());
            for (unsigned int j = 0; j < n_rigid; ++j)
              motion.add(vectors(j, k), rigid[j]);
            result.push_back(motion);
          }
      return result;
    }



    /// Combinations of six loads, a column each, that do no work on the free
    /// motions: @p work is that of the loads on each of these.
    FullMatrix<double>
    without_work(const std::vector<Tensor<1, 6>> &work)
    {
      LAPACKFullMatrix<double> gram(n_rigid, n_rigid);
      for (const Tensor<1, 6> &one : work)
        for (unsigned int i = 0; i < n_rigid; ++i)
          for (unsigned int j = 0; j < n_rigid; ++j)
            gram(i, j) += one[i] * one[j] / one.norm_square();
      const auto [values, vectors] = eigenvalues_of(gram);
      unsigned int n               = 0;
      while (n < n_rigid && values[n] < arithmetic::rounding_of_solutions)
        ++n;
      FullMatrix<double> result(n_rigid, n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int i = 0; i < n_rigid; ++i)
          result(i, k) = vectors(i, k);
      return result;
    }



    /// Section loads at the far end of @p piece, @p arm from the held one,
    /// as end_fields() says.
    std::vector<Vector>
    end_loads(const SaintVenant         &states,
              const Beam                &piece,
              const unsigned int         far_node,
              const double               arm,
              const std::vector<Vector> &motions)
    {
      const Section      &section = states.of_section();
      std::vector<Vector> loads   = tractions(states);
      // Unit energy each, so that no digits are lost by powers of lengths.
      for (Vector &load : loads)
        {
          const Tensor<1, 6> s = forces_at_end(section, load, arm);
          load /= std::sqrt(s * (states.compliance() * s));
        }
      std::vector<Tensor<1, 6>> work(motions.size());
      const DofIndex            first = piece.dofs().first(far_node);
      for (unsigned int m = 0; m < motions.size(); ++m)
        for (unsigned int k = 0; k < n_rigid; ++k)
          for (unsigned int a = 0; a < loads[k].size(); ++a)
            work[m][k] += motions[m][first + a] * loads[k][a];
      const FullMatrix<double> parts = without_work(work);
      const unsigned int       n     = parts.n();

      std::vector<Vector> combined(n, Vector(section.n_fields()));
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int i = 0; i < n_rigid; ++i)
          combined[k].add(parts(i, k), loads[i]);
      LAPACKFullMatrix<double> energy(n, n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          energy(k, l) =
            forces_at_end(section, combined[k], arm) *
            (states.compliance() * forces_at_end(section, combined[l], arm));
      std::vector<Vector> result(n, Vector(section.n_fields()));
      if (n == 0)
        return result;
      const auto [values, vectors] = eigenvalues_of(energy);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          result[k].add(vectors(l, k) / std::sqrt(values[k]), combined[l]);
      return result;
    }



    /// Section vectors at the node number @p node of @p piece, or at all nodes.
    Vector
    at_node(const Beam &piece, const Vector &v, const unsigned int node)
    {
      Vector u(piece.n_dofs());
      for (unsigned int a = 0; a < v.size(); ++a)
        u[piece.dofs().first(node) + a] = v[a];
      return u;
    }

    Vector
    all_along(const Beam &piece, const Vector &v)
    {
      Vector u(piece.n_dofs());
      for (unsigned int node = 0; node < piece.axis().n_nodes(); ++node)
        u += at_node(piece, v, node);
      return u;
    }



    /// What @p u is beside the answer of @p heat all along @p piece, scaled to
    /// the energy that a state has along one H; nothing where that is rounding.
    std::optional<Vector>
    disturbance(const Beam &piece, const Vector &u, const HeatedSection &heat)
    {
      const Vector answer    = all_along(piece, heat.answer);
      const auto   energy_of = [&piece](const Vector &v) {
        Vector forces(v.size());
        piece.add_internal_forces(v, forces);
        return v * forces;
      };
      Vector left = u;
      left -= answer;
      const double energy = energy_of(left);
      if (energy <= arithmetic::rounding_of_solutions * energy_of(answer))
        return {};
      left *= std::sqrt(piece.section().extents().first / energy);
      return left;
    }



    /// The displacements of @p piece under the six loads, and those that its
    /// end makes of what heat does to it.
    std::vector<Vector>
    solutions(const Beam                       &piece,
              const SaintVenant                &states,
              const HeldSection                &held,
              const std::vector<PrescribedRow> &rows,
              const std::vector<HeatedSection> &heat)
    {
      const RowReduction        reduction(piece, 0, rows, {"end"});
      const std::vector<Vector> motions = free_motions(piece, rows);
      std::vector<SpringTerm>   springs;
      // No load works on them: how stiff they are does not matter.
      if (!motions.empty())
        for (const Spring &spring : stabilising_springs(piece, 0, rows, {1.}))
          springs.emplace_back(spring.row, spring.stiffness);
      const unsigned int last = piece.axis().n_nodes() - 1,
                         far  = held.goes_forward ? last : 0;
      const double arm = (held.goes_forward ? 1. : -1.) * piece.axis().length();
      std::vector<Vector> u;
      for (const Vector &load : end_loads(states, piece, far, arm, motions))
        u.push_back(at_node(piece, load, far));
      const std::size_t n_states = u.size();
      // What is held in part has none (choose_fields() says so).
      const bool is_clamped_or_free = motions.empty() || rows.empty();
      for (const HeatedSection &one :
           is_clamped_or_free ? heat : std::vector<HeatedSection>())
        {
          // What makes the answer all along, but for its traction at the end.
          u.push_back(at_node(piece, one.traction, last - far));
          u.back() *= held.goes_forward ? 1. : -1.;
          piece.add_internal_forces(all_along(piece, one.answer), u.back());
        }
      if (u.empty())
        return u;
      for (Vector &one : u)
        reduction.constraints().condense(one);
      piece.make_solver(reduction.constraints(), springs)->solve_all(u);
      for (Vector &one : u)
        reduction.constraints().distribute(one);
      std::vector<Vector> result(u.begin(), u.begin() + n_states);
      for (std::size_t k = n_states; k < u.size(); ++k)
        if (const auto left = disturbance(piece, u[k], heat[k - n_states]))
          result.push_back(*left);
      return result;
    }



    /// What a piece tells: weighted section vectors, and how far from the held
    /// end each is.
    struct Snapshots
    {
      std::vector<Vector> vectors;
      std::vector<double> weights, distances;
    };



    Snapshots
    snapshots_of(const Beam                &piece,
                 const std::vector<Vector> &u,
                 const HeldSection         &held)
    {
      const Axis  &axis    = piece.axis();
      const auto   lengths = axis.node_weights();
      const double H       = piece.section().extents().first;
      Snapshots    result;
      for (unsigned int node = 0; node < axis.n_nodes(); ++node)
        for (const Vector &one : u)
          {
            const auto first = one.begin() + piece.dofs().first(node);
            Vector     v(first, first + piece.section().n_fields());
            result.weights.push_back(std::sqrt(lengths[node] / H));
            v *= result.weights.back();
            result.vectors.push_back(v);
            result.distances.push_back(held.goes_forward ?
                                         axis.nodes()[node] :
                                         axis.length() - axis.nodes()[node]);
          }
      return result;
    }
  } // namespace



  HeatedSection::HeatedSection(const SaintVenant       &states,
                               const Beam::SectionHeat &heat)
    : answer(states.response_to_constant(heat.on_values))
    , traction(answer.size())
  {
    const Section &section = states.of_section();
    section.S(1, 0).vmult(traction, answer);
    const double size =
      traction.linfty_norm() + heat.on_derivatives.linfty_norm();
    traction -= heat.on_derivatives;
    const std::vector<Vector> of_states = tractions(states);
    FullMatrix<double>        forces(n_rigid);
    for (unsigned int j = 0; j < n_rigid; ++j)
      for (unsigned int i = 0; i < n_rigid; ++i)
        forces(i, j) = forces_at_end(section, of_states[j], 0.)[i];
    forces.gauss_jordan();
    const Tensor<1, 6> left = forces_at_end(section, traction, 0.);
    for (unsigned int j = 0; j < n_rigid; ++j)
      {
        double part = 0.;
        for (unsigned int i = 0; i < n_rigid; ++i)
          part += forces(j, i) * left[i];
        traction.add(-part, of_states[j]);
        answer.add(-part, states.values()[j]);
      }
    if (traction.linfty_norm() < arithmetic::alike * size)
      traction = 0.;
  }



  namespace
  {
    /// The zones of @p found, as end_fields() says.
    std::vector<EndZone>
    zones_of(const Snapshots     &found,
             const Warping       &warping,
             const FieldColumns  &warpings,
             const double         larger,
             const EndFieldRules &rules)
    {
      // Over the larger extent: inner fields go on into the next zone, since a
      // stress in an element whose nodes differ is as poor as the poorer one.
      constexpr double    overlap = 0.5;
      std::vector<double> norms   = warping.strengths(found.vectors, warpings);
      for (unsigned int k = 0; k < norms.size(); ++k)
        norms[k] /= found.weights[k];
      const double largest = *std::max_element(norms.begin(), norms.end());
      double       reach   = 0.;
      for (unsigned int k = 0; k < norms.size(); ++k)
        if (norms[k] > std::max(rules.rest * largest, rules.tolerance))
          reach = std::max(reach, found.distances[k]);

      std::vector<EndZone> zones;
      FieldColumns         known = warpings;
      for (unsigned int z = rules.zones.size(); z-- > 0;)
        {
          const double        begin = rules.zones[z] * larger;
          std::vector<Vector> from_there;
          for (unsigned int k = 0; k < norms.size(); ++k)
            if (found.distances[k] >= begin && found.distances[k] <= reach)
              from_there.push_back(found.vectors[k]);
          EndZone zone;
          zone.fields = warping.weighted_basis(from_there,
                                               warpings,
                                               known,
                                               rules.tolerance);
          zone.reach =
            z + 1 < rules.zones.size() ?
              std::min((rules.zones[z + 1] + overlap) * larger, reach) :
              reach;
          if (zone.fields.n() == 0)
            continue;
          known = beside(known, zone.fields);
          zones.push_back(std::move(zone));
        }
      return zones;
    }
  } // namespace



  std::vector<EndZone>
  end_fields(const std::shared_ptr<const Section> &section,
             const SaintVenant                    &states,
             const Warping                        &warping,
             const FieldColumns                   &warpings,
             const HeldSection                    &held,
             const std::vector<HeatedSection>     &heat,
             const EndFieldRules                  &rules)
  {
    const double larger = section->extents().second;
    const auto   piece  = make_piece(section, held, rules);
    if (piece->n_dofs() > rules.most_dofs)
      return {};
    const std::vector<Vector> u =
      solutions(*piece, states, held, rows_of(held, *piece), heat);
    if (u.empty())
      return {};
    return zones_of(
      snapshots_of(*piece, u, held), warping, warpings, larger, rules);
  }



  unsigned int
  nodes_of_pieces(const Beam               &beam,
                  const std::vector<Touch> &touches,
                  const EndFieldRules      &rules)
  {
    const auto   section = beam.fields().shared_section();
    unsigned int nodes   = 0;
    for (unsigned int t = 0; t < touches.size(); ++t)
      {
        // Touches that hold a section together have one piece.
        const bool is_first =
          std::none_of(touches.begin(),
                       touches.begin() + t,
                       [&](const auto &o) {
                         return o.holds_section &&
                                std::abs(o.begin - touches[t].begin) <
                                  arithmetic::same_place * beam.axis().length();
                       });
        if (touches[t].holds_section && is_first)
          for (const HeldSection &held : held_sections(touches, t, beam.axis()))
            if (const auto piece = make_piece(section, held, rules);
                piece->n_dofs() <= rules.most_dofs)
              nodes += piece->axis().n_nodes();
      }
    return nodes;
  }
} // namespace lamella
