// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `export`: scenes in the formats of other programs, so far CalculiX.
// Start with export_calculix(). It combines a CalculixMesh (hexahedra),
// CalculixConditions (supports and loads on nodes) and CalculixContacts
// (surfaces and laws), each of which writes its own cards.

#ifndef lamella_export_calculix_deck_h
#define lamella_export_calculix_deck_h

#include <lamella/scene/scene.h>

#include <iosfwd>

namespace lamella
{
  /// Options of a deck, as typed by the user.
  struct DeckRequest
  {
    /// Output file; the name must end in .inp.
    std::string output;
    /// Name known to CalculixElement; C3D20R if empty.
    std::string element;
    /// Pressure over penetration, force / length^3; empty or `auto`: automatic.
    std::string contact_stiffness;
  };

  /**
   * Writes @p scene as an input deck of CalculiX, as @p request demands. A
   * .json of the same name lists the sets of supports and contacts and the
   * positions of the probes (doc/verification/calculix.md). A summary goes to
   * @p out.
   *
   * The model has other approximations than the scene: all bodies become
   * hexahedra with plies of their own, contact a linear penalty between
   * surfaces. Each load factor is a step of linear statics.
   *
   * Throws InputError for scenes that a deck cannot express, invalid requests,
   * and files that cannot be written; existing files stay then. Not parallel.
   */
  void
  export_calculix(const Scene       &scene,
                  const DeckRequest &request,
                  std::ostream      &out);
} // namespace lamella

#endif
