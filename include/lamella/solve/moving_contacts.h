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
  /// Contact forces and friction variables of a state, stored by the contact
  /// point's position on the slave body. When surfaces are paired anew, they
  /// are transferred to the new constraints at the same positions.
  class MultiplierTransfer
  {
  public:
    MultiplierTransfer() = default;
    MultiplierTransfer(const std::vector<ContactInterface> &contacts,
                       const State                         &state);

    /// Sets the contact forces and friction variables of @p state for the
    /// constraints of @p contacts, at stored positions; elsewhere zero.
    void
    transfer_to(const std::vector<ContactInterface> &contacts,
                State                               &state) const;

  private:
    /// Contact number, cell number, and position in the cell.
    using Key = std::array<double, 5>;
    static Key
    key(const unsigned int c, const ContactInterface::Point &point);

    /// Normal force of a constraint, and its entries in FrictionState.
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

    /// Values of all constraints with friction, else of those with a force.
    std::map<Key, StoredMultiplier> places;
  };

  /// An end face of the first or second body of contact number `contact`.
  struct EndInContact
  {
    unsigned int contact;
    bool         of_second;
  };

  /// Exception: an edge of a body's end face penetrates the other body since
  /// the contact has no constraints there. The caller can add an `edge to
  /// surface` contact; smaller load steps do not help.
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

    /// Returns the data of each contact that restore() needs in another run.
    std::vector<ContactHistory>
    memory() const;
    void
    restore(const std::vector<ContactHistory> &known,
            const BlockVector                 &u,
            const LoadFactor                  &factor);

    /// Updates the constraints to @p state at @p factor (Contact::move()). If
    /// the projection of an active constraint leaves the other surface, the
    /// constraint is deactivated if an `edge to surface` contact covers that
    /// end. Else throws MissingEnds (discretization `auto`) or NumericsError.
    void
    move(State &state, const LoadFactor &factor);

    /// Begins a load step: slips are measured from @p state at load factor
    /// @p factor. Clears reason_of_loss().
    void
    begin_step(State &state, const LoadFactor &factor);

    /// Returns a sentence, for messages, on why a contact lost its constraints
    /// since begin_step(); empty if none did.
    const std::string &
    reason_of_loss() const
    {
      return lost;
    }

    /// Adds the contact forces B^T lambda of @p state to @p f.
    void
    add_forces(const State &state, BlockVector &f) const;

    /// Adds the contact forces B(u)^T lambda to @p f, with the forces lambda of
    /// @p state and the constraints moved to the displacements @p u at load
    /// factor @p factor. Stored constraints are unchanged. Returns false if an
    /// active contact point has no projection.
    bool
    add_forces_at(const State       &state,
                  const BlockVector &u,
                  const LoadFactor  &factor,
                  BlockVector       &f) const;

    /// Returns the error of the contact law in @p state at @p factor [length]:
    /// the largest |g + a lambda| of active constraints (gap g, force lambda,
    /// compliance a), penetration -g of others, and friction_error().
    double
    law_error(const State &state, const LoadFactor &factor) const;

    /// Pairs contacts anew if their surfaces touch without a constraint in
    /// @p state at load factor @p factor, and transfers the forces. Returns
    /// true if any was. Throws NumericsError if no points face each other.
    bool
    find_loads(State &state, const LoadFactor &factor);

    /// Throws NumericsError if a body passed through a roller or another body
    /// between the displacements @p before at load factor @p from and @p state
    /// at @p to, or if bodies with a deactivated constraint lost contact.
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
    /// Returns true if an `edge to surface` contact covers the ends of the
    /// bodies of contact @p c.
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
    /// Contacts with deactivated constraints, and reason_of_loss().
    std::set<unsigned int> release;
    std::string            lost;
  };
} // namespace lamella

#endif
