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
  /**
   * A scene with all that is made of it before anything is solved, which is all
   * that a scene can be wrong in: sections, bodies with the fields of their
   * nodes, supports, loads, contacts with their gap rows, the places of probes.
   * No stiffness matrix is assembled.
   *
   * It neither moves nor is copied: what solves refers to its parts. On several
   * processes each builds and holds all of it.
   */
  class BuiltScene
  {
  public:
    /// Throws InputError. Progress goes to @p out, seconds to @p timer. What it
    /// needs of @p scene is copied. Fields of SV-N are chosen by @p rules.
    /// Collective.
    BuiltScene(const Scene         &scene,
               const FieldRules    &rules,
               std::ostream        &out,
               dealii::TimerOutput &timer);
    BuiltScene(const BuiltScene &) = delete;
    BuiltScene &
    operator=(const BuiltScene &) = delete;

    /// As it was given, with the axes that grade themselves made, and resolved
    /// what was automatic.
    const Scene &
    scene() const
    {
      return given;
    }

    /// Returns scene() for other axes: contacts for which `auto` chose node to
    /// node are set to `auto` again.
    Scene
    anew() const;

    /// By which the fields of SV-N were chosen.
    const FieldRules &
    rules() const
    {
      return field_rules;
    }

    /// All sections of the scene, whether a body has them or not.
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

    /// A line a body: its model, what that is foreseen to cost, and why it is
    /// this one.
    void
    print_plans(std::ostream &out) const;

    /// Of each contact its rows with their geometry.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return contacts;
    }

    /// A view of these rows, numbered through.
    const GapRows &
    rows() const
    {
      return gap_rows;
    }

    /// Takes the view anew: where contacts were paired anew, which gives them
    /// other rows.
    void
    number_rows()
    {
      gap_rows = GapRows(contacts);
    }

    /// Says in @p found, which has them already, what contacts are paired like
    /// now: numbers of rows and of points without a partner, and what carries
    /// them. Gaps of the start stay.
    void
    tell_pairs(std::vector<ContactFacts> &found) const;

    /// The lives of the contacts, each of which writes its interface.
    const Contacts &
    contact_lives() const
    {
      return lives;
    }

    /// The places of probes, lines and cuts in their bodies.
    const Sampler &
    sampler() const
    {
      return *places;
    }

    /// Null where the scene asks for no criteria.
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

    /// @p quantities, which are of the scene, those that only References ask
    /// for in the lower ply where their probe lies between two. Throws
    /// InputError for one that names a ply that its probe is not in, or none
    /// where plies differ (Sampler::check()). Goals are such.
    std::vector<NamedQuantity>
    in_plies(std::vector<NamedQuantity> quantities) const;

    /// What acts on faces in @p state, that of load factor @p factor.
    FaceTractions
    tractions_at(const State &state, const LoadFactor &factor) const;

    /// Contact, body and position of the gap row @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;

    /// What results say of the scene itself: names, sizes, notes; no step.
    Results
    facts() const;

  private:
    /// Section meshes, bodies, supports, loads and stabilising springs.
    void
    build_structure(std::ostream &out);
    /// The bodies, each node with the fields that the scene wants there: where
    /// they depend on what touches a body, conditions and contacts are made
    /// once to see it.
    Bodies
    make_bodies_with_fields();
    /// Finds the motions that holds among the supports take out of
    /// @p bodies, which are made; contacts are, once more, to see what may
    /// touch them.
    void
    hold_bodies(const Bodies &bodies);
    /// Search and pairing: the gap rows of all contacts, none twice.
    void
    build_contacts();
    /// Returns the initial overlap of contact number @p contact at @p at
    /// [length] if supports hold both sides there, else zero.
    double
    held_overlap(const unsigned int             contact,
                 const ContactInterface::Point &at) const;
    /// Throws InputError if bodies overlap from the start where supports hold
    /// both sides, since no contact force can separate them there.
    void
    check_held_overlaps() const;
    /// Appends the notes on the scene to @p found.
    void
    add_notes(Results &found) const;
    /// Throws InputError for a goal or a quantity of a trade that asks for the
    /// pressure of a strip that is on no contact's surface.
    void
    check_strips() const;
    /// Probes, lines, cuts, goals, criteria.
    void
    build_requests();

    Scene                         given;
    FieldRules                    field_rules;
    SectionMeshes                 section_meshes;
    std::unique_ptr<Structure>    whole;
    std::vector<ContactInterface> contacts;
    GapRows                       gap_rows;
    Contacts                      lives;
    /// What the choice of fields has to say.
    std::vector<std::string> field_notes;
    /// Of each body, why its nodes carry the fields that they do.
    std::vector<std::string>       reasons;
    std::unique_ptr<Sampler>       places;
    std::unique_ptr<StrengthSweep> sweep;
    std::unique_ptr<Plausibility>  units_check;
  };
} // namespace lamella

#endif
