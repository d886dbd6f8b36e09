// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_calculix_deck_h
#define lamella_run_calculix_deck_h

#include <lamella/run/command_line.h>
#include <lamella/scene/scene.h>

#include <iosfwd>

namespace lamella
{
  /**
   * Writes @p scene as an input deck of CalculiX, a finite-element program that
   * we did not write, and beside it a .json of the same name that says which
   * sets of the deck are which supports and contacts and where the probes are
   * (doc/calculix.md). Of @p command it takes the deck's name (it must end in
   * .inp), the element and the contact stiffness; what was done goes to @p out.
   *
   * Throws InputError for what a deck cannot express; nothing is then written.
   */
  void
  export_calculix(const Scene       &scene,
                  const CommandLine &command,
                  std::ostream      &out);
} // namespace lamella

#endif
