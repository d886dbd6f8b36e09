// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_check_h
#define lamella_contact_search_check_h

#include <lamella/contact/gap_constraints.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// A row that another search for the same contact finds.
  struct AdditionalConstraint
  {
    /// Number of the row in that search.
    unsigned int found = 0;
    /// Row of the same node, with less area, if any.
    std::optional<unsigned int> own;
  };

  /// Returns the rows of @p found whose nodes (place_of()) have no row in @p
  /// own, or one with less than @p share of their area, on the same slave side.
  std::vector<AdditionalConstraint>
  additional_constraints(const ContactInterface &own,
                         const ContactInterface &found,
                         const double            share);

  /// Check of a given Search distance. Points farther apart have no row and
  /// would pass through the other body undetected. For each state, the rows are
  /// created again with a search radius increased by the motion of the bodies,
  /// and must not be in contact where rows are missing. One object per contact
  /// is kept through the load steps; it searches again only if displacements
  /// exceed those checked so far. No effect for an automatic search distance.
  class SearchCheck
  {
  public:
    /// Refers to both arguments; does not search.
    SearchCheck(const ContactPair &contact, const Bodies &bodies);

    /**
     * Throws NumericsError if a place without a row in @p interface, or with
     * part of its area, is in contact in the state @p u at load factor @p
     * factor: if the gap of its full row is below zero by more than 1e-9 of the
     * displacements, or if its partial row is in @p active, ascending rows from
     * 0. The message gives the required Search distance. The search radius
     * grows by 2 sqrt(3) times the largest component of @p u, since both
     * surfaces may approach, and by the motion of the obstacle, up to
     * automatic_search_distance(). Surfaces that cannot be paired are skipped.
     */
    void
    check(const ContactInterface          &interface,
          const BlockVector               &u,
          const LoadFactor                &factor,
          const std::vector<unsigned int> &active);

  private:
    /// Row of a place within the larger radius, and its partial row, if any.
    struct MissingConstraint
    {
      /// Row with its whole area, within the larger radius.
      GapConstraint    row;
      dealii::Point<3> position;
      /// Number of the row of the contact with less of its area, if any.
      std::optional<unsigned int> seen;
    };

    /// Fills `unseen` from rows of @p interface's sides within @p
    /// new_search_radius.
    void
    extend_search(const double            new_search_radius,
                  const ContactInterface &interface);

    const ContactPair &contact;
    const Bodies      &bodies;
    /// Search radius so far [length]; 0 initially, never decreasing.
    double                         search_radius = 0.;
    std::vector<MissingConstraint> missing_constraints;
  };
} // namespace lamella

#endif
