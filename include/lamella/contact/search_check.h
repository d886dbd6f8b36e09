// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_check_h
#define lamella_contact_search_check_h

#include <lamella/contact/gap_rows.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// A row that another search for the same contact finds.
  struct RowBeside
  {
    /// Its number there.
    unsigned int found = 0;
    /// The row of the same node, which has less area; none if there is none.
    std::optional<unsigned int> own;
  };

  /// The rows of @p found whose nodes (place_of()) have no row in @p own, or
  /// one with less than @p share of their area. The same side carries both.
  std::vector<RowBeside>
  rows_beside(const ContactInterface &own,
              const ContactInterface &found,
              const double            share);

  /**
   * Looks at what a Search distance leaves out. Places further apart have no
   * row, and would go through the other body without a word; rows at the end of
   * the reach have a part of their area only. So for each state the rows are
   * made again with as much more reach as bodies have moved, and must not touch
   * where those of the contact are missing.
   *
   * One for each contact, kept through the load steps. The rows with more reach
   * cost another search, but only where displacements grow beyond what has been
   * looked at. Without a Search distance of the user's own there is nothing to
   * check.
   */
  class SearchCheck
  {
  public:
    /// Refers to both, which stay where they are while the object lives.
    /// Nothing is searched yet.
    SearchCheck(const ContactPair &contact, const Bodies &bodies);

    /**
     * Throws NumericsError if a place that @p interface, the contact's own,
     * has no row for, or one with a part of its area, has come to touch in the
     * state @p u at load factor @p factor; @p active are the rows that touch,
     * numbered from 0. The message gives the Search distance to take.
     * How far is looked in addition: 2 sqrt(3) times the largest component of
     * @p u, since two surfaces come nearer by no more than both move, and what
     * the obstacle has moved; at most automatic_search_distance(). A place has
     * come to touch if the gap that its full row would have is negative by more
     * than 1e-9 of the displacements, or if its part of a row is in @p active,
     * which is ascending.
     *
     * Bodies whose surfaces do not suit each other within the longer reach are
     * let pass. Done on every process alike.
     */
    void
    check(const ContactInterface          &interface,
          const BlockVector               &u,
          const LoadFactor                &factor,
          const std::vector<unsigned int> &active);

  private:
    /// The row that a place would have with more reach, and the one that it has
    /// with a part of its area, if it has any.
    struct Unseen
    {
      /// With its whole area, within the longer reach.
      GapRow           row;
      dealii::Point<3> position;
      /// Number of the contact's own row, if it has one with less of its area.
      std::optional<unsigned int> seen;
    };

    /// Fills `unseen` from the rows within @p new_reach; the points stay on the
    /// side that carries them in @p interface.
    void
    look_within(const double new_reach, const ContactInterface &interface);

    const ContactPair &contact;
    const Bodies      &bodies;
    /// How far unseen places have been looked for. [length]; 0 before the first
    /// look. It only grows.
    double              reach = 0.;
    std::vector<Unseen> unseen;
  };
} // namespace lamella

#endif
