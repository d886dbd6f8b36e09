// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `export`: scenes in the formats of other programs, so far CalculiX.
// It owns the deck and the list of its sets. It never solves, and refuses what
// the format cannot express.
//
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
    /// Pressure over penetration, force / length^3; empty or `auto`: from the
    /// scene (CalculixContacts).
    std::string contact_stiffness;
  };

  /**
   * Writes @p scene as an input deck of CalculiX, an independent
   * finite-element program. A .json of the same name lists the sets of
   * supports and contacts and the places of the probes
   * (doc/verification/calculix.md). A summary goes to @p out.
   *
   * The model has other approximations than the scene: all bodies become
   * hexahedra with plies of their own, contact a linear penalty between
   * surfaces. Meshes and integration points of loads are Lamella's; stiffness,
   * contact and solution are CalculiX'. Each load factor is a step of linear
   * statics.
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
