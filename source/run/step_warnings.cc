// SPDX-License-Identifier: LGPL-2.1-or-later

// Warnings about the state at the end of a load step.

#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/run/step_results.h>
#include <lamella/scene/rotation_rules.h>
#include <lamella/solve/checks.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  bool
  StepRecorder::has_carried_force(const unsigned int c) const
  {
    const ContactInterface &contact = built.interfaces()[c];
    return std::any_of(
      facts.steps.begin(), facts.steps.end(), [&](const StepResults &step) {
        const std::vector<double> &energies = step.checks.energies;
        // Energies of a resumed run are not known.
        const auto is_strained = [&](const unsigned int body) {
          return energies.empty() || energies[body] > 0.;
        };
        return step.changes[c].closed > 0 &&
               (is_strained(contact.first_body) ||
                (contact.second_body && is_strained(*contact.second_body)));
      });
  }



  std::vector<unsigned int>
  StepRecorder::idle_contacts() const
  {
    const std::vector<ContactInterface> &contacts = built.interfaces();
    const StepResults                   &last     = facts.last();
    std::vector<unsigned int>            idle;
    for (unsigned int c = 0; c < contacts.size(); ++c)
      if (!has_carried_force(c) && !last.contacts[c].empty())
        idle.push_back(c);
    const auto is_unstrained = [&last](const unsigned int body) {
      return last.checks.energies[body] == 0.;
    };
    // A stop that a strained body does not reach may be intended.
    if (idle.size() < contacts.size())
      idle.erase(std::remove_if(idle.begin(),
                                idle.end(),
                                [&](const unsigned int c) {
                                  const ContactInterface &contact = contacts[c];
                                  return !is_unstrained(contact.first_body) &&
                                         (contact.second_body ?
                                            !is_unstrained(
                                              *contact.second_body) :
                                            contact.obstacle->is_fixed());
                                }),
                 idle.end());
    return idle;
  }



  std::string
  StepRecorder::note_on_idle_contacts() const
  {
    const StepResults       &last = facts.last();
    std::vector<std::string> names;
    for (const unsigned int c : idle_contacts())
      {
        const auto nearest = std::min_element(last.contacts[c].begin(),
                                              last.contacts[c].end(),
                                              [](const auto &a, const auto &b) {
                                                return a.gap < b.gap;
                                              });
        names.push_back("'" + built.interfaces()[c].name + "' (smallest gap " +
                        to_text(nearest->gap, 3) + " at " +
                        to_text(nearest->point.first) + ")");
      }
    return names.empty() ?
             "" :
             "run.idle-contact: no contact force acts in contact " +
               joined(names) +
               " in any load step. Close the gap (Origin of a body, Through of "
               "an obstacle), or check the directions of loads";
  }



  std::vector<std::string>
  StepRecorder::warnings_off_path(const SolvedStep       &solved,
                                  std::vector<PlyReserve> plies) const
  {
    StepResults sampled;
    sampled.step  = scene.solve.load_factors.size();
    sampled.plies = std::move(plies);
    built.sampler().sample(solved.state.u,
                           sampled,
                           built.tractions_at(solved.state,
                                              solved.load_factor));
    return warnings(solved, sampled);
  }



  std::vector<std::string>
  StepRecorder::warnings(const SolvedStep  &solved,
                         const StepResults &sampled) const
  {
    const std::vector<ContactInterface> &contacts = built.interfaces();
    auto       warnings = warnings_of(solved.state, solved.checks, contacts);
    const auto add      = [&warnings](const std::vector<std::string> &more) {
      warnings.insert(warnings.end(), more.begin(), more.end());
    };
    const bool is_linear = !structure.has_finite_rotations(),
               is_last   = sampled.step == scene.solve.load_factors.size();
    add(warnings_of(solved.checks.beyond, structure));
    if (scene.solve.computes_estimates)
      add(built.plausibility().plausibility_warnings(solved.state.u,
                                                     solved.checks,
                                                     is_last));
    for (unsigned int k = 0; k < contacts.size() && is_linear; ++k)
      add(assumption_warnings(contacts[k],
                              structure.bodies(),
                              solved.state.u,
                              solved.load_factor,
                              built.rows().local_rows_of(k,
                                                         solved.state.active)));
    add(warnings_of_rollers(solved));
    add(warnings_of_ends(solved));
    add(warnings_of_isostatic_supports(solved));
    if (solved.change && *solved.change > scene.solve.substeps.tolerance)
      warnings.push_back(
        "run.substeps-too-few: with twice as many substeps, " +
        std::to_string(solved.substeps) + ", results still change by " +
        to_text(100. * *solved.change, 2) +
        " %: they depend on the slip path. Add values between those of Load "
        "factors");
    add(warnings_of_defects(sampled.defects));
    if (built.strength() != nullptr)
      if (const std::string found = worst_reserve_warning(
            sampled.plies, scene.supports, scene.loads, structure.bodies());
          !found.empty())
        warnings.push_back(found);
    return warnings;
  }



  namespace
  {
    /// Returns a warning that contact points on the roller of @p contact are
    /// @p spacing apart. Suggests line contact if @p may_be.
    std::string
    describe_coarse_points(const ContactInterface &contact,
                           const double            spacing,
                           const bool              may_be)
    {
      const double radius = contact.obstacle->radius;
      return "run.roller-points-too-coarse: contact " + contact.name +
             ": neighboring contact points are " + to_text(spacing, 3) +
             " apart on a roller of radius " + to_text(radius, 4) +
             ", so the direction of the contact force has an error of up to " +
             to_text(0.5 * spacing / radius, 2) + " rad. Use " +
             (may_be ? "Discretization = line to roller, or " : "") +
             "shorter elements at the roller";
    }



    /// Returns names of bodies with constraints at ends, and of the others.
    std::set<std::pair<std::string, std::string>>
    ends_with_rows(const std::vector<ContactInterface> &contacts,
                   const Bodies                        &bodies)
    {
      std::set<std::pair<std::string, std::string>> found;
      for (const ContactInterface &contact : contacts)
        if (contact.discretization != Discretization::surface_to_surface)
          {
            const std::string &first = bodies[contact.first_body]->name();
            const bool         is_both =
              contact.discretization == Discretization::node_to_node;
            if (!contact.points_on_second || is_both)
              found.emplace(first, contact.second_name);
            if (contact.points_on_second || is_both)
              found.emplace(contact.second_name, first);
          }
      return found;
    }
  } // namespace



  std::vector<std::string>
  StepRecorder::warnings_of_rollers(const SolvedStep &solved) const
  {
    std::vector<std::string> warnings;
    if (!structure.has_finite_rotations())
      return warnings;
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &contact = built.interfaces()[c];
        const auto active = built.rows().local_rows_of(c, solved.state.active);
        if (contact.obstacle == nullptr ||
            contact.obstacle->shape != Obstacle::Shape::cylinder)
          continue;
        const bool wraps_around = built.contact_objects()[c]->wraps_around(
                     solved.state.u, solved.load_factor, contact, active),
                   is_line =
                     contact.discretization == Discretization::line_to_roller;
        if (is_line && wraps_around)
          warnings.push_back(
            "run.line-contact-not-valid: contact " + contact.name +
            ": the body bends around '" + contact.second_name +
            "', so contact is not along a single line (line to roller). Use "
            "Discretization = auto or surface to surface");
        if (is_line || wraps_around)
          continue;
        const ContactArc arc = contact_arc(contact, active);
        // Small rotations do not move the force.
        if (arc.is_line() &&
            are_too_coarse_for(arc.spacing *
                                 std::min(1., solved.checks.max_rotation),
                               contact.obstacle->radius))
          warnings.push_back(describe_coarse_points(
            contact,
            arc.spacing,
            allows_line_contact(scene.contacts[c],
                                scene.bodies[contact.first_body]) &&
              !scene.contacts[c].is_automatic));
      }
    return warnings;
  }



  bool
  StepRecorder::touches(const unsigned int contact,
                        const SolvedStep  &solved) const
  {
    const ContactInterface &own = built.interfaces()[contact];
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const ContactInterface &other = built.interfaces()[c];
        if (other.first_body == own.first_body &&
            other.second_name == own.second_name &&
            !built.rows().local_rows_of(c, solved.state.active).empty())
          return true;
      }
    return false;
  }



  void
  StepRecorder::require_found(const SolvedStep &solved) const
  {
    // Of the displacements.
    constexpr double worth_failing = 1e-2;
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        if (touches(c, solved))
          continue;
        const ContactInterface &contact = built.interfaces()[c];
        const auto              penetration =
          built.contact_objects()[c]->cylinder_penetration(solved.state.u,
                                                           solved.load_factor,
                                                           contact);
        const unsigned int number = penetration && penetration->of_second ?
                                      *contact.second_body :
                                      contact.first_body;
        const Body        &body   = *structure.bodies()[number];
        if (!penetration ||
            penetration->depth <
              std::max(worth_failing * solved.checks.max_displacement,
                       arithmetic::decimal_tolerance * body.size()))
          continue;
        throw_undetected_penetration(contact, *penetration, number);
      }
  }



  void
  StepRecorder::throw_undetected_penetration(
    const ContactInterface    &contact,
    const CylinderPenetration &penetration,
    const unsigned int         body) const
  {
    // Nodes of B4 beside the common end of two elements are 0.28 of their
    // length h apart. If the roller is deepest at one of them, the mean gap
    // there is (0.28 h)^2 / (12 R) larger: a hundredth of the depth.
    const double longest =
      contact.obstacle == nullptr ?
        0. :
        std::sqrt(1.5 * contact.obstacle->radius * penetration.depth);
    throw UndetectedPenetration(
      "run.penetration-undetected: contact " + contact.name +
        ": no contact point is active, but body or obstacle '" +
        (penetration.of_second ?
           structure.bodies()[contact.first_body]->name() :
           contact.second_name) +
        "' penetrates the other body at " + to_text(penetration.position) +
        ", between its contact points, by " + to_text(penetration.depth, 2) +
        ". For body '" + structure.bodies()[body]->name() +
        "' use Axis elements = auto, or " +
        (longest > 0. ? "elements of at most " + to_text(longest, 2) :
                        std::string("shorter elements")) +
        " there (Axis breaks)" +
        (longest > 0. ? ", or Discretization = line to roller." : "."),
      body,
      scene.bodies[body].placement.to_body(penetration.position)[1],
      longest);
  }



  std::optional<EndPenetration>
  StepRecorder::end_penetration(const unsigned int c,
                                const SolvedStep  &solved) const
  {
    // Shares of the cell's depth and of the displacements: gaps of faces are
    // averages. Penetrations of the latter change a contact force by 0.1 %.
    constexpr double worth_saying = 1e-2, of_displacements = 1e-3;
    const auto       end =
      built.contact_objects()[c]->end_penetration(solved.state.u,
                                                  solved.load_factor);
    // The penetration of a penalty is no lack of constraints.
    if (end && end->depth >
                 std::min(worth_saying * end->cell,
                          of_displacements * solved.checks.max_displacement) +
                   solved.checks.contacts[c].max_penetration)
      return end;
    return {};
  }



  std::vector<std::string>
  StepRecorder::warnings_of_ends(const SolvedStep &solved) const
  {
    std::vector<std::string>  warnings, of_missing;
    std::vector<EndInContact> missing;
    auto have_rows = ends_with_rows(built.interfaces(), structure.bodies());
    for (unsigned int c = 0; c < built.interfaces().size(); ++c)
      {
        const auto end = end_penetration(c, solved);
        if (!end)
          continue;
        const ContactInterface &contact = built.interfaces()[c];
        std::string one   = structure.bodies()[contact.first_body]->name(),
                    other = contact.second_name;
        if (end->second)
          std::swap(one, other);
        // Contacts of the same surfaces give one warning.
        if (!have_rows.emplace(one, other).second)
          continue;
        const bool is_automatic =
          built.contact_objects()[c]->parameters().is_automatic;
        if (is_automatic)
          missing.push_back({c, end->second});
        (is_automatic ? of_missing : warnings)
          .push_back(
            "run.end-penetration: contact " + contact.name +
            ": an end of body '" + one + "' is " + to_text(end->depth, 2) +
            " inside the surface of body '" + other +
            "', where it has no contact constraints. Add a contact of the same "
            "surfaces with Discretization = edge to surface and body '" +
            one + "' as Slave side");
      }
    if (!missing.empty())
      throw MissingEnds(of_missing.front(), missing);
    return warnings;
  }



  double
  StepRecorder::largest_moment(const SolvedStep &solved) const
  {
    // Couples act on thin sections by forces far above couple / scene size.
    const double size    = structure.size();
    double       largest = 0.;
    for (const LoadResultant &load : structure.load_resultants())
      largest =
        std::max(largest,
                 load.force.norm() * size >
                     arithmetic::decimal_tolerance * load.moment.norm() ?
                   load.force.norm() * size :
                   load.moment.norm());
    largest *= std::abs(solved.load_factor.of_scene());
    for (const Resultant &reaction : solved.checks.reactions)
      largest = std::max(largest, reaction.force.norm() * size);
    for (const KktResidual &contact : solved.checks.contacts)
      largest = std::max(largest, contact.force.norm() * size);
    // Loads that balance on their own, and heat, leave rounding.
    const double of_nodes =
      size *
      std::max(structure.load(solved.load_factor, solved.state.u).linfty_norm(),
               arithmetic::decimal_tolerance *
                 structure.thermal_load().l2_norm());
    return largest > arithmetic::decimal_tolerance * of_nodes ? largest :
                                                                of_nodes;
  }



  std::vector<std::string>
  StepRecorder::warnings_of_isostatic_supports(const SolvedStep &solved) const
  {
    // Of the largest force, a moment over the scene's size.
    constexpr double         worth_saying = 1e-3;
    const Checks            &checks       = solved.checks;
    std::vector<std::string> warnings;
    // Loads that balance on the undeformed body (check_isostatic_balance())
    // need not balance on the deformed one.
    double largest = 0.;
    if (checks.is_large)
      largest = std::max(
        structure.load(solved.load_factor, solved.state.u).linfty_norm(),
        arithmetic::decimal_tolerance * structure.thermal_load().l2_norm());
    for (const Resultant &reaction : checks.reactions)
      largest = std::max(largest, reaction.force.norm());
    for (const KktResidual &contact : checks.contacts)
      largest = std::max(largest, contact.force.norm());
    const double of_moments =
      checks.is_large ? largest_moment(solved) : largest * structure.size();
    for (unsigned int s = 0; s < scene.supports.size(); ++s)
      {
        const Resultant &reaction = checks.reactions[s];
        const double     share    = std::max(reaction.force.norm() / largest,
                                      reaction.moment.norm() / of_moments);
        if (scene.supports[s].isostatic && share > worth_saying &&
            (checks.is_large || !checks.contacts.empty()))
          warnings.push_back(
            "run.isostatic-support-loaded: the isostatic support of body '" +
            structure.bodies()[scene.supports[s].isostatic->body]->name() +
            "' carries a force of " + to_text(reaction.force) +
            " and a moment of " + to_text(reaction.moment) + ", " +
            to_text(100. * share, 2) + " % of the largest force or moment: " +
            (checks.is_large ?
               "loads and contact forces on the deformed bodies " :
               "contact forces not along their main direction ") +
            "do not balance. Add a Support if this reaction is too large");
      }
    return warnings;
  }



  std::vector<std::string>
  StepRecorder::warnings_of_defects(const EquilibriumDefects &defects) const
  {
    constexpr double         much = 0.05;
    std::vector<std::string> warnings;
    for_each_defect(
      facts,
      defects,
      [&](const std::string &kind,
          const std::string &name,
          const double       share) {
        if (share > much)
          warnings.push_back(
            "run.equilibrium-defect: " + kind + " " + name +
            ": the transverse stresses, integrated from the equilibrium "
            "equations, miss their boundary value at the upper face by " +
            to_text(100. * share, 2) +
            " % of the largest. Use more elements along the axis there, or a "
            "position further from supports, edges and concentrated loads");
      });
    return warnings;
  }
} // namespace lamella
