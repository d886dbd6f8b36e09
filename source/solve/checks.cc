// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/checks.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Where @p u moves the points @p points of @p body, in place.
    void
    move(std::vector<Point<3>> &points, const Body &body, const Vector &u)
    {
      const auto locations = body.locate(points);
      for (unsigned int k = 0; k < points.size(); ++k)
        if (!locations[k].empty())
          points[k] += body.sample(locations[k].front(), u).displacement;
    }



    /// Prescribed rows of supports; for finite rotations in the state @p u.
    std::vector<Point<3>>
    places_of_supports(const Structure &structure, const BlockVector &u)
    {
      const std::vector<PrescribedFunctional> &rows = structure.prescribed();
      std::vector<Point<3>>                    places;
      for (const PrescribedFunctional &row : rows)
        places.push_back(row.position);
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        if (structure.bodies()[b]->has_finite_rotations())
          {
            std::vector<Point<3>>     here;
            std::vector<unsigned int> numbers;
            for (unsigned int k = 0; k < rows.size(); ++k)
              if (rows[k].row.body == b)
                {
                  here.push_back(rows[k].position);
                  numbers.push_back(k);
                }
            move(here, *structure.bodies()[b], u.block(b));
            for (unsigned int k = 0; k < here.size(); ++k)
              places[numbers[k]] = here[k];
          }
      return places;
    }



    /// Of each of @p n supports a reaction without force yet, about the middle
    /// of the box around the points that it holds.
    std::vector<Resultant>
    unloaded_reactions(const std::vector<PrescribedFunctional> &rows,
                       const std::vector<Point<3>>             &places,
                       const unsigned int                       n)
    {
      std::vector<std::vector<Point<3>>> points(n);
      for (unsigned int k = 0; k < rows.size(); ++k)
        points[rows[k].support].push_back(places[k]);
      std::vector<Resultant> reactions(n);
      for (unsigned int s = 0; s < n; ++s)
        if (!points[s].empty())
          reactions[s].about = BoundingBox<3>(points[s]).center();
      return reactions;
    }



    /// What one row of a support does at @p place with @p force to the body
    /// with that @p center, about it, whatever the theory feels.
    Wrench
    wrench_of(const PrescribedFunctional &row,
              const Point<3>             &place,
              const double                force,
              const Point<3>             &center)
    {
      return {force * row.direction,
              force *
                (row.couple + cross_product_3d(place - center, row.direction))};
    }



    /// Adds the reactions of the supports of body @p b, whose rows act at
    /// @p places, and gives their work; adds to the forces @p on_body the
    /// moments that the body's theory feels.
    double
    add_reactions(const TangentOperator       &tangent,
                  const std::vector<Point<3>> &places,
                  const unsigned int           b,
                  const Vector                &unbalanced,
                  const LoadFactor            &factor,
                  std::vector<Resultant>      &reactions,
                  BodyForces                  &on_body)
    {
      // Each support is checked alone: opposite reactions would cancel.
      const Point<3>      center = on_body.body.center();
      std::vector<Wrench> of_support(reactions.size()),
        resultant_of_work(reactions.size());
      double work = 0.;
      for (const auto &[row, force] :
           tangent.reduction(b).multipliers(unbalanced))
        {
          const PrescribedFunctional &p = tangent.prescribed()[row];
          const Wrench whole = wrench_of(p, places[row], force, center);
          of_support[p.support].force += whole.force;
          of_support[p.support].moment += whole.moment;
          const double multiplier = force;
          resultant_of_work[p.support].moment +=
            on_body
              .resultant_of_work([&p = p, multiplier](const Vector &motion) {
                return multiplier * p.row.row(motion);
              })
              .moment;
          work += 0.5 * force * factor.of(p.history) * p.value;
        }
      for (unsigned int s = 0; s < reactions.size(); ++s)
        {
          const Tensor<1, 3> &force = of_support[s].force;
          reactions[s].force += force;
          reactions[s].moment +=
            of_support[s].moment +
            cross_product_3d(center - reactions[s].about, force);
          on_body.add({force, resultant_of_work[s].moment});
        }
      return work;
    }



    /// Where each of @p reactions acts.
    void
    find_centers(std::vector<Resultant> &reactions, const double size)
    {
      // Of the moment over the size of the scene.
      constexpr double rounding = arithmetic::negligible;
      for (Resultant &reaction : reactions)
        if (reaction.force.norm() * size > rounding * reaction.moment.norm())
          reaction.center_of_pressure =
            reaction.about + cross_product_3d(reaction.force, reaction.moment) /
                               reaction.force.norm_square();
    }



    /// What the load vector @p f does to a body as a whole.
    Wrench
    load_vector_on(const BodyForces &body, const Vector &f)
    {
      return body.resultant_of_work(
        [&](const Vector &motion) { return f * motion; });
    }



    /// Adds the forces of the springs of body @p b; returns their energy.
    double
    add_springs(const Structure   &structure,
                const unsigned int b,
                const State       &state,
                BodyForces        &on_body)
    {
      const Vector &u      = state.u.block(b);
      double        energy = 0.;
      for (unsigned int k = 0; k < structure.springs(b).size(); ++k)
        {
          const Spring &spring = structure.springs(b)[k];
          const double  length =
            spring.row(u) - (state.rest.empty() ? 0. : state.rest[b][k]);
          on_body.add(on_body.resultant_of_work([&](const Vector &motion) {
            return -spring.stiffness * length * spring.row(motion);
          }));
          energy += 0.5 * spring.stiffness * length * length;
        }
      return energy;
    }



    /// The strain energy that the last digits of the displacements @p u make,
    /// or lengths of @p nothing, if that is more. A body that has no more is
    /// moved by its supports as a whole; its forces are rounding, too, and are
    /// ignored. (That of bending is larger by decades in the slenderest body
    /// that doubles can hold: it falls with (h / L)^3 only.)
    double
    rounding_energy(const double  largest_stiffness,
                    const Vector &u,
                    const double  nothing)
    {
      const double rounding = std::max(displacement_rounding(u), nothing);
      return 0.5 * largest_stiffness * rounding * rounding;
    }



    /// Clapeyron's theorem, with the energy of the whole strains and
    /// @p other_work half the work of contact forces and heat. Energies below
    /// @p rounding are none. Of bodies that turn nothing: half the work is a
    /// matter of forces that grow with displacements.
    void
    check_energy(const double other_work, const double rounding, Checks &checks)
    {
      if (checks.is_large)
        {
          checks.external_work = 0.;
          return;
        }
      const double elastic = checks.energy;
      const double stored  = elastic + checks.stabilization_energy;
      if (stored <= rounding)
        return;
      const double size = std::max({std::abs(elastic),
                                    std::abs(checks.external_work),
                                    checks.stabilization_energy});
      checks.energy_balance =
        std::abs(stored - checks.external_work - other_work) / size;
      if (checks.stabilization_energy > rounding)
        checks.stabilization_share = checks.stabilization_energy / stored;
    }



    /// Keeps the larger of @p largest and @p error; what is not a number must
    /// not be lost in a maximum.
    void
    update_maximum(double &largest, const double error)
    {
      if (error > largest || !std::isfinite(error))
        largest = error;
    }



    /// That of one more body.
    void
    add_deformation(const Deformation &deformation, Checks &checks)
    {
      checks.energy += deformation.energy;
      checks.max_rotation =
        std::max(checks.max_rotation, deformation.max_rotation);
      checks.max_strain = std::max(checks.max_strain, deformation.max_strain);
      checks.max_rms_strain =
        std::max(checks.max_rms_strain, deformation.max_rms_strain);
      checks.max_element_rotation =
        std::max(checks.max_element_rotation, deformation.max_element_rotation);
      checks.shape_change =
        std::max(checks.shape_change, deformation.shape_change);
    }



    /// The @p load, springs and deformation of body @p b, and whether the
    /// forces @p on_body, of supports and contacts, balance. Returns the
    /// rounding energy.
    double
    check_body(const TangentOperator &tangent,
               const unsigned int     b,
               const State           &state,
               const Vector          &load,
               BodyForces            &on_body,
               Checks                &checks)
    {
      // Reactions below that share of what heat would do to a body that is
      // held, or of loads that balance each other, are rounding.
      constexpr double thermal_factor = arithmetic::quadrature_tolerance;
      const Structure &structure      = tangent.of();
      const Vector    &u              = state.u.block(b);
      const Vector    &thermal_load   = structure.thermal_load().block(b);
      on_body.add(load_vector_on(on_body, load));
      on_body.at_least(thermal_factor * std::max(thermal_load.linfty_norm(),
                                                 load.linfty_norm()));
      checks.stabilization_energy += add_springs(structure, b, state, on_body);
      const Deformation deformation = on_body.body.deformation(u);
      add_deformation(deformation, checks);
      const double noise =
        rounding_energy(tangent.largest_stiffness(b), u, state.rounding(b));
      const double energy =
        deformation.energy + structure.thermal_energy(b) - thermal_load * u;
      checks.energies.push_back(
        energy > std::max(noise, thermal_factor * structure.thermal_energy(b)) ?
          energy :
          0.);
      // Of bodies that turn the work of heat is taken off.
      const double kept =
        deformation.energy + (on_body.body.has_finite_rotations() ?
                                structure.thermal_energy(b) :
                                0.);
      if (kept > noise)
        {
          const auto [forces, moments] = on_body.unbalanced();
          update_maximum(checks.force_balance, forces);
          update_maximum(checks.moment_balance, moments);
        }
      return noise;
    }



    /// The largest component of displacements, those of obstacles among them.
    double
    largest_displacement(const std::vector<ContactInterface> &contacts,
                         const BlockVector                   &u,
                         const LoadFactor                    &factor)
    {
      double largest = u.linfty_norm();
      for (const ContactInterface &contact : contacts)
        if (contact.obstacle != nullptr)
          largest =
            std::max(largest,
                     contact.obstacle->displacement_at(factor, u).norm());
      return largest;
    }



    /// What the contacts do to the degrees of freedom of all bodies.
    BlockVector
    load_of_contacts(const Structure                     &structure,
                     const std::vector<ContactInterface> &contacts,
                     const State                         &state)
    {
      BlockVector          load = structure.zero();
      const GapConstraints rows(contacts);
      for (unsigned int c = 0; c < contacts.size(); ++c)
        {
          const ConstraintForces forces(rows, c, state);
          for (unsigned int k = 0; k < contacts[c].rows.size(); ++k)
            add_force(contacts[c].rows[k],
                      forces.normal[k],
                      forces.shear_of(k),
                      load);
        }
      return load;
    }



    /// What contacts and supports do, with the work of the supports. @p
    /// unbalanced are the forces on degrees of freedom that loads, contacts and
    /// strains leave to the supports.
    void
    add_external_forces(const TangentOperator               &tangent,
                        const std::vector<Point<3>>         &places,
                        const std::vector<ContactInterface> &contacts,
                        const BlockVector                   &unbalanced,
                        const State                         &state,
                        const LoadFactor                    &factor,
                        std::vector<BodyForces>             &on_body,
                        Checks                              &checks)
    {
      const GapConstraints rows(contacts);
      for (unsigned int c = 0; c < contacts.size(); ++c)
        checks.contacts.push_back(
          check_contact(contacts[c],
                        ConstraintForces(rows, c, state),
                        state.u,
                        factor,
                        checks.max_displacement,
                        on_body));
      BlockVector reaction = unbalanced;
      reaction *= -1.;
      for (unsigned int b = 0; b < on_body.size(); ++b)
        checks.external_work += add_reactions(tangent,
                                              places,
                                              b,
                                              reaction.block(b),
                                              factor,
                                              checks.reactions,
                                              on_body[b]);
      find_centers(checks.reactions, tangent.of().size());
    }
  } // namespace



  double
  displacement_rounding(const Vector &u)
  {
    constexpr double digits = 1e3 * std::numeric_limits<double>::epsilon();
    return digits * u.linfty_norm();
  }



  Checks
  check_state(const TangentOperator               &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const LoadFactor                    &factor)
  {
    const Structure            &structure = tangent.of();
    Checks                      checks;
    const std::vector<Point<3>> places = places_of_supports(structure, state.u);
    checks.reactions =
      unloaded_reactions(structure.prescribed(), places, n_supports);
    checks.is_large         = structure.has_finite_rotations();
    checks.max_displacement = largest_displacement(contacts, state.u, factor);
    std::vector<BodyForces> on_body;
    for (const auto &body : structure.bodies())
      on_body.emplace_back(*body, state.u.block(on_body.size()));
    const BlockVector contact_load =
      load_of_contacts(structure, contacts, state);
    // Made of f(t) less the internal forces.
    BlockVector       r    = structure.residual(state.u, factor, state.rest);
    const BlockVector load = structure.load(factor, state.u);
    BlockVector       internal = load;
    internal -= r;
    internal += structure.thermal_load();
    r += contact_load;
    add_external_forces(
      tangent, places, contacts, r, state, factor, on_body, checks);
    checks.external_work += 0.5 * (load * state.u);
    double rounding = 0.;
    for (unsigned int b = 0; b < on_body.size(); ++b)
      rounding +=
        check_body(tangent, b, state, load.block(b), on_body[b], checks);
    tangent.condense(r);
    // Of bodies that turn, the work of heat is off the energy, and what it does
    // to bodies that are held makes it none below zero.
    const double of_heat = checks.is_large ? structure.thermal_energy() : 0.;
    if (checks.energy + of_heat > rounding && r.l2_norm() != 0.)
      checks.residual = r.linfty_norm() / internal.linfty_norm();
    const double thermal = structure.thermal_load() * state.u;
    check_energy(0.5 * (contact_load * state.u + thermal), rounding, checks);
    checks.energy += structure.thermal_energy() - thermal;
    return checks;
  }
} // namespace lamella
