// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/adapt/graded_axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/body_solver.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/conditions/stabilization.h>

#include <algorithm>
#include <cmath>
#include <optional>

// Boundary-layer modes of a clamped end from one fine solution (Saint-Venant's
// principle; proper orthogonal decomposition of Sirovich, Quart. Appl. Math. 45
// (1987) 561-590, on snapshots at the nodes):
// 1. make_piece(): a short beam with all section fields, graded to the end;
// 2. solutions(): its displacements under six end loads and heat;
// 3. snapshots_of(): section vectors at the nodes, weighted by length;
// 4. zones_of(): a basis per zone, orthogonal to rigid fields and warpings,
//    from the outermost zone, whose fields decay slowest, inwards.
// Fields of inner zones are added to those of outer ones, which all nodes up to
// the outer zone's end carry.
namespace lamella
{
  using namespace dealii;

  // The scene's element, limited in terms of the section height H.
  double
  first_element(const Section            &section,
                const ConstrainedSection &held,
                const BoundaryLayerRules &rules)
  {
    const double H = section.extents().first;
    return std::clamp(held.element,
                      rules.shortest_element * H,
                      rules.longest_element * H);
  }



  namespace
  {
    /// Returns a beam with all fields, its axis graded to the clamped end.
    std::unique_ptr<Beam>
    make_piece(const std::shared_ptr<const Section> &section,
               const ConstrainedSection             &held,
               const BoundaryLayerRules             &rules)
    {
      const double length = rules.length * section->extents().second;
      AxisMesh     axis;
      axis.length = length;
      axis.breaks = graded_breaks(length,
                                  {{held.extends_forward ? 0. : length,
                                    first_element(*section, held, rules)}});
      axis.elements.assign(axis.breaks.size() + 1, 1);
      return std::make_unique<Beam>("end",
                                    section,
                                    std::make_shared<const Axis>(axis),
                                    Placement());
    }



    /// The rows of @p held at the DoFs of @p piece.
    /// The constraints of the section at the first or last node of the piece.
    std::vector<PrescribedFunctional>
    rows_of(const ConstrainedSection &held, const Beam &piece)
    {
      const unsigned int node =
        held.extends_forward ? 0 : piece.axis().n_nodes() - 1;
      std::vector<PrescribedFunctional> rows;
      for (const LinearFunctional &row : held.rows)
        {
          PrescribedFunctional at_node;
          for (const auto &[field, weight] : row.entries())
            at_node.row.row.add(piece.dofs().first(node) + field, weight);
          rows.push_back(at_node);
        }
      return rows;
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
    along_whole_axis(const Beam &piece, const Vector &v)
    {
      Vector u(piece.n_dofs());
      for (unsigned int node = 0; node < piece.axis().n_nodes(); ++node)
        u += at_node(piece, v, node);
      return u;
    }



    /// Returns @p u less the response to @p heat along the whole @p piece,
    /// scaled to the energy of a state along one H; nothing if that is
    /// rounding.
    std::optional<Vector>
    disturbance(const Beam &piece, const Vector &u, const HeatedSection &heat)
    {
      const Vector answer    = along_whole_axis(piece, heat.answer);
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



    /// Replaces the forces @p u on @p piece by displacements.
    void
    solve_constrained(const Beam                    &piece,
                      const Constraints             &constraints,
                      const std::vector<SpringTerm> &springs,
                      std::vector<Vector>           &u)
    {
      for (Vector &one : u)
        constraints.condense(one);
      make_solver(piece, constraints, springs)->solve_all(u);
      for (Vector &one : u)
        constraints.distribute(one);
    }



    /// Returns the displacements of @p piece under the six loads, and the
    /// disturbances of its end due to heat.
    /// One factorization for the section loads and heat. Springs make the piece
    /// regular on free motions, which the loads are orthogonal to.
    std::vector<Vector>
    solutions(const Beam                              &piece,
              const SaintVenant                       &states,
              const ConstrainedSection                &held,
              const std::vector<PrescribedFunctional> &rows,
              const std::vector<HeatedSection>        &heat)
    {
      const RowReduction        reduction(piece, 0, rows, {"end"});
      const std::vector<Vector> motions = free_motions(piece, rows);
      std::vector<SpringTerm>   springs;
      // The loads do no work on these springs.
      if (!motions.empty())
        for (const Spring &spring : stabilizing_springs(piece, 0, rows, {1.}))
          springs.emplace_back(spring.row, spring.stiffness);
      const unsigned int last = piece.axis().n_nodes() - 1,
                         far  = held.extends_forward ? last : 0;
      const double arm =
        (held.extends_forward ? 1. : -1.) * piece.axis().length();
      std::vector<Vector> u;
      for (const Vector &load : end_loads(states, piece, far, arm, motions))
        u.push_back(at_node(piece, load, far));
      const std::size_t n_states = u.size();
      // Partly constrained sections have none (see choose_fields()).
      const bool is_clamped_or_free = motions.empty() || rows.empty();
      for (const HeatedSection &one :
           is_clamped_or_free ? heat : std::vector<HeatedSection>())
        {
          // Loads of the uniform response, without its traction at the end.
          u.push_back(at_node(piece, one.traction, last - far));
          u.back() *= held.extends_forward ? 1. : -1.;
          piece.add_internal_forces(along_whole_axis(piece, one.answer),
                                    u.back());
        }
      if (u.empty())
        return u;
      solve_constrained(piece, reduction.constraints(), springs, u);
      std::vector<Vector> result(u.begin(), u.begin() + n_states);
      for (std::size_t k = n_states; k < u.size(); ++k)
        if (const auto left = disturbance(piece, u[k], heat[k - n_states]))
          result.push_back(*left);
      return result;
    }



    /// Snapshots: weighted section vectors with their distances from the end.
    struct Snapshots
    {
      std::vector<Vector> vectors;
      std::vector<double> weights, distances;
    };



    // Weights sqrt(int N_i dy / H): the sum of squares is an integral over the
    // axis.
    Snapshots
    snapshots_of(const Beam                &piece,
                 const std::vector<Vector> &u,
                 const ConstrainedSection  &held)
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
            result.distances.push_back(held.extends_forward ?
                                         axis.nodes()[node] :
                                         axis.length() - axis.nodes()[node]);
          }
      return result;
    }



