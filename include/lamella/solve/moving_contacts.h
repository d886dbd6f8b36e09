// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_moving_contacts_h
#define lamella_solve_moving_contacts_h

#include <lamella/contact/contact.h>
#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/state.h>

#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// Regularization of an indefinite tangent stiffness K by springs in the
  /// active constraints, for bodies that would buckle without their contact
  /// with an obstacle (a column beside a stop). S = K + rho B^T B is definite,
  /// with the rows B of active constraints and a spring of stiffness rho in
  /// each.
  ///
  /// With the gaps g, penalty eps, contact forces lambda and shifted forces
  /// lambda' = lambda + rho g, the increment x from a state (index 0) with
  /// residual r,
  ///   K x = r + B^T (lambda - lambda_0),   lambda = -eps g,
  /// equals that of
  ///   S x = r + B^T (lambda' - lambda'_0),   lambda' = -(eps - rho) g,
  /// as long as the constraints are active. If a constraint opens, x has an
  /// error due to the spring force, which the next iteration corrects. rho is a
  /// fraction of eps. If S is definite, the state is stable.
  class ActiveConstraintShift
  {
  public:
    /// Springs to the ground, one list per body.
    using Springs = std::vector<std::vector<SpringTerm>>;

    /// Adds a spring, with @p share times the penalty as stiffness, to each
    /// constraint on an obstacle that has a contact force in @p state.
    ActiveConstraintShift(const std::vector<ContactInterface> &contacts,
                          const State                         &state,
                          const unsigned int                   n_bodies,
                          const double                         share);

    /// Returns true if no constraint has a spring.
    bool
    none() const
    {
      return shift.empty();
    }

    /// Returns the springs of all bodies, to be added to the tangent stiffness.
    const Springs &
    springs() const
    {
      return of_bodies;
    }

    /// Returns all constraints, with penalties reduced by their springs.
    GapConstraints
    rows() const
    {
      return GapConstraints(softened);
    }

    /// Replaces the forces lambda of constraints with a spring by the shifted
    /// forces lambda', for the gaps at displacements @p u and load factor @p
    /// factor.
    void
    remove_shift(const BlockVector &u,
                 const LoadFactor  &factor,
                 State             &state) const;
    /// Replaces lambda' by lambda again; deactivates constraints without force.
    void
    apply_shift(const BlockVector &u,
                const LoadFactor  &factor,
                State             &state) const;

  private:
    struct ShiftedConstraint
    {
      unsigned int row;
      double       spring;
    };
    std::vector<ShiftedConstraint> shift;
    Springs                        of_bodies;
    std::vector<ContactInterface>  softened;
  };

  /// An end face of a body that needs an `edge to surface` contact.
  struct EndInContact
  {
    unsigned int contact;   ///< Index of the contact.
    bool         of_second; ///< True: end of its second body; false: first.
  };

  /// Exception: an edge of an end face may penetrate the other body. The caller
  /// can add an `edge to surface` contact; smaller load steps do not help.
  struct MissingEnds : public std::runtime_error
  {
    /// Creates the exception for the end faces @p ends.
    MissingEnds(const std::string &message, std::vector<EndInContact> ends)
      : std::runtime_error(message)
      , ends(std::move(ends))
    {}

    std::vector<EndInContact> ends; ///< End faces that need a contact.
  };

  /// All contacts of a scene with finite rotations. Constraints follow the
  /// displacements, and surfaces are paired anew if they touch without a
  /// constraint. Slips are measured from the start of the load step, and shear
  /// forces rotate with the tangents. Owns the constraints and their pairings.
  class MovingContacts
  {
  public:
    /// Starts with the constraints @p interfaces and their pairings @p
    /// histories. Keeps a reference to the Contact objects.
    MovingContacts(std::vector<ContactInterface> interfaces,
                   std::vector<ContactHistory>   histories,
                   const Contacts               &contact_objects);
    /// Not copyable, since the numbering refers to the constraints.
    MovingContacts(const MovingContacts &) = delete;
    /// Moves the constraints, which keep their addresses.
    MovingContacts(MovingContacts &&) = default;
    /// Creates contacts with the constraints @p fixed, which do not follow the
    /// displacements, for small rotations.
    explicit MovingContacts(const GapConstraints &fixed);

    /// Returns true if there are neither contacts nor constraints.
    bool
    none() const
    {
      return contact_objects.empty() && numbered.empty();
    }

    /// Returns all contacts, with the constraints of the last move().
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return all;
    }
    /// Returns the constraints of all contacts, numbered consecutively.
    const GapConstraints &
    rows() const
    {
      return numbered;
    }

    /// Returns the pairing data of each contact for restore().
    std::vector<ContactHistory>
    memory() const;
    /// Returns the pairing data of the undeformed bodies for restore().
    const std::vector<ContactHistory> &
    undeformed() const
    {
      return initial_pairings;
    }
    /// Restores all contacts from @p known, the result of memory(), at
    /// displacements @p u and load factor @p factor.
    void
    restore(const std::vector<ContactHistory> &known,
            const BlockVector                 &u,
            const LoadFactor                  &factor);

    /// Updates the constraints to @p state at load factor @p factor. An active
    /// constraint without projection on the other surface is deactivated if an
    /// `edge to surface` contact covers that end. Otherwise throws MissingEnds
    /// (discretization `auto`) or NumericsError.
    void
    move(State &state, const LoadFactor &factor);

    /// Begins a load step: slips are measured from @p state at load factor @p
    /// factor. Clears reason_of_loss().
    void
    begin_step(State &state, const LoadFactor &factor);

    /// Returns the reason, as a sentence for messages, why an active constraint
    /// was lost since begin_step(); empty if none was lost.
    const std::string &
    reason_of_loss() const
    {
      return lost;
    }

    /// Adds the nodal contact forces of @p state to the load vector @p f.
    void
    add_forces(const State &state, BlockVector &f) const;

    /// Adds the forces of @p state to @p f, with constraints moved to the
    /// displacements @p u at load factor @p factor; stored constraints do not
    /// change. Returns false if an active contact point has no projection.
    bool
    add_forces_at(const State       &state,
                  const BlockVector &u,
                  const LoadFactor  &factor,
                  BlockVector       &f) const;

    /// Returns the largest error of the contact law in @p state at @p factor
    /// [length]: |g + a lambda| of active constraints (gap g, force lambda,
    /// compliance a), penetration -g of inactive ones, and friction_error().
    double
    law_error(const State &state, const LoadFactor &factor) const;

    /// Pairs contacts anew if their surfaces touch without a constraint in @p
    /// state at load factor @p factor. Returns true if any was paired anew.
    /// Throws NumericsError if no points of a contact face each other.
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
    /// Updates the constraints to @p state without rotating shear forces.
    void
    move_rows(State &state, const LoadFactor &factor);
    /// Throws NumericsError: contact @p c was lost; @p how describes the cause.
    [[noreturn]] void
    lose(const unsigned int c, const std::string &how);
    /// Throws MissingEnds or NumericsError: no projection in contact @p c.
    [[noreturn]] void
    release_facing(const unsigned int c);
    /// Returns true if an `edge to surface` contact covers the body ends of the
    /// contact of index @p c.
    bool
    ends_have_constraints(const unsigned int c) const;
    /// Returns true if the bodies of contact @p c have any contact force.
    bool
    has_contact_force(const unsigned int c, const State &state) const;
    /// Renumbers the constraints after a pairing: those of the material points
    /// @p before keep the forces and friction variables of @p state.
    void
    renumber(const std::vector<std::pair<unsigned int, unsigned int>> &before,
             State                                                    &state);
    /// Pairs the surfaces of the contact of index @p c at @p state anew.
    void
    pair(const unsigned int c, const State &state, const LoadFactor &factor);

    std::vector<ContactInterface> all;
    std::vector<ContactHistory>   pairings, initial_pairings;
    const Contacts               &contact_objects;
    GapConstraints                numbered;
    /// Contacts with deactivated constraints; text of reason_of_loss().
    std::set<unsigned int> release;
    std::string            lost;
  };
} // namespace lamella

#endif
