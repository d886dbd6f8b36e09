// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/linear/factorization.h>
#include <lamella/solve/structure.h>
#include <lamella/solve/tangent_operator.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// How many histories there are, that of the scene among them.
    unsigned int
    n_histories(const std::vector<Support> &supports,
                const std::vector<Load>    &loads)
    {
      unsigned int last = 0;
      for (const Support &support : supports)
        last = std::max(last, support.history);
      for (const Load &load : loads)
        last = std::max(last, load.history);
      return last + 1;
    }



    /// @p rows with the values of @p history, the others zero.
    std::vector<PrescribedFunctional>
    of_history(std::vector<PrescribedFunctional> rows,
               const unsigned int                history)
    {
      for (PrescribedFunctional &row : rows)
        if (row.history != history)
          row.value = 0.;
      return rows;
    }
  } // namespace



  Structure::Structure(Bodies                            bodies,
                       const std::vector<Support>       &supports,
                       const std::vector<Load>          &loads,
                       const std::vector<Stabilization> &stabilizations,
                       const dealii::Tensor<1, 3>       &gravity)
    : all_bodies(std::move(bodies))
    , rows(prescribed_functionals(supports, all_bodies))
    , histories(n_histories(supports, loads), {zero(), zero()})
    , follower_loads(all_bodies.size())
    , initial_load(zero())
  {
    check_rigid_motions(stabilizations);
    const std::vector<PrescribedFunctional> of_scene = of_history(rows, 0);
    std::vector<std::string>                names;
    for (const Support &support : supports)
      names.push_back(support.name);
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        reductions.push_back(
          std::make_unique<RowReduction>(*all_bodies[b], b, of_scene, names));
        histories[0].particular.block(b) = reductions[b]->particular();
        all_springs.push_back(stabilizing_springs(*all_bodies[b],
                                                  b,
                                                  rows,
                                                  stabilizations.empty() ?
                                                    Stabilization() :
                                                    stabilizations[b]));
      }
    for (unsigned int h = 1; h < histories.size(); ++h)
      histories[h].particular = prescribed_in(h, names);
    check_rotations(names);
    for (const Load &load : loads)
      take(load);
    if (gravity.norm() > 0.)
      assemble_weight(gravity);
    apply_temperatures(loads, all_bodies);
    assemble_thermal_load();
  }



  void
  Structure::take(const Load &load)
  {
    BlockVector at_start = zero();
    resultants.push_back(add_load(load, all_bodies, at_start));
    BlockVector free = at_start;
    condense(free);
    if (at_start.linfty_norm() > 0. &&
        free.linfty_norm() <=
          arithmetic::rounding_of_results * at_start.linfty_norm())
      resultants.back().notes.push_back(
        "solve.load-on-supports: load " + load.name +
        ": supports prescribe all displacements of the region where this load "
        "acts, so it causes reactions but no deformation. Check the positions "
        "of load and supports (On, At)");
    for (const Region &region : load.on)
      if (depends_on_state(load, *all_bodies[region.body]))
        {
          follower_loads[region.body].emplace_back(
            follower_load(load, region, *all_bodies[region.body]),
            load.history);
          at_start.block(region.body) = 0.;
        }
    histories[load.history].load += at_start;
  }



  void
  Structure::assemble_thermal_load()
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        initial_energies.push_back(
          all_bodies[b]->add_thermal_load(undisplaced, initial_load.block(b)));
        if (auto load = turning_heat(*all_bodies[b]))
          {
            initial_load.block(b) = 0.;
            follower_loads[b].emplace_back(std::move(load), LoadFactor::heat);
          }
      }
  }



  void
  Structure::assemble_weight(const dealii::Tensor<1, 3> &gravity)
  {
    // On top of other loads; of bodies whose rows turn what these have stays.
    BlockVector &dead_load = histories[0].load;
    BlockVector  before    = dead_load;
    resultants.push_back(add_weight(gravity, all_bodies, dead_load));
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      if (auto load = follower_weight(gravity, *all_bodies[b]))
        {
          follower_loads[b].emplace_back(std::move(load), 0);
          dead_load.block(b) = before.block(b);
        }
  }



  BlockVector
  Structure::prescribed_in(const unsigned int              history,
                           const std::vector<std::string> &names) const
  {
    const std::vector<PrescribedFunctional> own     = of_history(rows, history);
    BlockVector                             u       = zero();
    double                                  largest = 0.;
    for (const PrescribedFunctional &row : own)
      largest = std::max(largest, std::abs(row.value));
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      u.block(b) = reductions[b]->influence(
        [&own](const unsigned int k) { return own[k].value; });
    for (const PrescribedFunctional &row : own)
      if (std::abs(row.row(u) - row.value) >
          arithmetic::dependency_tolerance * largest)
        throw InputError(
          "Support " + names[row.support],
          "",
          "solve.supports-contradict: this support and another prescribe "
          "different displacements of the same point, at " +
            to_text(row.position),
          "Write the same displacements and Factors, or remove a support.");
    return u;
  }



  void
  Structure::check_rotations(const std::vector<std::string> &names) const
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      if (has_prescribed_rotation(b) && all_bodies[b]->has_finite_rotations() &&
          !all_bodies[b]->constraints_rotate())
        {
          std::vector<PrescribedFunctional> whole = rows;
          for (PrescribedFunctional &row : whole)
            row.value = row.value_at(1.);
          RowReduction(*all_bodies[b], b, whole, names);
        }
  }



  void
  Structure::check_rigid_motions(
    const std::vector<Stabilization> &stabilizations) const
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        if (!stabilizations.empty() && stabilizations[b].share > 0.)
          continue;
        std::vector<std::string> free;
        for (const FreeMotion &motion :
             free_rigid_motions(*all_bodies[b], b, rows))
          free.push_back(motion.words);
        if (!free.empty())
          throw InputError(
            "Body " + all_bodies[b]->name(),
            "",
            "solve.unconstrained-motion: the body can move freely: " +
              (free.size() == 6 ? "it has no support" : joined(free, "; ")),
            "Add a support that prevents this motion, or a contact that "
            "does (Body " +
              all_bodies[b]->name() + "/Stabilization = auto).");
      }
  }



  DofIndex
  Structure::n_dofs() const
  {
    return initial_load.size();
  }



  double
  Structure::size() const
  {
    dealii::BoundingBox<3> box = all_bodies.front()->bounding_box();
    for (const auto &body : all_bodies)
      box.merge_with(body->bounding_box());
    const auto corners = box.get_boundary_points();
    return corners.first.distance(corners.second);
  }



  BlockVector
  Structure::zero() const
  {
    std::vector<dealii::types::global_dof_index> sizes;
    for (const auto &body : all_bodies)
      sizes.push_back(body->n_dofs());
    return BlockVector(sizes);
  }



  BlockVector
  Structure::particular(const LoadFactor &factor) const
  {
    BlockVector u = zero();
    for (unsigned int h = 0; h < histories.size(); ++h)
      u.add(factor.of(h), histories[h].particular);
    return u;
  }



  BlockVector
  Structure::load(const LoadFactor &factor, const BlockVector &u) const
  {
    BlockVector f = zero();
    for (unsigned int h = 0; h < histories.size(); ++h)
      f.add(factor.of(h), histories[h].load);
    for (unsigned int b = 0; b < follower_loads.size(); ++b)
      for (const auto &[load, history] : follower_loads[b])
        load->add_forces(factor.of(history), u.block(b), f.block(b));
    return f;
  }



  BlockVector
  Structure::load(const LoadFactor &factor) const
  {
    return load(factor, zero());
  }



  bool
  Structure::has_unsymmetric_loads() const
  {
    return std::any_of(
      follower_loads.begin(), follower_loads.end(), [](const auto &loads) {
        return std::any_of(loads.begin(), loads.end(), [](const auto &load) {
          return load.first->is_unsymmetric();
        });
      });
  }



  void
  Structure::add_derivative_of_loads(const LoadFactor  &factor,
                                     const BlockVector &u,
                                     const BlockVector &w,
                                     BlockVector       &f) const
  {
    for (unsigned int b = 0; b < follower_loads.size(); ++b)
      for (const auto &[load, history] : follower_loads[b])
        load->add_derivative(factor.of(history),
                             u.block(b),
                             w.block(b),
                             f.block(b));
  }



  void
  Structure::check_orientation(const BlockVector &u) const
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      for (const auto &points : dealii::Utilities::MPI::all_gather(
             communicator(), all_bodies[b]->inverted_points(u.block(b))))
        if (!points.empty())
          throw NumericsError(
            "solve.inverted-element: An element of body '" +
            all_bodies[b]->name() +
            "' is inside out (det F is not positive) near " +
            to_text(points[0]) +
            ". Reduce the loads, distribute them over a larger area, or use "
            "larger elements there.");
  }



  void
  Structure::for_each_block_of_loads(const unsigned int   body,
                                     const LoadFactor    &factor,
                                     const Vector        &u,
                                     const bool           with_values,
                                     const BlockCallback &use) const
  {
    for (const auto &[load, history] : follower_loads[body])
      load->for_each_stiffness_block(factor.of(history), u, with_values, use);
  }



  bool
  Structure::holds(const BodyFunctional &row) const
  {
    const auto largest_of = [](const LinearFunctional &of) {
      double largest = 0.;
      for (const auto &[dof, weight] : of.entries())
        largest = std::max(largest, std::abs(weight));
      return largest;
    };
    const double nothing = arithmetic::rounding_of_sums * largest_of(row.row);
    return largest_of(row.row.reduced(reductions[row.body]->constraints())) <=
             nothing &&
           std::all_of(histories.begin(),
                       histories.end(),
                       [&](const OfHistory &history) {
                         return std::abs(row(history.particular)) <=
                                arithmetic::rounding_of_sums *
                                  history.particular.linfty_norm();
                       });
  }



  std::vector<SpringTerm>
  Structure::spring_terms(const unsigned int body) const
  {
    std::vector<SpringTerm> terms;
    for (const Spring &spring : all_springs[body])
      terms.emplace_back(spring.row, spring.stiffness);
    return terms;
  }



  double
  Structure::largest_stiffness(const unsigned int body) const
  {
    stiffest.resize(all_bodies.size(), 0.);
    if (stiffest[body] == 0.)
      stiffest[body] = assembled_stiffness(*all_bodies[body],
                                           reduction(body).constraints(),
                                           spring_terms(body))
                         ->diagonal()
                         .linfty_norm();
    return stiffest[body];
  }



  bool
  Structure::has_springs() const
  {
    return std::any_of(all_springs.begin(),
                       all_springs.end(),
                       [](const auto &springs) { return !springs.empty(); });
  }



  SpringOffsets
  Structure::spring_lengths(const BlockVector &u) const
  {
    SpringOffsets lengths(all_springs.size());
    for (unsigned int b = 0; b < all_springs.size(); ++b)
      for (const Spring &spring : all_springs[b])
        lengths[b].push_back(spring.row(u.block(b)));
    return lengths;
  }



  bool
  Structure::has_finite_rotations() const
  {
    return std::any_of(all_bodies.begin(),
                       all_bodies.end(),
                       [](const auto &body) {
                         return body->has_finite_rotations();
                       });
  }



  bool
  Structure::is_heated() const
  {
    return std::any_of(all_bodies.begin(),
                       all_bodies.end(),
                       [](const auto &body) { return body->is_heated(); });
  }



  BlockVector
  Structure::internal_forces(const BlockVector   &u,
                             const SpringOffsets &rest) const
  {
    BlockVector r = zero();
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        all_bodies[b]->add_internal_forces(u.block(b), r.block(b));
        for (unsigned int k = 0; k < all_springs[b].size(); ++k)
          {
            const Spring &spring = all_springs[b][k];
            spring.row.add_to(r.block(b),
                              spring.stiffness *
                                (spring.row(u.block(b)) -
                                 (rest.empty() ? 0. : rest[b][k])));
          }
      }
    return r;
  }



  BlockVector
  Structure::residual(const BlockVector   &u,
                      const LoadFactor    &factor,
                      const SpringOffsets &rest) const
  {
    BlockVector r = internal_forces(u, rest);
    r.sadd(-1., 1., load(factor, u));
    r += initial_load;
    return r;
  }



  BlockVector
  Structure::retract(const BlockVector &u, const BlockVector &change) const
  {
    BlockVector result = u;
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      result.block(b) = all_bodies[b]->retract(u.block(b), change.block(b));
    return result;
  }



  void
  Structure::condense(BlockVector &r) const
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        reductions[b]->constraints().condense(r.block(b));
        reductions[b]->constraints().set_zero(r.block(b));
      }
  }
} // namespace lamella
