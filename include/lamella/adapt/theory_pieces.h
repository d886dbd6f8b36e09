// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_theory_pieces_h
#define lamella_adapt_theory_pieces_h

#include <lamella/body/beam.h>
#include <lamella/body/parameters.h>
#include <lamella/contact/gap_rows.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Of the pieces by hand that hold @p y the theories.
  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length);

  /// The list of LE-@p degree: all of the section's fields, or those of lower
  /// degree that lead them.
  std::vector<unsigned int>
  list_of_degree(const Section &section, const unsigned int degree);

  /// Of the pieces at a node what they want of it together.
  struct Wanted
  {
    /// The highest degree of LE, or 0; and whether there is SV, or nothing
    /// but SV without responses.
    unsigned int degree = 0;
    bool         any_SV = false, plain = true;
  };

  /// Of the theories at a node.
  Wanted
  wanted_by(const std::vector<Theory> &theories);

  /// Notes the contacts surface to surface that reach nodes of LE of a lower
  /// degree than the section's: they have a row for each node of its trace.
  void
  note_coarse_rows(const Beam                          &beam,
                   const unsigned int                   body,
                   const TheoryPieces                  &pieces,
                   const std::vector<ContactInterface> &contacts,
                   std::vector<std::string>            &notes);

  /// As in "SV-6 (of LE-2), 12 to 111 fields a node".
  std::string
  label_of(const BodyDescription                        &body,
           const std::vector<std::vector<unsigned int>> &lists);

  /// The body @p description, whose pieces are all LE, as @p beam is but with
  /// the leading fields of each degree.
  std::unique_ptr<Body>
  by_degrees(const BodyDescription &description, const Beam &beam);
} // namespace lamella

#endif
