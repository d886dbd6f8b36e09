// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_check_h
#define lamella_contact_search_check_h

#include <lamella/contact/gap_rows.h>

#include <optional>
#include <vector>

namespace lamella
{
  /**
   * Looks at what a Search distance leaves out. Places further apart have no
   * row, and would go through the other body without a word; rows at the end of
   * the reach have a part of their area only. So for each state the rows are
   * made again with as much more reach as bodies have moved, and must not touch
   * where those of the contact are missing.
   */
  class SearchCheck
  {
  public:
    /// What is referred to stays where it is while the object lives.
    SearchCheck(const ContactPair &contact, const Bodies &bodies);

    /// Throws NumericsError if a place that @p interface, the contact's own,
    /// has no row for, or one with a part of its area, has come to touch in the
    /// state @p u at load factor @p factor; @p active are the rows that touch,
    /// numbered from 0. The message gives the Search distance to take.
    void
    check(const ContactInterface          &interface,
          const BlockVector               &u,
          const double                     factor,
          const std::vector<unsigned int> &active);

  private:
    /// The row that a place would have with more reach, and the one that it has
    /// with a part of its area, if it has any.
    struct Unseen
    {
      GapRow                      row;
      dealii::Point<3>            position;
      std::optional<unsigned int> seen;
    };

    void
    look_within(const double new_reach, const ContactInterface &interface);

    const ContactPair &contact;
    const Bodies      &bodies;
    /// How far unseen places have been looked for.
    double              reach = 0.;
    std::vector<Unseen> unseen;
  };
} // namespace lamella

#endif
