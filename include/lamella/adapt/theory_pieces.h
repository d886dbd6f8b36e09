// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_theory_pieces_h
#define lamella_adapt_theory_pieces_h

#include <lamella/body/beam.h>
#include <lamella/body/parameters.h>
#include <lamella/contact/gap_constraints.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Returns the theories of those axis segments @p pieces that contain @p y.
  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length);

  /// Returns the field numbers of LE-@p degree, all or up to a lower degree.
  std::vector<unsigned int>
  list_of_degree(const Section &section, const unsigned int degree);

  /// Combined requirements of all axis segments that meet at a node.
  struct Wanted
  {
    /// Highest degree of LE, or 0; true if any segment is SV, if all are SV.
    unsigned int degree = 0;
    bool         any_SV = false, plain = true;
  };

  /// Returns the requirements of the theories at a node.
  Wanted
  requirements_of(const std::vector<Theory> &theories);

  /// Adds notes for the user on surface-to-surface contacts at nodes of LE of a
  /// lower degree than the section's, which have one constraint per trace node.
  void
  add_coarse_row_notes(const Beam                          &beam,
                       const unsigned int                   body,
                       const TheoryPieces                  &pieces,
                       const std::vector<ContactInterface> &contacts,
                       std::vector<std::string>            &notes);

  /// Returns a label, for example "SV-6 (of LE-2), 12 to 111 fields a node".
  std::string
  label_of(const BodyDescription                        &body,
           const std::vector<std::vector<unsigned int>> &lists);

  /// Returns the body of @p description, all of whose segments are LE, from
  /// @p beam with the section fields of each segment's degree.
  std::unique_ptr<Body>
  make_by_degrees(const BodyDescription &description, const Beam &beam);
} // namespace lamella

#endif
