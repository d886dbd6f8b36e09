// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/linear/factorisation.h>
#include <lamella/solve/lost_digits.h>
#include <lamella/solve/structure.h>

#include <algorithm>

namespace lamella
{
  Structure::Structure(Bodies                            bodies,
                       const std::vector<Support>       &supports,
                       const std::vector<Load>          &loads,
                       const std::vector<Stabilisation> &stabilisations,
                       const dealii::Tensor<1, 3>       &gravity)
    : all_bodies(std::move(bodies))
    , rows(prescribed_rows(supports, all_bodies))
    , unit_load(zero())
    , initial_load(zero())
  {
    check_held(stabilisations);
    std::vector<std::string> names;
    for (const Support &support : supports)
      names.push_back(support.name);
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        reductions.push_back(
          std::make_unique<RowReduction>(*all_bodies[b], b, rows, names));
        all_springs.push_back(stabilising_springs(*all_bodies[b],
                                                  b,
                                                  rows,
                                                  stabilisations.empty() ?
                                                    Stabilisation() :
                                                    stabilisations[b]));
      }
    for (const Load &load : loads)
      resultants.push_back(add_load(load, all_bodies, unit_load));
    if (gravity.norm() > 0.)
      resultants.push_back(add_weight(gravity, all_bodies, unit_load));
    apply_heat(loads, all_bodies);
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      initial_energies.push_back(
        all_bodies[b]->add_heat(initial_load.block(b)));
  }



  void
  Structure::check_held(const std::vector<Stabilisation> &stabilisations) const
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        if (!stabilisations.empty() && stabilisations[b].share > 0.)
          continue;
        std::vector<std::string> free;
        for (const FreeMotion &motion :
             free_rigid_motions(*all_bodies[b], b, rows))
          free.push_back(motion.words);
        if (!free.empty())
          throw InputError(
            "Body " + all_bodies[b]->name(),
            "",
            "can move freely: " + (free.size() == 6 ?
                                     "no support holds it at all" :
                                     joined(free, "; ")),
            "Add a support that prevents this, or, if contact is to hold it, a "
            "Stabilisation (Body " +
              all_bodies[b]->name() + "/Stabilisation = 1e-6).");
      }
  }



  DofIndex
  Structure::n_dofs() const
  {
    return unit_load.size();
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
  Structure::particular(const double factor) const
  {
    BlockVector u = zero();
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      u.block(b).equ(factor, reductions[b]->particular());
    return u;
  }



  std::vector<SpringTerm>
  Structure::spring_terms(const unsigned int body) const
  {
    std::vector<SpringTerm> terms;
    for (const Spring &spring : all_springs[body])
      terms.emplace_back(spring.row, spring.stiffness);
    return terms;
  }



  bool
  Structure::has_springs() const
  {
    return std::any_of(all_springs.begin(),
                       all_springs.end(),
                       [](const auto &springs) { return !springs.empty(); });
  }



  SpringRest
  Structure::spring_lengths(const BlockVector &u) const
  {
    SpringRest lengths(all_springs.size());
    for (unsigned int b = 0; b < all_springs.size(); ++b)
      for (const Spring &spring : all_springs[b])
        lengths[b].push_back(spring.row(u.block(b)));
    return lengths;
  }



  bool
  Structure::is_heated() const
  {
    return std::any_of(all_bodies.begin(),
                       all_bodies.end(),
                       [](const auto &body) { return body->is_heated(); });
  }



  BlockVector
  Structure::internal_forces(const BlockVector &u, const SpringRest &rest) const
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
  Structure::residual(const BlockVector &u,
                      const double       factor,
                      const SpringRest  &rest) const
  {
    BlockVector r = internal_forces(u, rest);
    r.sadd(-1., factor, unit_load);
    r += initial_load;
    return r;
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
