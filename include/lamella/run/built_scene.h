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
  /// The model of a scene before the solution: section meshes, bodies with
  /// their section functions, supports, loads, contacts with gap constraints,
  /// and probes. The constructor finds all errors of a scene. Stiffness
  /// matrices are not assembled here. Each process has all objects. Not movable
  /// or copyable, since solvers keep references.
  class BuiltScene
  {
  public:
    /// Builds the objects of a copy of @p scene. @p rules control the section
    /// functions of theory SV-N, which are computed from harmonic loads. Prints
    /// progress to @p out and measures times with @p timer. Throws InputError.
    /// Collective.
    BuiltScene(const Scene         &scene,
               const FieldRules    &rules,
               std::ostream        &out,
               dealii::TimerOutput &timer);
    BuiltScene(const BuiltScene &) = delete;
    BuiltScene &
    operator=(const BuiltScene &) = delete;

    /// Returns the scene with final axis meshes and most `auto` entries set.
    const Scene &
    scene() const
    {
      return given;
    }

    /// Returns scene() with `auto` again for contact discretizations that the
    /// program chose, to build models with other axis meshes.
    Scene
    with_automatic_contacts() const;

    /// Returns the parameters that select section functions for theory SV-N.
    const FieldRules &
    rules() const
    {
      return field_rules;
    }

    /// Returns the meshes of all sections of the scene, with unused sections.
    const SectionMeshes &
    sections() const
    {
      return section_meshes;
    }

    /// Returns the assembly of all bodies with supports and loads.
    const Structure &
    structure() const
    {
      return *whole;
    }

    /// Prints theory, mesh, estimated cost and their reason, a line per body.
    void
    print_plans(std::ostream &out) const;

    /// Returns the gap constraints and contact points of each contact.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return contacts;
    }

    /// Returns all gap constraints of the scene with consecutive indices.
    const GapConstraints &
    rows() const
    {
      return gap_constraints;
    }

    /// Replaces the constraints of the contacts by @p current, those of the
    /// last load step, with the indices in rows().
    void
    set_interfaces(std::vector<ContactInterface> current)
    {
      contacts        = std::move(current);
      gap_constraints = GapConstraints(contacts);
    }

    /// Updates the numbers of constraints and of unpaired points, the slave
    /// surface and the discretization in @p found, one entry per contact.
    void
    update_pairing_facts(std::vector<ContactSummary> &found) const;

    /// Returns the contacts, which evaluate constraints at displacements.
    const Contacts &
    contact_objects() const
    {
      return moving;
    }
    /// Returns the pairing of each contact on the undeformed bodies.
    const std::vector<ContactHistory> &
    pairings() const
    {
      return undeformed_pairings;
    }

    /// Returns the object that evaluates fields at probes, lines and cuts.
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

    /// Returns the checks for implausible results, such as strains above 2 %.
    Plausibility &
    plausibility() const
    {
      return *units_check;
    }

    /// Returns the tractions of loads, supports and contacts on the faces of
    /// bodies in the equilibrium @p state at the load factor @p factor.
    FaceTractions
    tractions_at(const State &state, const LoadFactor &factor) const;

    /// Returns contact, body and position of constraint @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;

    /// Returns the results known before the first step: names, sizes, notes.
    Results
    facts() const;

  private:
    /// Builds section meshes, bodies, supports, loads and stabilizing springs.
    void
    build_structure(std::ostream &out);
    /// Creates the bodies. For theory SV-N, chooses the section functions of
    /// each axis node, from temporary supports, loads and contacts of the
    /// scene.
    Bodies
    make_bodies_with_fields();
    /// Finds the rigid motions of @p bodies that isostatic supports constrain.
    void
    set_isostatic_motions(const Bodies &bodies);
    /// Pairs the surfaces of all contacts, without duplicate constraints.
    void
    build_contacts();
    /// Returns the initial overlap [length] of the surfaces at the point @p at
    /// of contact number @p contact if supports fix both of them, else zero.
    double
    constrained_overlap(const unsigned int             contact,
                        const ContactInterface::Point &at) const;
    /// Throws InputError if constrained_overlap() of a contact point is not 0.
    void
    check_constrained_overlaps() const;
    /// Appends notes on units, theories, loads and contacts to @p found.
    void
    add_notes(Results &found) const;
    /// Throws InputError if a goal or Trade quantity refers to a strip (range
    /// of x, y or z) of a contact in which there are no contact points.
    void
    check_strips() const;
    /// Builds probes, lines, cuts and strength criteria, and checks goals.
    void
    build_requests();

    Scene                         given;
    FieldRules                    field_rules;
    SectionMeshes                 section_meshes;
    std::unique_ptr<Structure>    whole;
    std::vector<ContactInterface> contacts;
    GapConstraints                gap_constraints;
    std::vector<ContactHistory>   undeformed_pairings;
    Contacts                      moving;
    /// Notes from the choice of section functions.
    std::vector<std::string> field_notes;
    /// Reason for the section functions at the nodes of each body.
    std::vector<std::string>       reasons;
    std::unique_ptr<Sampler>       places;
    std::unique_ptr<StrengthSweep> sweep;
    std::unique_ptr<Plausibility>  units_check;
  };
} // namespace lamella

#endif
