// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_check_h
#define lamella_contact_search_check_h

#include <lamella/contact/gap_constraints.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// A contact constraint found by a second contact search with a larger search
  /// radius. The first search found none, or one for a smaller area.
  struct AdditionalConstraint
  {
    unsigned int found = 0; ///< Index of the constraint in the second search.
    /// Index of the first search's constraint at the same slave node, if any.
    std::optional<unsigned int> own;
  };

  /// Returns the constraints of @p found, a search with a larger radius, at
  /// slave nodes without a constraint in @p own, or with one that has less than
  /// the fraction @p share of the area. Both searches have the same slave side.
  std::vector<AdditionalConstraint>
  additional_constraints(const ContactInterface &own,
                         const ContactInterface &found,
                         const double            share);

  /// Checks that the search distance given in the input file was large enough.
  /// Points farther apart have no constraint and would pass through the other
  /// body undetected. For each equilibrium state, the contact is paired again
  /// with a search radius increased by the motion of the bodies; the additional
  /// constraints must not be in contact. One object per contact checks all load
  /// steps; it searches again only if displacements exceed those checked so
  /// far. Automatic search distances are not checked.
  class SearchCheck
  {
  public:
    /// Keeps references to both arguments, which must outlive this object.
    SearchCheck(const ContactPair &contact, const Bodies &bodies);

    /// Throws NumericsError if a point without a constraint in @p interface, or
    /// with a constraint for a part of its area, is in contact at the
    /// displacements @p u and the load factor @p factor. A point is in contact
    /// if the gap of its additional constraint is below -1e-9 times the largest
    /// DoF of @p u, or if its existing constraint is one of @p active
    /// (ascending indices within the contact). The message gives the required
    /// search distance. The search radius grows with @p u and the motion of the
    /// obstacle, up to automatic_search_distance().
    void
    check(const ContactInterface          &interface,
          const BlockVector               &u,
          const LoadFactor                &factor,
          const std::vector<unsigned int> &active);

  private:
    /// A constraint that exists only with the larger search radius.
    struct MissingConstraint
    {
      /// The constraint with its whole area, for the larger radius.
      GapConstraint    row;
      dealii::Point<3> position;
      /// Number of the existing constraint with a part of its area, if any.
      std::optional<unsigned int> seen;
    };

    /// Sets `missing_constraints` by a search within @p new_search_radius.
    void
    extend_search(const double            new_search_radius,
                  const ContactInterface &interface);

    const ContactPair &contact;
    const Bodies      &bodies;
    /// Search radius up to now [length]; 0 initially, never decreasing.
    double                         search_radius = 0.;
    std::vector<MissingConstraint> missing_constraints;
  };
} // namespace lamella

#endif