    /// Returns the distance from the end up to which @p norms exceed the
    /// tolerance.
    double
    influence_length_of(const std::vector<double> &norms,
                        const std::vector<double> &distances,
                        const BoundaryLayerRules  &rules)
    {
      const double largest = *std::max_element(norms.begin(), norms.end());
      double       influence_length = 0.;
      for (unsigned int k = 0; k < norms.size(); ++k)
        if (norms[k] > std::max(rules.rest * largest, rules.tolerance))
          influence_length = std::max(influence_length, distances[k]);
      return influence_length;
    }



    /// Returns the zones of @p found: in each zone a weighted basis (singular
    /// vectors above the tolerance) of the snapshots from its start on, beyond
    /// the fields of the outer zones.
    std::vector<BoundaryLayerZone>
    zones_of(const Snapshots          &found,
             const Warping            &warping,
             const FieldColumns       &warpings,
             const double              larger,
             const BoundaryLayerRules &rules)
    {
      std::vector<double> norms = warping.strengths(found.vectors, warpings);
      for (unsigned int k = 0; k < norms.size(); ++k)
        norms[k] /= found.weights[k];
      const double influence_length =
        influence_length_of(norms, found.distances, rules);

      std::vector<BoundaryLayerZone> zones;
      FieldColumns                   known = warpings;
      for (unsigned int z = rules.zones.size(); z-- > 0;)
        {
          const double        begin = rules.zones[z] * larger;
          std::vector<Vector> from_there;
          for (unsigned int k = 0; k < norms.size(); ++k)
            if (found.distances[k] >= begin &&
                found.distances[k] <= influence_length)
              from_there.push_back(found.vectors[k]);
          BoundaryLayerZone zone;
          zone.fields = warping.weighted_basis(from_there,
                                               warpings,
                                               known,
                                               rules.tolerance);
          zone.influence_length =
            z + 1 < rules.zones.size() ?
              std::min((rules.zones[z + 1] + rules.overlap) * larger,
                       influence_length) :
              influence_length;
          if (zone.fields.n() == 0)
            continue;
          known = beside(known, zone.fields);
          zones.push_back(std::move(zone));
        }
      return zones;
    }
  } // namespace



  // Empty if the piece would exceed the limit of DoFs.
  std::vector<BoundaryLayerZone>
  boundary_layer_modes(const std::shared_ptr<const Section> &section,
                       const SaintVenant                    &states,
                       const Warping                        &warping,
                       const FieldColumns                   &warpings,
                       const ConstrainedSection             &held,
                       const std::vector<HeatedSection>     &heat,
                       const BoundaryLayerRules             &rules)
  {
    const double larger = section->extents().second;
    const auto   piece  = make_piece(section, held, rules);
    if (piece->n_dofs() > rules.max_dofs)
      return {};
    const std::vector<Vector> u =
      solutions(*piece, states, held, rows_of(held, *piece), heat);
    if (u.empty())
      return {};
    return zones_of(
      snapshots_of(*piece, u, held), warping, warpings, larger, rules);
  }



  unsigned int
  nodes_of_pieces(const Beam                          &beam,
                  const std::vector<LocalInteraction> &interactions,
                  const BoundaryLayerRules            &rules)
  {
    const auto   section = beam.fields().shared_section();
    unsigned int nodes   = 0;
    for (unsigned int t = 0; t < interactions.size(); ++t)
      {
        // Interactions that constrain one section together have one piece.
        const bool is_first = std::none_of(
          interactions.begin(), interactions.begin() + t, [&](const auto &o) {
            return o.constrains_section &&
                   std::abs(o.begin - interactions[t].begin) <
                     arithmetic::same_position * beam.axis().length();
          });
        if (interactions[t].constrains_section && is_first)
          for (const ConstrainedSection &held :
               constrained_sections(interactions, t, beam.axis()))
            if (const auto piece = make_piece(section, held, rules);
                piece->n_dofs() <= rules.max_dofs)
              nodes += piece->axis().n_nodes();
      }
    return nodes;
  }
} // namespace lamella
