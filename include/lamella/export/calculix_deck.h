// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `export`: scenes in the words of other programs, so far those of
// CalculiX. It owns the deck and the list of what its sets mean. It never
// solves, and what it cannot express it refuses.

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
    /// C3D20R if empty.
    std::string element;
    /// A pressure over a penetration; empty or `auto`: from the scene.
    std::string contact_stiffness;
  };

  /**
   * Writes @p scene as an input deck of CalculiX, a finite-element program that
   * we did not write, and beside it a .json of the same name that says which
   * sets of the deck are which supports and contacts and where the probes are
   * (doc/calculix.md). What was done goes to @p out.
   *
   * Throws InputError for what a deck cannot express; nothing is then written.
   */
  void
  export_calculix(const Scene       &scene,
                  const DeckRequest &request,
                  std::ostream      &out);
} // namespace lamella

#endif
