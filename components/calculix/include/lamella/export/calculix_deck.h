// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `export`: scenes in the words of other programs, so far those of
// CalculiX. It owns the deck and the list of what its sets mean. It never
// solves, and what it cannot express it refuses.
//
// Where to start reading: export_calculix() puts together a CalculixMesh (the
// hexahedra), CalculixConditions (supports and loads on their nodes) and
// CalculixContacts (surfaces and laws), each of which writes its own cards.

#ifndef lamella_export_calculix_deck_h
#define lamella_export_calculix_deck_h

#include <lamella/scene/scene.h>

#include <iosfwd>

namespace lamella
{
  /// What a user says of the deck, word for word.
  struct DeckRequest
  {
    /// Its file; the name must end in .inp.
    std::string output;
    /// A name that CalculixElement knows; C3D20R if empty.
    std::string element;
    /// A pressure over a penetration, force / length^3; empty or `auto`: from
    /// the scene (CalculixContacts).
    std::string contact_stiffness;
  };

  /**
   * Writes @p scene as an input deck of CalculiX, a finite-element program that
   * we did not write, and beside it a .json of the same name that says which
   * sets of the deck are which supports and contacts and where the probes are
   * (doc/calculix.md). What was done goes to @p out.
   *
   * The model is the scene's with other approximations: bodies, whatever their
   * theory, become hexahedra with plies of their own, contact a linear penalty
   * between surfaces. Meshes and the points of loads are Lamella's, stiffness,
   * contact and solution are not. Each load factor is a step of linear statics.
   *
   * Throws InputError for what a deck cannot express, for a request that cannot
   * be understood and for files that cannot be written; what was there before
   * then stays. For one process.
   */
  void
  export_calculix(const Scene       &scene,
                  const DeckRequest &request,
                  std::ostream      &out);
} // namespace lamella

#endif
