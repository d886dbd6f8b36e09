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
  /// Transfer of contact forces and friction variables to rows paired anew, by
  /// the position of a point on the slave body, per contact.
  class MultiplierTransfer
  {
  public:
    MultiplierTransfer() = default;
    MultiplierTransfer(const std::vector<ContactInterface> &contacts,
                       const State                         &state);

    /// Assigns the stored values to the rows of @p contacts in @p state.
    void
    transfer_to(const std::vector<ContactInterface> &contacts,
                State                               &state) const;

  private:
    /// Contact, cell, and position in the cell.
    using Key = std::array<double, 5>;
    static Key
    key(const unsigned int c, const ContactInterface::Point &point);

    /// Force of a row, and its part of FrictionState.
    struct StoredMultiplier
    {
      double               force = 0.;
      dealii::Tensor<1, 3> shear, direction, before;
      double               length = 0., dissipated = 0.;
    };
    /// Adds the dissipation of rows that are no longer in @p contacts to the
    /// first row of their contact.
    void
    preserve_dissipation(const std::vector<ContactInterface> &contacts,
                         FrictionState                       &of) const;

    /// Stored rows: all with friction in any contact, else those with a force.
    std::map<Key, StoredMultiplier> places;
  };

  /// An end of the first or the second body of contact number `contact`.
  struct EndInContact
  {
    unsigned int contact;
    bool         of_second;
  };

  /// Exception: ends of bodies press in automatic contacts that have no
  /// constraints at the nodes there. More load steps do not help.
  struct MissingEnds : public std::runtime_error
  {
    MissingEnds(const std::string &message, std::vector<EndInContact> ends)
      : std::runtime_error(message)
      , ends(std::move(ends))
    {}

    std::vector<EndInContact> ends;
  };

  /// Contacts with finite motion: gap rows move with the surfaces, and surfaces
  /// are paired anew when they come to face each other. With friction, slips
  /// are measured from the beginning of the step, and shear forces rotate with
  /// the frames of their rows. Modifies the lists of the scene (Contact).
  class MovingContacts
  {
  public:
    MovingContacts(const std::vector<ContactInterface> &interfaces,
                   const Contacts                      &contact_objects);

    bool
    none() const
    {
      return contact_objects.empty();
    }

    /// Returns the interfaces, with the rows of the last move().
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return all;
    }
    const GapConstraints &
    rows() const
    {
      return numbered;
    }

    /// Returns the history of each contact, or restores it
    /// (Contact::restore()).
    std::vector<ContactHistory>
    memory() const;
    void
    restore(const std::vector<ContactHistory> &known,
            const BlockVector                 &u,
            const LoadFactor                  &factor);

    /// Moves the rows to @p state at @p factor (Contact::move()). An active
    /// constraint whose projection leaves the other surface, past an end or
    /// through it, is deactivated if that end has its own constraints (`edge to
    /// surface`). Otherwise throws MissingEnds if automatic, else
    /// NumericsError.
    void
    move(State &state, const LoadFactor &factor);

    /// Begins a step in @p state at @p factor and clears reason_of_loss().
    void
    begin_step(State &state, const LoadFactor &factor);

    /// Returns a sentence on why a contact was lost since begin_step(), or
    /// would be without replacements of deactivated constraints; else empty.
    const std::string &
    reason_of_loss() const
    {
      return lost;
    }

    /// Adds B^T lambda of the forces of @p state to @p f.
    void
    add_forces(const State &state, BlockVector &f) const;

    /// Adds B^T lambda of @p state with its active rows moved to @p u; the
    /// stored rows are unchanged. Returns true if all have a projection there.
    bool
    add_forces_at(const State       &state,
                  const BlockVector &u,
                  const LoadFactor  &factor,
                  BlockVector       &f) const;

    /// Returns the largest of |g + a lambda| of active rows of @p state, -g of
    /// all others, and friction_error() at @p factor [length].
    double
    law_error(const State &state, const LoadFactor &factor) const;

    /// Pairs contacts anew whose surfaces close without a row in @p state at @p
    /// factor, and transfers the forces. Returns true if there were any. Throws
    /// NumericsError if nothing is paired.
    bool
    find_loads(State &state, const LoadFactor &factor);

    /// Throws NumericsError if between @p before at @p from and @p state at @p
    /// to a body passed through a roller, or if constraints were deactivated
    /// and none between their bodies has a force.
    void
    check_kept(const BlockVector &before,
               const LoadFactor  &from,
               const State       &state,
               const LoadFactor  &to);

  private:
    /// Moves the rows to @p state, without rotating the shear forces.
    void
    move_rows(State &state, const LoadFactor &factor);
    /// Throws NumericsError: @p how contact @p c was lost.
    [[noreturn]] void
    lose(const unsigned int c, const std::string &how);
    /// Throws MissingEnds or NumericsError: a constraint of @p c is lost.
    [[noreturn]] void
    release_facing(const unsigned int c);
    /// Returns true if another contact has rows for ends that face @p c.
    bool
    ends_have_constraints(const unsigned int c) const;
    /// Returns true if a row between the bodies of contact @p c is active.
    bool
    has_contact_force(const unsigned int c, const State &state) const;
    /// Pairs contact @p c anew.
    void
    pair(const unsigned int c, const State &state, const LoadFactor &factor);

    const std::vector<ContactInterface> &all;
    const Contacts                      &contact_objects;
    GapConstraints                       numbered;
    /// Contacts with a deactivated row, and reason_of_loss().
    std::set<unsigned int> release;
    std::string            lost;
  };
} // namespace lamella

#endif
