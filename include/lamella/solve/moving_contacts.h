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
  /// Transfer of contact forces and friction variables to the constraints of a
  /// new pairing, by the position of the contact point on the slave body.
  class MultiplierTransfer
  {
  public:
    MultiplierTransfer() = default;
    MultiplierTransfer(const std::vector<ContactInterface> &contacts,
                       const State                         &state);

    /// Sets forces and friction of @p state for the rows of @p contacts.
    void
    transfer_to(const std::vector<ContactInterface> &contacts,
                State                               &state) const;

  private:
    /// Contact number, cell number, and position in the cell.
    using Key = std::array<double, 5>;
    static Key
    key(const unsigned int c, const ContactInterface::Point &point);

    /// Force of a constraint, and its entries in FrictionState.
    struct StoredMultiplier
    {
      double               force = 0.;
      dealii::Tensor<1, 3> shear, direction, before;
      double               length = 0., dissipated = 0.;
    };
    /// Adds the dissipated energy of constraints that are no longer in
    /// @p contacts to the first constraint of their contact.
    void
    preserve_dissipation(const std::vector<ContactInterface> &contacts,
                         FrictionState                       &of) const;

    /// Stored constraints: with friction all, else those with a force.
    std::map<Key, StoredMultiplier> places;
  };

  /// An end of the first or the second body of contact number `contact`.
  struct EndInContact
  {
    unsigned int contact;
    bool         of_second;
  };

  /// Exception: body ends penetrate in contacts with the discretization `auto`
  /// and without constraints at end nodes. More load steps do not help.
  struct MissingEnds : public std::runtime_error
  {
    MissingEnds(const std::string &message, std::vector<EndInContact> ends)
      : std::runtime_error(message)
      , ends(std::move(ends))
    {}

    std::vector<EndInContact> ends;
  };

  /// All contacts of a scene at finite motion: gap constraints are updated to
  /// the displacements, and surfaces are paired anew when they approach each
  /// other. With friction, slips are measured from the beginning of the load
  /// step, and shear forces rotate with the tangents of their constraints.
  /// Modifies the lists of constraints in the scene (Contact).
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

    /// Returns the contacts with the constraints of the last move().
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

    /// Returns the history of each contact, for restore().
    std::vector<ContactHistory>
    memory() const;
    void
    restore(const std::vector<ContactHistory> &known,
            const BlockVector                 &u,
            const LoadFactor                  &factor);

    /// Updates the constraints to @p state at @p factor (Contact::move()). An
    /// active constraint whose projection leaves the other surface, past an end
    /// or through it, is deactivated if that end has its own constraints (`edge
    /// to surface`). Otherwise throws MissingEnds if `auto`, else
    /// NumericsError.
    void
    move(State &state, const LoadFactor &factor);

    /// Begins a load step in @p state at @p factor and clears reason_of_loss().
    void
    begin_step(State &state, const LoadFactor &factor);

    /// Returns a sentence on why a contact was lost since begin_step(), or
    /// would be if deactivated constraints have no replacement.
    const std::string &
    reason_of_loss() const
    {
      return lost;
    }

    /// Adds the contact forces B^T lambda of @p state to @p f.
    void
    add_forces(const State &state, BlockVector &f) const;

    /// Adds the contact forces B^T lambda of @p state to @p f, with its active
    /// constraints at the displacements @p u and load factor @p factor. The
    /// stored constraints are unchanged. Returns true if all are projected.
    bool
    add_forces_at(const State       &state,
                  const BlockVector &u,
                  const LoadFactor  &factor,
                  BlockVector       &f) const;

    /// Returns the error of the contact law in @p state at @p factor [length]:
    /// |g + a lambda| of active constraints, -g of others, friction_error().
    double
    law_error(const State &state, const LoadFactor &factor) const;

    /// Pairs those contacts anew whose surfaces touch without a constraint in
    /// @p state at @p factor, and transfers the forces. Returns true if there
    /// were any. Throws NumericsError if no points face each other.
    bool
    find_loads(State &state, const LoadFactor &factor);

    /// Throws NumericsError if a body passed through a roller between the
    /// states @p before at @p from and @p state at @p to, or if constraints
    /// were deactivated and no other one of the same bodies has a force.
    void
    check_kept(const BlockVector &before,
               const LoadFactor  &from,
               const State       &state,
               const LoadFactor  &to);

  private:
    /// Updates the constraints to @p state, without rotating the shear forces.
    void
    move_rows(State &state, const LoadFactor &factor);
    /// Throws NumericsError: contact @p c was lost; @p how describes the cause.
    [[noreturn]] void
    lose(const unsigned int c, const std::string &how);
    /// Throws MissingEnds or NumericsError: no projection in contact @p c.
    [[noreturn]] void
    release_facing(const unsigned int c);
    /// Returns true if another contact constrains the ends in contact @p c.
    bool
    ends_have_constraints(const unsigned int c) const;
    /// Returns true if the bodies of contact @p c have a contact force.
    bool
    has_contact_force(const unsigned int c, const State &state) const;
    /// Pairs contact @p c anew.
    void
    pair(const unsigned int c, const State &state, const LoadFactor &factor);

    const std::vector<ContactInterface> &all;
    const Contacts                      &contact_objects;
    GapConstraints                       numbered;
    /// Contacts with a deactivated constraint, and reason_of_loss().
    std::set<unsigned int> release;
    std::string            lost;
  };
} // namespace lamella

#endif
