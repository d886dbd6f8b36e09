// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/adapt/plan.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/conditions/isostatic_support.h>
#include <lamella/contact/assumptions.h>
#include <lamella/contact/parameters.h>
#include <lamella/run/built_scene.h>
#include <lamella/run/first_failure.h>
#include <lamella/scene/scene_checks.h>
#include <lamella/scene/theory_notes.h>
#include <lamella/solve/phase.h>

#include <algorithm>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// What takes a while says so before it begins.
    void
    print_large_sections(const SectionMeshes &sections, std::ostream &out)
    {
      constexpr unsigned int many = 5000;
      for (const auto &[name, section] : sections)
        if (const unsigned int n = section->mesh.n_active_cells(); n > many)
          out
            << "Section " << name << ": " << n
            << " cells; making its expansion, bodies and supports takes a while"
            << std::endl;
    }



    ContactSummary
    contact_facts(const ContactInterface &contact,
                  const Enforcement       enforcement)
    {
      const auto [least, greatest] =
        std::minmax_element(contact.rows.begin(),
                            contact.rows.end(),
                            [](const GapConstraint &a, const GapConstraint &b) {
                              return a.initial_gap < b.initial_gap;
                            });
      return {contact.name,
              contact.second_name,
              contact.discretization,
              enforcement,
              static_cast<unsigned int>(contact.rows.size()),
              contact.unpaired,
              contact.unpaired_second,
              least->initial_gap,
              greatest->initial_gap,
              least->friction,
              contact.surface};
    }



    /// Returns the stabilization of each body; `auto` depends on contacts.
    std::vector<Stabilization>
    stabilizations_of(const Scene &given)
    {
      std::vector<Stabilization> stabilizations;
      for (const BodyDescription &body : given.bodies)
        stabilizations.push_back({body.stabilization.value_or(0.)});
      for (const ContactPair &contact : given.contacts)
        for (const Region *side : {&contact.first, &contact.second})
          if (!given.bodies[side->body].stabilization &&
              (side == &contact.first || contact.obstacle == nullptr))
            stabilizations[side->body].share = stabilization_of_contact;
      for (unsigned int b = 0; b < given.bodies.size(); ++b)
        if (given.bodies[b].has_inertia && !given.bodies[b].stabilization)
          stabilizations[b].share = stabilization_of_contact;
      return stabilizations;
    }



    /// Returns the contacts of the undeformed bodies, for the choice of fields.
    std::vector<ContactInterface>
    undeformed_interfaces(const std::vector<ContactPair> &contacts,
                          const Bodies                   &bodies)
    {
      std::vector<ContactInterface> interfaces(contacts.size());
      for (unsigned int k = 0; k < contacts.size(); ++k)
        {
          ContactHistory history;
          if (contacts[k].has_slips())
            const Contact with_slips(contacts[k],
                                     bodies,
                                     interfaces[k],
                                     history);
          else
            interfaces[k] = make_interface(contacts[k], bodies);
        }
      return interfaces;
    }



    /// Takes the slips out of the rows of @p contact that supports of both
    /// sides hold, as those along the axis in plane strain: no force in them
    /// would do anything, so none can be told.
    void
    drop_constrained_slips(ContactInterface &contact,
                           const Structure  &structure)
    {
      for (GapConstraint &row : contact.rows)
        row.slips.erase(
          std::remove_if(row.slips.begin(),
                         row.slips.end(),
                         [&](const SlipConstraint &slip) {
                           return slip.rate == 0. &&
                                  std::all_of(slip.parts.begin(),
                                              slip.parts.end(),
                                              [&](const BodyFunctional &part) {
                                                return structure.holds(part);
                                              });
                         }),
          row.slips.end());
    }
  } // namespace



  BuiltScene::BuiltScene(const Scene      &scene,
                         const FieldRules &rules,
                         std::ostream     &out,
                         TimerOutput      &timer)
    : given(scene)
    , field_rules(rules)
  {
    {
      TimerOutput::Scope scope(timer, name_of(Phase::setup));
      build_structure(out);
    }
    {
      TimerOutput::Scope scope(timer, name_of(Phase::contact));
      build_contacts();
    }
    TimerOutput::Scope scope(timer, name_of(Phase::setup));
    build_requests();
  }



  void
  BuiltScene::build_structure(std::ostream &out)
  {
    section_meshes = build_section_meshes(given);
    print_large_sections(section_meshes, out);
    grade_axes(given.bodies,
               section_meshes,
               given.supports,
               given.loads,
               given.contacts,
               given.gravity);
    Bodies bodies = make_bodies_with_fields();
    set_isostatic_motions(bodies);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (given.bodies[b].has_inertia)
        densities(*bodies[b]);
    std::vector<Load>          loads          = given.loads;
    std::vector<Stabilization> stabilizations = stabilizations_of(given);
    add_guided_obstacles(
      given.obstacles, given.contacts, bodies, loads, stabilizations);
    whole = std::make_unique<Structure>(
      std::move(bodies), given.supports, loads, stabilizations, given.gravity);
    for (const LoadFactor &factor : given.solve.load_factors)
      check_isostatic_balance(given.supports,
                              whole->bodies(),
                              whole->load(factor));
    for (const auto &body : whole->bodies())
      if (const SolverKind kind = solver_kind(*body, given.solve.solver);
          body->has_finite_rotations() && kind == SolverKind::cg)
        throw InputError(
          "Linear solver",
          name_of(given.solve.solver),
          "run.cg-with-large-rotations: Rotations = large checks stability by "
          "a factorization of each tangent stiffness matrix, but body '" +
            body->name() + "' with " + std::to_string(body->n_dofs()) +
            " DoFs would be solved by conjugate gradients (cg)",
          "Write Linear solver = cholmod, or use fewer hexahedra.");
  }



  void
  BuiltScene::set_isostatic_motions(const Bodies &bodies)
  {
    if (std::none_of(given.bodies.begin(),
                     given.bodies.end(),
                     [](const BodyDescription &body) { return body.is_held; }))
      return;
    std::vector<PotentialContact> touched;
    for (const ContactPair &contact : given.contacts)
      {
        const ContactInterface made  = make_interface(contact, bodies);
        const Body            &first = *bodies[made.first_body];
        // Nearer than a tenth of what the section extends to either side.
        const double depth =
          0.1 * centroid_of(first.surface_points("start"))
                  .distance(farthest_points(first, "start").front().position);
        for (const auto &[row, normal] :
             main_normals(contact, made, bodies, depth))
          {
            const ContactInterface::Point &at = made.points[row];
            touched.push_back({made.first_body, at.first, normal});
            if (made.second_body)
              touched.push_back({*made.second_body, at.second, normal});
          }
      }
    find_isostatic_motions(given.supports, bodies, touched);
  }



  Bodies
  BuiltScene::make_bodies_with_fields()
  {
    Bodies bodies =
      make_bodies(given.bodies, section_meshes, given.solve.memory_limit);
    reasons.assign(bodies.size(), "");
    distribute_total_forces(given.loads, bodies);
    clear_isostatic_motions(given.supports);
    if (has_fields_to_choose(given.bodies))
      {
        apply_temperatures(given.loads, bodies);
        field_notes = choose_fields(
          bodies,
          given.bodies,
          given.supports,
          given.loads,
          undeformed_interfaces(given.contacts, bodies),
          stress_ranges(bodies, given.probes, given.lines, given.cuts),
          field_rules,
          given.gravity,
          &reasons);
      }
    return bodies;
  }



  void
  BuiltScene::build_contacts()
  {
    contacts.resize(given.contacts.size());
    undeformed_pairings.resize(given.contacts.size());
    for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        ContactPair &contact = given.contacts[k];
        moving.push_back(std::make_unique<const Contact>(
          contact, whole->bodies(), contacts[k], undeformed_pairings[k]));
        contact.discretization = contacts[k].discretization;
        drop_constrained_slips(contacts[k], *whole);
        // Choices that a run may revise are made again by who reads the scene.
        if (contact.part_of ||
            (contact.is_automatic &&
             (contact.obstacle == nullptr ||
              contact.discretization == Discretization::line_to_roller) &&
             contact.discretization != Discretization::node_to_node))
          continue;
        given.resolved =
          SceneText::with_automatic(given.resolved,
                                    "Contact " + contact.name,
                                    "Discretization",
                                    name_of(contact.discretization));
      }
    gap_constraints = GapConstraints(contacts);
    check_node_matching(contacts);
    check_conflicts(contacts, whole->bodies());
    check_constrained_overlaps();
    check_strips();
  }



  Scene
  BuiltScene::with_automatic_contacts() const
  {
    Scene again = given;
    for (ContactPair &contact : again.contacts)
      if (contact.is_automatic &&
          contact.discretization == Discretization::node_to_node)
        contact.discretization = Discretization::automatic;
    return again;
  }



  double
  BuiltScene::constrained_overlap(const unsigned int             contact,
                                  const ContactInterface::Point &at) const
  {
    const ContactInterface &own = contacts[contact];
    // Averaged normals over a curved surface are shorter than 1.
    const Tensor<1, 3> n = at.normal / at.normal.norm();
    const auto is_held   = [&](const unsigned int body, const Point<3> &x) {
      const auto row = row_of({body, x, n}, whole->bodies());
      return row && whole->holds(*row);
    };
    const double depth = (at.first - at.second) * n;
    return depth > 0. &&
               given.contacts[contact].overclosure != Overclosure::adjust &&
               (own.second_body ? is_held(*own.second_body, at.second) :
                                  own.obstacle->is_fixed()) &&
               is_held(own.first_body, at.first) ?
             depth :
             0.;
  }



  void
  BuiltScene::check_constrained_overlaps() const
  {
    double       deepest = arithmetic::same_position * whole->size();
    unsigned int worst   = contacts.size();
    Point<3>     place;
    for (unsigned int c = 0; c < contacts.size(); ++c)
      for (const ContactInterface::Point &at : contacts[c].points)
        if (const double depth = constrained_overlap(c, at); depth > deepest)
          {
            deepest = depth;
            worst   = c;
            place   = at.first;
          }
    if (worst == contacts.size())
      return;
    throw InputError(
      "Contact " + contacts[worst].name + "/Overclosure",
      name_of(given.contacts[worst].overclosure),
      "run.overlap-supported: the bodies '" +
        whole->bodies()[contacts[worst].first_body]->name() + "' and '" +
        contacts[worst].second_name + "' overlap at the start by " +
        to_text(deepest, 4) + " at " + to_text(place) +
        ", where supports fix both, so that no contact force can separate them",
      "Write adjust (subtract overlap from gaps), or move the bodies apart.");
  }



  void
  BuiltScene::check_strips() const
  {
    for (const auto *quantities :
         {&given.goals.quantities, &given.trade.quantities})
      for (const NamedQuantity &quantity : *quantities)
        for (const ContactInterface &contact : contacts)
          if (quantity.of == NamedQuantity::ObjectKind::contact &&
              quantity.name == contact.name)
            check_strip(quantity, contact.points);
  }



  void
  BuiltScene::build_requests()
  {
    places =
      std::make_unique<Sampler>(whole->bodies(),
                                given.probes,
                                given.lines,
                                given.cuts,
                                given.solve.stress_axes == StressAxes::scene);
    for (const Measure &measure : given.measures)
      places->check(measure.quantity);
    // A stress of an entry `References` on a ply interface is evaluated in the
    // lower ply; others must name a ply.
    for (NamedQuantity &goal : given.goals.quantities)
      {
        if (goal.path == references_path)
          goal = places->in_lower_ply(goal);
        places->check(goal);
      }
    units_check = std::make_unique<Plausibility>(*whole, given.units, contacts);
    if (!given.strength.criteria.empty())
      sweep = std::make_unique<StrengthSweep>(whole->bodies(), given.strength);
    if (given.find.first_failure)
      check_load_growth(*whole, contacts, given.solve.load_factors.front());
  }



  FaceTractions
  BuiltScene::tractions_at(const State &state, const LoadFactor &factor) const
  {
    FaceTractions tractions(given.loads, factor, given.supports);
    for (unsigned int c = 0; c < contacts.size(); ++c)
      tractions.add_contact(contacts[c],
                            gap_constraints.of_contact(c, state.force),
                            gap_constraints.of_contact(c,
                                                       state.friction.shear));
    return tractions;
  }



  std::string
  BuiltScene::describe_row(const unsigned int row) const
  {
    const auto [c, k]               = gap_constraints.contact_of_row(row);
    const ContactInterface &contact = contacts[c];
    return "contact " + contact.name + ", body '" +
           whole->bodies()[contact.first_body]->name() + "' at " +
           to_text(contact.points[k].first);
  }



  void
  BuiltScene::print_plans(std::ostream &out) const
  {
    constexpr double        bytes = 8., mega = 1e6;
    const Bodies           &bodies = whole->bodies();
    const std::vector<Cost> costs  = predicted_costs(bodies);
    for (unsigned int b = 0; b < given.bodies.size(); ++b)
      out << "Plan of body " << bodies[b]->name() << ": " << bodies[b]->theory()
          << ", " << bodies[b]->n_dofs() << " DoFs, a factor of some "
          << to_text(bytes * costs[b].non_zeros / mega, 3) << " MB and "
          << to_text(costs[b].operations, 2) << " multiplications\n  "
          << (given.goals.theory_is_default ?
                "a run to a tolerance begins with it" :
                "as the scene says")
          << (reasons[b].empty() ? "" : "; ") << reasons[b] << "\n";
  }



  void
  BuiltScene::update_pairing_facts(std::vector<ContactSummary> &found) const
  {
    for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        found[k].discretization  = contacts[k].discretization;
        found[k].rows            = contacts[k].rows.size();
        found[k].unpaired        = contacts[k].unpaired;
        found[k].unpaired_second = contacts[k].unpaired_second;
        found[k].surface         = contacts[k].surface;
      }
  }



  Results
  BuiltScene::facts() const
  {
    Results found;
    found.title      = given.title;
    found.units      = given.units;
    found.load_steps = given.solve.load_factors.size();
    found.size       = whole->size();
    found.loads      = whole->load_resultants();
    for (unsigned int b = 0; b < given.bodies.size(); ++b)
      {
        const Body &body = *whole->bodies()[b];
        found.bodies.push_back({body.name(), body.theory(), body.n_dofs(), {}});
        for (const Ply &ply : body.plies())
          found.bodies.back().materials.push_back(ply.material);
      }
    for (unsigned int k = 0; k < contacts.size(); ++k)
      found.contacts.push_back(
        contact_facts(contacts[k], given.contacts[k].enforcement));
    const auto name = [](const auto &all, std::vector<std::string> &names) {
      for (const auto &one : all)
        names.push_back(one.name);
    };
    if (have_densities(whole->bodies()))
      found.inertia = inertia_of(whole->bodies());
    name(given.supports, found.supports);
    name(given.probes, found.probes);
    name(given.lines, found.lines);
    name(given.cuts, found.cuts);
    name(given.measures, found.measures);
    add_notes(found);
    return found;
  }



  void
  BuiltScene::add_notes(Results &found) const
  {
    const auto add = [&found](const std::vector<std::string> &notes) {
      found.notes.insert(found.notes.end(), notes.begin(), notes.end());
    };
    add(given.warnings);
    add(magnitude_warnings(given, section_meshes));
    add(field_notes);
    add(notes_on_theories(given, section_meshes));
    for (const LoadResultant &load : whole->load_resultants())
      add(load.notes);
    for (const ContactInterface &contact : contacts)
      add(contact.notes);
  }
} // namespace lamella
