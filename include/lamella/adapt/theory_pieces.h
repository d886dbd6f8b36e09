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
  /// Returns the theories of those segments @p pieces of an axis of length @p
  /// length (entry `Theories`) that contain @p y.
  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length);

  /// Returns the indices of the section functions of @p section for nodes of
  /// LE-@p degree: functions up to this polynomial degree.
  std::vector<unsigned int>
  list_of_degree(const Section &section, const unsigned int degree);

  /// Theories of all axis segments that meet at a node, combined.
  struct Wanted
  {
    unsigned int degree = 0;     ///< Highest degree N of LE-N; 0 without LE.
    bool         any_SV = false; ///< True if any segment is SV or SV-N.
    bool         plain  = true;  ///< True if all segments are SV, not SV-N.
  };

  /// Returns the combined requirements of @p theories, which meet at a node.
  Wanted
  requirements_of(const std::vector<Theory> &theories);

  /// Adds to @p notes a message for each of @p contacts with surface-to-surface
  /// discretization on nodes of @p beam, body number @p body, that have a lower
  /// degree of LE than its section. There are more constraints than DoFs there.
  void
  add_coarse_row_notes(const Beam                          &beam,
                       const unsigned int                   body,
                       const TheoryPieces                  &pieces,
                       const std::vector<ContactInterface> &contacts,
                       std::vector<std::string>            &notes);

  /// Returns a description of the theory of @p body with the section functions
  /// @p lists of its nodes, e.g. "SV-6 (of LE-2), 12 to 111 fields a node".
  std::string
  label_of(const BodyDescription                        &body,
           const std::vector<std::vector<unsigned int>> &lists);

  /// Creates the body of @p description, with LE theories on all axis segments,
  /// from @p beam, which has all section functions at all nodes.
  std::unique_ptr<Body>
  make_by_degrees(const BodyDescription &description, const Beam &beam);
} // namespace lamella

#endif
