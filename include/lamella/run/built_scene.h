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
  /// their gap constraints, and probes. All errors of a scene are found during
  /// construction. No stiffness matrix is assembled. Each process has all
  /// objects. Not movable or copyable: solvers refer to members.
  class BuiltScene
  {
  public:
    /// Builds the objects of a copy of @p scene; @p rules are the parameters
    /// for the fields of SV-N. Prints progress to @p out; @p timer measures
    /// time. Throws InputError. Collective.
    BuiltScene(const Scene         &scene,
               const FieldRules    &rules,
               std::ostream        &out,
               dealii::TimerOutput &timer);
    BuiltScene(const BuiltScene &) = delete;
    BuiltScene &
    operator=(const BuiltScene &) = delete;

    /// Returns the scene with graded axes and the choices made for `auto`.
    const Scene &
    scene() const
    {
      return given;
    }

    /// Returns scene() with the setting `auto` restored for contacts for which
    /// it was chosen, to build models with other axes.
    Scene
    with_automatic_contacts() const;

    /// Returns the parameters by which the fields of SV-N were chosen.
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

    /// Returns the constraints and geometry of each contact.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return contacts;
    }

    /// Returns a view of all gap constraints with consecutive numbers.
    const GapConstraints &
    rows() const
    {
      return gap_constraints;
    }

    /// Renumbers rows() after contacts were paired again.
    void
    number_rows()
    {
      gap_constraints = GapConstraints(contacts);
    }

    /// Updates numbers of constraints and slave surfaces in @p found.
    void
    update_pairing_facts(std::vector<ContactSummary> &found) const;

    /// Returns the contact objects, which update their interfaces() at pairing.
    const Contacts &
    contact_objects() const
    {
      return moving;
    }

    /// Returns the evaluation of probes, lines and cuts.
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

    /// Returns the plausibility checks, which list surface points at first use.
    Plausibility &
    plausibility() const
    {
      return *units_check;
    }

    /// Returns @p quantities of the scene (such as goals) with their plies set.
    /// Quantities requested only by References get the lower of two plies.
    /// Throws InputError for a wrong or missing ply (Sampler::check()).
    std::vector<NamedQuantity>
    with_resolved_plies(std::vector<NamedQuantity> quantities) const;

    /// Returns the tractions on faces in @p state at load factor @p factor.
    FaceTractions
    tractions_at(const State &state, const LoadFactor &factor) const;

    /// Returns contact, body and position of constraint @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;

    /// Returns results of the scene without load steps: names, sizes, notes.
    Results
    facts() const;

  private:
    /// Builds section meshes, bodies, supports, loads and stabilizing springs.
    void
    build_structure(std::ostream &out);
    /// Returns the bodies with the fields at each node that the scene requests.
    /// Creates temporary supports, loads and contacts if needed.
    Bodies
    make_bodies_with_fields();
    /// Finds the rigid motions of @p bodies that isostatic supports constrain.
    void
    set_isostatic_motions(const Bodies &bodies);
    /// Pairs all contacts, without duplicate constraints.
    void
    build_contacts();
    /// Returns the initial overlap [length] of contact number @p contact at
    /// @p at if supports constrain both sides at this point, else zero.
    double
    constrained_overlap(const unsigned int             contact,
                        const ContactInterface::Point &at) const;
    /// Throws InputError for initial overlap between two constrained sides.
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
    /// Reason for the fields of the nodes of each body.
    std::vector<std::string>       reasons;
    std::unique_ptr<Sampler>       places;
    std::unique_ptr<StrengthSweep> sweep;
    std::unique_ptr<Plausibility>  units_check;
  };
} // namespace lamella

#endif
