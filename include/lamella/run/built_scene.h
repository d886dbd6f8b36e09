// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_built_scene_h
#define lamella_run_built_scene_h

#include <lamella/adapt/node_fields.h>
#include <lamella/contact/contact.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/plausibility.h>
#include <lamella/recover/results.h>
#include <lamella/recover/sampler.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/scene/scene.h>
#include <lamella/solve/structure.h>

#include <deal.II/base/timer.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// A scene with all objects built from it before the solution: sections,
  /// bodies with the fields of their nodes, supports, loads, contacts with
  /// their gap rows, places of probes. All errors of a scene are found here. No
  /// stiffness matrix is assembled. Each process holds all of it. Not movable
  /// or copyable, since solvers refer to its parts.
  class BuiltScene
  {
  public:
    /// Builds a copy of @p scene with fields of SV-N by @p rules. Progress goes
    /// to @p out, seconds to @p timer. Throws InputError. Collective.
    BuiltScene(const Scene         &scene,
               const FieldRules    &rules,
               std::ostream        &out,
               dealii::TimerOutput &timer);
    BuiltScene(const BuiltScene &) = delete;
    BuiltScene &
    operator=(const BuiltScene &) = delete;

    /// Returns the scene with graded axes and resolved automatic choices.
    const Scene &
    scene() const
    {
      return given;
    }

    /// Returns scene() for other axes, with `auto` contacts restored.
    Scene
    with_automatic_contacts() const;

    /// Returns the rules by which the fields of SV-N were chosen.
    const FieldRules &
    rules() const
    {
      return field_rules;
    }

    /// Returns the meshes of all sections of the scene, used or not.
    const SectionMeshes &
    sections() const
    {
      return section_meshes;
    }

    const Structure &
    structure() const
    {
      return *whole;
    }

    /// Prints a line per body: its model, the estimated cost, and the reason.
    void
    print_plans(std::ostream &out) const;

    /// Returns the rows and geometry of each contact.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return contacts;
    }

    /// Returns a view of these rows with consecutive numbers.
    const GapConstraints &
    rows() const
    {
      return gap_constraints;
    }

    /// Renews rows() after contacts were paired anew, which changes their rows.
    void
    number_rows()
    {
      gap_constraints = GapConstraints(contacts);
    }

    /// Updates numbers of rows and slave surfaces in @p found.
    void
    update_pairing_facts(std::vector<ContactSummary> &found) const;

    /// Returns the contacts, each of which updates its interface.
    const Contacts &
    contact_objects() const
    {
      return moving;
    }

    /// Returns the places of probes, lines and cuts in their bodies.
    const Sampler &
    sampler() const
    {
      return *places;
    }

    /// Returns the strength analysis; null if the scene has no criteria.
    const StrengthSweep *
    strength() const
    {
      return sweep.get();
    }

    /// Returns the checks of results; lists surface points at its first use.
    Plausibility &
    plausibility() const
    {
      return *units_check;
    }

    /// Returns @p quantities of the scene, as goals are; those that only
    /// References request are set to the lower ply if their probe lies between
    /// two. Throws InputError for a wrong or missing ply (Sampler::check()).
    std::vector<NamedQuantity>
    with_resolved_plies(std::vector<NamedQuantity> quantities) const;

    /// Returns the tractions on faces in @p state at load factor @p factor.
    FaceTractions
    tractions_at(const State &state, const LoadFactor &factor) const;

    /// Returns contact, body and position of the gap row @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;

    /// Returns results of the scene itself: names, sizes, notes; no step.
    Results
    facts() const;

  private:
    /// Builds section meshes, bodies, supports, loads and stabilizing springs.
    void
    build_structure(std::ostream &out);
    /// Returns the bodies with the fields that the scene requests at each node,
    /// with temporary conditions and contacts if they depend on these.
    Bodies
    make_bodies_with_fields();
    /// Finds the motions of @p bodies that isostatic supports remove.
    void
    set_isostatic_motions(const Bodies &bodies);
    /// Searches and pairs the gap rows of all contacts, without duplicates.
    void
    build_contacts();
    /// Returns the initial overlap [length] of contact @p contact at @p at if
    /// supports constrain both sides there, else zero.
    double
    constrained_overlap(const unsigned int             contact,
                        const ContactInterface::Point &at) const;
    /// Throws InputError for initial overlap where supports fix both sides.
    void
    check_constrained_overlaps() const;
    /// Appends the notes on the scene to @p found.
    void
    add_notes(Results &found) const;
    /// Throws InputError for a strip outside all contact surfaces.
    void
    check_strips() const;
    /// Builds probes, lines, cuts, goals, criteria.
    void
    build_requests();

    Scene                         given;
    FieldRules                    field_rules;
    SectionMeshes                 section_meshes;
    std::unique_ptr<Structure>    whole;
    std::vector<ContactInterface> contacts;
    GapConstraints                gap_constraints;
    Contacts                      moving;
    /// Notes from the choice of fields.
    std::vector<std::string> field_notes;
    /// Reason for the fields of each body's nodes.
    std::vector<std::string>       reasons;
    std::unique_ptr<Sampler>       places;
    std::unique_ptr<StrengthSweep> sweep;
    std::unique_ptr<Plausibility>  units_check;
  };
} // namespace lamella

#endif
