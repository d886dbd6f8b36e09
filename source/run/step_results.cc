// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/step_results.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/solve/soundness.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  StepRecorder::StepRecorder(const BuiltScene                  &built,
                             const Results                     &facts,
                             std::shared_ptr<const BlockVector> cured)
    : built(built)
    , scene(built.scene())
    , structure(built.structure())
    , cured(std::move(cured))
    , facts(facts)
  {}



  StepResults
  StepRecorder::record(const unsigned int step,
                       const SolvedStep  &solved,
                       const State       &previous) const
  {
    StepResults results;
    results.step        = step;
    results.load_factor = solved.load_factor;
    results.state       = solved.state;
    results.checks      = solved.checks;
    results.substeps    = solved.substeps;
    results.change      = solved.change;
    results.halvings    = solved.cuts;
    results.warnings    = warnings(solved);
    const FaceTractions tractions =
      built.tractions_at(solved.state, solved.load_factor);
    built.sampler().sample(solved.state.u, results, tractions);
    for (const std::string &warning : warnings_of_closures(results.closures))
      results.warnings.push_back(warning);
    take_strength(results, tractions);
    take_contacts(solved, previous, results);
    return results;
  }



  bool
  StepRecorder::has_touched(const State       &previous,
                            const unsigned int contact,
                            const unsigned int row) const
  {
    if (!structure.turns())
      return !previous.force.empty() &&
             built.rows().of_contact(contact, previous.force)[row] > 0.;
    // Contacts that pair anew give their rows other numbers, but points stay.
    if (facts.steps.empty() || facts.last().contacts.empty())
      return false;
    const auto &before = facts.last().contacts[contact];
    const auto &here   = place_of(built.interfaces()[contact].points[row]);
    return std::any_of(before.begin(), before.end(), [&](const auto &other) {
      return other.touches() && place_of(other.point) == here;
    });
  }



  void
  StepRecorder::take_contacts(const SolvedStep &solved,
                              const State      &previous,
                              StepResults      &results) const
  {
    const GapRows &all = built.rows();
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        const RowForces         forces(all, c, solved.state);
        auto                   &rows   = results.contacts.emplace_back();
        auto                   &change = results.changes.emplace_back();
        for (unsigned int k = 0; k < contact.rows.size(); ++k)
          {
            const ContactInterface::Point &pair = contact.points[k];
            // Of rows that move Eq. 17 of the places that face each other, if
            // they do.
            const bool moves =
              structure.turns() && !contact.rows[k].parts.empty();
            rows.push_back(
              {pair,
               moves ? (pair.second - pair.first) * pair.normal :
                       contact.rows[k].initial_gap,
               contact.rows[k].gap(solved.state.u, solved.load_factor),
               forces.normal[k],
               solved.checks.contacts[c].of_rows[k]});
            if (contact.rows[k].friction > 0.)
              rows.back().friction = {forces.shear[k],
                                      forces.slips(k),
                                      forces.length[k],
                                      forces.dissipated[k]};
            const bool touched = has_touched(previous, c, k);
            change.closed += rows.back().touches() && !touched;
            change.opened += !rows.back().touches() && touched;
          }
      }
  }



  void
  StepRecorder::take_strength(StepResults         &results,
                              const FaceTractions &tractions) const
  {
    if (built.strength() == nullptr)
      return;
    StrengthSweep::Found found =
      built.strength()->sweep(results.state.u, tractions, cured.get());
    results.plies           = std::move(found.plies);
    results.plies_along     = std::move(found.along);
    const std::string doubt = doubt_of_worst(results.plies,
                                             scene.supports,
                                             scene.loads,
                                             structure.bodies());
    if (!doubt.empty())
      results.warnings.push_back(doubt);
  }



  void
  StepRecorder::take_measures(Results &results) const
  {
    if (scene.measures.empty())
      return;
    const ResultNumbers numbers(results);
    for (const Measure &measure : scene.measures)
      results.steps.back().measures.push_back(numbers.value(measure.quantity));
  }



  FailureTrial
  StepRecorder::trial(const SolvedStep        &solved,
                      std::vector<PlyReserve> &plies) const
  {
    FailureTrial trial;
    trial.load_factor = solved.load_factor.of_scene();
    trial.checks      = solved.checks;
    const FaceTractions tractions =
      built.tractions_at(solved.state, solved.load_factor);
    trial.probes = built.sampler().sample_probes(solved.state.u, tractions);
    plies =
      built.strength()->sweep(solved.state.u, tractions, cured.get()).plies;
    if (const PlyReserve *worst = worst_of(plies))
      trial.reserve = worst->reserve;
    return trial;
  }



  Results
  StepRecorder::bare_results(const SolvedStep &solved,
                             const State      &before) const
  {
    Results bare;
    bare.bodies       = facts.bodies;
    bare.contacts     = facts.contacts;
    bare.supports     = facts.supports;
    bare.probes       = facts.probes;
    bare.measures     = facts.measures;
    StepResults &step = bare.steps.emplace_back();
    step.load_factor  = solved.load_factor;
    step.state        = solved.state;
    step.checks       = solved.checks;
    step.probes       = built.sampler().sample_probes(
      solved.state.u, built.tractions_at(solved.state, solved.load_factor));
    take_contacts(solved, before, step);
    return bare;
  }



  double
  StepRecorder::change_of_goals(const SolvedStep &one,
                                const SolvedStep &other,
                                const State      &before) const
  {
    if (scene.goals.quantities.empty())
      return 0.;
    const ResultNumbers first(bare_results(one, before)),
      second(bare_results(other, before));
    double change = 0.;
    for (const NamedQuantity &goal : scene.goals.quantities)
      {
        // What is dissipated is nothing beside the energy where nothing slips,
        // and change_of() has it so.
        const double size =
          goal.column == "dissipated" ? 0. : first.scale_of(goal);
        if (size > 0.)
          change =
            std::max(change,
                     std::abs(first.value(goal) - second.value(goal)) / size);
      }
    return change;
  }



  std::vector<std::string>
  StepRecorder::warnings(const SolvedStep &solved) const
  {
    const std::vector<ContactInterface> &contacts = built.interfaces();
    std::vector<std::string>             warnings =
      warnings_of(solved.state, solved.checks, contacts);
    const auto add = [&warnings](const std::vector<std::string> &more) {
      warnings.insert(warnings.end(), more.begin(), more.end());
    };
    add(warnings_of(solved.checks.beyond, structure));
    if (scene.solve.is_judged)
      add(built.plausibility().doubts(solved.state.u));
    for (unsigned int k = 0; k < contacts.size() && !structure.turns(); ++k)
      add(
        broken_assumptions(contacts[k],
                           structure.bodies(),
                           solved.state.u,
                           solved.load_factor,
                           built.rows().among_contact(k, solved.state.active)));
    add(warnings_of_rollers(solved));
    add(warnings_of_sunk_rollers(solved));
    add(warnings_of_ends(solved));
    add(warnings_of_holds(solved));
    if (solved.change && *solved.change > scene.solve.substeps.tolerance)
      warnings.push_back(
        "twice as many substeps, " + std::to_string(solved.substeps) +
        ", still changed the load step by " +
        to_text(100. * *solved.change, 2) +
        " %: where it slips while pressures change, results depend on the way; "
        "put load factors between");
    return warnings;
  }



  namespace
  {
    /// That points of @p contact are @p spacing apart, too few for the radius
    /// of its roller; the remedy is a line, too, if it
    /// @p may_be_line.
    std::string
    note_of_few_points(const ContactInterface &contact,
                       const double            spacing,
                       const bool              may_be_line)
    {
      const double radius = contact.obstacle->radius;
      return "contact " + contact.name + ": points that touch are " +
             to_text(spacing, 3) + " apart on a roller of radius " +
             to_text(radius, 4) +
             ", so that the direction of its force is off by up to " +
             to_text(0.5 * spacing / radius, 2) + " rad: take " +
             (may_be_line ? "Discretisation = line to roller, or " : "") +
             "shorter elements wherever it touches";
    }
  } // namespace



  std::vector<std::string>
  StepRecorder::warnings_of_rollers(const SolvedStep &solved) const
  {
    std::vector<std::string> warnings;
    if (!structure.turns())
      return warnings;
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        const auto active = built.rows().among_contact(c, solved.state.active);
        if (contact.obstacle == nullptr ||
            contact.obstacle->shape != Obstacle::Shape::cylinder)
          continue;
        const bool nestles =
                     built.contact_lives()[c]->nestles(solved.state.u,
                                                       solved.load_factor,
                                                       active),
                   is_line =
                     contact.discretisation == Discretisation::line_to_roller;
        if (is_line && nestles)
          warnings.push_back(
            "contact " + contact.name + ": the body bends around '" +
            contact.second_name +
            "', where a line is not all that touches: take Discretisation = "
            "auto or surface to surface");
        if (is_line || nestles)
          continue;
        const PressedArc arc = pressed_arc(contact, active);
        // What is turned by little has its force where it was.
        if (arc.is_line() &&
            are_few_on(arc.spacing * std::min(1., solved.checks.max_rotation),
                       contact.obstacle->radius))
          warnings.push_back(note_of_few_points(
            contact,
            arc.spacing,
            may_be_line(scene.contacts[c], scene.bodies[contact.first_body]) &&
              !scene.contacts[c].may_take_points));
      }
    return warnings;
  }



  std::vector<std::string>
  StepRecorder::warnings_of_sunk_rollers(const SolvedStep &solved) const
  {
    // Of the displacements.
    constexpr double         worth_saying = 1e-2;
    std::vector<std::string> warnings;
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        if (!built.rows().among_contact(c, solved.state.active).empty())
          continue;
        const auto sunk =
          built.contact_lives()[c]->sunk_place(solved.state.u,
                                               solved.load_factor);
        if (!sunk ||
            sunk->depth <
              std::max(worth_saying * solved.checks.max_displacement,
                       arithmetic::as_written * contact.obstacle->radius))
          continue;
        // With that between two nodes their averages of the gap are zero.
        const double spacing =
          std::sqrt(4. * contact.obstacle->radius * sunk->depth);
        warnings.push_back(
          "contact " + contact.name + ": nothing touches, but '" +
          contact.second_name + "' is inside of the body at " +
          to_text(sunk->position) + ", between its points, by " +
          to_text(sunk->depth, 2) + ": have these nearer than " +
          to_text(spacing, 2) +
          " there (three an axis element B4), or take Discretisation = line to "
          "roller");
      }
    return warnings;
  }



  namespace
  {
    /// Bodies whose ends have rows, and against which others, by name.
    std::set<std::pair<std::string, std::string>>
    ends_with_rows(const std::vector<ContactInterface> &contacts,
                   const Bodies                        &bodies)
    {
      std::set<std::pair<std::string, std::string>> found;
      for (const ContactInterface &contact : contacts)
        if (contact.discretisation != Discretisation::surface_to_surface)
          {
            const std::string &first = bodies[contact.first_body]->name();
            const bool         is_both =
              contact.discretisation == Discretisation::node_to_node;
            if (!contact.points_on_second || is_both)
              found.emplace(first, contact.second_name);
            if (contact.points_on_second || is_both)
              found.emplace(contact.second_name, first);
          }
      return found;
    }
  } // namespace



  std::vector<std::string>
  StepRecorder::warnings_of_ends(const SolvedStep &solved) const
  {
    // Of the cell's depth and of the displacements: gaps of faces are averages.
    // What is in by the latter costs a contact force as much or more.
    constexpr double         worth_saying = 1e-2, of_displacements = 1e-3;
    std::vector<std::string> warnings;
    auto have_rows = ends_with_rows(built.interfaces(), structure.bodies());
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        const auto end = built.contact_lives()[c]->sunk_end(solved.state.u,
                                                            solved.load_factor);
        if (!end)
          continue;
        const double worth =
          std::min(worth_saying * end->cell,
                   of_displacements * solved.checks.max_displacement);
        // What a penalty leaves is no lack of rows.
        if (end->depth < worth + solved.checks.contacts[c].max_penetration)
          continue;
        const std::string first =
          structure.bodies()[contact.first_body]->name();
        const auto &[one, other] =
          end->second ? std::make_pair(contact.second_name, first) :
                        std::make_pair(first, contact.second_name);
        // Of several contacts of the same surfaces one says it.
        if (!have_rows.emplace(one, other).second)
          continue;
        warnings.push_back(
          "contact " + contact.name + ": an end of body '" + one + "' is " +
          to_text(end->depth, 2) + " behind the surface of body '" + other +
          "', where no row holds it: beside this contact take one of the same "
          "surfaces with Discretisation = edge to surface, whose Points on are "
          "of body '" +
          one + "'");
      }
    return warnings;
  }



  double
  StepRecorder::largest_moment(const SolvedStep &solved) const
  {
    // Couples bear on thin sections with forces that are far larger than what
    // they are over the size of the scene.
    const double size    = structure.size();
    double       largest = 0.;
    for (const LoadResultant &load : structure.load_resultants())
      largest = std::max(largest,
                         load.force.norm() * size >
                             arithmetic::as_written * load.moment.norm() ?
                           load.force.norm() * size :
                           load.moment.norm());
    largest *= std::abs(solved.load_factor.of_scene());
    for (const Resultant &reaction : solved.checks.reactions)
      largest = std::max(largest, reaction.force.norm() * size);
    for (const KuhnTucker &contact : solved.checks.contacts)
      largest = std::max(largest, contact.force.norm() * size);
    // Loads that balance on their own, and heat, leave rounding.
    const double of_nodes =
      size *
      std::max(structure.load(solved.load_factor, solved.state.u).linfty_norm(),
               arithmetic::as_written * structure.heat_load().l2_norm());
    return largest > arithmetic::as_written * of_nodes ? largest : of_nodes;
  }



  std::vector<std::string>
  StepRecorder::warnings_of_holds(const SolvedStep &solved) const
  {
    // Of the largest force, a moment over the scene's size.
    constexpr double         worth_saying = 1e-3;
    const Checks            &checks       = solved.checks;
    std::vector<std::string> warnings;
    // What balances on the undeformed body (check_balance_of_held()) need not
    // where it has gone.
    double largest = 0.;
    if (checks.is_large)
      largest = std::max(
        structure.load(solved.load_factor, solved.state.u).linfty_norm(),
        arithmetic::as_written * structure.heat_load().l2_norm());
    for (const Resultant &reaction : checks.reactions)
      largest = std::max(largest, reaction.force.norm());
    for (const KuhnTucker &contact : checks.contacts)
      largest = std::max(largest, contact.force.norm());
    const double of_moments =
      checks.is_large ? largest_moment(solved) : largest * structure.size();
    for (unsigned int s = 0; s < scene.supports.size(); ++s)
      {
        const Resultant &reaction = checks.reactions[s];
        const double     share    = std::max(reaction.force.norm() / largest,
                                      reaction.moment.norm() / of_moments);
        if (scene.supports[s].hold && share > worth_saying &&
            (checks.is_large || !checks.contacts.empty()))
          warnings.push_back(
            "the hold of body '" +
            structure.bodies()[scene.supports[s].hold->body]->name() +
            "' bears a force of " + to_text(reaction.force) +
            " and a moment of " + to_text(reaction.moment) + ", " +
            to_text(100. * share, 2) + " % of the largest: " +
            (checks.is_large ?
               "where bodies have gone loads and contact forces " :
               "contact forces off their main direction ") +
            "do not balance in motions that it takes out. Put a support where "
            "the real one is, if that is too much");
      }
    return warnings;
  }



  std::vector<std::string>
  StepRecorder::warnings_of_closures(const Closures &closures) const
  {
    constexpr double         much = 0.05;
    std::vector<std::string> warnings;
    for_each_closure(
      facts,
      closures,
      [&](const std::string &kind,
          const std::string &name,
          const double       share) {
        if (share > much)
          warnings.push_back(
            kind + " " + name +
            ": transverse stresses by equilibrium miss the traction on the "
            "upper face by " +
            to_text(100. * share, 2) +
            " % of the largest; put more elements along the axis there, or "
            "look further away from supports, edges and concentrated loads");
      });
    return warnings;
  }
} // namespace lamella
