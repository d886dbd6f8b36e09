// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_moving_contacts_h
#define lamella_solve_moving_contacts_h

#include <lamella/contact/contact.h>
#include <lamella/solve/contact_solver.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// The forces of gap rows, and what friction remembers of them, by where
  /// their points are on the body that carries them, contact by contact: what
  /// stays the same when contacts pair anew and rows get other numbers.
  class PressedPlaces
  {
  public:
    PressedPlaces() = default;
    PressedPlaces(const std::vector<ContactInterface> &contacts,
                  const State                         &state);

    /// Gives @p state these in the rows of @p contacts; nothing in those whose
    /// points are not among them.
    void
    give(const std::vector<ContactInterface> &contacts, State &state) const;

  private:
    /// The contact, and the cell and the place in it.
    using Key = std::array<double, 5>;
    static Key
    key(const unsigned int c, const ContactInterface::Point &point);

    /// Of a row its force, and of FrictionState what there is of it.
    struct Pressed
    {
      double               force = 0.;
      dealii::Tensor<1, 3> shear, direction, before;
      double               length = 0., dissipated = 0.;
    };
    /// Gives what rows that are no more among those of @p contacts have
    /// dissipated to the first of their contact, so that its sum stays.
    void
    keep_dissipated(const std::vector<ContactInterface> &contacts,
                    FrictionState                       &of) const;

    /// All rows where any contact rubs, else those that bear a force.
    std::map<Key, Pressed> places;
  };

  /// An end of the first or the second body of contact number `contact`.
  struct EndInContact
  {
    unsigned int contact;
    bool         of_second;
  };

  /// Exception: ends of bodies press in contacts whose discretization is
  /// automatic and has no constraints at the nodes there. More load steps do
  /// not help, so that it is no NumericsError.
  struct MissingEnds : public std::runtime_error
  {
    MissingEnds(const std::string &message, std::vector<EndInContact> ends)
      : std::runtime_error(message)
      , ends(std::move(ends))
    {}

    std::vector<EndInContact> ends;
  };

  /**
   * The contacts of bodies that move far: their gap rows are moved with the
   * surfaces, and surfaces that come to face each other are paired anew. Where
   * they rub slips are those since the step began, and shear forces turn with
   * the frames of their rows. Refers to the lists of the scene, which it writes
   * (Contact).
   */
  class MovingContacts
  {
  public:
    MovingContacts(const std::vector<ContactInterface> &interfaces,
                   const Contacts                      &lives);

    bool
    none() const
    {
      return lives.empty();
    }

    /// The interfaces, with rows as the last move() left them.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return all;
    }
    const GapRows &
    rows() const
    {
      return numbered;
    }

    /// What each contact has come to, and all of them as they were then, in
    /// the state @p u at @p factor (Contact::recall()).
    std::vector<ContactMemory>
    memory() const;
    void
    recall(const std::vector<ContactMemory> &known,
           const BlockVector                &u,
           const LoadFactor                 &factor);

    /// Takes the rows to @p state at @p factor (Contact::move()). Where one
    /// that bears a force finds nothing to bear it on, past an end of the other
    /// body or through it, it lets go of that if the ends of the other body
    /// have rows (`edge to surface`), which take over; else throws MissingEnds
    /// if the discretization is automatic, or NumericsError.
    void
    move(State &state, const LoadFactor &factor);

    /// Has a step begin in @p state at @p factor, where the rows are taken, in
    /// which nothing is lost yet.
    void
    begin_step(State &state, const LoadFactor &factor);

    /// Why a contact is lost since begin_step(), or would be if nothing takes
    /// over from rows that let go, a sentence; empty if none is.
    const std::string &
    why_lost() const
    {
      return lost;
    }

    /// f += B^T lambda of the forces of @p state.
    void
    add_forces(const State &state, BlockVector &f) const;

    /// The same with the rows that bear the forces of @p state where @p u is
    /// and not it; rows stay. Whether all of them face something there.
    bool
    add_forces_at(const State       &state,
                  const BlockVector &u,
                  const LoadFactor  &factor,
                  BlockVector       &f) const;

    /// The largest |g + a lambda| of an active row of @p state, -g of any
    /// other and friction_error() at @p factor, a length; rows are those of the
    /// state.
    double
    law_error(const State &state, const LoadFactor &factor) const;

    /**
     * Looks whether surfaces that touch in @p state, at @p factor, have rows
     * for it, and pairs those contacts anew that have not; the state's forces
     * go with their points. Says whether there were any. Throws NumericsError
     * where nothing faces the other side any more.
     */
    bool
    see_what_touches(State &state, const LoadFactor &factor);

    /// Throws NumericsError where from @p before at @p from to @p state at @p
    /// to a body went through a roller, so that nothing touches it, or rows let
    /// go and nothing bears a force between their bodies.
    void
    require_kept(const BlockVector &before,
                 const LoadFactor  &from,
                 const State       &state,
                 const LoadFactor  &to);

  private:
    /// Takes rows, but not the shear forces that are along them, to @p state.
    void
    move_rows(State &state, const LoadFactor &factor);
    /// Throws NumericsError: @p how contact @p c is lost.
    [[noreturn]] void
    lose(const unsigned int c, const std::string &how);
    /// Throws MissingEnds or NumericsError: a constraint of contact @p c has a
    /// force and faces nothing.
    [[noreturn]] void
    lose_facing(const unsigned int c);
    /// Whether another contact has rows for the ends of the body that faces the
    /// points of contact @p c.
    bool
    ends_have_rows(const unsigned int c) const;
    /// Whether a row in @p state bears a force between the bodies of contact
    /// @p c.
    bool
    is_pressed(const unsigned int c, const State &state) const;
    /// Pairs contact @p c anew.
    void
    pair(const unsigned int c, const State &state, const LoadFactor &factor);

    const std::vector<ContactInterface> &all;
    const Contacts                      &lives;
    GapRows                              numbered;
    /// Since begin_step(): contacts of which a row let go, and why_lost().
    std::set<unsigned int> let_go;
    std::string            lost;
  };
} // namespace lamella

#endif
