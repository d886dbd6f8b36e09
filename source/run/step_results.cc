// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/step_results.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/solve/checks.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  StepRecorder::StepRecorder(const BuiltScene                  &built,
                             const Results                     &facts,
                             std::shared_ptr<const BlockVector> thermal_part)
    : built(built)
    , scene(built.scene())
    , structure(built.structure())
    , thermal_part(std::move(thermal_part))
    , facts(facts)
  {}



  StepResults
  StepRecorder::record(const unsigned int step,
                       const SolvedStep  &solved,
                       const State       &previous) const
  {
    require_found(solved);
    StepResults results;
    results.step        = step;
    results.load_factor = solved.load_factor;
    results.state       = solved.state;
    results.checks      = with_part_resultants(solved.checks);
    results.substeps    = solved.substeps;
    results.change      = solved.change;
    results.halvings    = solved.cuts;
    const FaceTractions tractions =
      built.tractions_at(solved.state, solved.load_factor);
    built.sampler().sample(solved.state.u, results, tractions);
    if (const StrengthSweep *const strength = built.strength())
      {
        StrengthSweep::Found found =
          strength->sweep(results.state.u, tractions, thermal_part.get());
        results.plies       = std::move(found.plies);
        results.plies_along = std::move(found.along);
      }
    results.warnings = warnings(solved, results);
    record_contacts(solved, previous, results);
    return results;
  }



  Checks
  StepRecorder::with_part_resultants(Checks checks) const
  {
    for (unsigned int c = 0; c < checks.contacts.size(); ++c)
      if (const auto whole = scene.contacts[c].part_of)
        add_resultants(checks.contacts[*whole], checks.contacts[c]);
    return checks;
  }



  bool
  StepRecorder::was_active(const State       &previous,
                           const unsigned int contact,
                           const unsigned int row) const
  {
    if (!structure.has_finite_rotations())
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
  StepRecorder::record_contacts(const SolvedStep &solved,
                                const State      &previous,
                                StepResults      &results) const
  {
    const GapConstraints &all = built.rows();
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        const ConstraintForces  forces(all, c, solved.state);
        auto                   &rows   = results.contacts.emplace_back();
        auto                   &change = results.changes.emplace_back();
        for (unsigned int k = 0; k < contact.rows.size(); ++k)
          {
            const ContactInterface::Point &pair = contact.points[k];
            // Rows of finite rotations: Eq. 17 at points that are paired.
            const bool moves = structure.has_finite_rotations() &&
                               !contact.rows[k].parts.empty();
            rows.push_back(
              {pair,
               moves ? (pair.second - pair.first) * pair.normal :
                       contact.rows[k].initial_gap,
               contact.rows[k].gap(solved.state.u, solved.load_factor),
               forces.normal[k],
               solved.checks.contacts[c].of_rows[k]});
            if (contact.rows[k].friction > 0. || contact.rows[k].is_tied())
              rows.back().friction = {
                forces.shear[k],
                forces.slips(k),
                forces.history(contact.rows[k]).length,
                forces.history(contact.rows[k]).dissipated};
            const bool touched = was_active(previous, c, k);
            change.closed += rows.back().touches() && !touched;
            change.opened += !rows.back().touches() && touched;
          }
      }
  }



  void
  StepRecorder::add_measures(Results &results) const
  {
    if (scene.measures.empty() && scene.goals.quantities.empty())
      return;
    const ResultNumbers numbers(results);
    for (const Measure &measure : scene.measures)
      results.steps.back().measures.push_back(numbers.value(measure.quantity));
    results.quantities.clear();
    for (const NamedQuantity &goal : scene.goals.quantities)
      if (goal.of != NamedQuantity::ObjectKind::mode)
        results.quantities[goal.label()] = numbers.value(goal);
  }



  FailureTrial
  StepRecorder::trial(const SolvedStep        &solved,
                      std::vector<PlyReserve> &plies) const
  {
    FailureTrial trial;
    trial.load_factor = solved.load_factor.of_scene();
    trial.checks      = with_part_resultants(solved.checks);
    const FaceTractions tractions =
      built.tractions_at(solved.state, solved.load_factor);
    trial.probes = built.sampler().sample_probes(solved.state.u, tractions);
    plies        = built.strength()
              ->sweep(solved.state.u, tractions, thermal_part.get())
              .plies;
    if (const PlyReserve *worst = worst_of(plies))
      trial.reserve = worst->reserve;
    return trial;
  }



  Results
  StepRecorder::minimal_results(const SolvedStep &solved,
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
    record_contacts(solved, before, step);
    return bare;
  }



  double
  StepRecorder::change_of_goals(const SolvedStep &one,
                                const SolvedStep &other,
                                const State      &before) const
  {
    if (scene.goals.quantities.empty())
      return 0.;
    const ResultNumbers first(minimal_results(one, before)),
      second(minimal_results(other, before));
    double change = 0.;
    for (const NamedQuantity &goal : scene.goals.quantities)
      {
        // Without slip no energy is dissipated, as change_of() has it; modes
        // are found after the steps.
        const bool has_none = goal.column == "dissipated" ||
                              goal.of == NamedQuantity::ObjectKind::mode;
        const double size = has_none ? 0. : first.scale_of(goal);
        if (size > 0.)
          change =
            std::max(change,
                     std::abs(first.value(goal) - second.value(goal)) / size);
      }
    return change;
  }
} // namespace lamella
