// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `export`: scenes in the formats of other programs, so far
// CalculiX. Start with export_calculix(). It combines a CalculixMesh
// (hexahedra), CalculixConditions (supports and loads on nodes) and
// CalculixContacts (surfaces and contact laws). No room of the core depends
// on it; it does not run CalculiX.

#ifndef lamella_export_calculix_deck_h
#define lamella_export_calculix_deck_h

#include <lamella/scene/scene.h>

#include <iosfwd>

namespace lamella
{
  /// Options of the export of a scene as an input deck of CalculiX.
  struct DeckRequest
  {
    /// Path of the output file; its name must end in .inp.
    std::string output;
    /// Element type in CalculiX, such as C3D8I; C3D20R if empty.
    std::string element;
    /// Penalty stiffness of contacts, pressure over penetration [force /
    /// length^3]; if empty or `auto`, the default of CalculixContacts.
    std::string contact_stiffness;
  };

  /**
   * Writes @p scene as an input deck of CalculiX with the options @p request. A
   * .json file of the same name lists node sets, contacts and probes
   * (doc/verification/calculix.md). Prints a summary to @p out.
   *
   * The model differs from the scene: all bodies are meshed with hexahedra, and
   * contact has a linear penalty. Each load factor becomes a static step.
   *
   * Throws InputError for features of the scene that cannot be exported,
   * invalid options and files that cannot be written. One process only.
   */
  void
  export_calculix(const Scene       &scene,
                  const DeckRequest &request,
                  std::ostream      &out);
} // namespace lamella

#endif
