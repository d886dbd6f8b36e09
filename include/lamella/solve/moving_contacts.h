// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_moving_contacts_h
#define lamella_solve_moving_contacts_h

#include <lamella/contact/contact.h>
#include <lamella/solve/contact_solver.h>

#include <array>
#include <map>
#include <vector>

namespace lamella
{
  /// The forces of gap rows by where their points are on the body that carries
  /// them, contact by contact: what stays the same when contacts pair anew and
  /// rows get other numbers.
  class PressedPlaces
  {
  public:
    PressedPlaces() = default;
    /// Of rows without friction.
    PressedPlaces(const std::vector<ContactInterface> &contacts,
                  const State                         &state);

    /// Gives @p state the forces in the rows of @p contacts; nothing in those
    /// whose points are not among these.
    void
    give(const std::vector<ContactInterface> &contacts, State &state) const;

  private:
    /// The contact, and the cell and the place in it.
    using Key = std::array<double, 5>;
    static Key
    key(const unsigned int c, const ContactInterface::Point &point);

    std::map<Key, double> forces;
  };

  /**
   * The contacts of bodies that move far: their gap rows are moved with the
   * surfaces, and surfaces that come to face each other are paired anew.
   * Without friction. Refers to the lists of the scene, which it writes
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

    /// Takes the rows to @p state at @p factor (Contact::move()). Throws
    /// NumericsError where one that bears a force finds nothing to bear it on:
    /// bodies have gone through each other, or past an end.
    void
    move(const State &state, const LoadFactor &factor);

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

    /// The largest |g + a lambda| of an active row of @p state and -g of any
    /// other at @p factor, a length; rows are those of the state.
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

    /// Pairs all contacts anew in @p state, at @p factor, which rows were not
    /// of: it is left without contact forces. Throws as see_what_touches().
    void
    pair(State &state, const LoadFactor &factor);

    /// Throws NumericsError where a body went through a roller between two
    /// displacements, each at a load factor, so that nothing touches it.
    void
    require_not_through(const BlockVector &before,
                        const LoadFactor  &from,
                        const BlockVector &u,
                        const LoadFactor  &to) const;

  private:
    /// Pairs contact @p c anew.
    void
    pair(const unsigned int c, const State &state, const LoadFactor &factor);

    const std::vector<ContactInterface> &all;
    const Contacts                      &lives;
    GapRows                              numbered;
  };
} // namespace lamella

#endif
