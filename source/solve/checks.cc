// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/lost_digits.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Beyond these the linear strain misses about rotation^2 / 2, 0.5 %.
    constexpr double linear_rotation = 0.1;
    // A first correction above this says that the assembled matrix has lost
    // more than half of its digits.
    constexpr double lost_digits = 1e-7;
    // Of the displacements; a penalty this soft changes the answer.
    constexpr double large_penetration = 1e-3;
    // Of all energy in stabilising springs.
    constexpr double worth_failing = 0.1, worth_saying = 1e-3;
    // Of the displacements; rows that average this much of the gap away.
    constexpr double large_averaging = 1e-2;
    // What displacements and gaps of a trusted result may be off by.
    constexpr double sound = 1e-6;
    // Forces come out of displacements that are held in doubles, which leaves
    // about eps (L/h)^2 of them: tolerable, but to be told.
    constexpr double tolerable = 1e-3, worth_telling = 1e-7;



    /// The forces on one body, summed, with their moments about its centre, and
    /// the largest single resultant: a force, or a couple over half the body's
    /// length.
    class Resultants
    {
    public:
      explicit Resultants(const Body &body)
        : size(body.size())
      {}

      void
      add(const Tensor<1, 3> &force, const Tensor<1, 3> &moment)
      {
        forces += force;
        moments += moment;
        at_least(std::max(force.norm(), moment.norm() / size));
      }

      /// Forces are compared with no less than that.
      void
      at_least(const double force)
      {
        largest = std::max(largest, force);
      }

      /// What is left of forces and of moments, as shares of the largest.
      std::pair<double, double>
      unbalanced() const
      {
        const auto share = [this](const double left) {
          return left == 0. ? 0. : left / largest;
        };
        return {share(forces.norm()), share(moments.norm() / size)};
      }

    private:
      double       size;
      Tensor<1, 3> forces, moments;
      double       largest = 0.;
    };



    /// The middle of the box around the points that each of @p n supports
    /// holds.
    std::vector<Point<3>>
    middles_of_supports(const std::vector<PrescribedRow> &rows,
                        const unsigned int                n)
    {
      std::vector<std::vector<Point<3>>> points(n);
      for (const PrescribedRow &row : rows)
        points[row.support].push_back(row.position);
      std::vector<Point<3>> middles(n);
      for (unsigned int s = 0; s < n; ++s)
        if (!points[s].empty())
          middles[s] = BoundingBox<3>(points[s]).center();
      return middles;
    }



    /// Fills reactions and their work; adds them to the bodies' resultants,
    /// with the moments that the bodies' theories feel: the work of the rows on
    /// the @p rigid motions.
    double
    add_reactions(const Structure                        &structure,
                  const std::vector<std::vector<Vector>> &rigid,
                  const BlockVector                      &unbalanced,
                  const double                            factor,
                  Checks                                 &checks,
                  std::vector<Resultants>                &on_body)
    {
      double work = 0.;
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          // Each support is a force of its own: two opposite reactions must not
          // hide in a sum of zero.
          const Body               &body = *structure.bodies()[b];
          std::vector<Tensor<1, 3>> of_support(checks.reactions.size()),
            moment(checks.reactions.size()), felt(checks.reactions.size());
          for (const auto &[row, force] :
               structure.reduction(b).multipliers(unbalanced.block(b)))
            {
              const PrescribedRow &p = structure.prescribed()[row];
              of_support[p.support] += force * p.direction;
              moment[p.support] +=
                force * (p.couple + cross_product_3d(p.position - body.centre(),
                                                     p.direction));
              for (unsigned int c = 0; c < 3; ++c)
                felt[p.support][c] += force * p.row.row(rigid[b][3 + c]);
              work += 0.5 * force * factor * p.value;
            }
          for (unsigned int s = 0; s < of_support.size(); ++s)
            {
              Resultant &reaction = checks.reactions[s];
              reaction.force += of_support[s];
              reaction.moment +=
                moment[s] +
                cross_product_3d(body.centre() - reaction.about, of_support[s]);
              on_body[b].add(of_support[s], felt[s]);
            }
        }
      return work;
    }



    /// Where each of @p reactions acts.
    void
    find_centres(std::vector<Resultant> &reactions, const double size)
    {
      // Of the moment over the size of the scene.
      constexpr double rounding = arithmetic::negligible;
      for (Resultant &reaction : reactions)
        if (reaction.force.norm() * size > rounding * reaction.moment.norm())
          reaction.centre_of_pressure =
            reaction.about + cross_product_3d(reaction.force, reaction.moment) /
                               reaction.force.norm_square();
    }



    /// Adds what the load vector @p f does as a whole, by its work on the
    /// @p rigid motions of its body.
    void
    add_load_resultant(const std::vector<Vector> &rigid,
                       const Vector              &f,
                       const double               factor,
                       Resultants                &on_body)
    {
      Tensor<1, 3> force, couple;
      for (unsigned int c = 0; c < 3; ++c)
        {
          force[c]  = factor * (f * rigid[c]);
          couple[c] = factor * (f * rigid[3 + c]);
        }
      on_body.add(force, couple);
    }



    /// Adds the forces of the stabilising springs of body @p b; returns their
    /// energy.
    double
    add_springs(const Structure           &structure,
                const unsigned int         b,
                const std::vector<Vector> &rigid,
                const State               &state,
                Resultants                &on_body)
    {
      const Vector &u      = state.u.block(b);
      double        energy = 0.;
      for (unsigned int k = 0; k < structure.springs(b).size(); ++k)
        {
          const Spring &spring = structure.springs(b)[k];
          const double  length =
            spring.row(u) - (state.rest.empty() ? 0. : state.rest[b][k]);
          Vector f(u.size());
          spring.row.add_to(f, -spring.stiffness * length);
          add_load_resultant(rigid, f, 1., on_body);
          energy += 0.5 * spring.stiffness * length * length;
        }
      return energy;
    }



    /// Force and moment about the scene's origin of the load vector @p f.
    std::pair<Tensor<1, 3>, Tensor<1, 3>>
    wrench(const Body &body, const std::vector<Vector> &rigid, const Vector &f)
    {
      Tensor<1, 3> force, moment;
      for (unsigned int c = 0; c < 3; ++c)
        {
          force[c]  = f * rigid[c];
          moment[c] = f * rigid[3 + c];
        }
      moment += cross_product_3d(body.centre(), force);
      return {force, moment};
    }



    /// What the force @p lambda of a row does to the @p body of its @p part, by
    /// its work on the @p rigid motions.
    Wrench
    wrench_of(const BodyRow             &part,
              const Body                &body,
              const std::vector<Vector> &rigid,
              const double               lambda)
    {
      Wrench wrench;
      for (unsigned int c = 0; c < 3; ++c)
        {
          wrench.force[c]  = lambda * part.row(rigid[c]);
          wrench.moment[c] = lambda * part.row(rigid[3 + c]);
        }
      wrench.moment += cross_product_3d(body.centre(), wrench.force);
      return wrench;
    }



    /// The point nearest to @p mean of the line on which @p force has the
    /// moment @p moment about the origin (up to a couple along it).
    Point<3>
    line_of_action(const Tensor<1, 3> &force,
                   const Tensor<1, 3> &moment,
                   const Point<3>     &mean)
    {
      const Tensor<1, 3> arm =
        cross_product_3d(force, moment) / force.norm_square();
      return Point<3>(arm + (mean * force / force.norm_square()) * force);
    }



    /// Between the points of a pair, none if they overlap.
    double
    gap_of(const ContactInterface::Point &pair)
    {
      return std::max(0.,
                      (pair.second - pair.first) *
                        (pair.normal / pair.normal.norm()));
    }



    /// What the rows say of gaps and forces, each for itself.
    void
    check_rows(const ContactInterface        &contact,
               const ArrayView<const double> &force,
               const BlockVector             &u,
               const double                   factor,
               const double                   displacement,
               KuhnTucker                    &kkt)
    {
      double smallest = std::numeric_limits<double>::max(), largest = 0.;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const GapRow &row    = contact.rows[k];
          const double  lambda = force[k];
          const double  g      = row.gap(u, factor);
          kkt.max_penetration  = std::max(kkt.max_penetration, -g);
          kkt.law_error =
            std::max(kkt.law_error,
                     lambda == 0. ? -g :
                                    std::abs(g + law_softness(row) * lambda));
          kkt.complementarity =
            std::max(kkt.complementarity, std::max(g, 0.) * std::abs(lambda));
          largest = std::max(largest, std::abs(lambda));
          if (lambda != 0.)
            {
              ++kkt.active;
              kkt.averaged_away = std::max(kkt.averaged_away,
                                           contact.rows[k].initial_gap -
                                             gap_of(contact.points[k]));
              smallest          = std::min(smallest, lambda);
            }
        }
      if (kkt.active == 0)
        return;
      kkt.min_force = smallest;
      kkt.violation =
        std::max({kkt.law_error / displacement,
                  -smallest / largest,
                  kkt.complementarity / (displacement * largest)});
    }



    /// Force, moment and centre of pressure; adds the forces to the bodies'
    /// resultants.
    void
    add_contact_forces(const Structure                        &structure,
                       const std::vector<std::vector<Vector>> &rigid,
                       const ContactInterface                 &contact,
                       const ArrayView<const double>          &lambda,
                       KuhnTucker                             &kkt,
                       std::vector<Resultants>                &on_body)
    {
      BlockVector  load = structure.zero();
      Tensor<1, 3> mean;
      double       weight = 0.;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        if (lambda[k] != 0.)
          {
            contact.rows[k].add_to(load, lambda[k]);
            mean += lambda[k] * contact.points[k].first;
            weight += lambda[k];
          }
      const unsigned int first  = contact.first_body,
                         second = contact.second_body.value_or(first);
      const auto on             = [&](const unsigned int b) {
        return wrench(*structure.bodies()[b], rigid[b], load.block(b));
      };
      const auto [force_1, moment_1] = on(first);
      const auto [force_2, moment_2] = on(second);
      const auto about_centre        = [&](const unsigned int  b,
                                    const Tensor<1, 3> &force,
                                    const Tensor<1, 3> &moment) {
        return moment -
               cross_product_3d(structure.bodies()[b]->centre(), force);
      };
      on_body[first].add(force_1, about_centre(first, force_1, moment_1));
      const bool second_deforms = contact.second_body.has_value();
      if (second_deforms)
        on_body[second].add(force_2, about_centre(second, force_2, moment_2));
      // A theory without a turn about its axis sees no torque about it.
      const bool from_second =
        second_deforms &&
        structure.bodies()[second]->missing_motions().size() <=
          structure.bodies()[first]->missing_motions().size();
      kkt.force                  = from_second ? force_2 : -force_1;
      kkt.moment                 = from_second ? moment_2 : -moment_1;
      const unsigned int seen_by = from_second ? second : first;
      kkt.of_rows.resize(contact.rows.size());
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        if (lambda[k] != 0.)
          kkt.of_rows[k] = wrench_of(contact.rows[k].parts[from_second],
                                     *structure.bodies()[seen_by],
                                     rigid[seen_by],
                                     from_second ? lambda[k] : -lambda[k]);
      if (kkt.force.norm() == 0.)
        return;
      if (second_deforms)
        kkt.imbalance = (force_1 + force_2).norm() / weight;
      kkt.centre_of_pressure =
        line_of_action(kkt.force, kkt.moment, Point<3>(mean / weight));
    }



    /// The strain energy that the last digits of the displacements @p u make. A
    /// body that has no more is moved by its supports as a whole; its forces
    /// are rounding, too, balance nothing, and are not looked at. (That of
    /// bending is larger by decades in the slenderest body that doubles can
    /// hold: it falls with (h / L)^3 only.)
    double
    rounding_energy(const double largest_stiffness, const Vector &u)
    {
      constexpr double digits   = 1e3 * std::numeric_limits<double>::epsilon();
      const double     rounding = digits * u.linfty_norm();
      return 0.5 * largest_stiffness * rounding * rounding;
    }



    /// Clapeyron's theorem, with @p elastic the energy of the whole strains and
    /// @p other_work half the work of contact forces and heat. Energies below
    /// @p rounding are none.
    void
    check_energy(const double elastic,
                 const double other_work,
                 const double rounding,
                 Checks      &checks)
    {
      const double stored = elastic + checks.stabilisation_energy;
      if (stored <= rounding)
        return;
      const double size = std::max({std::abs(elastic),
                                    std::abs(checks.external_work),
                                    checks.stabilisation_energy});
      checks.energy_balance =
        std::abs(stored - checks.external_work - other_work) / size;
      if (checks.stabilisation_energy > rounding)
        checks.stabilisation_share = checks.stabilisation_energy / stored;
    }



    /// Keeps the larger of @p largest and @p error; what is not a number must
    /// not be lost in a maximum.
    void
    keep_larger(double &largest, const double error)
    {
      if (error > largest || !std::isfinite(error))
        largest = error;
    }



    /// Loads, springs and deformation of all bodies, and whether the forces
    /// @p on_body, of supports and contacts so far, balance. Returns the energy
    /// that is rounding.
    double
    check_bodies(const Linearisation                    &tangent,
                 const std::vector<std::vector<Vector>> &rigid,
                 const State                            &state,
                 const double                            factor,
                 std::vector<Resultants>                &on_body,
                 Checks                                 &checks)
    {
      // Reactions below that share of what heat would do to a body that is
      // held, or of loads that balance each other, are rounding.
      constexpr double of_heat   = arithmetic::integrated;
      const Structure &structure = tangent.of();
      double           rounding  = 0.;
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        {
          const Body   &body = *structure.bodies()[b];
          const Vector &u    = state.u.block(b);
          add_load_resultant(rigid[b],
                             structure.load().block(b),
                             factor,
                             on_body[b]);
          on_body[b].at_least(
            of_heat * std::max(structure.heat_load().block(b).linfty_norm(),
                               std::abs(factor) *
                                 structure.load().block(b).linfty_norm()));
          checks.stabilisation_energy +=
            add_springs(structure, b, rigid[b], state, on_body[b]);
          const Deformation deformation = body.deformation(u);
          checks.energy += deformation.energy;
          checks.max_rotation =
            std::max(checks.max_rotation, deformation.max_rotation);
          const double noise = rounding_energy(tangent.largest_stiffness(b), u);
          rounding += noise;
          const double energy = deformation.energy + structure.heat_energy(b) -
                                structure.heat_load().block(b) * u;
          checks.energies.push_back(
            energy > std::max(noise, of_heat * structure.heat_energy(b)) ?
              energy :
              0.);
          if (deformation.energy <= noise)
            continue;
          const auto [forces, moments] = on_body[b].unbalanced();
          keep_larger(checks.force_balance, forces);
          keep_larger(checks.moment_balance, moments);
        }
      return rounding;
    }
  } // namespace



  Checks
  check_state(const Linearisation                 &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const double                         factor)
  {
    const Structure &structure = tangent.of();
    Checks           checks;
    for (const Point<3> &middle :
         middles_of_supports(structure.prescribed(), n_supports))
      checks.reactions.push_back({{}, {}, middle});
    std::vector<Resultants>          on_body;
    std::vector<std::vector<Vector>> rigid;
    for (const auto &body : structure.bodies())
      {
        on_body.emplace_back(*body);
        rigid.push_back(body->rigid_motions());
      }

    checks.max_displacement = state.u.linfty_norm();
    for (const ContactInterface &contact : contacts)
      if (contact.obstacle != nullptr)
        checks.max_displacement =
          std::max(checks.max_displacement,
                   std::abs(factor) * contact.obstacle->displacement.norm());
    BlockVector   contact_load = structure.zero();
    const GapRows rows(contacts);
    for (unsigned int c = 0; c < contacts.size(); ++c)
      {
        const ContactInterface &contact = contacts[c];
        const auto              force   = rows.of_contact(c, state.force);
        KuhnTucker              kkt;
        check_rows(
          contact, force, state.u, factor, checks.max_displacement, kkt);
        add_contact_forces(structure, rigid, contact, force, kkt, on_body);
        checks.contacts.push_back(kkt);
        for (unsigned int k = 0; k < contact.rows.size(); ++k)
          contact.rows[k].add_to(contact_load, force[k]);
      }

    BlockVector r = structure.residual(state.u, factor, state.rest);
    // What the residual was made of: t f less the internal forces.
    BlockVector internal = structure.load();
    internal.sadd(factor, -1., r);
    internal += structure.heat_load();
    r += contact_load;
    BlockVector reaction = r;
    reaction *= -1.;
    checks.external_work =
      add_reactions(structure, rigid, reaction, factor, checks, on_body) +
      0.5 * factor * (structure.load() * state.u);
    find_centres(checks.reactions, structure.size());

    const double rounding =
      check_bodies(tangent, rigid, state, factor, on_body, checks);
    structure.condense(r);
    if (checks.energy > rounding && r.l2_norm() != 0.)
      checks.residual = r.linfty_norm() / internal.linfty_norm();
    const double elastic = checks.energy,
                 of_heat = structure.heat_load() * state.u;
    check_energy(elastic,
                 0.5 * (contact_load * state.u + of_heat),
                 rounding,
                 checks);
    checks.energy += structure.heat_energy() - of_heat;
    return checks;
  }



  void
  require_sound(const State  &state,
                const Checks &checks,
                const double  rotation_limit)
  {
    const auto last = [](const std::vector<double> &corrections) {
      return corrections.empty() ? 0. : corrections.back();
    };
    if (checks.stabilisation_share > worth_failing)
      throw NumericsError(
        "Stabilising springs hold " +
        to_text(100. * checks.stabilisation_share, 3) +
        " % of the energy: a body with Stabilisation is not held by its "
        "contacts. Add a support, close its gaps by a prescribed displacement, "
        "or load it towards the body that is to hold it.");
    const double left =
      std::max(last(state.free_corrections), last(state.contact_corrections));
    if (!(left < sound))
      throw LostDigits(
        "The linear solution does not settle: the last correction is " +
        to_text(left, 3) +
        " of the displacements. The scene is beyond what double precision "
        "holds: less slender bodies or less different stiffnesses are needed.");
    for (const auto &[what, error] :
         {std::make_pair("forces on a body do not balance",
                         checks.force_balance),
          std::make_pair("moments on a body do not balance",
                         checks.moment_balance),
          std::make_pair("unbalanced forces do not vanish", checks.residual),
          std::make_pair("strain energy is not the work done",
                         checks.energy_balance)})
      if (!(error < tolerable))
        throw LostDigits("The " + std::string(what) +
                         ": the relative error "
                         "is " +
                         to_text(error, 3) +
                         ". The scene is beyond what double precision "
                         "holds: make bodies less slender, or stiffnesses "
                         "and penalties less different.");
    for (const KuhnTucker &contact : checks.contacts)
      if (!(contact.imbalance < tolerable))
        throw NumericsError(
          "The forces of a contact on its two bodies differ by " +
          to_text(contact.imbalance, 3) +
          " of their sum: its rows do not follow rigid motions, a fault of "
          "this program. Please report the scene.");
      else if (contact.min_force < 0. ||
               !(contact.law_error <= sound * checks.max_displacement))
        throw NumericsError(
          "The contact conditions do not hold: the smallest force is " +
          to_text(contact.min_force) +
          ", and gaps miss the contact law by up to " +
          to_text(contact.law_error, 3) + " (relative violation " +
          to_text(contact.violation, 3) +
          "). Try a softer penalty, or Contact strategy = condensed if it is "
          "full.");
    if (!std::isfinite(checks.max_rotation) || !std::isfinite(checks.energy))
      throw NumericsError("The solution is not a finite number. Check the "
                          "loads and the materials.");
    if (checks.max_rotation > rotation_limit)
      throw NumericsError(
        "Rotations reach " + to_text(checks.max_rotation, 3) +
        " rad, beyond Rotation limit = " + to_text(rotation_limit) +
        ": linear kinematics does not describe this scene. Reduce the loads, "
        "or raise the limit if you want the linear result all the same.");
  }



  namespace
  {
    void
    add_contact_warnings(const ContactInterface   &contact,
                         const KuhnTucker         &kkt,
                         const double              displacement,
                         std::vector<std::string> &warnings)
    {
      const std::string what = "contact " + contact.name + ": ";
      if (kkt.max_penetration > large_penetration * displacement)
        warnings.push_back(
          what + "bodies penetrate by " + to_text(kkt.max_penetration, 3) +
          ", " + to_text(100. * kkt.max_penetration / displacement, 2) +
          " % of the displacements: a result of the penalty as "
          "much as of the bodies; raise it, or take Enforcement = exact");
      if (kkt.averaged_away > large_averaging * displacement)
        warnings.push_back(
          what + "gaps averaged over elements are up to " +
          to_text(kkt.averaged_away, 3) +
          " wider than those at their points, " +
          to_text(100. * kkt.averaged_away / displacement, 2) +
          " % of the displacements: the mesh is too coarse there for how the "
          "surfaces curve. Refine it where they touch, or take Discretisation "
          "= node to surface");
      double smallest = 0.;
      for (const GapRow &row : contact.rows)
        smallest = std::min(smallest, row.initial_gap);
      if (smallest < 0.)
        warnings.push_back(what +
                           "the bodies overlap from the start by up to " +
                           to_text(-smallest, 3) + " and are pushed apart");
    }
  } // namespace



  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts)
  {
    std::vector<std::string> warnings;
    for (unsigned int k = 0; k < contacts.size(); ++k)
      add_contact_warnings(contacts[k],
                           checks.contacts[k],
                           checks.max_displacement,
                           warnings);
    if (checks.max_rotation > linear_rotation)
      warnings.push_back(
        "rotations reach " + to_text(checks.max_rotation, 3) +
        " rad, where linear kinematics makes the shape longer by rotation^2 / 2 "
        "= " +
        to_text(50. * checks.max_rotation * checks.max_rotation, 2) +
        " %; read the results as those of a linear model");
    if (checks.stabilisation_share > worth_saying)
      warnings.push_back(
        "stabilising springs hold " +
        to_text(100. * checks.stabilisation_share, 2) +
        " % of the energy; a smaller Stabilisation falsifies less");
    const double first =
      state.free_corrections.empty() ? 0. : state.free_corrections.front();
    const double forces = std::max({checks.force_balance,
                                    checks.moment_balance,
                                    checks.residual,
                                    checks.energy_balance});
    if (forces > worth_telling)
      warnings.push_back("reactions and contact forces hold to " +
                         to_text(forces, 2) +
                         " only (their balance, relative): bodies are very "
                         "slender or stiffnesses very different");
    if (first > lost_digits)
      warnings.push_back(
        "the assembled matrix has lost digits (first refinement correction " +
        to_text(first, 2) + "); the refinement restored them, down to " +
        to_text(state.free_corrections.back(), 2));
    return warnings;
  }
} // namespace lamella
